// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef benchStartPlan_h
#define benchStartPlan_h

#include "dataset/sequence.h"
#include "starts/startOptions.h"

#include <visp3/model/vpTrackedModel.h>
#include <visp3/se3/vpPoseRandom.h>

#include <memory>

namespace bench {

//! Which way a start is off.
struct StartDirection
{
  Eigen::Vector3d axis = Eigen::Vector3d::UnitX();  //!< Of the turn, unit vector, camera frame.
  Eigen::Vector3d shift = Eigen::Vector3d::UnitX(); //!< Unit vector, camera frame.
};

//! \return Directions that are as likely one as another.
StartDirection drawDirection(vpPoseRandom &random);

//! \return \e cMo turned about the object's centre and then shifted. \param centre Object frame, metres.
//! \param angle Radians. \param distance Metres.
vpHomogeneousMatrix deviate(const vpHomogeneousMatrix &cMo, const Eigen::Vector3d &centre,
                            const StartDirection &direction, double angle, double distance);

//! An object and the scenes that show it.
struct StartObject
{
  std::string name; //!< Of its model's file.
  SequenceObject files;
  std::shared_ptr<const vpTrackedModel> model;
  std::vector<std::size_t> scenes; //!< Into StartScenes::sequences.

  //! Of the model's box, object frame, metres.
  Eigen::Vector3d centre() const { return 0.5 * (model->boxMin() + model->boxMax()); }
};

//! What trials are drawn from.
struct StartScenes
{
  std::vector<Sequence> sequences;
  std::vector<StartObject> objects; //!< In the order of their names.
};

//! \throw vpException where a scene cannot be opened, or cameras differ, or there is no other object to be wrong with.
StartScenes openScenes(const StartOptions &options);

//! One trial, before it is known how far the start is off.
struct StartTrial
{
  std::size_t object = 0;     //!< That is looked for.
  std::size_t model = 0;      //!< Object whose model the tracker has; another one for WrongStart::MODEL.
  std::size_t scene = 0;      //!< Where the pose is taken from.
  std::size_t frame = 0;      //!< Index into its frames.
  std::size_t imageScene = 0; //!< Where the images are taken from; another object's for WrongStart::SCENE.
  std::size_t imageFrame = 0;
  StartDirection direction;
};

/*!
  The trials of an object. They depend on the seed, the object's place among the objects and the number of the trial
  alone: deviations and trackers are compared on the same ones.
  \throw vpException where no frame shows enough of the object, in this image and in those that follow.
*/
std::vector<StartTrial> planTrials(const StartOptions &options, const StartScenes &scenes, std::size_t object);

//! \return The other object's files, its mesh scaled to \e object's diameter; a .cao stays as large as it is.
SequenceObject scaledTo(const SequenceObject &other, const SequenceObject &object);

} // namespace bench
#endif
