// SPDX-License-Identifier: GPL-2.0-or-later
#include "generate/generateOptions.h"

#include "generate/variants.h"
#include "program/commandLine.h"

#include <visp3/core/vpException.h>
#include <visp3/model/vpModelReader.h>

#include <algorithm>
#include <sstream>

namespace bench {
namespace {
// The names in a list, "all" replaced by all of them.
std::vector<std::string> expand(const std::string &option, const std::string &value,
                                const std::vector<std::string> &all, bool meshes)
{
  std::vector<std::string> list;
  const auto isKnown = [&all](const std::string &name) { return std::find(all.begin(), all.end(), name) != all.end(); };
  for (const std::string &name : programs::splitList(value)) {
    if (name == "all") {
      list.insert(list.end(), all.begin(), all.end());
    } else if (isKnown(name) || (meshes && vpModelReader::isMesh(name))) {
      list.push_back(name);
    } else {
      throw vpException(vpException::badValue, "%s: '%s' is not one of the names that --help lists%s", option.c_str(),
                        name.c_str(), meshes ? ", nor the name of a mesh file" : "");
    }
  }
  return list;
}

// Those that are joined of several are known where all their parts are.
std::vector<std::string> expandVariants(const std::string &value)
{
  std::vector<std::string> list;
  for (const std::string &name : programs::splitList(value)) {
    if (name.find('+') == std::string::npos) {
      const std::vector<std::string> one = expand("--variant", name, variantNames(), false);
      list.insert(list.end(), one.begin(), one.end());
      continue;
    }
    std::string parts = name;
    std::replace(parts.begin(), parts.end(), '+', ',');
    expand("--variant", parts, variantNames(), false);
    list.push_back(name);
  }
  return list;
}

void setSize(const std::string &value, SceneOptions &scene)
{
  std::istringstream text(value);
  char cross = ' ';
  if (value.find('-') != std::string::npos || !(text >> scene.width >> cross >> scene.height) || cross != 'x' ||
      !(text >> std::ws).eof() || scene.width == 0 || scene.height == 0) {
    throw vpException(vpException::badValue, "--size: '%s' is not a width and a height in pixels, such as 640x480",
                      value.c_str());
  }
}

void setSeed(const std::string &value, SceneOptions &scene)
{
  std::istringstream text(value);
  if (value.find('-') != std::string::npos || !(text >> scene.seed) || !(text >> std::ws).eof()) {
    throw vpException(vpException::badValue, "--seed: '%s' is not a whole number of at least 0", value.c_str());
  }
}

void addMotion(programs::CommandLine &line, SceneOptions &scene)
{
  line.add("--motion", "smooth, handheld, shaken-camera, or a file with poses in RBOT's format; default smooth",
           scene.motion);
  line.add("--motion-scale", "multiplies the motion from frame to frame; default 1", scene.motionScale);
}

void addImperfections(programs::CommandLine &line, SceneOptions &scene)
{
  line.addSetter(
      "--effects",
      "all, or some of what the variant webcam has: rolling-shutter, exposure, drift, vignetting, defocus, noise, "
      "bayer, jpeg, highlights, soft-shadows",
      [&scene](const std::string &value) { scene.effects = expand("--effects", value, effectNames(), false); });
  line.add("--mesh-error",
           "errors of the mesh that trackers get against the one that is rendered: 1 for those of a scan; default 0",
           scene.meshError);
}
} // namespace

bool GenerateOptions::read(int argc, const char *const argv[])
{
  programs::CommandLine line("Renders image sequences of moving objects with their true poses, in BOP's layout:\n"
                             "multicue-generate --object LIST --variant LIST --out DIR");
  line.addSetter("--object", "box, bands, window, satellite, figurine, the path of a mesh, or all; several with commas",
                 [this](const std::string &value) { objects = expand("--object", value, objectNames(), true); });
  line.addSetter("--variant",
                 "regular, light, noise, occlusion, blur, blackout, exit, webcam, or all; several with commas, in one "
                 "sequence with +: occlusion+blackout",
                 [this](const std::string &value) { variants = expandVariants(value); });
  addMotion(line, scene);
  line.add("--out", "folder of the data set", scene.dataset);
  line.add("--frames", "images of each sequence; default 300", scene.frames, 2);
  line.addSetter("--seed", "the same seed gives the same images; default 1",
                 [this](const std::string &value) { setSeed(value, scene); });
  line.add("--background",
           "photo, wall (with posters), plain or space; default: space for the satellite, photo for the others",
           scene.background);
  line.addSetter("--size", "width and height of the images, pixels; default 640x480",
                 [this](const std::string &value) { setSize(value, scene); });
  line.add("--unit", "metres per unit of a mesh; default 1", scene.unit);
  addImperfections(line, scene);
  line.add("--jpeg", "quality of images in JPEG, 1 to 100; default: images in PNG", scene.jpegQuality, 1);
  line.add("--video", "write each sequence as a video too, at 25 images per second: <scene>.mp4 in --out", scene.video);
  line.add("--jobs", "threads; default 1, 2 for blur", scene.jobs, 1);
  if (!line.read(argc, argv)) {
    return false;
  }
  check();
  return true;
}

void GenerateOptions::check() const
{
  const auto exits = [](const std::string &variant) { return hasVariant(variant, "exit"); };
  if (scene.motion != "smooth" && std::any_of(variants.begin(), variants.end(), exits)) {
    throw vpException(vpException::badValue,
                      "the variant 'exit' has a motion of its own: leave --motion %s out, or list other variants",
                      scene.motion.c_str());
  }
  if (scene.jpegQuality > 100) {
    throw vpException(vpException::badValue, "--jpeg: %d is not from 1 to 100", scene.jpegQuality);
  }
  if (objects.empty() || variants.empty() || scene.dataset.empty()) {
    throw vpException(vpException::badValue, "--object, --variant and --out are needed; --help says more");
  }
}

} // namespace bench
