// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/multicue/vpMbMultiCueTracker.h>

#include "facade/vpTrackerImpl.h"
#include "model/vpStartFile.h"

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
  vpMbTracker::initFromPoints(I, points.image, points.object);
}

void vpMbMultiCueTracker::initFromPose(const vpImage<unsigned char> &I, const std::string &initFile)
{
  vpMbTracker::initFromPose(I, vpStartFile::readPose(initFile));
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
  vpMbTracker::initFromPoints(I_color, points.image, points.object);
  m_impl->startOn(I_color);
}

void vpMbMultiCueTracker::initFromPoints(const vpImage<vpRGBa> &I_color, const std::vector<vpImagePoint> &points2D_list,
                                         const std::vector<vpPoint> &points3D_list)
{
  vpMbTracker::initFromPoints(I_color, points2D_list, points3D_list);
  m_impl->startOn(I_color);
}

void vpMbMultiCueTracker::initFromPose(const vpImage<vpRGBa> &I_color, const std::string &initFile)
{
  vpMbTracker::initFromPose(I_color, vpStartFile::readPose(initFile));
  m_impl->startOn(I_color);
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
