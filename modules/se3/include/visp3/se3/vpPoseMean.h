// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpPoseMean_h
#define vpPoseMean_h

#include <visp3/se3/vpCompatibility.h>

#include <visp3/core/vpHomogeneousMatrix.h>

#include <vector>

BEGIN_VISP_NAMESPACE

/*!
  \class vpPoseMean
  \ingroup group_se3
  \brief Weighted mean of poses: the mean of the translations, and the rotation that is closest to the mean of the
  rotation matrices ([T10] eq. 7).

  vpHomogeneousMatrix::mean() has no weights, and fails where the mean matrix has a negative determinant, as that of
  rotations by more than 120 degrees about different axes can have.

  \sa \ref se3_mean
*/
class VISP_EXPORT vpPoseMean
{
public:
  /*!
    \param poses At least one pose, all between the same two frames.
    \param weights One weight for each pose, >= 0, not all of them 0; their sum is free.
    \return The weighted mean. Where several rotations are equally close, as for two poses half a turn apart, one of
    them.
    \throw vpException::badValue if there is no pose, the sizes differ, a weight is negative, all are 0, or a weight or
    a pose is not finite.
  */
  static vpHomogeneousMatrix weighted(const std::vector<vpHomogeneousMatrix> &poses,
                                      const std::vector<double> &weights);

  /*!
    The same for a part of an array.
    \param poses, weights The first of each. \param count Number of poses, at least 1.
  */
  static vpHomogeneousMatrix weighted(const vpHomogeneousMatrix *poses, const double *weights, std::size_t count);
};

END_VISP_NAMESPACE

#endif
