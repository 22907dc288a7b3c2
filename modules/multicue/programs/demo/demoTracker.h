// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef programsDemoTracker_h
#define programsDemoTracker_h

#include "demo/demoSequence.h"

#include <visp3/core/vpImage.h>
#include <visp3/core/vpRGBa.h>
#include <visp3/multicue/vpTrackingState.h>

#include <opencv2/core.hpp>

#include <memory>
#include <string>

namespace programs {

//! What a tracker says of an image.
struct DemoAnswer
{
  vpHomogeneousMatrix cMo;
  vpTrackingState state = vpTrackingState::LOST; //!< ViSP's tracker is LOST where track() throws, else TRACKING.
  double milliseconds = 0.;                      //!< Of track().
};

//! One of the two trackers that are compared.
class DemoTracker
{
public:
  virtual ~DemoTracker() = default;
  virtual std::string name() const = 0;
  //! Starts at the sequence's pose.
  virtual void start(const vpImage<vpRGBa> &I, const std::string &pose) = 0;
  virtual DemoAnswer track(const vpImage<vpRGBa> &I) = 0;
  //! Draws the model at a pose into an 8-bit BGR image.
  virtual void draw(cv::Mat &image, const DemoAnswer &answer) = 0;
  //! ViSP's measure: mean angle of the model's edges and the image's gradients, degrees.
  virtual double projectionError(const vpImage<vpRGBa> &I, const vpHomogeneousMatrix &cMo) = 0;
};

//! \return vpMbGenericTracker with edges and points, as ViSP's tutorials set it up.
std::unique_ptr<DemoTracker> makeVispTracker(const DemoSequence &sequence);
//! \return vpMbMultiCueTracker as it is made, with the same files.
std::unique_ptr<DemoTracker> makeMultiCueTracker(const DemoSequence &sequence);

} // namespace programs
#endif
