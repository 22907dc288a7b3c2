// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef compareOptions_h
#define compareOptions_h

#include <visp3/core/vpException.h>
#include <visp3/core/vpHomogeneousMatrix.h>
#include <visp3/core/vpImagePoint.h>
#include <visp3/core/vpPoint.h>
#include <visp3/core/vpPoseVector.h>
#include <visp3/io/vpVideoReader.h>

#include <cstdio>
#include <fstream>
#include <functional>
#include <iostream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

//! What multicue-compare is asked to do.
struct compareOptions
{
  //! A further model file, placed in the object frame.
  struct Part
  {
    std::string file;
    vpHomogeneousMatrix oMp;
  };

  std::string images;
  std::string model;
  std::vector<Part> parts;
  std::string mesh;
  std::string writeMesh;
  double unit = 1.;
  std::string config;
  vpPoseVector initPose;
  std::vector<vpImagePoint> initPoints;
  std::vector<vpPoint> initPoints3d;
  std::string truth;
  std::string poses;
  int first = 0;
  int last = 1000000;
  int repeat = 1;
  unsigned int candidates = 3;
  double oldScaleThreshold = 0.;
  bool points = false; //!< Beside the edges.
  bool hypotheses = false;
  bool scanline = false;

  //! \return False where help was asked for and given.
  bool read(int argc, const char *argv[])
  {
    const std::map<std::string, std::function<void(std::istringstream &)>> table = {
        {"--images", [this](std::istringstream &s) { s >> images; }},
        {"--model", [this](std::istringstream &s) { s >> model; }},
        {"--part", [this](std::istringstream &s) { parts.push_back(readPart(s)); }},
        {"--mesh", [this](std::istringstream &s) { s >> mesh; }},
        {"--write-mesh", [this](std::istringstream &s) { s >> writeMesh; }},
        {"--unit", [this](std::istringstream &s) { s >> unit; }},
        {"--config", [this](std::istringstream &s) { s >> config; }},
        {"--init-pose", [this](std::istringstream &s) { readInitPose(s.str()); }},
        {"--init-points", [this](std::istringstream &s) { readInitPoints(s); }},
        {"--truth", [this](std::istringstream &s) { s >> truth; }},
        {"--poses", [this](std::istringstream &s) { s >> poses; }},
        {"--first", [this](std::istringstream &s) { s >> first; }},
        {"--last", [this](std::istringstream &s) { s >> last; }},
        {"--repeat", [this](std::istringstream &s) { s >> repeat; }},
        {"--candidates", [this](std::istringstream &s) { s >> candidates; }},
        {"--old-threshold", [this](std::istringstream &s) { s >> oldScaleThreshold; }},
        {"--points", [this](std::istringstream &s) { s >> points; }},
        {"--hypotheses", [this](std::istringstream &s) { s >> hypotheses; }},
        {"--scanline", [this](std::istringstream &s) { s >> scanline; }},
    };
    for (int i = 1; i < argc; i += 2) {
      const auto found = table.find(argv[i]);
      if (found == table.end() || i + 1 == argc) {
        help(table);
        if (std::string(argv[i]) == "--help") {
          return false;
        }
        throw vpException(vpException::badValue, "Option '%s' is not known or lacks its value", argv[i]);
      }
      std::istringstream value(argv[i + 1]);
      found->second(value);
    }
    if (images.empty() || model.empty() || config.empty()) {
      throw vpException(vpException::badValue, "--images, --model and --config are needed");
    }
    return true;
  }

  void open(vpVideoReader &reader) const
  {
    reader.setFileName(images);
    if (images.find('%') != std::string::npos) {
      reader.setFirstFrameIndex(first);
      reader.setLastFrameIndex(last);
    }
    vpImage<unsigned char> I;
    reader.open(I);
  }

  vpHomogeneousMatrix truthAt(int frame) const
  {
    char name[1024];
    std::snprintf(name, sizeof(name), truth.c_str(), frame);
    std::ifstream file(name);
    vpHomogeneousMatrix cMo;
    for (unsigned int i = 0; i < 16; ++i) {
      if (!(file >> cMo.data[i])) {
        throw vpException(vpException::ioError, "The true pose '%s' cannot be read", name);
      }
    }
    return cMo;
  }

private:
  static Part readPart(std::istringstream &s)
  {
    Part part;
    s >> part.file;
    for (unsigned int i = 0; i < 12; ++i) {
      s >> part.oMp.data[i];
    }
    return part;
  }

  void readInitPose(const std::string &name)
  {
    std::ifstream file(name);
    for (unsigned int i = 0; i < 6; ++i) {
      if (!(file >> initPose[i])) {
        throw vpException(vpException::ioError, "The initial pose '%s' cannot be read", name.c_str());
      }
    }
  }

  void readInitPoints(std::istringstream &s)
  {
    double u = 0., v = 0., X = 0., Y = 0., Z = 0.;
    while (s >> u >> v >> X >> Y >> Z) {
      initPoints.emplace_back(v, u);
      initPoints3d.emplace_back(X, Y, Z);
    }
  }

  template <typename Table> static void help(const Table &table)
  {
    std::cout << "Compares vpMbMultiCueTracker with vpMbGenericTracker on a recording, by edges.\nOptions, each "
                 "with a value:";
    for (const auto &entry : table) {
      std::cout << " " << entry.first;
    }
    std::cout << "\n  --images and --truth are printf patterns (or a video), --part is \"FILE and the 12 numbers of "
                 "its pose\",\n"
                 "  --init-points is \"u v X Y Z\" repeated, --mesh is what our tracker loads in place of --model,\n"
                 "  --points 1 has both use points as well, --hypotheses 1 switches pose hypotheses on and counts "
                 "minimisations,\n"
                 "  --write-mesh where the surface of the model is written as .obj.\n";
  }
};

#endif
