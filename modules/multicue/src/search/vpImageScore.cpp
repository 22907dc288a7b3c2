// SPDX-License-Identifier: GPL-2.0-or-later
#include "search/vpImageScore.h"

#include "frame/vpStopwatch.h"

#include <visp3/core/vpException.h>

#include <filesystem>

BEGIN_VISP_NAMESPACE

namespace {
// What colours and surface count in a search after a loss: other sides are seen, and other light.
const double othersAfterLoss = 0.5;
const double othersByEdges = 0.15; // The same in one by edges.
const unsigned int spherePoints = 100;
// Of the sphere, to look for poses: neighbouring views are 17 degrees apart.
const unsigned int leastLevel = 2;
// The first steps of an alignment look at one point of so many. With all of them, 97.7 % of the frames of three objects
// in a hand were followed (three images apart, three sequences), with every second one in all steps 97.3 %.
const std::size_t everyAtFirst = 2;
const std::size_t keptParents = 24;
// Drawn about those that were aligned: more of them, or in further layers, found nothing that more draws before did
// not.
const std::size_t childrenOfAligned = 48;
const std::size_t children = 200;
const unsigned int layers = 3;
const vpPoseSearch::Spread aroundSettled = {0.05, 0.15, 0.08};

// The best poses after a first alignment, with those that were not to be lost by it.
void keepSettled(vpPoseSearch &search)
{
  search.addCopies();
  search.score();
  search.keepBest(4 * keptParents, {0.04, 0.12, 0.08});
}

std::size_t shareOf(double share, std::size_t number)
{
  return static_cast<std::size_t>(share * static_cast<double>(number));
}
} // namespace

void vpImageScore::setModel()
{
  m_maker.reset();
  m_sphere.reset();
  m_level = 0;
}

// The CPU draws its depth buffers, so that they may be drawn in any thread.
void vpImageScore::makeSphere()
{
  vpViewSphereOptions options;
  options.points = spherePoints;
  const bool isConvex = m_looks.model().isConvex();
  m_sphere = std::make_unique<vpViewSphere>(
      m_looks.pointer(), options,
      isConvex ? nullptr : vpModelRenderer::create(m_looks.pointer(), vpModelRenderer::CPU));
  loadViews();
  m_score.setSphere(m_sphere.get());
  m_aligner.setSphere(m_sphere.get());
  m_contourScan.setSphere(m_sphere.get());
}

// A file that is damaged, or of another version, is as good as none: it is replaced once all views are made.
void vpImageScore::loadViews()
{
  if (m_viewCache.empty()) {
    return; // The file's name takes a look at all of the model.
  }
  const std::filesystem::path file = std::filesystem::path(m_viewCache) / m_sphere->fileName();
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored)) {
    return;
  }
  try {
    m_sphere->load(file.string());
  } catch (const vpException &) {
  }
}

void vpImageScore::setLevel(unsigned int level)
{
  m_level = level;
  m_score.setLevel(level);
  m_aligner.setLevel(level);
  m_contourScan.setLevel(level);
}

vpViewSphere &vpImageScore::sphere()
{
  m_maker.reset();
  if (!m_sphere) {
    makeSphere();
  }
  setLevel(m_sphere->options().level);
  return *m_sphere;
}

void vpImageScore::prepare(bool isTimed)
{
  if (!isTimed) {
    m_maker.reset();
    if (m_sphere) {
      setLevel(m_sphere->options().level);
    }
    return;
  }
  if (!m_sphere) {
    makeSphere();
  }
  if (!m_maker) {
    for (std::size_t i = 0; i < vpViewSphere::size(0); ++i) { // Of which some view is always at hand.
      m_sphere->make(i);
    }
    m_maker = std::make_unique<vpViewMaker>(*m_sphere, m_viewCache);
  }
  setLevel(m_maker->level());
}

void vpImageScore::setFrame(const vpFrameContext &frame)
{
  if (!hasWhole(frame)) {
    setRegion(frame, {0, 0, static_cast<int>(frame.image.width()), static_cast<int>(frame.image.height())});
    m_wholeFrame = frame.image.number();
  }
}

bool vpImageScore::setFrameInTime(const vpFrameContext &frame)
{
  if (m_maker && m_level < leastLevel) {
    frame.deadline.notePutOff(vpPutOff::SEARCH);
    return false;
  }
  if (frame.deadline.putsOff(vpPutOff::SEARCH)) {
    return false;
  }
  const vpTimedWork work(frame.deadline, vpPutOff::SEARCH);
  setFrame(frame);
  return true;
}

void vpImageScore::setRegion(const vpFrameContext &frame, const vpImageRegion &region)
{
  if (!m_sphere) {
    sphere();
  }
  const vpStopwatch stage(frame.timings.map);
  const vpCueFrame &image = frame.image;
  m_distances.compute(image, region);
  m_hasColors = m_cues.knowsColors();
  if (m_hasColors) {
    m_odds.compute(image, m_cues.color().histograms(), region);
  }
  m_aligner.setImage(m_hasColors ? &m_odds : nullptr, &m_distances, image.camera(), image.width(), image.height());
  const bool hasSurface = !m_cues.isEdgesAlone();
  if (hasSurface) {
    m_knowledge.surface.setFrame(image);
  }
  weigh(false);
  m_score.setImage(m_cues.uses(vpCueSet::EDGE) ? &m_distances : nullptr, m_hasColors ? &m_odds : nullptr,
                   hasSurface ? &m_knowledge.surface : nullptr, image.camera(), image.width(), image.height());
}

void vpImageScore::weigh(bool byEdges)
{
  const double others = byEdges ? othersByEdges : m_situation.mustConfirm ? othersAfterLoss : 1.;
  const vpAgreement &unsteadiness = m_knowledge.unsteadiness;
  m_score.setWeights(vpObjectKnowledge::reliability(unsteadiness.cues[vpCueSet::EDGE]),
                     others * vpObjectKnowledge::reliability(unsteadiness.cues[vpCueSet::COLOR]),
                     others * vpObjectKnowledge::reliability(unsteadiness.surface));
}

double vpImageScore::insideShare(const vpHomogeneousMatrix &cMo)
{
  if (!m_sphere) {
    sphere();
  }
  vpPoseScore outline; // What the score looks at stays as it is.
  outline.setSphere(m_sphere.get());
  outline.setLevel(m_level);
  outline.setImage(nullptr, nullptr, nullptr, m_looks.camera(), m_looks.width(), m_looks.height());
  return outline(cMo).inside;
}

void vpImageScore::settle(vpPoseSearch &search, double share)
{
  if (!m_hasColors) {
    settleByScore(search, share);
    return;
  }
  if (m_situation.mustConfirm || m_knowledge.hasUnsteadyColors()) {
    search.keepCopies(); // Poses are looked at where they were drawn, too.
  }
  search.alignByColors(m_aligner, 0.15, 2, everyAtFirst);
  search.alignByColors(m_aligner, 0.08, 1, everyAtFirst);
  keepSettled(search);
  search.alignByColors(m_aligner, 0.05, 2);
  // A right pose's peak is narrow: what is drawn around those that are near to it slides to where it fits before it is
  // looked at.
  search.score();
  search.breed(aroundSettled, keptParents, shareOf(share, childrenOfAligned));
  search.keepCopies();
  search.alignByColors(m_aligner, 0.05, 1);
  if (m_cues.uses(vpCueSet::EDGE)) {
    search.alignByEdges(m_aligner, 2);
  }
  search.addCopies();
  search.score();
  search.keepBest(keptParents, aroundSettled.halved());
}

void vpImageScore::settleByScore(vpPoseSearch &search, double share) const
{
  if (!m_cues.uses(vpCueSet::EDGE)) {
    search.score();
    search.anneal(vpPoseSearch::near(), keptParents, shareOf(share, children), layers);
    return;
  }
  search.keepCopies(); // Where edges are many, the nearest ones may lead away from the object's.
  search.alignByEdges(m_aligner, 3);
  keepSettled(search);
  search.alignByEdges(m_aligner, 2);
  search.score();
  search.anneal(aroundSettled, keptParents, shareOf(share, children), layers - 1);
}

END_VISP_NAMESPACE
