// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef benchProtocol_h
#define benchProtocol_h

#include "evaluate/benchTracker.h"
#include "evaluate/imageStore.h"
#include "evaluate/poseError.h"

#include <functional>

namespace bench {

//! How a tracker is run over a sequence.
enum class Protocol
{
  RBOT, //!< After a failure the tracker is started again at the truth of that frame, or near it.
  RUN   //!< Started once, at the first frame.
};

//! "rbot" or "run".
std::string toString(Protocol protocol);

//! When a pose is right; lengths are in metres.
struct Limits
{
  explicit Limits(double diameter);

  double successTranslation; //!< 5 cm, or a tenth of the diameter where that is more.
  double successRotation;    //!< 5 degrees.
  double rightTranslation;   //!< A tenth of the diameter.
  double rightRotation;      //!< 10 degrees.
};

//! A frame that shows less of the object than this counts nowhere: no tracker can be right there but by luck.
constexpr double leastVisibility = 0.2;

//! One tracked frame.
struct FrameRecord
{
  int frame = 0; //!< SequenceFrame::id.
  double ms = 0.;
  bool reset = false; //!< Started again in this frame, after it was tracked.
  TrackerAnswer answer;
  bool known = false;   //!< It has a truth.
  bool counted = false; //!< It has a truth, and shows enough of the object.
  bool success = false; //!< Within Limits::success*.
  bool right = false;   //!< Within Limits::right*.
  PoseError error;      //!< Where it has a truth.
};

//! Where a tracker is started in a frame with truth.
using StartPose = std::function<vpHomogeneousMatrix(const SequenceFrame &)>;

/*!
  Runs a tracker over every \e step -th frame. The first frame starts the tracker and is no record.
  \param tracker Any state; it is started anew.
  \param progress Called after each frame.
  \param startPose Of all starts; none: they are at the truth.
  \throw vpException naming the image that cannot be read; nothing else.
*/
std::vector<FrameRecord> runProtocol(const Sequence &sequence, ImageStore &images, BenchTracker &tracker,
                                     const PoseErrorMeasure &measure, Protocol protocol, int step,
                                     const std::function<void()> &progress, const StartPose &startPose = nullptr);

//! Number of frames that runProtocol() tracks.
std::size_t trackedFrames(const Sequence &sequence, int step);

} // namespace bench
#endif
