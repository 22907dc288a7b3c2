// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpPoseCue_h
#define vpPoseCue_h

#include <visp3/core/vpHomogeneousMatrix.h>
#include <visp3/cues/vpCueFrame.h>
#include <visp3/model/vpModelView.h>

#include <Eigen/Core>

#include <vector>

BEGIN_VISP_NAMESPACE

/*!
  \ingroup group_cues
  One equation of the pose's least squares.
*/
struct vpResidual
{
  double error = 0.; //!< s - s*, in the cue's own unit.
  Eigen::Matrix<double, 6, 1> jacobian =
      Eigen::Matrix<double, 6, 1>::Zero(); //!< ViSP's interaction matrix: error' = jacobian . (v, omega) for a camera
                                           //!< velocity in the camera frame, m/s and rad/s.
  double weight = 1.;                      //!< What the cue itself thinks of it, [0, 1].
  bool onSurface = false; //!< Of a mark on the surface, which turns with it, as print does; else of an outline.
};

/*!
  \ingroup group_cues
  The equations that a cue gives for a pose; always in the same order between two calls of match().
*/
struct vpResidualBlock
{
  std::vector<vpResidual> rows;
  double bias = 0.; //!< Standard deviation of what all errors may be shifted by alike: no number of rows averages it.
  double noise =
      0.; //!< Standard deviation of error that the image's noise alone explains; robust scales do not go below it.
};

/*!
  \ingroup group_cues
  What became of a feature, with the values of ViSP's vpMeSite::vpMeSiteState.
*/
enum class vpFeatureState
{
  GOOD = 0,      //!< Used.
  CONTRAST = 1,  //!< Nothing found of the contrast that it had.
  THRESHOLD = 2, //!< Nothing found above the threshold.
  OUTLIER = 3    //!< Found, and refused by the robust estimation.
};

/*!
  \ingroup group_cues
  A feature for display.
*/
struct vpCueFeature
{
  double u = 0.; //!< Column in the frame, pixels.
  double v = 0.; //!< Row in the frame, pixels.
  vpFeatureState state = vpFeatureState::GOOD;
};

/*!
  \ingroup group_cues
  What can be seen of the object in one way: edges, colours, points. The pose estimation knows cues through this class
  alone.

  For a frame, match() compares image and view once; residuals() then gives the equations for any pose, so several poses
  and threads can share one match; updateReference() lets the cue learn from a pose that is trusted.
*/
class VISP_EXPORT vpPoseCue
{
public:
  virtual ~vpPoseCue() = default;

  //! How many levels the cue has, coarse to fine: for each in turn, the pose is estimated from setLevel() and match()
  //! on.
  virtual unsigned int levels() const { return 1; }
  //! Chooses the level of the following calls of match(): 0 is the coarsest; beyond the finest: that one.
  virtual void setLevel(unsigned int /*level*/) {}

  //! Finds in \e frame what \e view shows. Never throws because of what the image shows: it may find nothing.
  virtual void match(const vpCueFrame &frame, const vpModelView &view) = 0;

  //! The equations at \e cMo for what was matched. \param block Result; its memory is used again.
  virtual void residuals(const vpHomogeneousMatrix &cMo, vpResidualBlock &block) const = 0;

  /*!
    Learns from the matched frame.
    \param cMo Pose that is trusted.
    \param weights Robust weights of the rows of residuals(), in [0, 1].
    \throw vpException where there is not one weight for each row.
  */
  virtual void updateReference(const vpHomogeneousMatrix &cMo, const std::vector<double> &weights) = 0;

  //! Forgets all that was learnt from trusted poses; the last match stays.
  virtual void reset() = 0;

  //! Features of the last match, with the states that \e weights (rows of residuals()) give them at \e cMo.
  virtual void getFeatures(const vpHomogeneousMatrix &cMo, const std::vector<double> &weights,
                           std::vector<vpCueFeature> &features) const = 0;
};

END_VISP_NAMESPACE
#endif
