// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpStartCapture_h
#define vpStartCapture_h

#include "estimate/vpEdgeEstimator.h"
#include "search/vpPoseCapture.h"

BEGIN_VISP_NAMESPACE

//! Finds the pose near one that came from outside and is some pixels off, see vpPoseCapture.
class vpStartCapture
{
public:
  vpStartCapture(vpModelLooks &looks, const vpCueSet &cues, const vpEdgeEstimator &edges)
      : m_looks(looks), m_cues(cues), m_edges(edges)
  {
  }

  //! \return The pose that the image shows, or the given one. \param reach How far off that may be, in the usual
  //! offsets of a start.
  vpHomogeneousMatrix find(const vpFrameContext &frame, const vpHomogeneousMatrix &cMo, double reach)
  {
    const auto viewAt = [&](const vpHomogeneousMatrix &pose) -> const vpModelView & {
      return m_looks.compute(frame, pose);
    };
    const vpModelView before = viewAt(cMo);
    const vpPoseCapture::Result found =
        m_capture.find(frame.image, m_looks.model(), cMo, reach, m_cues.edges().settings(), m_edges.freeMotions(),
                       viewAt, frame.streams.captures++, frame.deadline);
    m_looks.continueFrom(before); // The poses that were tried saw other faces.
    return found.cMo;
  }

private:
  vpModelLooks &m_looks;
  const vpCueSet &m_cues;
  const vpEdgeEstimator &m_edges;
  vpPoseCapture m_capture;
};

END_VISP_NAMESPACE
#endif
