// SPDX-License-Identifier: GPL-2.0-or-later
#include "search/vpPoseCapture.h"

#include "hypotheses/vpControlPointMotion.h"

#include <algorithm>
#include <array>
#include <cmath>

BEGIN_VISP_NAMESPACE

namespace {
// From coarse to fine: how far edges are searched for, as a share of the range in use, and how far off the pose may
// still be, pixels.
struct Stage
{
  double range;
  double uncertainty;
};
const std::array<Stage, 5> stages = {{{2., 8.}, {1.5, 5.}, {1., 3.}, {1., 1.5}, {1., 0.}}};
const unsigned int iterations = 8;
const unsigned int mostCandidates = 8;
// How far off a start usually is, pixels: a clicked one is off by 4.
const double usualOffset = 5.;
// What that speaks against a pose, per control point: they are not independent.
const double priorWeight = 0.05;
// Poses around the given one. Of 100 starts that are 10 pixels off, as many are found on ViSP's cube with 8 and with
// 16 (97 and 98, with none 90).
const std::uint64_t starts = 8;
// By how much another pose has to be better than the given one. The best of them is so by chance where much else looks
// like an edge of the object: on a box of marble before a plain wall by 0.09, on a painted box before clutter by 0.17.
// Of 883 exact starts in rendered sequences, 874 are kept with 0.2, 881 with 0.25; of 100 starts that are two pixels
// off on ViSP's teabox, which its model fits badly, 100 and 99 are right.
const double leastGain = 0.2;
// Shares of an offset that are shifts along each axis, and how far from the middle its turns are felt, diameters.
const double shiftShare = 0.7;
const double usualRadius = 0.35;
} // namespace

bool vpPoseCapture::refine(const vpCueFrame &frame, const vpEdgeCueSettings &settings, const vpPoseMatrix6 &freeMotions,
                           const ViewAt &viewAt, vpHomogeneousMatrix &cMo)
{
  vpEdgeCueSettings now = settings;
  now.candidates = mostCandidates;
  for (const Stage &stage : stages) {
    now.range = std::min(stage.range * settings.range, vpEdgeCueSettings::maxRange);
    m_edges.setSettings(now);
    m_edges.reset();
    m_edges.setUncertainty(stage.uncertainty);
    const vpModelView &view = viewAt(cMo);
    m_edges.match(frame, view);
    const vpPoseMatrix6 seen = m_solver.observed(m_edges, freeMotions, view.model().diameter(), cMo);
    if (!m_solver.minimise(m_edges, nullptr, seen, view.model().diameter(), cMo, iterations)) {
      return false;
    }
  }
  return true;
}

// What the image says of a pose as it is.
vpPoseCapture::Result vpPoseCapture::judge(const vpCueFrame &frame, const vpHomogeneousMatrix &cMo,
                                           const vpHomogeneousMatrix &start, double offset,
                                           const vpEdgeCueSettings &settings, const ViewAt &viewAt)
{
  vpEdgeCueSettings now = settings;
  now.candidates = mostCandidates;
  m_edges.setSettings(now);
  m_edges.reset();
  const vpModelView &view = viewAt(cMo);
  m_edges.match(frame, view);
  Result result;
  result.cMo = cMo;
  result.evidence = m_edges.evidence(cMo);
  const double off = vpControlPointMotion::between(view, cMo, start, frame.camera()) / offset;
  result.value = result.evidence - 0.5 * priorWeight * off * off;
  return result;
}

// Turned and shifted, so that the model's points move by about so many pixels.
vpHomogeneousMatrix vpPoseCapture::drawn(const vpHomogeneousMatrix &start, const vpTrackedModel &model, double pixels,
                                         const vpCameraParameters &cam, vpPoseRandom random)
{
  const Eigen::Isometry3d pose = vpPoseExponential::toEigen(start);
  const Eigen::Vector3d centre = model.centre();
  const double pixel = (pose * centre).z() / cam.get_px(); // Metres at the object.
  vpPoseTangent motion = pixels * pixel * random.normalTangent();
  motion.head<3>() *= shiftShare;
  motion.tail<3>() /= usualRadius * model.diameter();
  Eigen::Isometry3d toCentre = Eigen::Isometry3d::Identity();
  toCentre.translation() = centre;
  const Eigen::Isometry3d moved = vpPoseExponential::toEigen(vpPoseExponential::exp(motion));
  return vpPoseExponential::fromEigen(pose * toCentre * moved * toCentre.inverse());
}

vpPoseCapture::Result vpPoseCapture::find(const vpCueFrame &frame, const vpTrackedModel &model,
                                          const vpHomogeneousMatrix &start, double reach,
                                          const vpEdgeCueSettings &settings, const vpPoseMatrix6 &freeMotions,
                                          const ViewAt &viewAt, std::uint64_t stream, vpFrameDeadline &deadline)
{
  const double offset = reach * usualOffset;
  Result best = judge(frame, start, start, offset, settings, viewAt);
  best.value += leastGain;
  for (std::uint64_t i = 0; i <= starts && !deadline.putsOff(vpPutOff::STARTS); ++i) {
    const vpTimedWork work(deadline, vpPutOff::STARTS);
    vpHomogeneousMatrix cMo = i == 0 ? start : drawn(start, model, offset, frame.camera(), vpPoseRandom(stream, {i}));
    if (!refine(frame, settings, freeMotions, viewAt, cMo)) {
      continue;
    }
    const Result result = judge(frame, cMo, start, offset, settings, viewAt);
    if (result.value > best.value) {
      best = result;
    }
  }
  return best;
}

END_VISP_NAMESPACE
