// SPDX-License-Identifier: GPL-2.0-or-later
/*!
  \file multicue-generate.cpp
  Renders image sequences of moving objects with their true poses.
*/
#include "generate/generateOptions.h"

#include <visp3/core/vpTime.h>

#include <iostream>

#if defined(__unix__) || defined(__APPLE__)
#include <unistd.h>
#endif

namespace {
bool isTerminal()
{
#if defined(__unix__) || defined(__APPLE__)
  return isatty(STDERR_FILENO) != 0;
#else
  return false;
#endif
}

void showBar(const std::string &name, int finished, int frames)
{
  const int width = 40;
  const int done = width * finished / frames;
  std::cerr << "\r" << name << " [" << std::string(static_cast<std::size_t>(done), '#')
            << std::string(static_cast<std::size_t>(width - done), ' ') << "] " << finished << "/" << frames
            << std::flush;
}

void generate(const bench::SceneOptions &options)
{
  const std::string name = bench::sceneName(options);
  const bool bar = isTerminal();
  const double begin = vpTime::measureTimeMs();
  bench::generateScene(options, [&](int finished) {
    if (bar) {
      showBar(name, finished, options.frames);
    }
  });
  std::cerr << (bar ? "\r" + std::string(80, ' ') + "\r" : "") << name << ": " << options.frames << " images in "
            << (vpTime::measureTimeMs() - begin) / 1000. << " s" << std::endl;
}
} // namespace

int main(int argc, const char *argv[])
{
  try {
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
  } catch (const std::exception &e) {
    std::cerr << "multicue-generate: " << e.what() << std::endl;
    return 1;
  }
  return 0;
}
