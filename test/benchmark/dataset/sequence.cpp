// SPDX-License-Identifier: GPL-2.0-or-later
#include "dataset/sequence.h"

#include "dataset/bopReader.h"
#include "dataset/datasetFiles.h"
#include "dataset/rbotReader.h"
#include "dataset/recordingReader.h"

#include <algorithm>

namespace bench {
namespace {
// True where a user may mean a scene by this name: its last folder, or that one's number.
bool isShortNameOf(const std::string &name, const std::string &scene)
{
  const std::string folder = scene.substr(scene.rfind('/') + 1);
  const std::string last = folder.substr(0, folder.find('@')); // A sensor's name may follow.
  return name == folder || name == last || (numberOf(name) >= 0 && numberOf(name) == numberOf(last));
}

std::string findScene(const std::string &dataset, const std::string &name)
{
  const std::vector<std::string> scenes = listScenes(dataset);
  if (std::find(scenes.begin(), scenes.end(), name) != scenes.end()) {
    return name;
  }
  std::vector<std::string> meant;
  std::copy_if(scenes.begin(), scenes.end(), std::back_inserter(meant),
               [&](const std::string &scene) { return isShortNameOf(name, scene); });
  if (meant.empty()) {
    fail(inQuotes(dataset) + " has no scene '" + name + "'; there is: " + listed(scenes));
  }
  if (meant.size() > 1) {
    fail(inQuotes(dataset) + " has several scenes '" + name + "', say which one: " + listed(meant));
  }
  return meant.front();
}
} // namespace

std::vector<std::string> listScenes(const std::string &dataset)
{
  const std::vector<std::string> scenes =
      rbotReader::isDataset(dataset) ? rbotReader::scenes(dataset) : bopReader::scenes(dataset);
  if (scenes.empty()) {
    fail("The folder " + inQuotes(dataset) +
         " has no scene: neither scene_gt.json (BOP) nor poses_first.txt with <object>/frames (RBOT) is there");
  }
  return scenes;
}

Sequence openSequence(const std::string &dataset, const std::string &scene, int object)
{
  const std::string name = findScene(dataset, scene);
  return rbotReader::isDataset(dataset) ? rbotReader::open(dataset, name, object)
                                        : bopReader::open(dataset, name, object);
}

Sequence openRecording(const Recording &recording)
{
  return recordingReader::open(recording);
}

} // namespace bench
