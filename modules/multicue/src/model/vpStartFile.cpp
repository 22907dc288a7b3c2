// SPDX-License-Identifier: GPL-2.0-or-later
#include "model/vpStartFile.h"

#include "model/vpCaoLines.h"

#include <visp3/core/vpException.h>

#include <filesystem>
#include <system_error>

BEGIN_VISP_NAMESPACE

namespace {
constexpr std::size_t leastPoints = 4;

std::string withEnding(const std::string &file, const std::string &ending)
{
  const bool has = file.size() > ending.size() && file.compare(file.size() - ending.size(), ending.size(), ending) == 0;
  return has ? file : file + ending;
}

template <typename Read> auto named(const std::string &file, const Read &read)
{
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) {
    throw vpException(vpException::ioError, "The start file '" + file + "' does not exist or is no file");
  }
  try {
    return read();
  } catch (const vpException &e) {
    throw vpException(vpException::badValue, "The start file '" + file + "' cannot be read: " + e.getMessage());
  }
}

std::size_t countPoints(vpCaoLines &lines, const std::string &what)
{
  const std::size_t count = lines.count(what);
  if (count < leastPoints) {
    lines.refuse(std::to_string(count) + " " + what + " do not give a pose, at least " + std::to_string(leastPoints) +
                 " are needed");
  }
  return count;
}

std::vector<double> numbersOf(vpCaoLines &lines, std::size_t count, const std::string &element)
{
  vpLineWords words(lines.next(element));
  std::vector<double> numbers;
  while (numbers.size() < count) {
    numbers.push_back(lines.number(words, "number " + std::to_string(numbers.size() + 1), element));
  }
  lines.requireNoMore(words, element);
  return numbers;
}

std::vector<vpPoint> objectPoints(vpCaoLines &lines)
{
  std::vector<vpPoint> points;
  for (std::size_t left = countPoints(lines, "3D points"); left > 0; --left) {
    const std::vector<double> p = numbersOf(lines, 3, "3D point " + std::to_string(points.size() + 1));
    points.emplace_back(p[0], p[1], p[2]);
  }
  return points;
}

vpStartFile::Points allPoints(vpCaoLines lines)
{
  vpStartFile::Points points;
  points.object = objectPoints(lines);
  if (countPoints(lines, "2D points") != points.object.size()) {
    lines.refuse("there are to be as many 2D points as 3D points, " + std::to_string(points.object.size()));
  }
  while (points.image.size() < points.object.size()) {
    const std::vector<double> p = numbersOf(lines, 2, "2D point " + std::to_string(points.image.size() + 1));
    points.image.emplace_back(p[0], p[1]);
  }
  return points;
}
} // namespace

vpPoseVector vpStartFile::readPose(const std::string &file)
{
  const std::string path = withEnding(file, ".pos");
  return named(path, [&] {
    vpPoseVector pose;
    unsigned int taken = 0;
    for (const vpTextLine &line : vpTextLines::read(path).lines) {
      for (vpLineWords words(line.text); !words.rest().empty();) {
        double number = 0.;
        if (!words.take(number) || taken == 6) {
          throw vpException(vpException::badValue,
                            "line " + std::to_string(line.number) + ": '" + std::string(words.word()) +
                                (taken == 6 ? "' follows the six numbers of the pose" : "' is no number of a pose"));
        }
        pose[taken++] = number;
      }
    }
    if (taken < 6) {
      throw vpException(vpException::badValue, "it has " + std::to_string(taken) +
                                                   " numbers, a pose has six: translation (m) and theta u (rad)");
    }
    return pose;
  });
}

vpStartFile::Points vpStartFile::readPoints(const std::string &file)
{
  const std::string path = withEnding(file, ".init");
  return named(path, [&] { return allPoints(vpCaoLines(path)); });
}

void vpStartFile::requirePointsToClick(const std::string &file)
{
  const std::string path = file.rfind(".init") != std::string::npos ? file : file + ".init";
  named(path, [&] {
    vpCaoLines lines(path);
    return objectPoints(lines).size();
  });
}

END_VISP_NAMESPACE
