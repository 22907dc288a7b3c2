// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpTrackedPoints_h
#define vpTrackedPoints_h

#include <visp3/cues/vpPointCue.h>
#include <visp3/multicue/vpTrackedCue.h>

BEGIN_VISP_NAMESPACE

//! Points on the surface. They are matched once in a frame, before the other cues, since they reach far: see
//! vpFusedEstimator.
class vpTrackedPoints : public vpTrackedCue
{
public:
  //! Null while they are not used.
  vpPointCue *points() { return m_points.get(); }
  const vpPointCue *points() const { return m_points.get(); }
  const vpPointCueSettings &settings() const { return m_settings; }
  //! \throw vpException naming what is out of range.
  void setSettings(const vpPointCueSettings &settings);

  vpPointCue &cue() override { return *m_points; }
  const vpPointCue &cue() const { return *m_points; }
  //! Two rows each.
  unsigned int expected() const override { return static_cast<unsigned int>(2 * m_points->matches().size()); }
  std::optional<double> agreement(const vpHomogeneousMatrix &cMo, const vpCameraParameters &camera) override;
  std::string missing() const override;
  void setUsed(bool isUsed, vpModelLooks &looks) override;
  void matchFine(const vpCueFrame &, const vpModelView &, unsigned int) override {}
  void learnRefused(const vpHomogeneousMatrix &cMo, const vpCameraParameters &camera) override;
  void noteLoss(bool isSearched) override;
  void forget(vpModelLooks &looks) override;

  //! How many points agree with a pose, each as far as it does, of those that were found.
  struct Agreeing
  {
    double sum = 0.;
    std::size_t found = 0;
  };
  Agreeing agreeing(const vpHomogeneousMatrix &cMo, const vpCameraParameters &camera);

private:
  vpPointCueSettings m_settings;
  std::unique_ptr<vpPointCue> m_points;
  vpResidualBlock m_block; // Scratch memory.
};

END_VISP_NAMESPACE
#endif
