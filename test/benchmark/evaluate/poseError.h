// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef benchPoseError_h
#define benchPoseError_h

#include "dataset/sequence.h"

#include <visp3/model/vpTrackedModel.h>

namespace bench {

//! How far a pose is from the truth.
struct PoseError
{
  double translation = 0.; //!< Metres.
  double rotation = 0.;    //!< Degrees, [0, 180].
  double pixels = 0.; //!< Mean distance of the projected vertices, pixels; infinite where one is behind the camera.
  double add = 0.;    //!< Mean distance of the vertices (ADD), metres.
  double adds = 0.;   //!< Mean distance to the nearest vertex (ADD-S), metres.
};

/*!
  Errors of poses of one object. Where the object declares symmetries, the truth is the one of all poses that look the
  same which is nearest to the estimate, in the mean distance of the vertices.
*/
class PoseErrorMeasure
{
public:
  /*!
    \param object Its symmetries.
    \param model Its vertices; about 500 of them, spread over the list, are used.
  */
  PoseErrorMeasure(const SequenceObject &object, const vpTrackedModel &model);

  //! \return Infinite errors where \e cMo is not finite.
  PoseError operator()(const vpHomogeneousMatrix &cMo, const vpHomogeneousMatrix &truth,
                       const vpCameraParameters &cam) const;

  bool isSymmetric() const { return m_symmetries.size() > 1 || !m_axes.empty(); }

private:
  vpHomogeneousMatrix nearestTruth(const vpHomogeneousMatrix &cMo, const vpHomogeneousMatrix &truth) const;

  std::vector<Eigen::Vector3d> m_points;
  std::vector<Eigen::Matrix4d> m_symmetries; // The identity first.
  std::vector<SymmetryAxis> m_axes;
};

} // namespace bench
#endif
