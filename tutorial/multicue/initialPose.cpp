// SPDX-License-Identifier: GPL-2.0-or-later
#include "initialPose.h"

#include <visp3/core/vpException.h>
#include <visp3/se3/vpPoseMean.h>

#include <cmath>
#include <fstream>
#include <sstream>
#include <vector>

namespace {
[[noreturn]] void fail(const std::string &file, const std::string &text)
{
  throw vpException(vpException::ioError, "--init-pose " + file + ": " + text);
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
