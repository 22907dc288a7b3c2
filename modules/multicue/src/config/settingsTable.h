// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef settingsTable_h
#define settingsTable_h

#include <visp3/multicue/vpMultiCueSettings.h>

#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

BEGIN_VISP_NAMESPACE
namespace vpSettingsDetail {
//! The camera in parts, because vpCameraParameters takes them all at once only.
struct CameraParts
{
  static CameraParts of(const vpCameraParameters &camera);
  vpCameraParameters camera() const;
  bool operator==(const CameraParts &other) const;

  double px, py, u0, v0;
  std::optional<double> kud, kdu; // None of both: a camera without distortion.
};

//! A sum of cues, which files write as a list of names.
struct CueSum
{
  int sum;
};

//! Settings of which every single value can be set.
struct Draft
{
  explicit Draft(const vpMultiCueSettings &settings);
  //! The camera is the one that the draft was made from unless a part of it was changed.
  vpMultiCueSettings settings() const;
  void setPreset(vpMultiCuePreset preset);
  //! Says the cues by switches, those in which they differ from a preset's.
  void sayCuesBeside(vpMultiCuePreset preset);

  vpMultiCueSettings members;
  CameraParts camera;
  CueSum cues;
  // Cues that a file switches on or off beside this sum.
  std::optional<bool> usesEdges, usesPoints, usesColors;
  std::optional<vpMultiCuePreset> preset; //!< That a file said.
  std::set<std::string> said;             //!< Names of the entries that a file said.
  vpConfigReport report;
};

//! The values that a setting can have.
struct Range
{
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool lowIncluded = true;
  const char *unit = ""; // With a space before it; of a text, all that is to be said of it.

  bool contains(double value) const;
  //! \return For instance "a whole number in [3, 15] pixels". \param noun "number" or "whole number".
  std::string describe(const std::string &noun) const;
};

//! A function for each type that a setting can have, which gives its place in a draft.
using Place = std::variant<double &(*)(Draft &), std::optional<double> &(*)(Draft &), std::optional<bool> &(*)(Draft &),
                           std::map<int, double> &(*)(Draft &), vpEstimationSettings::Method &(*)(Draft &),
                           vpModelRenderer::Preference &(*)(Draft &), int &(*)(Draft &), unsigned int &(*)(Draft &),
                           bool &(*)(Draft &), std::vector<unsigned int> &(*)(Draft &),
                           std::vector<double> &(*)(Draft &), vpColorCueSettings::Rows &(*)(Draft &),
                           vpParticleSettings::NoiseFrame &(*)(Draft &), vpParticleSettings::Motion &(*)(Draft &),
                           vpParticleSettings::Output &(*)(Draft &), CueSum &(*)(Draft &), std::string &(*)(Draft &)>;

//! The words for a value that is one of several or, for CueSum, a sum of them.
using Words = std::vector<std::pair<std::string, int>>;
//! The argument only says which of them.
const Words &wordsOf(vpColorCueSettings::Rows);
const Words &wordsOf(vpParticleSettings::NoiseFrame);
const Words &wordsOf(vpParticleSettings::Motion);
const Words &wordsOf(vpParticleSettings::Output);
const Words &wordsOf(vpEstimationSettings::Method);
const Words &wordsOf(vpModelRenderer::Preference);
//! Of all kinds of cues that there are.
Words cueWords();
std::vector<std::string> namesOf(const Words &words);

//! One setting: the name it has in a file, where it is kept, and what it can be.
struct Entry
{
  const char *object;
  const char *key; //!< Empty where the value stands for the object.
  Place place;
  Range range;

  //! \return For instance "edge.range".
  std::string name() const;
  //! \return Its values, false and true as 0 and 1, those of a list in a row; none for a distortion that the camera
  //! does not have, and for words.
  std::vector<double> values(Draft &draft) const;
  //! \return False for a distortion that the camera does not have, and for a cue that was not switched.
  bool isSet(Draft &draft) const;
  //! \return The words that it can be, where it is words.
  std::vector<std::string> words() const;
  //! \return What is to be written for it, for instance "true or false".
  std::string describe() const;
};

//! Every setting that a file can hold, those of one object in a row.
const std::vector<Entry> &settingsTable();
//! \return The entry with this name, which has to exist.
const Entry &settingsEntry(std::string_view name);
} // namespace vpSettingsDetail
END_VISP_NAMESPACE
#endif
