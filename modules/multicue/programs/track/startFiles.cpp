// SPDX-License-Identifier: GPL-2.0-or-later
#include "track/startFiles.h"

#include <visp3/core/vpException.h>
#include <visp3/se3/vpPoseMean.h>
#include <visp3/se3/vpExactNumber.h>

#include <cmath>
#include <fstream>
#include <locale>
#include <sstream>
#include <vector>

namespace programs {
namespace {
[[noreturn]] void fail(const std::string &file, const std::string &text)
{
  throw vpException(vpException::ioError, file + ": " + text);
}

std::vector<double> readNumbers(const std::string &file)
{
  std::ifstream stream(file);
  if (!stream) {
    fail(file, "no such file");
  }
  std::vector<double> numbers;
  for (std::string line; std::getline(stream, line);) {
    std::istringstream words(line.substr(0, line.find('#')));
    for (std::string word; words >> word;) {
      std::istringstream number(word);
      number.imbue(std::locale::classic());
      numbers.push_back(0.);
      if (!(number >> numbers.back()) || !number.eof()) {
        fail(file, "\"" + word + "\" is no number");
      }
    }
  }
  return numbers;
}

// A matrix that was printed with a few digits is no rotation to ViSP: the closest one is taken.
vpHomogeneousMatrix closestPose(const std::string &file, const std::vector<double> &numbers)
{
  vpHomogeneousMatrix printed;
  for (unsigned int i = 0; i < numbers.size(); i++) {
    printed[i / 4][i % 4] = numbers[i];
  }
  const vpHomogeneousMatrix cMo = vpPoseMean::weighted({printed}, {1.});
  for (unsigned int i = 0; i < 4; i++) {
    for (unsigned int j = 0; j < 4; j++) {
      if (std::abs(cMo[i][j] - printed[i][j]) > 1e-2) {
        fail(file, "the matrix is not a rotation and a translation, with 0 0 0 1 as its last row");
      }
    }
  }
  return cMo;
}
// 0 where the first number is none of points that a pose can be computed of.
std::size_t pointCount(const std::vector<double> &numbers)
{
  return numbers.empty() || !(numbers[0] >= 4. && numbers[0] < 1e6) ? 0 : static_cast<std::size_t>(numbers[0]);
}
} // namespace

vpHomogeneousMatrix readPose(const std::string &file)
{
  const std::vector<double> numbers = readNumbers(file);
  if (numbers.size() == 6) {
    return vpHomogeneousMatrix(numbers[0], numbers[1], numbers[2], numbers[3], numbers[4], numbers[5]);
  }
  if (numbers.size() == 12 || numbers.size() == 16) {
    return closestPose(file, numbers);
  }
  fail(file, "a pose has 6, 12 or 16 numbers, but there are " + std::to_string(numbers.size()));
}

std::vector<vpPoint> readClickPoints(const std::string &file)
{
  const std::vector<double> numbers = readNumbers(file);
  const std::size_t count = pointCount(numbers);
  if (count == 0 || numbers.size() != 1 + 3 * count) {
    fail(file, "needs the number of points, at least 4, then X Y Z of each");
  }
  std::vector<vpPoint> points;
  for (std::size_t i = 0; i < count; i++) {
    points.emplace_back(numbers[1 + 3 * i], numbers[2 + 3 * i], numbers[3 + 3 * i]);
  }
  return points;
}

PointPairs readPoints(const std::string &file)
{
  const std::vector<double> numbers = readNumbers(file);
  const std::size_t count = pointCount(numbers);
  if (count == 0 || numbers.size() != 2 + 5 * count || vpIsOther(numbers[1 + 3 * count], numbers[0])) {
    fail(file, "needs the number of points, at least 4, X Y Z of each, the number again, and row and column of each");
  }
  PointPairs points;
  for (std::size_t i = 0; i < count; i++) {
    const double *object = &numbers[1 + 3 * i];
    const double *image = &numbers[2 + 3 * count + 2 * i];
    points.object.emplace_back(object[0], object[1], object[2]);
    points.image.emplace_back(image[0], image[1]);
  }
  return points;
}

} // namespace programs
