// SPDX-License-Identifier: GPL-2.0-or-later
/*!
  \file multicue-generate.cpp
  Renders image sequences of moving objects with their true poses.
*/
#include "generate/generateOptions.h"

#include "program/progressBar.h"
#include "program/runProgram.h"

#include <visp3/core/vpTime.h>

#include <iostream>
#include <memory>

namespace {
void generate(const bench::SceneOptions &options)
{
  const std::string name = bench::sceneName(options);
  const double begin = vpTime::measureTimeMs();
  auto bar = std::make_unique<bench::ProgressBar>(static_cast<std::size_t>(options.frames));
  bar->setText(name);
  bench::generateScene(options, [&bar](int) { bar->advance(1); });
  bar.reset(); // Before the line that stays.
  std::cerr << name << ": " << options.frames << " images in " << (vpTime::measureTimeMs() - begin) / 1000. << " s"
            << std::endl;
}
} // namespace

int main(int argc, const char *argv[])
{
  return programs::runProgram([&] {
    bench::GenerateOptions options;
    if (!options.read(argc, argv)) {
      return 0;
    }
    for (const std::string &object : options.objects) {
      for (const std::string &variant : options.variants) {
        bench::SceneOptions scene = options.scene;
        scene.object = object;
        scene.variant = variant;
        generate(scene);
      }
    }
    return 0;
  });
}
