// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/cues/vpSurfaceMemory.h>

#include "memory/vpHalfImage.h"
#include "memory/vpPatchSums.h"
#include "memory/vpPlaceProjection.h"
#include "memory/vpSurfacePatches.h"

#include <visp3/model/vpModelRenderer.h>

#include <algorithm>
#include <cmath>

BEGIN_VISP_NAMESPACE

namespace {
// Places that are seen flatter than this are no model for later.
const float leastFacingLearnt = 0.35F;
// Share of a frame in what is remembered.
const float rate = 0.15F;
// What contradicts the memory is not learnt: something may be in front of the object. It is forgotten after some time,
// in case it is the object that changed.
const float leastCorrelation = 0.3F;
const float forgetting = 0.02F;
const float forgotten = 0.3F;
// Share of the object's depth by which the depth buffer may differ from a place that it shows.
const float sameDepth = 0.02F;
// Patches with fewer places in view are left out.
const std::size_t fewestPlaces = 5;
// Of a patch's brightness and colours, gray levels: from there on it counts fully.
const float fullDeviation = 8.F;

float textureOf(const vpPatchSums &sums)
{
  return std::min(1.F, sums.deviation() / fullDeviation);
}

bool isKnown(const vpPatchSums &sums)
{
  return sums.known >= fewestPlaces && 2 * sums.known >= sums.seen;
}

// No member: what a library exports is not inlined where it is called.
inline const std::uint8_t *pixelOf(const std::vector<std::uint8_t> &pixels, const vpSeenPlace &place)
{
  return pixels.data() + 4 * static_cast<std::ptrdiff_t>(place.pixel);
}

// Pixel u of the reduced image is at 2 u + 0.5 of the whole one.
bool isHidden(const vpSeenPlace &place, const vpRenderedView *view)
{
  if (view == nullptr) {
    return false;
  }
  const int i = view->index(2. * static_cast<double>(place.u) + 0.5, 2. * static_cast<double>(place.v) + 0.5);
  return i < 0 || std::fabs(view->depth[static_cast<std::size_t>(i)] - place.depth) > sameDepth * place.depth;
}
} // namespace

void vpSurfaceMemory::setSamples(const std::vector<vpSurfaceSample> &samples)
{
  const std::size_t count = samples.size();
  m_places.resize(vpPlaceProjection::arrays * count);
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      m_places[k * count + i] = samples[i].position[static_cast<Eigen::Index>(k)];
      m_places[(3 + k) * count + i] = samples[i].normal[static_cast<Eigen::Index>(k)];
    }
    m_places[6 * count + i] = samples[i].seenFromBothSides ? 1.F : 0.F;
  }
  m_patches = vpGroupIntoPatches(samples, patches);
  m_known.colors.assign(count, {});
  m_known.shades.assign(count, {});
  m_known.weights.assign(count, 0.F);
  m_known.texture = 0.;
}

void vpSurfaceMemory::reset()
{
  std::fill(m_known.weights.begin(), m_known.weights.end(), 0.F);
  m_known.texture = 0.;
}

void vpSurfaceMemory::setReference(const Reference &reference)
{
  if (reference.weights.size() == m_known.weights.size() && reference.channels == m_known.channels) {
    m_known = reference;
  }
}

void vpSurfaceMemory::setFrame(const vpCueFrame &frame)
{
  if (m_frame == frame.number()) {
    return;
  }
  m_frame = frame.number();
  m_camera = frame.camera();
  m_width = static_cast<int>(frame.width() / 2);
  m_height = static_cast<int>(frame.height() / 2);
  const unsigned int channels = frame.hasColor() ? 3 : 1;
  if (channels != m_known.channels) {
    reset();
    m_known.channels = channels;
  }
  if (frame.hasColor()) {
    vpHalveImage(frame.color(), m_pixels);
  } else {
    vpHalveImage(frame.gray(), m_pixels);
  }
}

template <typename Sums, typename Visible>
void vpSurfaceMemory::sumUp(vpPlaceProjection &projection, const Reference &known, Sums &sums, Visible isVisible) const
{
  projection.forEachSeen(m_places.data(), known.weights.size(), [&](const vpSeenPlace &place) {
    if (!isVisible(place)) {
      return;
    }
    vpPatchSums &patch = sums[m_patches[place.number]];
    ++patch.seen;
    if (known.weights[place.number] > 0.F) {
      const std::uint8_t *pixel = pixelOf(m_pixels, place);
      const float color[3] = {static_cast<float>(pixel[0]), static_cast<float>(pixel[1]), static_cast<float>(pixel[2])};
      patch.add(known.shades[place.number], vpShadeOf(color, known.channels), known.middle);
    }
  });
}

vpSurfaceMemory::Agreement vpSurfaceMemory::agreement(const vpHomogeneousMatrix &cMo, const Reference &reference) const
{
  if (reference.weights.size() != m_known.weights.size() || reference.channels != m_known.channels) {
    return {};
  }
  vpPlaceProjection projection(cMo, m_camera, m_width, m_height);
  std::array<vpPatchSums, patches> sums;
  sumUp(projection, reference, sums, [](const vpSeenPlace &) { return true; });
  double seen = 0.;
  double known = 0.;
  double weight = 0.;
  double correlation = 0.;
  for (const vpPatchSums &patch : sums) {
    const double places = static_cast<double>(patch.seen);
    seen += places;
    if (isKnown(patch)) {
      const double share = places * static_cast<double>(textureOf(patch));
      known += places;
      weight += share;
      correlation += share * static_cast<double>(patch.correlation());
    }
  }
  Agreement result;
  result.known = known > 0. ? known / seen : 0.;
  result.texture = known > 0. ? weight / known : 0.;
  result.correlation = weight > 0. ? correlation / weight : 0.;
  return result;
}

void vpSurfaceMemory::mix(const vpSeenPlace &place)
{
  const std::uint8_t *pixel = pixelOf(m_pixels, place);
  std::array<float, 4> &color = m_known.colors[place.number];
  float &weight = m_known.weights[place.number];
  const float share = weight > 0.F ? rate : 1.F;
  for (unsigned int c = 0; c < m_known.channels; ++c) {
    color[c] += share * (static_cast<float>(pixel[c]) - color[c]);
  }
  m_known.shades[place.number] = vpShadeOf(color.data(), m_known.channels);
  weight = std::min(1.F, std::max(weight, forgotten) + rate);
}

void vpSurfaceMemory::learn(const vpHomogeneousMatrix &cMo, const vpRenderedView *depth)
{
  vpPlaceProjection projection(cMo, m_camera, m_width, m_height);
  const auto isVisible = [&](const vpSeenPlace &place) {
    return place.facing >= leastFacingLearnt && !isHidden(place, depth);
  };
  std::array<vpPatchSums, patches> sums;
  sumUp(projection, m_known, sums, isVisible);
  std::array<bool, patches> contradicts;
  std::transform(sums.begin(), sums.end(), contradicts.begin(), [](const vpPatchSums &patch) {
    return isKnown(patch) && textureOf(patch) > 0.5F && patch.correlation() < leastCorrelation;
  });
  projection.forEachSeen(m_places.data(), m_known.weights.size(), [&](const vpSeenPlace &place) {
    if (!isVisible(place)) {
      return;
    }
    float &weight = m_known.weights[place.number];
    if (contradicts[m_patches[place.number]] && weight > 0.F) {
      weight = weight - forgetting > forgotten ? weight - forgetting : 0.F;
    } else {
      mix(place);
    }
  });
  summarise();
}

// What all places that are remembered have in common.
void vpSurfaceMemory::summarise()
{
  m_known.middle.fill(0.F);
  float count = 0.F;
  for (std::size_t i = 0; i < m_known.weights.size(); ++i) {
    if (m_known.weights[i] > 0.F) {
      count += 1.F;
      for (std::size_t k = 0; k < 4; ++k) {
        m_known.middle[k] += (m_known.shades[i][k] - m_known.middle[k]) / count;
      }
    }
  }
  std::array<vpPatchSums, patches> sums;
  for (std::size_t i = 0; i < m_known.weights.size(); ++i) {
    if (m_known.weights[i] > 0.F) {
      sums[m_patches[i]].add(m_known.shades[i], m_known.shades[i], m_known.middle);
    }
  }
  double known = 0.;
  double textured = 0.;
  for (const vpPatchSums &patch : sums) {
    if (patch.known > 0) {
      known += static_cast<double>(patch.known);
      textured += static_cast<double>(patch.known) * static_cast<double>(textureOf(patch));
    }
  }
  m_known.texture = known > 0. ? textured / known : 0.;
}

END_VISP_NAMESPACE
