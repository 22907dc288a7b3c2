// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef benchStateFigures_h
#define benchStateFigures_h

#include "evaluate/protocol.h"

#include <array>

namespace bench {

//! A pose with the tracker's score for it, [0, 1], and whether it is right.
struct ScoredPose
{
  double score = 0.;
  bool right = false;
};

//! A place of the ROC curve: how many poses a threshold of the score lets pass.
struct RocPoint
{
  double wrong = 0.; //!< Share of the wrong poses with at least this score.
  double right = 0.; //!< Share of the right ones.
};

//! Poses with nearly the same score.
struct ReliabilityBin
{
  std::size_t count = 0;
  double score = 0.; //!< Mean; not a number where there is none.
  double right = 0.; //!< Share; not a number where there is none.
};

constexpr std::size_t reliabilityBins = 10;
using Reliability = std::array<ReliabilityBin, reliabilityBins>;

//! \return Probability that a right pose has a larger score than a wrong one, equal scores counting half (mid-ranks):
//! the area under the ROC curve. Not a number where there are no right or no wrong poses.
double rocArea(std::vector<ScoredPose> poses);
//! \return The curve from (0, 0) to (1, 1), \e most points at most, or none where rocArea() is not a number.
std::vector<RocPoint> rocCurve(std::vector<ScoredPose> poses, std::size_t most = 200);
//! \return Bins of equal width over [0, 1].
Reliability reliability(const std::vector<ScoredPose> &poses);
//! \return Mean distance of score and share of right poses over the bins, weighted by count: the expected calibration
//! error. Not a number where there is no pose.
double calibrationError(const Reliability &bins);

//! What the tracker did after the object was hidden, or after it was lost.
struct Recovery
{
  int frame = -1;      //!< The first one that showed the object again, or the first wrong one of a loss.
  int frames = -1;     //!< Tracked frames from there to the first of five right ones; -1: it was not found again.
  bool hidden = false; //!< The object was hidden; else it was lost in full view.
};

/*!
  A stretch begins with a frame that does not count, or with 5 counted ones on end that are not right; it ends with 5
  counted ones on end that are right. Where the images end before that, or the object is hidden again, which begins
  another stretch, it was not found; but nothing is said if it could be seen in fewer than 5 frames, or was right in the
  last of them.
  \param records In the order of time, of Protocol::RUN.
*/
std::vector<Recovery> findRecoveries(const std::vector<FrameRecord> &records);

//! How well a tracker knows when it is right, and whether it comes back. Shares are in [0, 1]; what has no value is not
//! a number.
struct StateFigures
{
  //! Over a set of frames.
  struct Frames
  {
    std::size_t count = 0;
    double falseTracking = 0.; //!< Share whose state is TRACKING and whose pose is not right.
    double rocArea = 0.;
    double calibrationError = 0.;
  };
  Frames counted;            //!< Frames that show enough of the object.
  Frames known;              //!< All with a truth, those that hardly show the object too.
  double lostWhileRight = 0; //!< Share of the counted frames whose state is LOST and whose pose is right.
  Reliability bins;          //!< Of the counted frames.
  std::vector<RocPoint> roc; //!< Of the counted frames.

  std::size_t recoveries = 0; //!< Of protocol run.
  double recovered = 0.;      //!< Share that ended with the object found.
  double recoveredSoon = 0.;  //!< Share that did so within soonFrames.
  double recoveryFrames = 0.; //!< Median over those that ended.
  std::size_t occlusions = 0; //!< Runs of protocol run on scenes named *_occlusion.
  double heldThroughout = 0.; //!< Share of them without a loss.
};

//! An object is found soon within this many tracked frames.
constexpr int soonFrames = 10;

//! Collects the frames of one run, or of several, for their figures.
class StatePool
{
public:
  void add(const std::string &scene, Protocol protocol, const std::vector<FrameRecord> &records);
  StateFigures figures() const;

private:
  struct Frames
  {
    std::size_t count = 0;
    std::size_t falseTracking = 0;
    std::vector<ScoredPose> poses; // That have a score.

    void add(const FrameRecord &record);
    StateFigures::Frames figures() const;
  };

  Frames m_counted;
  Frames m_known;
  std::size_t m_lostWhileRight = 0;
  std::vector<Recovery> m_recoveries;
  std::size_t m_occlusions = 0;
  std::size_t m_held = 0;
};

} // namespace bench
#endif
