// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/multicue/vpPoseHypotheses.h>

#include "hypotheses/vpClassDraw.h"
#include "hypotheses/vpPoseSolver.h"
#include "hypotheses/vpRankedPoses.h"

#include <opencv2/core/utility.hpp>

#include <algorithm>
#include <cmath>
#include <deque>
#include <numeric>

BEGIN_VISP_NAMESPACE

namespace {
// A minimisation of chosen candidates starts from the motion of the first order; the one of the nearest candidates
// after it starts close to its end.
const unsigned int chosenIterations = 4;
const unsigned int nearestIterations = 3;
// Draws whose motions are compared in the image.
const std::size_t maxScored = 12;
// Share of the control points that contours with a potential edge must have to tell a pose alone.
const double leastDrawn = 0.5;
} // namespace

class vpPoseHypotheses::Impl
{
public:
  // What one minimisation needs for itself.
  struct Work
  {
    vpPoseSolver solver;
    std::vector<int> choices;
    const vpClassDraw::Draw *draw = nullptr;
    vpHomogeneousMatrix cMo;
    double error = 0.;
    bool found = false;
  };

  void score(const vpEdgeCue &edges, const vpHomogeneousMatrix &cMo);
  void select(unsigned int limit);
  void choose(const vpClassDraw::Draw &draw, std::vector<int> &choices) const;
  void minimise(const vpEdgeCue &edges, double diameter, const vpHomogeneousMatrix &cMo, double decisive);
  vpHomogeneousMatrix start(const vpClassDraw::Draw &draw, const vpHomogeneousMatrix &cMo) const;
  void run(const vpEdgeCue &edges, double diameter, const vpHomogeneousMatrix &cMo, Work &work) const;
  void merge(const vpEdgeCue &edges, const vpModelView &view);
  void record(const vpEdgeCue &edges);

  vpPoseHypothesisSettings settings;
  vpPoseMatrix6 freeMotions = vpPoseMatrix6::Identity();
  vpPoseMatrix6 seenMotions = vpPoseMatrix6::Identity(); // Of the free ones those that the image shows.
  vpPoseMatrix6 toCamera;                                // From a draw's motion to the camera's velocity.
  vpContourClasses classes;
  vpClassDraw draws;
  std::vector<std::size_t> order; // Of the draws, the best first.
  std::vector<double> scores;     // Of each draw.
  std::deque<Work> works; // Memory, which grows without copies as vpCueFusion's; the first `minimised` are in use.
  std::size_t minimised = 0;
  vpRankedPoses found;
  vpPoseSolver solver;
  std::vector<Contour> contours;
  std::vector<vpControlPoint> points; // Of the matches, for lines().
};

vpPoseHypotheses::vpPoseHypotheses(const vpPoseHypothesisSettings &settings) : m_impl(std::make_unique<Impl>())
{
  setSettings(settings);
}

vpPoseHypotheses::~vpPoseHypotheses() = default;
vpPoseHypotheses::vpPoseHypotheses(vpPoseHypotheses &&) noexcept = default;
vpPoseHypotheses &vpPoseHypotheses::operator=(vpPoseHypotheses &&) noexcept = default;

void vpPoseHypotheses::setSettings(const vpPoseHypothesisSettings &settings)
{
  settings.check();
  m_impl->settings = settings;
}

const vpPoseHypothesisSettings &vpPoseHypotheses::settings() const
{
  return m_impl->settings;
}

void vpPoseHypotheses::setEstimatedMotions(const vpMatrix &oJo)
{
  m_impl->freeMotions = vpMotionFrame::toEigen(oJo);
}

// Where a draw leads to, to first order.
vpHomogeneousMatrix vpPoseHypotheses::Impl::start(const vpClassDraw::Draw &draw, const vpHomogeneousMatrix &cMo) const
{
  return vpPoseExponential::exp(toCamera * draw.motion).inverse() * cMo;
}

// The most coherent draws, in the order of what their motion leaves unexplained of all control points: that tells more
// than their coherence, which is that of the drawn classes and of the first order, and costs a tenth of a minimisation.
void vpPoseHypotheses::Impl::score(const vpEdgeCue &edges, const vpHomogeneousMatrix &cMo)
{
  order.resize(draws.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(),
                   [this](std::size_t a, std::size_t b) { return draws[a].error < draws[b].error; });
  scores.resize(order.size());
  const auto end = order.begin() + static_cast<std::ptrdiff_t>(std::min(order.size(), maxScored));
  std::for_each(order.begin(), end,
                [&](std::size_t i) { scores[i] = solver.error(edges, start(draws[i], cMo), cutoff); });
  std::stable_sort(order.begin(), end, [this](std::size_t a, std::size_t b) { return scores[a] < scores[b]; });
}

// The draws to minimise.
void vpPoseHypotheses::Impl::select(unsigned int limit)
{
  minimised = std::min<std::size_t>(order.size(), limit);
  works.resize(std::max(works.size(), minimised));
  for (std::size_t i = 0; i < minimised; ++i) {
    works[i].draw = &draws[order[i]];
  }
}

// What is in no drawn class takes no part, unless that is most of the object.
void vpPoseHypotheses::Impl::choose(const vpClassDraw::Draw &draw, std::vector<int> &choices) const
{
  const std::vector<int> &first = classes.members(0);
  choices.assign(first.size(), vpEdgeCue::NO_ROW);
  int drawn = 0;
  for (std::size_t i = 0; i < draw.classes.size(); ++i) {
    if (draw.classes[i] >= 0) {
      const vpContourClasses::Contour &contour = classes.contours()[i];
      const std::vector<int> &members = classes.members(draw.classes[i]);
      std::copy_n(members.begin() + contour.first, contour.count, choices.begin() + contour.first);
      drawn += contour.count;
    }
  }
  if (drawn < leastDrawn * static_cast<double>(choices.size())) {
    std::replace(choices.begin(), choices.end(), static_cast<int>(vpEdgeCue::NO_ROW),
                 static_cast<int>(vpEdgeCue::NEAREST));
  }
}

void vpPoseHypotheses::Impl::run(const vpEdgeCue &edges, double diameter, const vpHomogeneousMatrix &cMo,
                                 Work &work) const
{
  choose(*work.draw, work.choices);
  // From where the draw itself leads: seen from the pose before, the edges that moved would be its outliers.
  work.cMo = start(*work.draw, cMo);
  work.found = work.solver.minimise(edges, &work.choices, seenMotions, diameter, work.cMo, chosenIterations) &&
               work.solver.minimise(edges, nullptr, seenMotions, diameter, work.cMo, nearestIterations);
  if (work.found) {
    work.error = work.solver.error(edges, work.cMo, cutoff);
  }
}

void vpPoseHypotheses::Impl::minimise(const vpEdgeCue &edges, double diameter, const vpHomogeneousMatrix &cMo,
                                      double decisive)
{
  if (minimised == 0) {
    return;
  }
  run(edges, diameter, cMo, works[0]);
  if (std::isfinite(decisive) && !(works[0].found && works[0].error < decisive * decisive)) {
    minimised = 1;
  }
  if (minimised == 1) {
    return;
  }
  cv::parallel_for_(cv::Range(1, static_cast<int>(minimised)), [&](const cv::Range &range) {
    for (int i = range.start; i < range.end; ++i) {
      run(edges, diameter, cMo, works[static_cast<std::size_t>(i)]);
    }
  });
}

void vpPoseHypotheses::Impl::merge(const vpEdgeCue &edges, const vpModelView &view)
{
  found.start(classes.contours().size());
  for (std::size_t i = 0; i < minimised; ++i) {
    if (works[i].found) {
      found.add(works[i].cMo, works[i].error, works[i].draw->classes, edges, view, settings.mergeTolerance);
    }
  }
  found.rank();
}

void vpPoseHypotheses::Impl::record(const vpEdgeCue &edges)
{
  contours.clear();
  for (const vpContourClasses::Contour &contour : classes.contours()) {
    contours.push_back({contour.first, contour.count, contour.classes});
  }
  points.clear();
  for (const vpEdgeCue::Match &match : edges.matches()) {
    points.push_back(match.point);
  }
}

const std::vector<vpPoseHypothesis> &vpPoseHypotheses::find(const vpEdgeCue &edges, const vpModelView &view,
                                                            const vpHomogeneousMatrix &cMo, std::uint64_t stream,
                                                            unsigned int limit, double decisive)
{
  Impl &impl = *m_impl;
  const double diameter = view.model().diameter();
  impl.seenMotions = impl.solver.observed(edges, impl.freeMotions, diameter, cMo);
  impl.toCamera = vpPoseExponential::adjoint(cMo) * impl.seenMotions * vpMotionFrame::scale(diameter).asDiagonal();
  impl.classes.compute(edges, view, cMo, impl.toCamera, impl.settings.lambda);
  const double prior = edges.settings().range * std::max(cMo[2][3], 1e-9) / edges.camera().get_px();
  impl.draws.compute(impl.classes, prior, impl.settings.mergeTolerance, impl.settings.draws, impl.settings.seed,
                     stream);
  impl.score(edges, cMo);
  impl.select(limit > 0 ? limit : impl.settings.minimisations);
  impl.minimise(edges, diameter, cMo, decisive);
  impl.merge(edges, view);
  impl.record(edges);
  return impl.found.poses();
}

void vpPoseHypotheses::refine(std::size_t index, const vpEdgeCue &edges, double diameter)
{
  vpHomogeneousMatrix cMo = m_impl->found.poses().at(index).cMo;
  const vpPoseMatrix6 seen = m_impl->solver.observed(edges, m_impl->freeMotions, diameter, cMo);
  if (!m_impl->solver.minimise(edges, nullptr, seen, diameter, cMo, nearestIterations)) {
    cMo = m_impl->found.poses()[index].cMo;
  }
  m_impl->found.refine(index, cMo, m_impl->solver.error(edges, cMo, cutoff));
}

void vpPoseHypotheses::rank()
{
  m_impl->found.rank();
}

const std::vector<vpPoseHypothesis> &vpPoseHypotheses::hypotheses() const
{
  return m_impl->found.poses();
}

const std::vector<vpPoseHypotheses::Contour> &vpPoseHypotheses::contours() const
{
  return m_impl->contours;
}

std::vector<vpPoseHypotheses::Line> vpPoseHypotheses::lines() const
{
  std::vector<Line> lines;
  for (std::size_t i = 0; i < m_impl->contours.size(); ++i) {
    const vpContourClasses::Contour &contour = m_impl->classes.contours()[i];
    for (int label = 0; label < contour.classes; ++label) {
      Line line;
      line.contour = static_cast<int>(i);
      line.label = label;
      line.weight = m_impl->classes.at(contour, label).weight;
      for (int k = contour.first; k < contour.first + contour.count; ++k) {
        const vpControlPoint &point = m_impl->points[static_cast<std::size_t>(k)];
        line.points.push_back(point.pixel + m_impl->classes.displacement(label, k) * point.normal);
      }
      lines.push_back(line);
    }
  }
  return lines;
}

void vpPoseHypotheses::clear()
{
  m_impl->found.start(0);
  m_impl->contours.clear();
  m_impl->points.clear();
  m_impl->draws.clear();
  m_impl->minimised = 0;
}

unsigned int vpPoseHypotheses::differentDraws() const
{
  return static_cast<unsigned int>(m_impl->draws.size());
}

unsigned int vpPoseHypotheses::minimisations() const
{
  return static_cast<unsigned int>(m_impl->minimised);
}

END_VISP_NAMESPACE
