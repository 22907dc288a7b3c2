// SPDX-License-Identifier: GPL-2.0-or-later
#include "cues/vpTrackedColors.h"

BEGIN_VISP_NAMESPACE

// The coarse levels, which look far to both sides, are those that tell poses apart.
std::optional<double> vpTrackedColors::agreement(const vpHomogeneousMatrix &cMo, const vpCameraParameters &)
{
  return coarseLevels() == 0 ? std::nullopt : std::optional<double>(m_color.evidenceAt(cMo));
}

std::string vpTrackedColors::missing() const
{
  return "no silhouette point is inside the image with room on both sides";
}

void vpTrackedColors::matchLevel(const vpCueFrame &image, const vpModelView &view, unsigned int level)
{
  m_color.setLevel(level);
  m_color.match(image, view);
}

void vpTrackedColors::matchFine(const vpCueFrame &image, const vpModelView &view, unsigned int round)
{
  matchLevel(image, view, coarseLevels() + round); // Beyond the finest one: that one.
}

bool vpTrackedColors::matchStart(const vpCueFrame &image, const vpModelView &view)
{
  matchLevel(image, view, m_color.levels());
  return true;
}

vpCueReference vpTrackedColors::reference() const
{
  return std::make_shared<const vpColorCue::Reference>(m_color.reference());
}

void vpTrackedColors::recall(const vpCueReference &reference)
{
  m_color.setReference(*static_cast<const vpColorCue::Reference *>(reference.get()));
}

END_VISP_NAMESPACE
