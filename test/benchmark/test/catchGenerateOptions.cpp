// SPDX-License-Identifier: GPL-2.0-or-later
#include <catchMain.h>

#include "generate/generateOptions.h"

#include <visp3/core/vpException.h>

namespace {
bench::GenerateOptions read(std::vector<const char *> arguments)
{
  arguments.insert(arguments.begin(), {"multicue-generate", "--object", "box", "--out", "o"});
  bench::GenerateOptions options;
  options.read(static_cast<int>(arguments.size()), arguments.data());
  return options;
}
} // namespace

TEST_CASE("Motion, effects and errors of the mesh are read, and usual where they are not given")
{
  const bench::GenerateOptions usual = read({"--variant", "regular"});
  CHECK(usual.scene.motion == "smooth");
  CHECK(usual.scene.motionScale == exactly(1.));
  CHECK(usual.scene.effects.empty());
  CHECK(usual.scene.meshError == exactly(0.));
  const bench::GenerateOptions options =
      read({"--variant", "occlusion,webcam", "--motion", "handheld", "--motion-scale", "1.5", "--effects", "bayer,jpeg",
            "--mesh-error", "2"});
  CHECK(options.variants == std::vector<std::string>{"occlusion", "webcam"});
  CHECK(options.scene.motion == "handheld");
  CHECK(options.scene.motionScale == exactly(1.5));
  CHECK(options.scene.effects == std::vector<std::string>{"bayer", "jpeg"});
  CHECK(options.scene.meshError == exactly(2.));
  CHECK(read({"--variant", "regular", "--effects", "all"}).scene.effects == bench::effectNames());
}

TEST_CASE("Wrong options of a sequence are named")
{
  CHECK_THROWS_WITH(read({"--variant", "regular", "--effects", "jpeg,rain"}), ContainsSubstring("--effects: 'rain'"));
  CHECK_THROWS_WITH(read({"--variant", "regular", "--motion-scale", "fast"}), ContainsSubstring("'fast'"));
  CHECK_THROWS_WITH(read({"--variant", "all", "--motion", "handheld"}),
                    ContainsSubstring("'exit'") && ContainsSubstring("handheld"));
  CHECK_THROWS_WITH(read({"--motion", "handheld"}), ContainsSubstring("--variant"));
  CHECK_NOTHROW(read({"--variant", "all"}));
  CHECK(read({"--variant", "occlusion+blackout,noise"}).variants ==
        std::vector<std::string>({"occlusion+blackout", "noise"}));
  CHECK_THROWS_WITH(read({"--variant", "occlusion+rain"}), ContainsSubstring("--variant: 'rain'"));
  CHECK_THROWS_WITH(read({"--variant", "noise+exit", "--motion", "handheld"}), ContainsSubstring("--motion handheld"));
  CHECK_THROWS_WITH(read({"--variant", "regular", "--jpeg", "101"}), ContainsSubstring("--jpeg: 101"));
}
