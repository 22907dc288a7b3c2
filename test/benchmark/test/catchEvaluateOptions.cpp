// SPDX-License-Identifier: GPL-2.0-or-later
#include "evaluate/benchTracker.h"
#include "evaluate/evaluateOptions.h"

#include <catchMain.h>
#include <exceptionMessage.h>

#include <visp3/multicue/vpMbMultiCueTracker.h>

using namespace bench;

namespace {
EvaluateOptions read(const std::vector<const char *> &more)
{
  std::vector<const char *> arguments = {"multicue-evaluate", "--dataset", "d", "--scene", "s", "--out", "o"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  EvaluateOptions options;
  options.read(static_cast<int>(arguments.size()), arguments.data());
  return options;
}

std::string refusalOf(const std::vector<const char *> &more)
{
  return messageOf([&more] { read(more); });
}
} // namespace

TEST_CASE("Cues are named as in configurations", "[evaluate-options]")
{
  const EvaluateOptions options = read({"--tracker", "multicue", "--cues", "color,edge"});
  CHECK(cuesNamed(options.cues) == (vpMbMultiCueTracker::EDGE_TRACKER | vpMbMultiCueTracker::COLOR_TRACKER));
  CHECK(cuesNamed({}) == 0);
}

TEST_CASE("Cues and trackers that there are not are refused by name, with those that there are", "[evaluate-options]")
{
  const std::string cue = refusalOf({"--tracker", "multicue", "--cues", "edge,colour"});
  CHECK(cue.find("'colour'") != std::string::npos);
  CHECK(cue.find("edge, color, point") != std::string::npos);
  const std::string tracker = refusalOf({"--tracker", "multicue,nothing"});
  CHECK(tracker.find("'nothing'") != std::string::npos);
  CHECK(tracker.find("robust") != std::string::npos);
}
