// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/cues/vpEdgeCue.h>

#include "edge/vpEdgeClaims.h"
#include "edge/vpEdgeSearch.h"
#include "edge/vpProjectedLine.h"
#include "frame/vpLight.h"

#include <visp3/core/vpException.h>

#include <algorithm>
#include <cmath>

BEGIN_VISP_NAMESPACE

namespace {
const int binsPerEdge = 64;
// What an edge's place in the image is uncertain by even where all is well, pixels.
const double edgeNoise = 0.5;
// What the search may place all edges too far out or in by, as the pixels' squares and the mask make it, pixels.
const double edgeBias = 0.05;
// Rows with less robust weight are called outliers and teach nothing.
const double outlierWeight = 0.1;
// That tell by which factor the light has changed.
const std::size_t fewestRatios = 8;
// Of the distances of a right pose's edges, pixels, and the share of them that it misses.
const double evidenceDeviation = 1.;
const double missedShare = 0.2;
// What a row keeps of its weight whose edge of the image belongs to others.
const double leastClaim = 0.05;

int binOf(double parameter)
{
  return std::min(std::max(static_cast<int>(parameter * binsPerEdge), 0), binsPerEdge - 1);
}
} // namespace

vpEdgeCue::vpEdgeCue(const vpEdgeCueSettings &settings)
{
  setSettings(settings);
}

void vpEdgeCue::setSettings(const vpEdgeCueSettings &settings)
{
  settings.check();
  m_settings = settings;
}

void vpEdgeCue::reset()
{
  m_memory.clear();
}

const vpEdgeCue::Memory *vpEdgeCue::recall(const vpControlPoint &point) const
{
  if (point.edge < 0) {
    return nullptr;
  }
  const Memory &memory = m_memory[static_cast<std::size_t>(point.edge * binsPerEdge + binOf(point.parameter))];
  return memory.known ? &memory : nullptr;
}

void vpEdgeCue::remember(const Match &match, const Memory &memory)
{
  if (match.point.edge < 0) {
    return;
  }
  // The bins whose middles are within reach, so that neighbours share none, and in any case the point's own.
  const int own = binOf(match.point.parameter);
  const double middle = match.point.parameter * binsPerEdge - 0.5;
  const double half = 0.5 * match.reach * binsPerEdge;
  const int first = std::max(std::min(static_cast<int>(std::ceil(middle - half)), own), 0);
  const int last = std::min(std::max(static_cast<int>(std::ceil(middle + half)) - 1, own), binsPerEdge - 1);
  for (int bin = first; bin <= last; ++bin) {
    m_memory[static_cast<std::size_t>(match.point.edge * binsPerEdge + bin)] = memory;
  }
}

namespace {
// Distance to the nearer neighbour on the same model edge; infinite for a point that has none.
template <typename Distance>
double toNeighbour(const std::vector<vpControlPoint> &points, std::size_t i, Distance distance)
{
  double least = HUGE_VAL;
  for (const std::size_t other : {i + 1, i - 1}) {
    if (other < points.size() && points[other].edge == points[i].edge) {
      least = std::min(least, distance(points[other], points[i]));
    }
  }
  return least;
}

// A point alone on its edge stands for all of it.
double reachOf(const std::vector<vpControlPoint> &points, std::size_t i)
{
  const auto distance = [](const vpControlPoint &a, const vpControlPoint &b) {
    return std::fabs(a.parameter - b.parameter);
  };
  return std::min(toNeighbour(points, i, distance), 2.);
}

double lengthOf(const std::vector<vpControlPoint> &points, std::size_t i)
{
  const double length = toNeighbour(
      points, i, [](const vpControlPoint &a, const vpControlPoint &b) { return (a.pixel - b.pixel).norm(); });
  return std::isfinite(length) ? length : 0.;
}

void dropMasked(const vpCueFrame &frame, const vpControlPoint &point, vpEdgeSearch::Extrema &extrema)
{
  extrema.last = std::remove_if(extrema.first, extrema.last, [&](const vpEdgeSearch::Extremum &extremum) {
    const Eigen::Vector2d pixel = point.pixel + extremum.offset * point.normal;
    return frame.isMasked(pixel.x(), pixel.y());
  });
}

// Keeps the extrema that may be the edge that was seen before, the most alike first.
vpFeatureState select(vpEdgeSearch::Extrema &extrema, const float *reference, const vpEdgeCueSettings &settings)
{
  if (extrema.first == extrema.last) {
    return vpFeatureState::THRESHOLD;
  }
  const double remembered = reference == nullptr ? 0. : static_cast<double>(*reference);
  if (reference != nullptr) {
    extrema.last = std::remove_if(extrema.first, extrema.last, [&](const vpEdgeSearch::Extremum &extremum) {
      const double ratio = extremum.contrast / remembered;
      return ratio < 1. - settings.mu1 || ratio > 1. + settings.mu2;
    });
  }
  const auto likelier = [=](const vpEdgeSearch::Extremum &a, const vpEdgeSearch::Extremum &b) {
    return reference == nullptr ? std::fabs(a.contrast) > std::fabs(b.contrast)
                                : std::fabs(a.contrast - remembered) < std::fabs(b.contrast - remembered);
  };
  const std::ptrdiff_t kept = std::min<std::ptrdiff_t>(extrema.last - extrema.first, settings.candidates);
  std::partial_sort(extrema.first, extrema.first + kept, extrema.last, likelier);
  extrema.last = extrema.first + kept;
  return kept == 0 ? vpFeatureState::CONTRAST : vpFeatureState::GOOD;
}

// To where the control point was looked for.
const vpEdgeCue::Candidate &nearestOf(const vpEdgeCue::Candidate *candidates, int count)
{
  return *std::min_element(candidates, candidates + count,
                           [](const vpEdgeCue::Candidate &a, const vpEdgeCue::Candidate &b) {
                             return std::fabs(a.offset) < std::fabs(b.offset);
                           });
}

vpEdgeCue::Candidate toCandidate(const vpControlPoint &point, const vpEdgeSearch::Extremum &extremum,
                                 const vpCameraParameters &cam)
{
  vpEdgeCue::Candidate candidate;
  const Eigen::Vector2d pixel = point.pixel + extremum.offset * point.normal;
  candidate.place = Eigen::Vector2d((pixel.x() - cam.get_u0()) * cam.get_px_inverse(),
                                    (pixel.y() - cam.get_v0()) * cam.get_py_inverse());
  candidate.offset = extremum.offset;
  candidate.contrast = extremum.contrast;
  return candidate;
}
} // namespace

void vpEdgeCue::match(const vpCueFrame &frame, const vpModelView &view)
{
  match(frame, view, m_settings);
}

void vpEdgeCue::match(const vpCueFrame &frame, const vpModelView &view, const vpEdgeCueSettings &settings)
{
  m_camera = frame.camera();
  m_matches.clear();
  m_candidates.clear();
  const std::size_t bins = static_cast<std::size_t>(view.edgeNames()) * binsPerEdge;
  if (m_memory.size() != bins) {
    m_memory.assign(bins, Memory());
  }
  vpEdgeSearch search(frame.gray(), settings);
  const std::vector<vpControlPoint> &points = view.points();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const vpControlPoint &point = points[i];
    if (frame.isMasked(point.pixel.x(), point.pixel.y())) {
      continue;
    }
    m_matches.emplace_back();
    Match &match = m_matches.back();
    match.point = point;
    match.reach = reachOf(points, i);
    match.length = lengthOf(points, i);
    match.onSurface = view.textureEdgeOf(point) >= 0;
    match.first = static_cast<int>(m_candidates.size());
    const Memory *memory = recall(point);
    // Remembered along the edge's own direction, searched along the normal.
    const float reference = memory == nullptr ? 0.F : memory->contrast * static_cast<float>(point.side);
    vpEdgeSearch::Extrema extrema = search.along(point.pixel, point.normal);
    match.light = vpLight::at(extrema.brightest, settings.contrast);
    dropMasked(frame, point, extrema);
    match.state = select(extrema, memory == nullptr ? nullptr : &reference, settings);
    match.count = static_cast<int>(extrema.last - extrema.first);
    for (const vpEdgeSearch::Extremum *extremum = extrema.first; extremum != extrema.last; ++extremum) {
      m_candidates.push_back(toCandidate(point, *extremum, m_camera));
    }
  }
  shareCandidates();
}

double vpEdgeCue::adaptToLight(const vpCueFrame &frame, const vpModelView &view)
{
  vpEdgeCueSettings settings = m_settings;
  settings.mu1 = 1.; // Any contrast of the same sign.
  settings.mu2 = HUGE_VAL;
  match(frame, view, settings);
  std::vector<double> ratios;
  for (const Match &match : m_matches) {
    const Memory *memory = recall(match.point);
    if (memory != nullptr && match.count > 0) {
      const Candidate &nearest = nearestOf(m_candidates.data() + match.first, match.count);
      ratios.push_back(nearest.contrast * match.point.side / static_cast<double>(memory->contrast));
    }
  }
  if (ratios.size() < fewestRatios) {
    return 1.;
  }
  const auto middle = ratios.begin() + static_cast<std::ptrdiff_t>(ratios.size() / 2);
  std::nth_element(ratios.begin(), middle, ratios.end());
  for (Memory &memory : m_memory) {
    memory.contrast *= static_cast<float>(*middle);
  }
  return *middle;
}

void vpEdgeCue::shareCandidates()
{
  vpEdgeClaims claims(m_matches.size());
  for (const Match &match : m_matches) {
    if (match.count > 0) {
      const vpControlPoint &point = match.point;
      const Candidate &nearest = nearestOf(m_candidates.data() + match.first, match.count);
      claims.add({point.edge, (point.pixel + nearest.offset * point.normal).cast<float>(), point.normal.cast<float>(),
                  static_cast<float>(std::fabs(nearest.offset)), static_cast<float>(match.length)});
    }
  }
  const std::vector<float> shares = claims.shares();
  auto share = shares.begin();
  for (Match &match : m_matches) {
    if (match.count > 0) {
      match.claim = static_cast<double>(*share++);
    }
  }
}

void vpEdgeCue::addRow(const Match &match, int choice, const vpLineProjector &project,
                       std::vector<vpResidual> &rows) const
{
  rows.emplace_back();
  vpResidual &row = rows.back();
  row.onSurface = match.onSurface;
  const vpProjectedLine line = project(match.point);
  if (!line.isSeen()) {
    row.weight = 0.;
    return;
  }
  const Candidate *first = m_candidates.data() + match.first;
  const double deviation = m_uncertainty / m_camera.get_px();
  const Candidate &candidate = choice >= 0
                                   ? first[choice]
                                   : (deviation > 0. ? line.likeliest(first, match.count, 0.5 / (deviation * deviation))
                                                     : line.nearest(first, match.count));
  row.weight = vpLight::pull(match.light) * std::max(match.claim, leastClaim);
  row.error = line.distance(candidate.place);
  line.jacobian(candidate.place, row.error, row.jacobian);
}

void vpEdgeCue::residuals(const vpHomogeneousMatrix &cMo, vpResidualBlock &block) const
{
  block.rows.clear();
  block.noise = edgeNoise / m_camera.get_px();
  block.bias = edgeBias / m_camera.get_px();
  const vpLineProjector project(cMo);
  for (const Match &match : m_matches) {
    if (match.count > 0) {
      addRow(match, NEAREST, project, block.rows);
    }
  }
}

void vpEdgeCue::residuals(const vpHomogeneousMatrix &cMo, const std::vector<int> &choices, vpResidualBlock &block) const
{
  if (choices.size() != m_matches.size()) {
    throw vpException(vpException::dimensionError,
                      "vpEdgeCue::residuals() was given %zu choices for %zu control points: pass one for each",
                      choices.size(), m_matches.size());
  }
  block.rows.clear();
  block.noise = edgeNoise / m_camera.get_px();
  block.bias = edgeBias / m_camera.get_px();
  const vpLineProjector project(cMo);
  for (std::size_t i = 0; i < m_matches.size(); ++i) {
    if (m_matches[i].count > 0 && choices[i] != NO_ROW) {
      addRow(m_matches[i], std::min(choices[i], m_matches[i].count - 1), project, block.rows);
    }
  }
}

double vpEdgeCue::agreementOf(const Match &match, const vpLineProjector &project, double reach) const
{
  if (match.count == 0) {
    return 0.;
  }
  const vpProjectedLine line = project(match.point);
  if (!line.isSeen()) {
    return 0.;
  }
  const Candidate &nearest = line.nearest(m_candidates.data() + match.first, match.count);
  const double share = line.distance(nearest.place) * m_camera.get_px() / reach;
  return std::max(0., 1. - share * share);
}

double vpEdgeCue::agreement(const vpHomogeneousMatrix &cMo, double reach) const
{
  const vpLineProjector project(cMo);
  vpLight::Mean mean;
  for (const Match &match : m_matches) {
    mean.add(agreementOf(match, project, reach), match.light);
  }
  return mean.value();
}

std::vector<double> vpEdgeCue::agreements(const vpHomogeneousMatrix &cMo, double reach) const
{
  const vpLineProjector project(cMo);
  std::vector<double> each;
  each.reserve(m_matches.size());
  for (const Match &match : m_matches) {
    each.push_back(agreementOf(match, project, reach));
  }
  return each;
}

double vpEdgeCue::evidenceOf(const Match &match, const vpLineProjector &project) const
{
  double best = 0.;
  if (match.count > 0) {
    const vpProjectedLine line = project(match.point);
    const Candidate *first = m_candidates.data() + match.first;
    for (int i = 0; line.isSeen() && i < match.count; ++i) {
      const double d = line.distance(first[i].place) * m_camera.get_px() / evidenceDeviation;
      best = std::max(best, std::exp(-0.5 * d * d) / (i + 1));
    }
  }
  const double peak = 2. * m_settings.range / (std::sqrt(2. * M_PI) * evidenceDeviation);
  return std::log(missedShare + (1. - missedShare) * peak * best);
}

double vpEdgeCue::evidence(const vpHomogeneousMatrix &cMo) const
{
  const vpLineProjector project(cMo);
  vpLight::Mean mean;
  for (const Match &match : m_matches) {
    mean.add(evidenceOf(match, project), match.light);
  }
  return mean.value();
}

void vpEdgeCue::updateReference(const vpHomogeneousMatrix &cMo, const std::vector<double> &weights)
{
  const auto hasRow = [](const Match &match) { return match.count > 0; };
  const std::ptrdiff_t rows = std::count_if(m_matches.begin(), m_matches.end(), hasRow);
  if (static_cast<std::ptrdiff_t>(weights.size()) != rows) {
    throw vpException(
        vpException::dimensionError,
        "vpEdgeCue::updateReference() was given %zu weights for %zu rows: pass one for each of residuals()",
        weights.size(), static_cast<std::size_t>(rows));
  }
  const vpLineProjector project(cMo);
  std::size_t row = 0;
  for (const Match &match : m_matches) {
    Memory memory;
    if (match.count > 0 && weights[row++] > outlierWeight) {
      const vpProjectedLine line = project(match.point);
      memory.known = line.isSeen();
      if (memory.known) {
        const Candidate &candidate = line.nearest(m_candidates.data() + match.first, match.count);
        memory.contrast = static_cast<float>(candidate.contrast * match.point.side);
      }
    }
    remember(match, memory);
  }
}

void vpEdgeCue::getFeatures(const vpHomogeneousMatrix &cMo, const std::vector<double> &weights,
                            std::vector<vpCueFeature> &features) const
{
  features.clear();
  const vpLineProjector project(cMo);
  std::size_t row = 0;
  for (const Match &match : m_matches) {
    vpCueFeature feature;
    feature.state = match.state;
    Eigen::Vector2d pixel = match.point.pixel;
    if (match.count > 0) {
      const vpProjectedLine line = project(match.point);
      if (line.isSeen()) {
        pixel += line.nearest(m_candidates.data() + match.first, match.count).offset * match.point.normal;
      }
      feature.state =
          row < weights.size() && weights[row] <= outlierWeight ? vpFeatureState::OUTLIER : vpFeatureState::GOOD;
      ++row;
    }
    feature.u = pixel.x();
    feature.v = pixel.y();
    features.push_back(feature);
  }
}

END_VISP_NAMESPACE
