// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpTrackedCue_h
#define vpTrackedCue_h

#include <visp3/cues/vpPoseCue.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

BEGIN_VISP_NAMESPACE

class vpModelLooks;

//! \ingroup group_multicue
//! What a cue learnt from trusted poses; null for cues that need not go back to it.
using vpCueReference = std::shared_ptr<const void>;

/*!
  \ingroup group_multicue
  A cue as the tracker uses it: what is asked beyond vpPoseCue, whose equations are all that the estimation sees.

  A new cue overrides what is pure here, and what is special about it. vpCueKinds::add() brings it into the trackers,
  see \ref multicue_new_cue. Poses are cMo, metres; what an image shows never makes a cue throw.
*/
class vpTrackedCue
{
public:
  virtual ~vpTrackedCue() = default;

  virtual vpPoseCue &cue() = 0;
  const vpPoseCue &cue() const { return const_cast<vpTrackedCue *>(this)->cue(); }
  //! Features that the last match looked for.
  virtual unsigned int expected() const = 0;
  //! How well the last match agrees with a pose, about 1 at right ones and 0 by chance; none where nothing can be said.
  virtual std::optional<double> agreement(const vpHomogeneousMatrix &cMo, const vpCameraParameters &camera) = 0;
  //! Why the last match gave no equation, as a sentence's beginning.
  virtual std::string missing() const = 0;

  //! The cue is among those of the tracker, or no longer is. \throw vpException where it cannot be had.
  virtual void setUsed(bool /*isUsed*/, vpModelLooks & /*looks*/) {}
  //! Matches in one of the rounds in which all cues take part: 0 is the first; each is a little finer.
  virtual void matchFine(const vpCueFrame &image, const vpModelView &view, unsigned int /*round*/)
  {
    cue().match(image, view);
  }
  //! True where no round after this one is finer.
  virtual bool isFinest(unsigned int /*round*/) const { return true; }
  //! Matches at the pose of a start, to learn what the image shows there. \return False for a cue that needs none.
  virtual bool matchStart(const vpCueFrame &image, const vpModelView &view)
  {
    cue().match(image, view);
    return true;
  }
  //! Learns from a trusted pose. \param weights Robust weights of the last match's rows.
  virtual void learn(const vpHomogeneousMatrix &cMo, const std::vector<double> &weights, vpModelLooks & /*looks*/)
  {
    cue().updateReference(cMo, weights);
  }
  //! The same where the cue had no part in the pose, because it contradicted the others.
  virtual void learnRefused(const vpHomogeneousMatrix & /*cMo*/, const vpCameraParameters & /*camera*/) {}
  //! What it learnt, and back to it.
  virtual vpCueReference reference() const { return nullptr; }
  virtual void recall(const vpCueReference & /*reference*/) {}
  //! The object is lost: what was learnt last may be of something else. It may be looked for, or not.
  virtual void noteLoss(bool /*isSearched*/) {}
  //! A start: forgets all that images taught.
  virtual void forget(vpModelLooks & /*looks*/) { cue().reset(); }
};

END_VISP_NAMESPACE
#endif
