// SPDX-License-Identifier: GPL-2.0-or-later
/*!
  \file multicue-check.cpp
  Tells what keeps an object from being tracked, before it is tried.
*/
#include "check/setupCheck.h"
#include "program/commandLine.h"
#include "program/lengthUnit.h"
#include "program/runProgram.h"

#include <visp3/multicue/vpMultiCueSettings.h>

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

namespace {
int run(int argc, const char *const argv[])
{
  programs::Setup setup;
  bool printsSchema = false;
  programs::CommandLine line("Checks model, camera, image and start pose of an object that is to be tracked.\n\n"
                             "  multicue-check --model box.obj --unit mm --config camera.xml \\\n"
                             "    --image first.png --pose box.pos --overlay seen.png\n\n"
                             "It prints a line for each of what it finds, one for each fault, and ends with 1 where\n"
                             "there is a fault.");
  line.add("--model", "model: .cao .wrl .obj .ply .stl .dae .gltf .glb", setup.model);
  line.addSetter("--unit", "unit of a mesh file: m (default), cm, mm or inch",
                 [&](const std::string &value) { setup.metresPerUnit = programs::metresPerUnit(value); });
  line.add("--config", "ViSP's .xml, its camera's calibration, or .json, with the camera", setup.config);
  line.add("--image", "the image in which tracking starts", setup.image);
  line.add("--video", "the video whose first image that is, instead of --image", setup.video);
  line.add("--pose", "start pose in it: .pos of ViSP, or the rows of a matrix", setup.pose);
  line.add("--overlay", "picture to write, .png: the model over the image at the start pose, or the image alone",
           setup.overlay);
  line.add("--schema", "print the JSON schema of configurations, and nothing else", printsSchema);
  if (!line.read(argc, argv)) {
    return 0;
  }
  if (printsSchema) {
    std::cout << vpMultiCueSettingsReader::jsonSchema();
    return 0;
  }
  const programs::CheckReport report = programs::checkSetup(setup);
  for (const std::string &text : report.lines) {
    std::cout << text << "\n";
  }
  for (const std::string &fault : report.faults) {
    std::cout << "FAULT     " << fault << "\n";
  }
  std::cout << (report.faults.empty() ? "no fault\n" : "") << std::flush;
  return report.faults.empty() ? 0 : 1;
}
} // namespace

int main(int argc, const char *argv[])
{
  return programs::runProgram([&] { return run(argc, argv); });
}
