// SPDX-License-Identifier: GPL-2.0-or-later
// Compiled in place of the point cue where OpenCV's video, features2d or calib3d module was not found.
#include <visp3/cues/vpPointCue.h>

#include <visp3/core/vpException.h>

BEGIN_VISP_NAMESPACE

class vpPointCue::Impl
{
public:
  vpPointCueSettings settings;
  std::vector<Match> matches;
};

bool vpPointCue::isAvailable()
{
  return false;
}

vpPointCue::vpPointCue(const vpPointCueSettings &)
{
  throw vpException(
      vpException::functionNotImplementedError,
      "this library was built without OpenCV's video, features2d or calib3d module: install it and build it again");
}

vpPointCue::~vpPointCue() = default;

// No object exists that these could be called on.
void vpPointCue::setSettings(const vpPointCueSettings &)
{
}
const vpPointCueSettings &vpPointCue::settings() const
{
  return m_impl->settings;
}
void vpPointCue::setDepthSource(const DepthSource &)
{
}
void vpPointCue::setSurfaceFilter(const SurfaceFilter &)
{
}
void vpPointCue::match(const vpCueFrame &, const vpModelView &)
{
}
void vpPointCue::residuals(const vpHomogeneousMatrix &, vpResidualBlock &) const
{
}
void vpPointCue::updateReference(const vpHomogeneousMatrix &, const std::vector<double> &)
{
}
void vpPointCue::reset()
{
}
void vpPointCue::getFeatures(const vpHomogeneousMatrix &, const std::vector<double> &,
                             std::vector<vpCueFeature> &) const
{
}
bool vpPointCue::wantsPoints() const
{
  return false;
}
const std::vector<vpPointCue::Match> &vpPointCue::matches() const
{
  return m_impl->matches;
}
std::size_t vpPointCue::pointCount() const
{
  return 0;
}

END_VISP_NAMESPACE
