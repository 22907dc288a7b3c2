// SPDX-License-Identifier: GPL-2.0-or-later
#include "generate/scene.h"

#include <visp3/core/vpException.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>

namespace bench {

std::string sceneName(const SceneOptions &options)
{
  const std::vector<std::string> names = objectNames();
  if (std::find(names.begin(), names.end(), options.object) != names.end()) {
    return options.object + "_" + options.variant;
  }
  std::string stem = options.object.substr(options.object.find_last_of("/\\") + 1);
  return stem.substr(0, stem.find_last_of('.')) + "_" + options.variant;
}

std::vector<BopFrame> generateScene(const SceneOptions &options, const std::function<void(int)> &progress)
{
  const Scene scene(options);
  const BopSceneWriter writer(options.dataset, sceneName(options), scene.objectId(), scene.camera().cam);
  std::vector<BopFrame> truth(static_cast<std::size_t>(options.frames));
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
  const int jobs = std::max(options.jobs, options.variant == "blur" ? 2 : 1);
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
  return truth;
}

} // namespace bench
