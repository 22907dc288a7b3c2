// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpTrackerParticles_h
#define vpTrackerParticles_h

#include <visp3/multicue/vpParticleSettings.h>
#include <visp3/multicue/vpTrackingTimings.h>
#include <visp3/se3/vpPoseParticleFilter.h>

#include <array>
#include <vector>

BEGIN_VISP_NAMESPACE

// A pose beside the one that is followed, which may turn out to be the right one; of the frame b, too.
struct vpRivalPose
{
  vpHomogeneousMatrix cMb;
  double residue = 0.; // Pixels.
  double lead = 0.;    // How much better it explained the frames up to now.
};

/*
  The particles of a tracker: noise and weights, without images. All poses are those of a frame b at the middle of the
  object's box, so that noise in the object's frame turns the object about its middle.
*/
class vpTrackerParticles
{
public:
  // What is known of a pose whose likelihood vanishes.
  static constexpr double impossible = -1.;

  // Throws where one is out of range.
  void setSettings(const vpParticleSettings &settings);
  const vpParticleSettings &settings() const { return m_settings; }
  void clear();

  // About a pose. diameter: of the object, metres.
  void restart(const vpHomogeneousMatrix &cMb, double diameter);
  // Moves all particles. surprise: mean squared distance of the object from where it was expected, in diameters and
  // radians. bMp: how the object is expected to move.
  void move(double dt, const vpHomogeneousMatrix &bMp, const std::array<double, 2> &surprise, double diameter);
  // Distances of all particles and of the proposals, in any unit; impossible where there is none ([T10] eq. 12).
  // Returns false where all are impossible.
  bool weighDistances(const std::vector<double> &distances, const std::vector<vpHomogeneousMatrix> &proposals,
                      const std::vector<double> &proposalDistances);
  // The same with logarithms of likelihoods.
  bool weigh(const std::vector<double> &logs, const std::vector<vpHomogeneousMatrix> &proposals,
             const std::vector<double> &proposalLogs);
  void findModes(double diameter);
  // The particles that are worth to be optimised, the best first, none near another one or to cMb, at most as many.
  std::vector<std::size_t> best(const std::vector<double> &distances, const vpHomogeneousMatrix &cMb, double diameter,
                                unsigned int most) const;
  // Squared, 1 is the width of a mode.
  double distance(const vpHomogeneousMatrix &c1Mb, const vpHomogeneousMatrix &c2Mb, double diameter) const;
  // True where one of the predicted ones is near a pose.
  bool reach(const vpHomogeneousMatrix &cMb, double diameter) const;
  // How many particles the time of the last frame allows.
  void adaptNumber(const vpTrackingTimings &timings);
  // Goes on from a pose that was found without rivals.
  void follow(const vpHomogeneousMatrix &cMb);
  // While the object is lost.
  void widen();
  void narrow() { m_spread = 1.; }

  const vpPoseParticleFilter &filter() const { return m_filter; }
  bool isStarted() const { return m_filter.isStarted(); }
  const std::vector<vpPoseMode> &modes() const { return m_modes; }
  const vpHomogeneousMatrix &mean() const { return m_mean; }

  // Scratch memory of the tracker, which is used again.
  std::vector<double> values;
  std::vector<double> proposalValues;
  std::vector<vpHomogeneousMatrix> proposals;
  std::vector<double> residues;           // Of the proposals, pixels.
  std::vector<vpRivalPose> rivals;        // The best one first.
  std::vector<vpHomogeneousMatrix> found; // By the search.
  vpHomogeneousMatrix followed;           // Last pose of the object.
  vpHomogeneousMatrix followedMotion;     // To it, from the one before.
  vpHomogeneousMatrix explained;          // Last pose that the image showed well.
  bool isCalm = false;                    // The last frame was explained, and by no rival better.
  // What a frame started from.
  struct Before
  {
    bool isCalm = false;
    std::uint64_t draws = 0;         // Of the tracker.
    std::uint64_t particleDraws = 0; // See draws.
    vpHomogeneousMatrix cMo;
    std::vector<vpRivalPose> rivals; // While it is calm.
  };
  Before before;
  std::vector<char> isViewed;   // Of the view sphere: 1 where a view was made for them since the start.
  unsigned int blindFrames = 0; // On end, without a pose that explains the image.
  std::uint64_t draws = 0;      // As the tracker's.
  unsigned int minimisations = 0;
  unsigned long long frame = 0; // The last one that they have seen.
  bool isDisplayed = false;

private:
  double likelihood(double distance, double least, double range) const;

  vpParticleSettings m_settings;
  vpPoseParticleFilter m_filter;
  std::vector<vpPoseMode> m_modes;
  vpHomogeneousMatrix m_mean;
  std::size_t m_number = 100;
  double m_spread = 1.; // Of the noise.
};

END_VISP_NAMESPACE
#endif
