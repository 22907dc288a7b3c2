// SPDX-License-Identifier: GPL-2.0-or-later
#include "track/tagFinder.h"

#include <visp3/core/vpConfig.h>
#include <visp3/core/vpException.h>
#include <visp3/core/vpImageConvert.h>

#if defined(VISP_HAVE_APRILTAG) && defined(MULTICUE_HAVE_DETECTION)
#include <visp3/detection/vpDetectorAprilTag.h>
#define MULTICUE_HAVE_TAGS
#endif

namespace programs {

#ifdef MULTICUE_HAVE_TAGS
class TagFinder::Impl
{
public:
  Impl(int id, double size, const vpHomogeneousMatrix &oMt) : m_id(id), m_size(size), m_tMo(oMt.inverse()) {}

  std::vector<vpWeightedPose> find(const vpImage<vpRGBa> &I, const vpCameraParameters &cam)
  {
    vpImage<unsigned char> gray;
    vpImageConvert::convert(I, gray);
    std::vector<vpWeightedPose> poses;
    m_detector.detect(gray);
    const std::vector<int> ids = m_detector.getTagsId();
    for (std::size_t i = 0; i < ids.size(); ++i) {
      vpHomogeneousMatrix cMt;
      if (ids[i] == m_id && m_detector.getPose(i, m_size, cam, cMt)) {
        poses.push_back({cMt * m_tMo, 1.});
      }
    }
    return poses;
  }

private:
  int m_id;
  double m_size;
  vpHomogeneousMatrix m_tMo;
  vpDetectorAprilTag m_detector{vpDetectorAprilTag::TAG_36h11};
};
#else
class TagFinder::Impl
{
public:
  Impl(int, double, const vpHomogeneousMatrix &)
  {
    throw vpException(vpException::notImplementedError,
                      "--init-tag: this ViSP was built without AprilTag; start by another of the --init options");
  }
  std::vector<vpWeightedPose> find(const vpImage<vpRGBa> &, const vpCameraParameters &) { return {}; }
};
#endif

TagFinder::TagFinder(int id, double size, const vpHomogeneousMatrix &oMt)
    : m_impl(std::make_unique<Impl>(id, size, oMt))
{
}

TagFinder::~TagFinder() = default;

std::vector<vpWeightedPose> TagFinder::find(const vpImage<vpRGBa> &I, const vpCameraParameters &cam)
{
  return m_impl->find(I, cam);
}

} // namespace programs
