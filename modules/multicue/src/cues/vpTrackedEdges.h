// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpTrackedEdges_h
#define vpTrackedEdges_h

#include "knowledge/vpTextureSupport.h"

#include <visp3/cues/vpEdgeCue.h>
#include <visp3/multicue/vpTrackedCue.h>

BEGIN_VISP_NAMESPACE

//! Edges of the model, those of its texture included.
class vpTrackedEdges : public vpTrackedCue
{
public:
  vpEdgeCue &cue() override { return m_edges; }
  const vpEdgeCue &cue() const { return m_edges; }
  unsigned int expected() const override { return static_cast<unsigned int>(m_edges.matches().size()); }
  std::optional<double> agreement(const vpHomogeneousMatrix &cMo, const vpCameraParameters &camera) override;
  std::string missing() const override;
  void matchFine(const vpCueFrame &image, const vpModelView &view, unsigned int round) override;
  bool matchStart(const vpCueFrame &, const vpModelView &) override { return false; }
  void learn(const vpHomogeneousMatrix &cMo, const std::vector<double> &weights, vpModelLooks &looks) override;
  void noteLoss(bool) override { m_edges.reset(); }
  void forget(vpModelLooks &looks) override;

  //! Where the prediction says how far edges can be: the length of the search in rounds of all cues, pixels; 0: as set.
  void setRange(double pixels) { m_range = pixels; }

private:
  vpEdgeCue m_edges;
  vpTextureSupport m_texture;
  double m_range = 0.;
};

//! Searches with other settings while it lives, and leaves the cue as it was set, whatever happens meanwhile.
class vpOtherEdgeSettings
{
public:
  vpOtherEdgeSettings(vpEdgeCue &edges, const vpEdgeCueSettings &settings) : m_edges(edges), m_asSet(edges.settings())
  {
    m_edges.setSettings(settings);
  }
  ~vpOtherEdgeSettings() { m_edges.setSettings(m_asSet); }
  vpOtherEdgeSettings(const vpOtherEdgeSettings &) = delete;
  vpOtherEdgeSettings &operator=(const vpOtherEdgeSettings &) = delete;

private:
  vpEdgeCue &m_edges;
  const vpEdgeCueSettings m_asSet;
};

END_VISP_NAMESPACE
#endif
