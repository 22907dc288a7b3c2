// SPDX-License-Identifier: GPL-2.0-or-later
#include "starts/vpHintedStarts.h"

#include "motion/vpPoseCheck.h"

#include <visp3/core/vpException.h>
#include <visp3/core/vpImageConvert.h>

#include <cmath>

BEGIN_VISP_NAMESPACE

namespace {
const std::size_t drawn = 80;
const std::size_t mostStarts = 4;
} // namespace

void vpHintedStarts::forgetDetected()
{
  m_rough.detected.clear();
  m_rough.detectorText.clear();
}

void vpHintedStarts::askDetector(const vpCueFrame &image)
{
  const vpPoseDetector detector = m_rough.detector; // It may remove itself.
  try {
    if (image.hasColor()) {
      takeDetected(detector(image.color(), image.camera()));
    } else {
      vpImage<vpRGBa> I;
      vpImageConvert::convert(image.gray(), I);
      takeDetected(detector(I, image.camera()));
    }
  } catch (const vpException &e) {
    m_rough.detectorText = std::string("the detector failed: ") + e.getMessage();
  } catch (const std::exception &e) {
    m_rough.detectorText = std::string("the detector failed: ") + e.what();
  } catch (...) {
    m_rough.detectorText = "the detector failed with an exception of unknown type";
  }
}

void vpHintedStarts::takeDetected(const std::vector<vpWeightedPose> &poses)
{
  for (std::size_t i = 0; i < poses.size(); ++i) {
    try {
      vpPoseCheck::requireRigid(poses[i].cMo);
      vpPoseCheck::requireInView(m_looks.model(), poses[i].cMo, m_looks.camera(), m_looks.width(), m_looks.height());
      if (!(poses[i].weight > 0.) || !std::isfinite(poses[i].weight)) {
        throw vpException(vpException::badValue, "Its weight is %g, it must be above 0", poses[i].weight);
      }
      m_rough.detected.push_back(poses[i]);
    } catch (const vpException &e) {
      m_rough.detectorText = "pose " + std::to_string(i) + " of the detector is passed over: " + e.getMessage();
    }
  }
  if (!m_rough.detected.empty()) {
    m_rough.depths.clear();
    for (const vpWeightedPose &pose : m_rough.detected) {
      m_rough.depths.push_back(m_looks.depthOf(pose.cMo));
    }
  }
}

std::vector<vpHomogeneousMatrix> vpHintedStarts::take(const vpFrameContext &frame)
{
  m_rough.hasHint = false;
  m_rough.depths = {m_looks.depthOf(m_rough.hint)};
  m_score.setFrame(frame);
  vpPoseSearch search(m_score.score(), m_looks.model(), frame.streams.searches++);
  search.scatter(std::vector<vpHomogeneousMatrix>{m_rough.hint},
                 vpRoughStart::spreadOf(m_rough.hintDeviation, m_looks.model().diameter()), drawn);
  m_score.settle(search);
  search.keepBest(mostStarts - 1, vpPoseSearch::same());
  // The hint may be some pixels off, as a start.
  std::vector<vpHomogeneousMatrix> starts = {m_rough.hint, m_capture.find(frame, m_rough.hint, 1.)};
  for (const vpPoseCandidate &candidate : search.candidates()) {
    starts.push_back(candidate.cMo);
  }
  return starts;
}

END_VISP_NAMESPACE
