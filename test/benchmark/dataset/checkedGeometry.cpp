// SPDX-License-Identifier: GPL-2.0-or-later
#include "dataset/checkedGeometry.h"

#include "dataset/datasetFiles.h"
#include "dataset/largestDistance.h"

#include <visp3/model/vpModelReader.h>
#include <visp3/multicue/vpMbMultiCueTracker.h>
#include <visp3/se3/vpExactNumber.h>

#include <Eigen/LU>
#include <Eigen/SVD>

#include <algorithm>

namespace bench {
namespace {
const double rotationTolerance = 1e-3;
using Matrix3 = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

Eigen::Matrix3d nearestRotation(const Eigen::Matrix3d &R)
{
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(R, Eigen::ComputeFullU | Eigen::ComputeFullV);
  return svd.matrixU() * svd.matrixV().transpose();
}
} // namespace

vpHomogeneousMatrix checkedTransform(const std::vector<double> &rotation, const Eigen::Vector3d &translation,
                                     const std::string &place)
{
  if (rotation.size() != 9) {
    fail(place + ": a rotation has 9 numbers, not " + std::to_string(rotation.size()));
  }
  const Eigen::Matrix3d R = Eigen::Map<const Matrix3>(rotation.data());
  const double error = (R * R.transpose() - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();
  if (!(error <= rotationTolerance) || R.determinant() < 0. || !translation.allFinite()) {
    fail(place + ": this is no rotation matrix (rows of length 1, perpendicular, determinant 1) with a finite "
                 "translation");
  }
  const Eigen::Matrix3d clean = nearestRotation(R);
  vpHomogeneousMatrix T;
  for (unsigned int i = 0; i < 3; ++i) {
    for (unsigned int j = 0; j < 3; ++j) {
      T[i][j] = clean(i, j);
    }
    T[i][3] = translation[i];
  }
  return T;
}

vpHomogeneousMatrix checkedTransform(const std::vector<double> &matrix, double unit, const std::string &place)
{
  if (matrix.size() != 16) {
    fail(place + ": a pose has 4 x 4 numbers, not " + std::to_string(matrix.size()));
  }
  if (!vpIsZero(matrix[12]) || !vpIsZero(matrix[13]) || !vpIsZero(matrix[14]) || vpIsOther(matrix[15], 1.)) {
    fail(place + ": the last row of a pose is 0 0 0 1");
  }
  std::vector<double> rotation;
  for (std::size_t row = 0; row < 3; ++row) {
    rotation.insert(rotation.end(), matrix.begin() + static_cast<std::ptrdiff_t>(4 * row),
                    matrix.begin() + static_cast<std::ptrdiff_t>(4 * row + 3));
  }
  return checkedTransform(rotation, unit * Eigen::Vector3d(matrix[3], matrix[7], matrix[11]), place);
}

void requireInFront(const vpHomogeneousMatrix &cMo, const std::string &place)
{
  if (!(cMo[2][3] > 0.)) {
    fail(place + ": the object is not in front of the camera (z = " + std::to_string(cMo[2][3]) + " m)");
  }
}

vpCameraParameters checkedCamera(double px, double py, double u0, double v0, const std::string &place)
{
  if (!(px > 0.) || !(py > 0.)) {
    fail(place + ": focal lengths are positive, not " + std::to_string(px) + " and " + std::to_string(py));
  }
  return vpCameraParameters(px, py, u0, v0);
}

double measuredDiameter(const SequenceObject &object)
{
  if (!object.mesh.empty()) {
    vpModelOptions options;
    options.unit = object.meshUnit;
    return programs::largestDistance(vpModelReader::read(object.mesh, options).vertices());
  }
  vpMbMultiCueTracker parser;
  parser.loadModel(object.cao);
  return programs::largestDistance(parser.getModel()->vertices());
}

void startAtFirstTruth(std::vector<SequenceFrame> &frames, const std::string &place)
{
  frames.erase(frames.begin(),
               std::find_if(frames.begin(), frames.end(), [](const SequenceFrame &frame) { return frame.hasTruth; }));
  if (frames.size() < 2) {
    fail(place + " has " + std::to_string(frames.size()) +
         " frames from the first one with a pose on: a sequence needs two");
  }
}

} // namespace bench
