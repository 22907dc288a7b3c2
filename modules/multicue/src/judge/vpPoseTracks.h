// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpPoseTracks_h
#define vpPoseTracks_h

#include "judge/vpContourEvidence.h"
#include "judge/vpPoseBelief.h"

#include <visp3/core/vpHomogeneousMatrix.h>

#include <cmath>
#include <functional>
#include <vector>

BEGIN_VISP_NAMESPACE

/*!
  Poses that are followed side by side from frame to frame, after a loss and until one of them is confirmed.

  One image may show more at a wrong pose than at the right one, the next ones hardly do. Poses are compared by the
  logarithm of their odds, which takes in what each frame says of them; those before count less and less, since frames
  on end are alike:
  \f[ \ell_t = \max(k \ell_{t-1}, 0) + v_t \f]
  A pose that was unlikely and is likely now is as good as one that was found now. How far a pose is from where the
  object was is taken off once.
*/
class vpPoseTracks
{
public:
  //! True where two poses are the same one, or look alike.
  using Same = std::function<bool(const vpHomogeneousMatrix &c1Mo, const vpHomogeneousMatrix &c2Mo)>;

  //! How much of the object is in the image at a pose.
  enum class Seen
  {
    LITTLE, //!< What others would have to explain is not in the image.
    ENOUGH, //!< Others may be told from it in the next frames.
    WELL    //!< One image tells others from it.
  };

  //! Value that a frame has to have that confirms a pose.
  static constexpr double confirming = 0.75;

  struct Track
  {
    vpHomogeneousMatrix cMo;
    vpHomogeneousMatrix before; //!< In the frame before; the same where there was none.
    double odds = 0.;           //!< By the frames before, as a logarithm.
    unsigned int frames = 0;    //!< In which it was seen.
    double explained = 0.;      //!< In this frame.
    double value = 0.;          //!< What this frame adds to the odds.
    double change = HUGE_VAL;   //!< Least penalty for how far it is from where the object was.
    vpContourEvidence contours; //!< In this frame.
    double behind = 0.;         //!< The first one, by contours that only one of them has; as a logarithm of odds.
    bool isSeen = false;
    vpPoseBelief belief;
    unsigned int confirmations = 0; //!< Frames on end that explained it.
    unsigned int ahead = 0;         //!< Frames on end in which no other one came near.
    unsigned int compared = 0;      //!< Frames since others were looked for; 0 where they were not.
    //! By the images and where it is, which counts once.
    double standing() const { return odds - change; }
    //! The same, by this frame alone.
    double now() const { return value - change; }
  };

  void clear();
  bool empty() const { return m_tracks.empty(); }
  const std::vector<Track> &tracks() const { return m_tracks; }
  //! The first one: a pose that was followed until now. \param before Where it was a frame earlier; the same where that
  //! is unknown. \param belief What the frames before say of it.
  void begin(const vpHomogeneousMatrix &cMo, const vpHomogeneousMatrix &before, const vpPoseBelief &belief);
  //! The attempts to come start from this track, or from none of them.
  void follow(std::size_t index) { m_followed = index; }
  //! From the one with this pose, if there is one.
  void follow(const vpHomogeneousMatrix &cMo, const Same &isSame) { m_followed = indexOf(cMo, isSame); }
  void followNone() { m_followed = none; }
  //! What the attempts of this frame that started from the followed track explain; less than any pose where there is
  //! none.
  double followedValue() const;
  /*!
    A pose that was estimated in this frame. \return What to compare it by: the logarithm of its odds.
    \param explained By it in this frame. \param value What that adds to its odds. \param change Penalty for how far it
    is from where the object was: of a pose that is followed, the least one counts, as it moves with the object.
    \param contours What is there of its own.
  */
  double add(const vpHomogeneousMatrix &cMo, double explained, double value, double change, const Same &isSame,
             const vpContourEvidence &contours = vpContourEvidence());
  //! Other poses were looked for in all of this image.
  void noteSearch() { m_hasSearched = m_hasOthers = true; }
  //! Other poses were looked for, as far as there was time for it.
  void noteOthers() { m_hasOthers = true; }
  //! Ends the frame: the track of this pose comes first, some others are kept where they are as good.
  void choose(const vpHomogeneousMatrix &cMo, Seen seen, const Same &isSame);
  //! The first one; there is one after choose().
  Track &chosen() { return m_tracks.front(); }
  //! True where another one explains as much.
  bool isContested() const;
  //! True where others were looked for since enough of the first one is seen.
  bool wasCompared() const { return !m_tracks.empty() && m_tracks.front().compared > 0; }
  //! The same, and those that were found had some frames to show that they are better.
  bool isCompared() const;
  //! By how much the odds of the first one are better than those of the second, as a logarithm, in a frame in which
  //! others were looked for; 0 in the rest.
  double lead() const { return m_lead; }
  //! Frames on end in which no other one came near to the first.
  unsigned int ahead() const { return m_tracks.empty() ? 0 : m_tracks.front().ahead; }

private:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  std::size_t indexOf(const vpHomogeneousMatrix &cMo, const Same &isSame) const;
  void endFrame();
  void compareContours();
  void dropDoubles(const Same &isSame);

  std::vector<Track> m_tracks;
  std::size_t m_followed = none;
  bool m_hasSearched = false; // In this frame.
  bool m_hasOthers = false;   // The same.
  double m_lead = 0.;
};

END_VISP_NAMESPACE
#endif
