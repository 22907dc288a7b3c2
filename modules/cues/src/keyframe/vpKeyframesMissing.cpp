// SPDX-License-Identifier: GPL-2.0-or-later
// Compiled in place of the keyframes where OpenCV's modules were not found.
#include <visp3/cues/vpKeyframes.h>

BEGIN_VISP_NAMESPACE

class vpKeyframes::Impl
{
};

bool vpKeyframes::isAvailable()
{
  return false;
}

vpKeyframes::vpKeyframes(std::size_t)
{
}
vpKeyframes::~vpKeyframes() = default;

void vpKeyframes::setObject(const Eigen::Vector3d &, double)
{
}
void vpKeyframes::reset()
{
}
std::size_t vpKeyframes::size() const
{
  return 0;
}
bool vpKeyframes::wants(const vpHomogeneousMatrix &) const
{
  return false;
}
void vpKeyframes::learn(const vpCueFrame &, const vpHomogeneousMatrix &, const vpRenderedView &)
{
}
void vpKeyframes::propose(const vpCueFrame &, const vpHomogeneousMatrix &, const vpRenderedView &)
{
}
void vpKeyframes::confirm(const vpCueFrame &, const vpHomogeneousMatrix &)
{
}
std::vector<vpKeyframePose> vpKeyframes::find(const vpCueFrame &, const vpImageRegion &, const Where &)
{
  return {};
}
unsigned int vpKeyframes::agreeing(const vpHomogeneousMatrix &) const
{
  return 0;
}

END_VISP_NAMESPACE
