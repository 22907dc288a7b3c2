// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef marbleBox_h
#define marbleBox_h

#include <meshFiles.h>
#include <pointScenes.h>

#include <visp3/core/vpImageConvert.h>
#include <visp3/multicue/vpMbMultiCueTracker.h>

#include <fstream>
#include <string>

BEGIN_VISP_NAMESPACE

//! The box of marble of pointScenes.h, whose sides have the names side0 to side5 in its model file.
class marbleBox
{
public:
  marbleBox() : m_painter(pointScenes::makeBox()) {}

  static std::string writeCao(const std::string &name)
  {
    const std::string path = meshFiles::temporaryFile(name);
    std::ofstream file(path);
    const auto sides = modelShapes::boxPolygons(Eigen::Vector3d(0.16, 0.12, 0.1));
    file << "V1\n" << 4 * sides.size() << "\n";
    for (const auto &side : sides) {
      for (const Eigen::Vector3d &corner : side) {
        file << corner.x() << " " << corner.y() << " " << corner.z() << "\n";
      }
    }
    file << "0\n0\n" << sides.size() << "\n";
    for (std::size_t i = 0; i < sides.size(); ++i) {
      file << "4 " << 4 * i << " " << 4 * i + 1 << " " << 4 * i + 2 << " " << 4 * i + 3 << " name=side" << i << "\n";
    }
    file << "0\n0\n";
    return path;
  }

  //! Index of the side whose outward normal is an axis of the object, as boxPolygons() has them.
  static std::string nameOf(int axis, bool positive) { return "side" + std::to_string(2 * axis + (positive ? 1 : 0)); }

  static vpHomogeneousMatrix poseAt(int frame)
  {
    vpColVector motion(6);
    motion[0] = 0.001 * frame;
    motion[4] = 0.006 * frame;
    return pointScenes::startPose() * vpExponentialMap::direct(motion);
  }

  vpImage<unsigned char> draw(int frame) { return m_painter.draw(poseAt(frame)); }

  //! Starts a tracker in frame 0 and follows the box into the frames up to one.
  void follow(vpMbMultiCueTracker &tracker, int last)
  {
    tracker.initFromPose(draw(0), poseAt(0));
    for (int frame = 1; frame <= last; ++frame) {
      tracker.track(draw(frame));
    }
  }

  static double error(const vpHomogeneousMatrix &cMo, int frame)
  {
    return (cMo.getTranslationVector() - poseAt(frame).getTranslationVector()).frobeniusNorm();
  }

private:
  pointScenes::Painter m_painter;
};

END_VISP_NAMESPACE
#endif
