// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/multicue/vpMbMultiCueTracker.h>

#include "facade/vpTrackerImpl.h"
#include "model/vpStartFile.h"

#include <visp3/core/vpTrackingException.h>

#include <locale>

// vpMbTracker finds the pose and ends in init() with a gray image: the colours are learnt afterwards.

BEGIN_VISP_NAMESPACE

namespace {
// ViSP's reader takes numbers in the locale that streams start with.
class ClassicStreams
{
public:
  ClassicStreams() : m_before(std::locale::global(std::locale::classic())) {}
  ~ClassicStreams() { std::locale::global(m_before); }
  ClassicStreams(const ClassicStreams &) = delete;
  ClassicStreams &operator=(const ClassicStreams &) = delete;

private:
  std::locale m_before;
};

// What is wrong with the start of a file is said with its name.
template <typename Start> void startFrom(const std::string &file, const Start &start)
{
  try {
    start();
  } catch (const vpTrackingException &) {
    throw; // What a caller may wait for.
  } catch (const vpException &e) {
    throw vpException(e.getCode(), "The start file '" + file + "' does not give a start: " + e.getMessage());
  }
}
} // namespace

void vpMbMultiCueTracker::initClick(const vpImage<unsigned char> &I, const std::string &initFile, bool displayHelp,
                                    const vpHomogeneousMatrix &T)
{
  vpStartFile::requirePointsToClick(initFile);
  const ClassicStreams classic;
  vpMbTracker::initClick(I, initFile, displayHelp, T);
}

void vpMbMultiCueTracker::initFromPoints(const vpImage<unsigned char> &I, const std::string &initFile)
{
  const vpStartFile::Points points = vpStartFile::readPoints(initFile);
  startFrom(initFile, [&] { vpMbTracker::initFromPoints(I, points.image, points.object); });
}

void vpMbMultiCueTracker::initFromPose(const vpImage<unsigned char> &I, const std::string &initFile)
{
  const vpPoseVector pose = vpStartFile::readPose(initFile);
  startFrom(initFile, [&] { vpMbTracker::initFromPose(I, pose); });
}

void vpMbMultiCueTracker::initClick(const vpImage<vpRGBa> &I_color, const std::string &initFile, bool displayHelp,
                                    const vpHomogeneousMatrix &T)
{
  vpStartFile::requirePointsToClick(initFile);
  const ClassicStreams classic;
  vpMbTracker::initClick(I_color, initFile, displayHelp, T);
  m_impl->startOn(I_color);
}

void vpMbMultiCueTracker::initClick(const vpImage<vpRGBa> &I_color, const std::vector<vpPoint> &points3D_list,
                                    const std::string &displayFile)
{
  vpMbTracker::initClick(I_color, points3D_list, displayFile);
  m_impl->startOn(I_color);
}

void vpMbMultiCueTracker::initFromPoints(const vpImage<vpRGBa> &I_color, const std::string &initFile)
{
  const vpStartFile::Points points = vpStartFile::readPoints(initFile);
  startFrom(initFile, [&] {
    vpMbTracker::initFromPoints(I_color, points.image, points.object);
    m_impl->startOn(I_color);
  });
}

void vpMbMultiCueTracker::initFromPoints(const vpImage<vpRGBa> &I_color, const std::vector<vpImagePoint> &points2D_list,
                                         const std::vector<vpPoint> &points3D_list)
{
  vpMbTracker::initFromPoints(I_color, points2D_list, points3D_list);
  m_impl->startOn(I_color);
}

void vpMbMultiCueTracker::initFromPose(const vpImage<vpRGBa> &I_color, const std::string &initFile)
{
  const vpPoseVector pose = vpStartFile::readPose(initFile);
  startFrom(initFile, [&] {
    vpMbTracker::initFromPose(I_color, pose);
    m_impl->startOn(I_color);
  });
}

void vpMbMultiCueTracker::initFromPose(const vpImage<vpRGBa> &I_color, const vpHomogeneousMatrix &cMo)
{
  m_cMo = cMo;
  m_impl->startOn(I_color);
}

void vpMbMultiCueTracker::initFromPose(const vpImage<vpRGBa> &I_color, const vpPoseVector &cPo)
{
  vpMbTracker::initFromPose(I_color, cPo);
  m_impl->startOn(I_color);
}

END_VISP_NAMESPACE
