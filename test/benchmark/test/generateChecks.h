// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef generateChecks_h
#define generateChecks_h

#include "generate/scene.h"

#include <meshFiles.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <iomanip>
#include <sstream>
#include <string>
#include <vector>

/*! \file generateChecks.h What the tests of rendered sequences have in common. */

namespace generateChecks {

//! A short, small sequence before a plain background.
inline bench::SceneOptions options(const std::string &dataset, const std::string &object, const std::string &variant,
                                   int frames)
{
  bench::SceneOptions result;
  result.dataset = dataset;
  result.object = object;
  result.variant = variant;
  result.frames = frames;
  result.background = "plain";
  result.width = 160;
  result.height = 120;
  return result;
}

inline std::string bytesOf(const std::string &file)
{
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

inline nlohmann::json readJson(const std::string &file)
{
  std::ifstream in(file);
  return nlohmann::json::parse(in);
}

//! Image points of an object's vertices.
inline std::vector<Eigen::Vector2d> project(const vpTrackedModel &model, const vpHomogeneousMatrix &cMo,
                                            const vpCameraParameters &cam)
{
  std::vector<Eigen::Vector2d> pixels;
  for (const Eigen::Vector3d &p : model.vertices()) {
    Eigen::Vector3d c;
    for (unsigned int i = 0; i < 3; ++i) {
      c(i) = cMo[i][0] * p.x() + cMo[i][1] * p.y() + cMo[i][2] * p.z() + cMo[i][3];
    }
    pixels.emplace_back(cam.get_u0() + cam.get_px() * c.x() / c.z(), cam.get_v0() + cam.get_py() * c.y() / c.z());
  }
  return pixels;
}

} // namespace generateChecks
#endif
