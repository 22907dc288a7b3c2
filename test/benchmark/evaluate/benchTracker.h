// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef benchTracker_h
#define benchTracker_h

#include "dataset/sequence.h"

#include <visp3/core/vpImage.h>
#include <visp3/core/vpRGBa.h>
#include <visp3/multicue/vpTrackingState.h>

#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace bench {

//! An image as trackers want it, both filled.
struct BenchImage
{
  vpImage<vpRGBa> color;
  vpImage<unsigned char> gray;
  bool isGray = false; //!< Trackers are to see the gray one.
};

//! What a tracker says after an image.
struct TrackerAnswer
{
  vpHomogeneousMatrix cMo;
  vpTrackingState state = vpTrackingState::LOST;
  double score = std::numeric_limits<double>::quiet_NaN(); //!< [0, 1]; not a number where the tracker has none.
  std::vector<double> stages;                              //!< Milliseconds, in the order of BenchTracker::stages().
  //! Pose hypotheses that were minimised; not a number where the tracker knows none.
  double minimisations = std::numeric_limits<double>::quiet_NaN();
};

//! A tracker under test. What an image shows does not make it throw.
class BenchTracker
{
public:
  virtual ~BenchTracker() = default;
  virtual void init(const BenchImage &I, const vpHomogeneousMatrix &cMo) = 0;
  /*!
    Starts at a pose that is not exact. A tracker that knows nothing better takes it as it is.
    \param angleDeviation Of its rotation about the object's centre, radians. \param translationDeviation Metres.
  */
  virtual void startRoughly(const BenchImage &I, const vpHomogeneousMatrix &cMo, double angleDeviation,
                            double translationDeviation);
  /*!
    Starts without a pose.
    \param nearest, farthest Range of the object's distance, metres; 0: the tracker's default.
    \return True where a pose was accepted. \throw vpException where the tracker cannot do so.
  */
  virtual bool startAnywhere(const BenchImage &I, double nearest, double farthest);
  //! The only call whose time is measured.
  virtual void track(const BenchImage &I) = 0;
  virtual TrackerAnswer answer() = 0;
  //! Why the state is what it is, as a sentence; may be empty.
  virtual std::string text() const { return ""; }
  //! Names of the stages that are timed one by one; may be empty.
  virtual std::vector<std::string> stages() const { return {}; }
};

//! Names that makeTracker() knows, ours first.
std::vector<std::string> trackerNames();
//! The same in one text, separated by commas.
std::string trackerNamesText();
//! \throw vpException naming the first one that makeTracker() does not know.
void requireTrackers(const std::vector<std::string> &names);
//! \return Sum of the types of kinds of cues, 0 for no name. \throw vpException naming what is no kind.
int cuesNamed(const std::vector<std::string> &names);

/*!
  \param name One of trackerNames().
  \param object Its model is loaded: the mesh where there is one for ours, the .cao for ViSP's.
  \param cam Camera of the whole sequence.
  \param config ViSP's XML or our JSON, read on top of the benchmark's settings; empty for none. Its camera is not used.
  \param cues Sum of the types of the cues that trackers of ours use; 0: as they have them.
  \throw vpException naming the tracker where it is unknown or the object lacks the model that it needs, or what the
  tracker says of its files.
*/
std::unique_ptr<BenchTracker> makeTracker(const std::string &name, const SequenceObject &object,
                                          const vpCameraParameters &cam, const std::string &config, int cues = 0);

//! \return True where the tracker needs a .cao model.
bool needsCao(const std::string &name);

} // namespace bench
#endif
