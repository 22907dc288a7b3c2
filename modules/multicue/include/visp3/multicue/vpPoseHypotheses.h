// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpPoseHypotheses_h
#define vpPoseHypotheses_h

#include <visp3/cues/vpEdgeCue.h>

#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

BEGIN_VISP_NAMESPACE

/*!
  \ingroup group_multicue
  How several poses are drawn from the edges that one image offers ([T10] II).
*/
struct VISP_EXPORT vpPoseHypothesisSettings
{
  bool enabled = false; //!< Off: the pose is the one that the nearest candidates lead to.
  //! Selectivity of a draw, [T10] eq. 4: the class with the largest residue is exp(-lambda) times as likely as the best
  //! one, [0, 100].
  double lambda = 1.;
  unsigned int draws = 25;        //!< Largest number of draws for a match, [1, 10000].
  unsigned int minimisations = 5; //!< Draws that are minimised in a frame, [1, 1000]; each search has at least one.
  //! Poses whose control points are closer to one another than this in the mean are one pose, pixels, (0, 100].
  double mergeTolerance = 1.;
  //! Where no pose explains the image, candidates are looked for up to this many search ranges away, and for as many
  //! times fewer ones of each control point, [1, 10]; 1: never.
  double reach = 2.;
  unsigned int seed = 1; //!< The same seed gives the same poses.

  //! \throw vpException naming the first member out of range.
  void check() const;
};

/*!
  \ingroup group_multicue
  One of the poses that an image allows.
*/
struct vpPoseHypothesis
{
  vpHomogeneousMatrix cMo;
  /*!
    Root of the mean squared distance of the control points to their nearest candidates, pixels. Distances count up to
    vpPoseHypotheses::cutoff, and points without candidates count as much, so that the residues of poses that explain
    different parts of the image can be compared.
  */
  double residue = 0.;
  double weight = 0.; //!< Share of the probability, from residue and motion; they add up to 1.
  //! Class drawn for each contour, in the order of vpPoseHypotheses::contours(); -1 where it had none.
  std::vector<int> classes;
};

/*!
  \ingroup group_multicue
  Several poses for one image ([T10] II): the candidates of each contour are segmented into potential edges
  (vpEdgeClustering), combinations of one potential edge for each contour are drawn, and each is minimised.

  [T10] draws each contour by itself; with n contours of two alike potential edges a draw is then right once in 2^n.
  Here the contours of a draw are taken one after the other, in random order, and the weights of [T10] eq. 4 are
  multiplied by how well each potential edge agrees with the motion that the ones before it tell, to first order. Equal
  draws and those that lead to the same motion are minimised once: of the most coherent ones those first whose
  motion brings the control points nearest to candidates.

  Needs no tracker: any pose can be started from. An object serves one thread at a time; several may share one
  vpEdgeCue, which is only read.
*/
class VISP_EXPORT vpPoseHypotheses
{
public:
  static constexpr double cutoff = 3.; //!< Farther candidates do not support a pose, pixels.

  //! A run of control points that moves as a whole: a straight edge, or a bit of a curve.
  struct Contour
  {
    int first = 0;   //!< Its first control point among vpEdgeCue::matches().
    int count = 0;   //!< Number of its control points.
    int classes = 0; //!< Number of its potential edges.
  };

  //! A potential edge, for display.
  struct Line
  {
    int contour = 0;
    int label = 0;
    double weight = 1.;                  //!< [T10] eq. 4.
    std::vector<Eigen::Vector2d> points; //!< In the frame, pixels.
  };

  explicit vpPoseHypotheses(const vpPoseHypothesisSettings &settings = vpPoseHypothesisSettings());
  ~vpPoseHypotheses();
  vpPoseHypotheses(vpPoseHypotheses &&) noexcept;
  vpPoseHypotheses &operator=(vpPoseHypotheses &&) noexcept;

  //! \throw vpException naming the member that is out of range; the old settings then stay.
  void setSettings(const vpPoseHypothesisSettings &settings);
  const vpPoseHypothesisSettings &settings() const;
  //! Keeps motions out of the estimation. \param oJo 6 x 6 projector in the object frame, as vpMbTracker has it.
  void setEstimatedMotions(const vpMatrix &oJo);

  /*!
    Finds the poses for an image that was matched. Never throws because of what it shows: there may be no pose.
    \param edges Matched with \e view.
    \param view Control points at \e cMo.
    \param cMo Pose to start from.
    \param stream What the draws are for, such as the number of the frame: another number, other draws.
    \param limit Largest number of minimisations; 0: that of the settings.
    \param decisive Only where the first pose leaves a residue below this are others looked for, pixels.
    \return The poses, best first; good until the next call.
  */
  const std::vector<vpPoseHypothesis> &find(const vpEdgeCue &edges, const vpModelView &view,
                                            const vpHomogeneousMatrix &cMo, std::uint64_t stream,
                                            unsigned int limit = 0,
                                            double decisive = std::numeric_limits<double>::infinity());

  /*!
    Minimises one of the poses once more, with the nearest candidates of a match at this very pose, and takes its
    residue from there: this tells poses apart that the first match, at the pose before, does not. \param index Of
    hypotheses(). \param edges Matched at its pose. \param diameter Of the object, metres.
  */
  void refine(std::size_t index, const vpEdgeCue &edges, double diameter);
  //! Brings hypotheses() back into order after refine().
  void rank();
  //! Forgets the last find().
  void clear();
  //! The poses of the last find().
  const std::vector<vpPoseHypothesis> &hypotheses() const;
  //! What was segmented in the last find().
  const std::vector<Contour> &contours() const;
  //! The potential edges of the last find().
  std::vector<Line> lines() const;
  //! Number of draws in the last find() that led to different motions.
  unsigned int differentDraws() const;
  //! Number of draws that were minimised in the last find().
  unsigned int minimisations() const;

private:
  class Impl;
  std::unique_ptr<Impl> m_impl;
};

END_VISP_NAMESPACE
#endif
