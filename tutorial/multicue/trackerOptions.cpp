// SPDX-License-Identifier: GPL-2.0-or-later
#include "trackerOptions.h"

#include <visp3/core/vpException.h>

#include <algorithm>
#include <functional>
#include <map>
#include <sstream>
#include <vector>

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

namespace {
// One row per option serves both the parser and the help.
struct Row
{
  std::string name;
  std::string argument; // empty for a switch
  std::string help;
  std::function<void(TrackerOptions &, const std::string &)> set;
};

[[noreturn]] void fail(const std::string &text)
{
  throw vpException(vpException::badValue, text + " (see --help)");
}

template <typename Number> Number toNumber(const std::string &option, const std::string &text, Number least)
{
  std::istringstream stream(text);
  Number number;
  if (!(stream >> number) || !stream.eof() || number < least) {
    std::ostringstream message;
    message << option << " needs a number of at least " << least << ", but got \"" << text << "\"";
    fail(message.str());
  }
  return number;
}

double toMetres(const std::string &unit)
{
  const std::map<std::string, double> metres = {{"m", 1.}, {"cm", 0.01}, {"mm", 0.001}};
  const auto found = metres.find(unit);
  if (found == metres.end()) {
    fail("--unit knows m, cm and mm, but got \"" + unit + "\"");
  }
  return found->second;
}

Row text(const std::string &name, const std::string &argument, std::string TrackerOptions::*member,
         const std::string &help)
{
  return {name, argument, help,
          [member](TrackerOptions &options, const std::string &value) { options.*member = value; }};
}

Row number(const std::string &name, int TrackerOptions::*member, int least, const std::string &help)
{
  return {name, "N", help, [name, member, least](TrackerOptions &options, const std::string &value) {
            options.*member = toNumber<int>(name, value, least);
          }};
}

Row flag(const std::string &name, bool TrackerOptions::*member, bool value, const std::string &help)
{
  return {name, "", help, [member, value](TrackerOptions &options, const std::string &) { options.*member = value; }};
}

std::vector<Row> table()
{
  using Options = TrackerOptions;
  return {
      text("--images", "PATTERN", &Options::images, "image files to track in, such as data/image%04d.png"),
      text("--video", "FILE", &Options::video, "video to track in, instead of --images"),
      number("--camera", &Options::camera, 0, "camera to track in, 0 for the first; end with Ctrl-C or a click"),
      text("--model", "FILE", &Options::model, "model: .cao .wrl .obj .ply .stl .dae .gltf .glb"),
      {"--unit", "UNIT", "unit of a mesh file: m (default), cm or mm",
       [](Options &options, const std::string &value) { options.metresPerUnit = toMetres(value); }},
      text("--config", "FILE", &Options::config, "ViSP's .xml or our .json, with the camera's parameters"),
      text("--init-click", "FILE", &Options::initClick, ".init file of 3D points to click on in the first frame"),
      text("--init-pose", "FILE", &Options::initPose, "pose in the first frame: .pos of ViSP, or a 4x4 matrix"),
      text("--init-points", "FILE", &Options::initPoints, "3D points and their rows and columns in the first frame"),
      flag("--color", &Options::color, true, "track in colour; in gray levels otherwise"),
      number("--first", &Options::first, 0, "number of the first frame"),
      number("--last", &Options::last, 0, "number of the last frame"),
      number("--step", &Options::step, 1, "take every N-th frame"),
      {"--fps", "RATE", "frames per second of the saved video",
       [](Options &options, const std::string &value) { options.framesPerSecond = toNumber("--fps", value, 0.1); }},
      flag("--no-display", &Options::display, false, "open no window"),
      text("--save", "FILE", &Options::save, "write what is seen: .mp4, .avi, or images such as out%04d.png"),
      text("--poses", "FILE", &Options::poses, "write a .csv of frame, cMo row by row, milliseconds and state"),
      text("--summary", "FILE", &Options::summary, "write times, states and the projection error"),
      flag("--help", &Options::help, true, "print this"),
  };
}

void requireOne(const std::string &names, int given)
{
  if (given != 1) {
    fail("Give one of " + names);
  }
}

void check(const TrackerOptions &options)
{
  requireOne("--images, --video and --camera",
             !options.images.empty() + !options.video.empty() + (options.camera >= 0));
  requireOne("--init-click, --init-pose and --init-points",
             !options.initClick.empty() + !options.initPose.empty() + !options.initPoints.empty());
  if (options.model.empty()) {
    fail("--model is missing");
  }
  if (options.config.empty()) {
    fail("--config is missing: the camera's parameters come from there");
  }
  if (options.last >= 0 && options.last < options.first) {
    fail("--last is before --first");
  }
}
} // namespace

TrackerOptions readOptions(int argc, const char *const argv[])
{
  const std::vector<Row> rows = table();
  TrackerOptions options;
  for (int i = 1; i < argc; i++) {
    const std::string name = argv[i];
    const auto isNamed = [&name](const Row &row) { return row.name == name; };
    const auto row = std::find_if(rows.begin(), rows.end(), isNamed);
    if (row == rows.end()) {
      fail("There is no option " + name);
    }
    if (!row->argument.empty() && i + 1 == argc) {
      fail(name + " needs a value");
    }
    row->set(options, row->argument.empty() ? "" : argv[++i]);
  }
  if (!options.help) {
    check(options);
  }
  return options;
}

std::string helpText()
{
  std::ostringstream help;
  help << "Tracks an object whose model is known in a video, in images or with a camera.\n\n";
  for (const Row &row : table()) {
    const std::string usage = row.name + " " + row.argument;
    help << "  " << usage << std::string(24 - usage.size(), ' ') << row.help << "\n";
  }
  help << "\nExample:\n  tutorial-multicue-tracker --video box.mp4 --model box.obj --unit mm --config camera.xml \\\n"
          "    --init-pose box.pos --save out.mp4 --poses poses.csv\n";
  return help.str();
}
