// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpInertia_h
#define vpInertia_h

#include "motion/vpEvenMotion.h"

#include <array>

BEGIN_VISP_NAMESPACE

/*!
  How an object goes on that moved evenly, told from a frame before it seemed to change its motion.

  A motion that is taken from the last frame follows wrong poses at once: where an estimation slides off a little in
  each frame, each step is as expected. What was known some frames ago does not. A body may speed up, so after some
  frames the new motion is believed.
*/
class vpInertia
{
public:
  //! What was known of the object in a trusted frame.
  struct State
  {
    vpHomogeneousMatrix cMo;
    vpPoseTangent velocity = vpPoseTangent::Zero(); //!< In the object's frame, 1 / s.
    double time = 0.;                               //!< Seconds.
    //! How far it was off the expected poses lately, root of the mean square: in diameters, and radians.
    std::array<double, 2> deviation = {0., 0.};
  };

  void reset()
  {
    m_frames = none;
    skip();
  }
  //! No pose is known in this frame.
  void skip() { m_isPredicted = false; }
  //! Begins a frame. \param time Of it, seconds. \param centre Of the object, in its frame. \param diameter Of it.
  void predict(double time, const Eigen::Vector3d &centre, double diameter);
  //! True where a pose is known in this frame.
  bool isPredicted() const { return m_isPredicted; }
  const vpHomogeneousMatrix &cMo() const { return m_cMo; }
  //! True where a pose is one that the object can hardly have come to.
  bool isLeftBy(const vpHomogeneousMatrix &cMo) const { return m_isPredicted && surprise(cMo) > most; }
  //! Ends a trusted frame. The state before stays for some frames if this one has left it.
  void update(const State &state);

private:
  static constexpr int none = -1;
  static constexpr double most = 9.; // Squared deviations.

  double surprise(const vpHomogeneousMatrix &cMo) const;

  State m_state;
  int m_frames = none; // Since that state.
  bool m_isPredicted = false;
  vpHomogeneousMatrix m_cMo; // In this frame.
  Eigen::Vector3d m_centre = Eigen::Vector3d::Zero();
  double m_diameter = 1.;
};

END_VISP_NAMESPACE
#endif
