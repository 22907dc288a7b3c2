// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef benchEvaluation_h
#define benchEvaluation_h

#include "evaluate/evaluateOptions.h"
#include "evaluate/runFiles.h"

namespace bench {

//! Something that could not be run, and why.
struct Failure
{
  std::string what; //!< Scene, or scene and tracker.
  std::string why;
};

//! All that the report is made of.
struct Evaluation
{
  std::vector<Sequence> sequences; //!< The scenes that could be opened.
  std::vector<RunResult> runs;     //!< By scene, tracker, protocol and step, in the order in which they were asked for.
  std::vector<Failure> failures;
  std::vector<Failure> skipped; //!< Trackers that the object has no model for, and notes of sequences.

  //! \return The sequence of a run.
  const Sequence &sequenceOf(const RunResult &run) const;
};

/*!
  Runs everything that was asked for. A scene that is broken, or a tracker that crashes, is a failure in the result and
  does not keep the others from being run.
  \throw vpException where no scene can be opened at all, or the folder of the results cannot be written.
*/
Evaluation evaluate(const EvaluateOptions &options);

//! The object's model as its errors are measured, and overlays drawn, with: the mesh where there is one, else the .cao.
std::shared_ptr<const vpTrackedModel> loadModel(const SequenceObject &object);

//! \return True where focal lengths and principal points are equal.
bool sameCamera(const vpCameraParameters &a, const vpCameraParameters &b);

} // namespace bench
#endif
