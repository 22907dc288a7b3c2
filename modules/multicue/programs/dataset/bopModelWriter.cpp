// SPDX-License-Identifier: GPL-2.0-or-later
#include "dataset/bopWriter.h"

#include "dataset/largestDistance.h"
#include "frames/pictureFile.h"

#include <visp3/core/vpException.h>
#include <visp3/model/vpWholeFile.h>
#include <visp3/se3/vpExactNumber.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

namespace programs {
namespace {
namespace fs = std::filesystem;
using nlohmann::json;

std::string number(double value)
{
  char text[32];
  std::snprintf(text, sizeof(text), "%.9g", vpIsZero(value) ? 0. : value);
  return text;
}

std::string numbers(const Eigen::Vector3d &p)
{
  return number(p.x()) + " " + number(p.y()) + " " + number(p.z());
}

//! Gives equal lines one number, in the order of their first use.
class Lines
{
public:
  std::size_t indexOf(const std::string &line)
  {
    const auto place = m_index.emplace(line, m_index.size());
    if (place.second) {
      m_text += line + "\n";
    }
    return place.first->second;
  }
  std::size_t size() const { return m_index.size(); }
  const std::string &text() const { return m_text; }

private:
  std::map<std::string, std::size_t> m_index;
  std::string m_text;
};

//! The colour at a corner: the texture's where there is one.
Eigen::Vector3f cornerColor(const BopModel &model, const BopTriangle &triangle, std::size_t corner)
{
  if (triangle.image < 0) {
    return triangle.color[corner];
  }
  const cv::Mat &image = model.images[static_cast<std::size_t>(triangle.image)];
  const auto pixel = [](float share, int size) {
    return std::clamp(static_cast<int>(share * float(size)), 0, size - 1);
  };
  const cv::Vec3b &c = image.at<cv::Vec3b>(pixel(triangle.texture[corner].y(), image.rows),
                                           pixel(triangle.texture[corner].x(), image.cols));
  return Eigen::Vector3f(c[2], c[1], c[0]) / 255.F;
}

void writePly(const BopModel &model, const std::string &file)
{
  Lines vertices;
  std::ostringstream faces;
  for (const BopTriangle &triangle : model.triangles) {
    faces << "3";
    for (std::size_t i = 0; i < 3; ++i) {
      const Eigen::Vector3f color = cornerColor(model, triangle, i) * 255.F;
      std::string line = numbers(1000. * triangle.position[i]);
      for (int channel = 0; channel < 3; ++channel) {
        line += " " + std::to_string(std::clamp(static_cast<int>(std::lround(color(channel))), 0, 255));
      }
      faces << " " << vertices.indexOf(line);
    }
    faces << "\n";
  }
  std::ostringstream out;
  out << "ply\nformat ascii 1.0\ncomment millimetres\nelement vertex " << vertices.size()
      << "\nproperty float x\nproperty float y\nproperty float z\nproperty uchar red\nproperty uchar green\n"
         "property uchar blue\nelement face "
      << model.triangles.size() << "\nproperty list uchar int vertex_indices\nend_header\n"
      << vertices.text() << faces.str();
  vpWholeFile::write(file, out.str());
}

std::string textureName(const std::string &stem, std::size_t image)
{
  return stem + "_" + std::to_string(image) + ".png";
}

void writeMaterials(const BopModel &model, const std::string &path)
{
  const std::string stem = fs::path(path).filename().string();
  std::ostringstream out;
  out << "newmtl plain\nKd 1 1 1\n";
  for (std::size_t i = 0; i < model.images.size(); ++i) {
    out << "newmtl picture" << i << "\nKd 1 1 1\nmap_Kd " << textureName(stem, i) << "\n";
    writePicture(textureName(path, i), model.images[i]);
  }
  vpWholeFile::write(path + ".mtl", out.str());
}

//! Vertices that carry a colour too where a triangle has no picture: most programs read that.
void writeObj(const BopModel &model, const std::string &path)
{
  Lines vertices;
  Lines textures;
  std::ostringstream faces;
  int image = -2;
  for (const BopTriangle &triangle : model.triangles) {
    if (triangle.image != image) {
      image = triangle.image;
      faces << "usemtl " << (image < 0 ? "plain" : "picture" + std::to_string(image)) << "\n";
    }
    faces << "f";
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t v = vertices.indexOf("v " + numbers(triangle.position[i]));
      const std::size_t t = textures.indexOf("vt " + number(double(triangle.texture[i].x())) + " " +
                                             number(1. - double(triangle.texture[i].y())));
      faces << " " << v + 1 << "/" << t + 1;
    }
    faces << "\n";
  }
  vpWholeFile::write(path + ".obj", "# Metres\nmtllib " + fs::path(path).filename().string() + ".mtl\n" +
                                        vertices.text() + textures.text() + faces.str());
  writeMaterials(model, path);
}

void writeInfo(const std::string &file, const BopModel &model)
{
  json all = json::object();
  if (std::ifstream in(file); in) {
    try {
      all = json::parse(in);
    } catch (const json::exception &e) {
      throw vpException(vpException::ioError, "%s is not JSON; remove it to make a new one (%s)", file.c_str(),
                        e.what());
    }
  }
  std::vector<Eigen::Vector3d> points;
  for (const BopTriangle &triangle : model.triangles) {
    points.insert(points.end(), triangle.position.begin(), triangle.position.end());
  }
  Eigen::Vector3d low = points.front();
  Eigen::Vector3d high = points.front();
  for (const Eigen::Vector3d &p : points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const Eigen::Vector3d size = 1000. * (high - low);
  json entry = {{"diameter", 1000. * largestDistance(points)}};
  const char *names[] = {"x", "y", "z"};
  for (int i = 0; i < 3; ++i) {
    entry[std::string("min_") + names[i]] = 1000. * low(i);
    entry[std::string("size_") + names[i]] = size(i);
  }
  all[std::to_string(model.id)] = entry;
  vpWholeFile::write(file, all.dump(2) + "\n");
}
} // namespace

std::string bopModelPath(const std::string &dataset, int id, const std::string &folder)
{
  char name[32];
  std::snprintf(name, sizeof(name), "obj_%06d", id);
  return (fs::path(dataset) / folder / name).string();
}

void writeBopModel(const std::string &dataset, const BopModel &model)
{
  const std::string path = bopModelPath(dataset, model.id, model.folder);
  const fs::path folder = fs::path(path).parent_path();
  std::error_code error;
  fs::create_directories(folder, error);
  if (!fs::is_directory(folder)) {
    throw vpException(vpException::ioError, "the folder %s cannot be made: %s", folder.c_str(),
                      error.message().c_str());
  }
  writePly(model, path + ".ply");
  if (!model.images.empty()) {
    writeObj(model, path);
  }
  if (!model.cao.empty()) {
    vpWholeFile::write(path + ".cao", model.cao);
  } else {
    fs::remove(path + ".cao", error);
  }
  writeInfo((folder / "models_info.json").string(), model);
}

} // namespace programs
