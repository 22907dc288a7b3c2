// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpPosePrior_h
#define vpPosePrior_h

#include <visp3/cues/vpPoseCue.h>
#include <visp3/se3/vpPoseExponential.h>

#include <array>

BEGIN_VISP_NAMESPACE

/*!
  What is known of the pose before the image is looked at: it is near the one that is expected.

  Six rows of unit variance, in a frame with the object's orientation at its centre. Motions that the image shows are
  hardly held back; those that it does not show would else follow the noise of a few rows anywhere.
*/
class vpPosePrior
{
public:
  static constexpr unsigned int rows = 6;

  /*!
    \param cMo Expected pose. \param oMb Frame at the object's centre.
    \param deviations Standard deviations of its translation, metres, and rotation, radians.
  */
  void set(const vpHomogeneousMatrix &cMo, const vpHomogeneousMatrix &oMb, const vpPoseTangent &deviations)
  {
    m_oMb = oMb;
    m_bMc = (cMo * m_oMb).inverse();
    m_inverse = deviations.cwiseInverse();
    m_isSet = true;
  }
  void clear() { m_isSet = false; }
  bool isSet() const { return m_isSet; }

  //! Errors and interaction matrix at a pose.
  void residuals(const vpHomogeneousMatrix &cMo, std::array<vpResidual, rows> &block) const
  {
    const vpHomogeneousMatrix cMb = cMo * m_oMb;
    const vpPoseTangent error = m_inverse.cwiseProduct(vpPoseExponential::log(m_bMc * cMb));
    // A velocity v of the camera moves the object by -v, seen from where it is now.
    const vpPoseMatrix6 jacobian = -(m_inverse.asDiagonal() * vpPoseExponential::adjoint(cMb.inverse()));
    for (unsigned int i = 0; i < rows; ++i) {
      block[i] = vpResidual();
      block[i].error = error[i];
      block[i].jacobian = jacobian.row(i).transpose();
    }
  }

private:
  vpHomogeneousMatrix m_oMb, m_bMc;
  vpPoseTangent m_inverse = vpPoseTangent::Zero();
  bool m_isSet = false;
};

END_VISP_NAMESPACE
#endif
