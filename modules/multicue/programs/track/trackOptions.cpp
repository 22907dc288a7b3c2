// SPDX-License-Identifier: GPL-2.0-or-later
#include "track/trackOptions.h"

#include "program/commandLine.h"
#include "program/lengthUnit.h"
#include "track/trackKeys.h"

#include <visp3/core/vpException.h>
#include <visp3/multicue/vpCueKind.h>
#include <visp3/multicue/vpMultiCuePreset.h>
#include <visp3/se3/vpExactNumber.h>

namespace programs {
namespace {
[[noreturn]] void fail(const std::string &text)
{
  throw vpException(vpException::badValue, text + " (see --help)");
}

std::string joined(const std::vector<std::string> &names)
{
  std::string text;
  for (const std::string &name : names) {
    text += (text.empty() ? "" : ", ") + name;
  }
  return text;
}

std::string cueNames()
{
  std::vector<std::string> names;
  for (const vpCueKind &kind : vpCueKinds::all()) {
    names.push_back(kind.name);
  }
  return joined(names);
}

void addSource(CommandLine &line, FrameSource &source)
{
  line.add("--images", "image files to track in, such as data/image%04d.png", source.images);
  line.add("--video", "video to track in, instead of --images", source.video);
  line.add("--camera", "camera to track in, 0 for the first", source.camera, 0);
  line.add("--first", "number of the first frame", source.first, 0);
  line.add("--last", "number of the last frame", source.last, 0);
  line.add("--step", "take every N-th frame", source.step, 1);
}

void addStart(CommandLine &line, StartOptions &start)
{
  line.add("--init-click", ".init file of 3D points to click on in the first frame", start.click);
  line.add("--init-points", "3D points and their rows and columns in the first frame", start.points);
  line.add("--init-pose", "pose in the first frame: .pos of ViSP, or the rows of a matrix", start.pose);
  line.add("--init-rough", "likewise a pose that may be off: the object is looked for about it", start.rough);
  line.add("--rough-angle", "how far off its turn is, degrees; default 15", start.roughAngle);
  line.add("--rough-offset", "how far off its place is, metres; default a tenth of the model", start.roughOffset);
  line.add("--init-anywhere", "no pose: the object is looked for in all of the image, until one shows it",
           start.anywhere);
  line.add("--nearest", "with it: least distance of the object, metres; default where it fills the image",
           start.nearest);
  line.add("--farthest", "with it: largest distance of the object, metres; default where 1 / 20 of the image's height",
           start.farthest);
  line.add("--init-tag", "number of an AprilTag 36h11 on the object; finds it again, too", start.tag, 0);
  line.add("--tag-size", "side of the tag's black square, metres", start.tagSize);
  line.add("--tag-pose", "file with the tag's pose in the object's frame; default the same frame", start.tagPose);
}
} // namespace

bool TrackOptions::read(int argc, const char *const argv[])
{
  CommandLine line("Tracks an object whose model is known in a video, in images or with a camera.\n\n"
                   "  multicue-track --video box.mp4 --model box.obj --unit mm --config camera.xml \\\n"
                   "    --init-pose box.pos --save seen.mp4 --poses poses.csv");
  addSource(line, source);
  line.add("--model", "model: .cao .wrl .obj .ply .stl .dae .gltf .glb; default: the configuration's", model);
  line.addSetter("--unit", "unit of a mesh file: m (default), cm, mm or inch",
                 [this](const std::string &value) { metresPerUnit = programs::metresPerUnit(value); });
  line.add("--config", "ViSP's .xml or our .json, with the camera's parameters", config);
  line.add("--preset", "settings by purpose: " + joined(vpMultiCuePresetNames()), preset);
  line.add("--cues", "cues to use, with commas: " + cueNames(), cues);
  addStart(line, start);
  line.add("--gray", "track in gray levels; in colour otherwise", gray);
  line.add("--no-display", "open no window", noDisplay);
  line.add("--no-plots", "no plots of pose, score and time beside the image", noPlots);
  line.add("--full-speed", "do not slow a recorded video down to its own speed in the window", fullSpeed);
  line.add("--save", "write what is seen: .mp4, .avi, or images such as out%04d.png", save);
  line.add("--fps", "frames per second of the saved video; default those of the source", framesPerSecond);
  line.add("--record", "folder to record images and poses in, in BOP's layout", record);
  line.add("--poses", "write a .csv of frame, cMo row by row, milliseconds, state and score", poses);
  line.add("--summary", "write times, states and the projection error", summary);
  line.setEpilogue("\nKeys in the window:\n" + keysHelp());
  if (!line.read(argc, argv)) {
    return false;
  }
  check();
  return true;
}

void TrackOptions::check() const
{
  const auto requireOne = [](const std::string &names, int given) {
    if (given != 1) {
      fail("Give one of " + names);
    }
  };
  requireOne("--images, --video and --camera", !source.images.empty() + !source.video.empty() + (source.camera >= 0));
  requireOne("--init-click, --init-points, --init-pose, --init-rough, --init-anywhere and --init-tag",
             !start.click.empty() + !start.points.empty() + !start.pose.empty() + !start.rough.empty() +
                 start.anywhere + (start.tag >= 0));
  if (config.empty()) {
    fail("--config is missing: the camera's parameters come from there");
  }
  if (start.tag >= 0 && !(start.tagSize > 0.)) {
    fail("--init-tag needs --tag-size, the side of the tag's black square in metres");
  }
  if (source.last >= 0 && source.last < source.first) {
    fail("--last is before --first");
  }
  if (!vpIsZero(framesPerSecond) && !(framesPerSecond >= 0.1)) {
    fail("--fps needs a number of at least 0.1");
  }
}

} // namespace programs
