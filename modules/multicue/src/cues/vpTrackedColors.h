// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpTrackedColors_h
#define vpTrackedColors_h

#include <visp3/cues/vpColorCue.h>
#include <visp3/multicue/vpTrackedCue.h>

BEGIN_VISP_NAMESPACE

//! Colours on both sides of the silhouette.
class vpTrackedColors : public vpTrackedCue
{
public:
  vpColorCue &cue() override { return m_color; }
  const vpColorCue &cue() const { return m_color; }
  unsigned int expected() const override { return static_cast<unsigned int>(m_color.lines().size()); }
  std::optional<double> agreement(const vpHomogeneousMatrix &cMo, const vpCameraParameters &camera) override;
  std::string missing() const override;
  void matchFine(const vpCueFrame &image, const vpModelView &view, unsigned int round) override;
  bool isFinest(unsigned int round) const override { return round + 1 >= m_color.settings().bands.size(); }
  bool matchStart(const vpCueFrame &image, const vpModelView &view) override;
  vpCueReference reference() const override;
  void recall(const vpCueReference &reference) override;

  //! Matches at one level, coarse or fine.
  void matchLevel(const vpCueFrame &image, const vpModelView &view, unsigned int level);
  unsigned int coarseLevels() const { return static_cast<unsigned int>(m_color.settings().scales.size()); }

private:
  vpColorCue m_color;
};

END_VISP_NAMESPACE
#endif
