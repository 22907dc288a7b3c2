// SPDX-License-Identifier: GPL-2.0-or-later
#include "generate/scene.h"

#include "frames/filePattern.h"
#include "frames/imageFile.h"
#include "frames/videoFile.h"
#include "generate/variants.h"

#include <visp3/core/vpException.h>
#include <visp3/se3/vpExactNumber.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <sstream>
#include <thread>

namespace bench {

namespace {
std::string stemOf(const std::string &file)
{
  const std::string name = file.substr(file.find_last_of("/\\") + 1);
  return name.substr(0, name.find_last_of('.'));
}

bool contains(const std::vector<std::string> &names, const std::string &name)
{
  return std::find(names.begin(), names.end(), name) != names.end();
}

// Such as "handheld" and "handheld2"; nothing for what is usual.
std::string motionText(const SceneOptions &options)
{
  std::ostringstream text;
  if (options.motion != "smooth" || vpIsOther(options.motionScale, 1.)) {
    text << "_" << (contains(motionNames(), options.motion) ? options.motion : stemOf(options.motion));
  }
  if (vpIsOther(options.motionScale, 1.)) {
    text << options.motionScale;
  }
  return text.str();
}

// Their names; "webcam" for all of them.
std::string effectText(const SceneOptions &options)
{
  if (options.effects.empty()) {
    return "";
  }
  if (options.effects.size() == effectNames().size()) {
    return "_webcam";
  }
  std::string text;
  for (const std::string &effect : options.effects) {
    text += (text.empty() ? "_" : "+") + effect;
  }
  return text;
}

// Of the images that were written, since threads render them in any order.
void writeVideo(const SceneOptions &options)
{
  const double framesPerSecond = 25.; // As --help says.
  const std::string scene = options.dataset + "/" + sceneName(options);
  const std::string extension = options.jpegQuality > 0 ? ".jpg" : ".png";
  programs::VideoFile video("--video", scene + ".mp4", framesPerSecond);
  const programs::FilePattern images(scene + "/rgb/%06d" + extension);
  for (int frame = 0; frame < options.frames; ++frame) {
    video.write(programs::readColorImage(images.name(frame)), frame);
  }
}
} // namespace

std::string sceneName(const SceneOptions &options)
{
  const std::string object = contains(objectNames(), options.object) ? options.object : stemOf(options.object);
  return object + motionText(options) + effectText(options) + "_" + options.variant;
}

std::vector<programs::BopFrame> generateScene(const SceneOptions &options, const std::function<void(int)> &progress)
{
  const Scene scene(options);
  const programs::BopSceneWriter writer(options.dataset, sceneName(options), scene.objectId(), scene.camera().cam,
                                        options.jpegQuality);
  std::vector<programs::BopFrame> truth(static_cast<std::size_t>(options.frames));
  std::atomic<int> next(0);
  std::mutex mutex;
  int finished = 0;
  std::exception_ptr failure;
  const auto work = [&] {
    try {
      ObjectRenderer renderer = scene.makeRenderer();
      for (int frame = next++; frame < options.frames; frame = next++) {
        writer.writeImage(frame, scene.render(frame, renderer, truth[static_cast<std::size_t>(frame)]));
        const std::lock_guard<std::mutex> lock(mutex);
        ++finished;
        if (progress) {
          progress(finished);
        }
      }
    } catch (...) {
      const std::lock_guard<std::mutex> lock(mutex);
      failure = std::current_exception();
      next = options.frames;
    }
  };
  // A blurred image is made of eight, so that a second thread is worth it in any case.
  const int jobs = std::max(options.jobs, hasVariant(options.variant, "blur") ? 2 : 1);
  std::vector<std::thread> threads;
  for (int i = 1; i < jobs; ++i) {
    threads.emplace_back(work);
  }
  work();
  for (std::thread &thread : threads) {
    thread.join();
  }
  if (failure) {
    std::rethrow_exception(failure);
  }
  writer.writeTruth(truth);
  if (options.video) {
    writeVideo(options);
  }
  return truth;
}

} // namespace bench
