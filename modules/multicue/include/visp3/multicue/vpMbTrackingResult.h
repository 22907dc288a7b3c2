// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpMbTrackingResult_h
#define vpMbTrackingResult_h

#include <visp3/core/vpColVector.h>
#include <visp3/core/vpHomogeneousMatrix.h>
#include <visp3/core/vpMatrix.h>
#include <visp3/multicue/vpPoseHypotheses.h>
#include <visp3/multicue/vpPutOff.h>
#include <visp3/multicue/vpTrackingState.h>
#include <visp3/multicue/vpTrackingTimings.h>

#include <string>
#include <vector>

BEGIN_VISP_NAMESPACE

/*!
  \ingroup group_multicue
  All that vpMbMultiCueTracker says of a frame, by vpMbMultiCueTracker::getTrackingResult(): a copy, which stays as it
  is when the tracker goes on.
*/
struct vpMbTrackingResult
{
  //! Why the state is what it is.
  enum class Reason
  {
    NOT_STARTED,      //!< There is no pose to start from, or no image was tracked since the start.
    WELL_EXPLAINED,   //!< TRACKING: the image looks as it should at the pose.
    PARTLY_EXPLAINED, //!< UNCERTAIN: it does so in part.
    CONFIRMING,       //!< UNCERTAIN: too little of the object is in the image, or it was found again just now.
    NOTHING_SEEN,     //!< LOST: no pose could be estimated.
    FEW_FEATURES,     //!< LOST: a pose was estimated, but too few features support it.
    CONTRADICTED,     //!< LOST: enough features support it, and yet the image does not look as it should.
    COASTING          //!< LOST, for any of these reasons, and \e cMo is the pose that the motion before lets expect.
  };

  //! What one of the chosen cues had to say. A feature is a control point of an edge, a line across the silhouette, or
  //! one of the two coordinates of a point on the surface.
  struct Cue
  {
    int type = 0;              //!< vpMbMultiCueTracker::vpTrackerType.
    std::string name;          //!< "edge", "point" or "color", as in JSON settings.
    unsigned int expected = 0; //!< Features that were looked for.
    unsigned int good = 0;     //!< Those that the robust estimation kept.
    /*!
      How well the cue agrees with the pose, at least 0: 1 for edges and points that are where they should be, and about
      1 for colours. The state is judged by it where cues are fused; not a number where the cue is not asked: edges
      alone without a search, and points beside other cues.
    */
    double agreement = 0.;
    std::string reason; //!< vpMbMultiCueTracker::getCueReason(): empty where the cue took part in the pose.
  };

  //! A small motion of the object that the last image did not show.
  struct UnobservedMotion
  {
    /*!
      Shift (metres) and turn (radians) of a frame in the middle of the object's box that has the axes of the object's
      own: turns have a length of 1 rad, shifts without a turn one of 1 m.
    */
    vpColVector direction;
    std::string text; //!< "turn about the object's z axis", "shift along the object's x axis", or where it is neither.
  };

  vpHomogeneousMatrix cMo; //!< Object to camera, metres.
  //! 6 x 6 of vpMbTracker::getCovarianceMatrix(), metres and radians. Empty where setCovarianceComputation() is off.
  vpMatrix covariance;
  vpTrackingState state = vpTrackingState::UNCERTAIN;
  /*!
    How far to believe the pose, [0, 1]; 0 before the first image and while the object is lost: the probability that
    the pose is right, see \ref multicue_search_belief.
  */
  double score = 0.;
  Reason reason = Reason::NOT_STARTED;
  std::string text; //!< The reason as a sentence, with numbers, for a log.
  std::vector<Cue> cues;
  /*!
    Motions that the features of the last image do not constrain: what the pose says of them is what it said before the
    image. Empty where it shows all six, and before the first image; all six where no pose was estimated. See
    \ref multicue_unobserved.
  */
  std::vector<UnobservedMotion> unobserved;
  std::vector<vpPoseHypothesis> hypotheses; //!< vpMbMultiCueTracker::getPoseHypotheses().
  vpTrackingTimings timings;                //!< vpMbMultiCueTracker::getTimings(), milliseconds.
  //! What the frame left for the ones after, to end in time: vpMbMultiCueTracker::setFrameDeadline(). Mostly nothing.
  std::vector<vpPutOff> putOff;

  /** @name Saving
    As JSON: an object with the members' names, matrices as lists of rows, states and reasons as their names, null for
    what is not a number. What is written is read again to the last digit. */
  //@{
  //! \param indent Blanks that each level is set in by; none: all in one line, for a file with a line for each frame.
  VISP_EXPORT std::string toJson(int indent = -1) const;
  //! \throw vpException naming the member that is missing or wrong.
  VISP_EXPORT static vpMbTrackingResult fromJson(const std::string &text);
  //! \throw vpException naming the file where it cannot be written.
  VISP_EXPORT void saveToFile(const std::string &filename) const;
  //! \throw vpException naming the file where it cannot be read, and the member that is missing or wrong.
  VISP_EXPORT static vpMbTrackingResult readFromJsonFile(const std::string &filename);
  //@}
};

//! \ingroup group_multicue
//! \return The reason's name, "WELL_EXPLAINED" for instance.
VISP_EXPORT const char *toString(vpMbTrackingResult::Reason reason);

END_VISP_NAMESPACE
#endif
