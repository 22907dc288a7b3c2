// SPDX-License-Identifier: GPL-2.0-or-later
#include "generate/generateOptions.h"

#include <visp3/core/vpException.h>
#include <visp3/model/vpModelReader.h>

#include <algorithm>
#include <iostream>
#include <sstream>

namespace bench {
namespace {
const char *const help =
    "Renders image sequences of moving objects with their true poses, in BOP's layout.\n"
    "\n"
    "multicue-generate --object LIST --variant LIST --out DIR [options]\n"
    "  --object LIST      box, bands, window, satellite, figurine, the path of a mesh, or all; separated by commas\n"
    "  --variant LIST     regular, light, noise, occlusion, blur, blackout, exit, or all; separated by commas\n"
    "  --out DIR          folder of the data set\n"
    "  --frames N         images of each sequence (300)\n"
    "  --seed N           the same seed gives the same images (1)\n"
    "  --background KIND  photo, plain or space (space for the satellite, photo for the others)\n"
    "  --size WxH         pixels of the images (640x480)\n"
    "  --unit METRES      metres per unit of a mesh: 1, 0.01, 0.001 (1)\n"
    "  --jobs N           threads (1; 2 for blur)\n"
    "  --help             this text\n";

[[noreturn]] void refuse(const std::string &option, const std::string &value, const char *expected)
{
  throw vpException(vpException::badValue, "%s cannot be '%s': give %s", option.c_str(), value.c_str(), expected);
}

template <typename Number> Number number(const std::string &option, const std::string &value, const char *expected)
{
  std::istringstream in(value);
  Number result{};
  if (value.find('-') != std::string::npos || !(in >> result) || in.peek() != std::istringstream::traits_type::eof() ||
      (option != "--seed" && !(result > Number{}))) {
    refuse(option, value, expected);
  }
  return result;
}

std::vector<std::string> names(const std::string &option, const std::string &value, const std::vector<std::string> &all,
                               bool meshes)
{
  std::vector<std::string> list;
  std::istringstream in(value);
  for (std::string name; std::getline(in, name, ',');) {
    if (name == "all") {
      list.insert(list.end(), all.begin(), all.end());
    } else if (std::find(all.begin(), all.end(), name) != all.end() || (meshes && vpModelReader::isMesh(name))) {
      list.push_back(name);
    } else {
      refuse(option, name, meshes ? "names that --help lists, or the path of a mesh" : "names that --help lists");
    }
  }
  if (list.empty()) {
    refuse(option, value, "at least one name");
  }
  return list;
}

void setSize(const std::string &value, SceneOptions &scene)
{
  const char *const expected = "width and height in pixels, such as 640x480";
  const std::size_t cross = value.find('x');
  if (cross == std::string::npos) {
    refuse("--size", value, expected);
  }
  scene.width = number<unsigned int>("--size", value.substr(0, cross), expected);
  scene.height = number<unsigned int>("--size", value.substr(cross + 1), expected);
}

void set(const std::string &option, const std::string &value, GenerateOptions &options)
{
  SceneOptions &scene = options.scene;
  if (option == "--object") {
    options.objects = names(option, value, objectNames(), true);
  } else if (option == "--variant") {
    options.variants = names(option, value, variantNames(), false);
  } else if (option == "--out") {
    scene.dataset = value;
  } else if (option == "--frames") {
    scene.frames = number<int>(option, value, "a number of images of at least 2");
  } else if (option == "--seed") {
    scene.seed = number<std::uint64_t>(option, value, "a whole number of at least 0");
  } else if (option == "--background") {
    scene.background = names(option, value, {"photo", "plain", "space"}, false).front();
  } else if (option == "--size") {
    setSize(value, scene);
  } else if (option == "--unit") {
    scene.unit = number<double>(option, value, "metres per unit of the mesh, such as 0.001");
  } else if (option == "--jobs") {
    scene.jobs = number<int>(option, value, "a number of threads");
  } else {
    throw vpException(vpException::badValue, "there is no option '%s'; --help lists them", option.c_str());
  }
}
} // namespace

bool GenerateOptions::read(int argc, const char *const argv[])
{
  for (int i = 1; i < argc; ++i) {
    const std::string option = argv[i];
    if (option == "--help" || option == "-h") {
      std::cout << help;
      return false;
    }
    if (option.rfind("--", 0) != 0) {
      throw vpException(vpException::badValue, "'%s' is no option; --help lists them", option.c_str());
    }
    if (i + 1 == argc) {
      throw vpException(vpException::badValue, "%s needs a value; --help lists the options", option.c_str());
    }
    set(option, argv[++i], *this);
  }
  if (objects.empty() || variants.empty() || scene.dataset.empty()) {
    throw vpException(vpException::badValue, "give --object, --variant and --out; --help tells what they may be");
  }
  return true;
}

} // namespace bench
