// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpEdgeCue_h
#define vpEdgeCue_h

#include <visp3/cues/vpPoseCue.h>
#include <visp3/me/vpMe.h>

BEGIN_VISP_NAMESPACE

class vpLineProjector;

/*!
  \ingroup group_cues_edge
  How edges are looked for.
*/
struct VISP_EXPORT vpEdgeCueSettings
{
  //! The two scales of ViSP's moving-edge threshold.
  enum ThresholdScale
  {
    LIKELIHOOD, //!< ViSP up to 3.5, and OLD_THRESHOLD from 3.6 on: grows with the mask (10000 is 5 gray levels for 5 x
                //!< 5).
    CONTRAST    //!< NORMALIZED_THRESHOLD of ViSP from 3.6 on: gray levels.
  };

  static constexpr double maxRange = 100.; //!< Pixels.

  double range = 10.;          //!< Half length of the search along the normal, pixels, [1, maxRange].
  double contrast = 5.;        //!< Smallest difference of the gray levels on both sides, (0, 255].
  double mu1 = 0.5;            //!< The contrast may fall by this share from one frame to the next, [0, 1].
  double mu2 = 0.5;            //!< The contrast may grow by this share from one frame to the next, >= 0.
  unsigned int maskSize = 5;   //!< Pixels that a gradient is taken over, across and along the edge, [3, 15].
  unsigned int candidates = 3; //!< Edges kept for a control point: 1 is ViSP's classical tracker; [1, 8].

  /*!
    Takes over range, threshold, mu1, mu2 and mask size.
    \param me ViSP's parameters.
    \param scale Scale of the threshold of \e me.
  */
  void set(const vpMe &me, ThresholdScale scale);
  //! Likewise, in the scale that \e me itself names (ViSP 3.6 and later; LIKELIHOOD for older ones).
  void set(const vpMe &me);
  //! \return \e threshold in gray levels. \param maskSize Side of the mask, pixels.
  static double toContrast(double threshold, ThresholdScale scale, unsigned int maskSize);

  //! \return \e contrast (gray levels) in the scale LIKELIHOOD. \param maskSize Side of the mask, pixels.
  static double toLikelihood(double contrast, unsigned int maskSize);

  //! \throw vpException naming the first member out of range.
  void check() const;
};

/*!
  \ingroup group_cues_edge
  Distances between projected edges and edges of the image ([T10] II, [P14] eq. 6 and 7).

  Each control point is searched along its normal for local extrema of the gradient, to a fraction of a pixel. As in
  ViSP's moving edges, a point remembers its contrast, and what differs too much from it is no candidate. Of several
  candidates the one nearest to the projected edge counts, chosen anew for every pose (*minimum mode*, [P14] eq. 7). The
  error is the distance of the candidate to the projected line through the control point, in normalised coordinates
  (metres at 1 m); its interaction matrix has the dependence of the line's normal on the pose in it.
*/
class VISP_EXPORT vpEdgeCue : public vpPoseCue
{
public:
  //! An edge found in the image.
  struct Candidate
  {
    Eigen::Vector2d place; //!< In the image, normalised coordinates (metres at 1 m).
    double offset = 0.;    //!< Along the control point's normal, pixels.
    double contrast = 0.;  //!< Gray levels: brighter (positive) or darker (negative) along the normal.
  };
  //! A control point and what was found for it.
  struct Match
  {
    vpControlPoint point;
    double reach = 1.;  //!< Stretch of the model edge that it stands for, as a difference of vpControlPoint::parameter.
    double length = 0.; //!< The same in the image, pixels; 0 where it is alone on its edge.
    int first = 0;      //!< Index of its first candidate.
    int count = 0;      //!< Number of its candidates, best first; 0: nothing found.
    vpFeatureState state = vpFeatureState::GOOD; //!< Why nothing was found.
    /*!
      How well the image can show an edge there, [0, 1]: 0 where all is darker than the smallest contrast around the
      point, 1 from twice that on. See \ref cues_edge_light.
    */
    double light = 1.;
    /*!
      How far the nearest candidate is evidence of this edge, (0, 1]: less than 1 where other model edges beside it take
      the same edge of the image for theirs. See \ref cues_edge_claims.
    */
    double claim = 1.;
    bool onSurface = false; //!< The edge is one of the model's texture.
  };

  //! What residuals() takes of a control point where it is not told a candidate by its index.
  enum Choice
  {
    NEAREST = -1, //!< The candidate nearest to the projected edge.
    NO_ROW = -2   //!< Nothing.
  };

  explicit vpEdgeCue(const vpEdgeCueSettings &settings = vpEdgeCueSettings());

  //! \throw vpException naming the member that is out of range; the old settings then stay.
  void setSettings(const vpEdgeCueSettings &settings);
  const vpEdgeCueSettings &settings() const { return m_settings; }

  void match(const vpCueFrame &frame, const vpModelView &view) override;
  //! One row for each control point with candidates, in the order of matches().
  void residuals(const vpHomogeneousMatrix &cMo, vpResidualBlock &block) const override;
  /*!
    Likewise with candidates that the caller chose.
    \param cMo Pose.
    \param choices For each of matches(): which of its candidates, 0 for the first, or a Choice. Control points without
    candidates give no row in any case.
    \param block Result.
    \throw vpException where there is not one choice for each match.
  */
  void residuals(const vpHomogeneousMatrix &cMo, const std::vector<int> &choices, vpResidualBlock &block) const;
  void updateReference(const vpHomogeneousMatrix &cMo, const std::vector<double> &weights) override;
  void reset() override;
  void getFeatures(const vpHomogeneousMatrix &cMo, const std::vector<double> &weights,
                   std::vector<vpCueFeature> &features) const override;

  /*!
    Takes it that the light has changed all contrasts since the last updateReference() by one factor, as it does when a
    lamp is switched or a camera's exposure jumps: what is remembered is multiplied by the median of those that the
    image has at the view's pose. \param frame Image. \param view Of the pose where the object is expected. \return The
    factor; 1 where fewer than 8 control points tell it.
  */
  double adaptToLight(const vpCueFrame &frame, const vpModelView &view);

  /*!
    How well the last match agrees with a pose.
    \param cMo Pose.
    \param reach Distance of a candidate from which on it does not agree, pixels, > 0.
    \return Mean over the control points of 1 - (distance / reach)^2, 0 where no candidate is within reach, in [0, 1];
    each counts as far as there is light. 0 without control points.
  */
  double agreement(const vpHomogeneousMatrix &cMo, double reach) const;
  //! The same for each of matches(): 1 - (distance / reach)^2, 0 where no candidate is within reach.
  std::vector<double> agreements(const vpHomogeneousMatrix &cMo, double reach) const;

  /*!
    Says how far off the pose may be that residuals() are asked for. Each control point then takes its likeliest
    candidate in place of the nearest: the k-th best of n on a line of length 2 R is met by chance with a density of
    k / 2 R, so that the cost of a candidate at a distance d is d^2 / (2 s^2) + log k. Far off, the best candidate
    counts, as in ViSP's moving edges; near, the nearest.
    \param pixels Deviation s of the projected edges, pixels; 0, the default: the nearest candidate.
  */
  void setUncertainty(double pixels) { m_uncertainty = pixels; }

  /*!
    How much more likely the last match is at a pose than anywhere else: the mean over the control points of the
    logarithm of \f$ p + (1 - p) \max_k \frac{2R}{k} N(d_k; \sigma) \f$, with p the share of edges that a right pose
    misses, too. Each counts as far as there is light. \param cMo Pose. \return Log p at least; 0 without control
    points.
  */
  double evidence(const vpHomogeneousMatrix &cMo) const;

  const std::vector<Match> &matches() const { return m_matches; }
  const std::vector<Candidate> &candidates() const { return m_candidates; }
  //! Camera of the last match.
  const vpCameraParameters &camera() const { return m_camera; }

private:
  // Contrast of one stretch of a model edge in the frame where it was last seen, in the sense of the edge's own
  // direction.
  struct Memory
  {
    float contrast = 0.F;
    bool known = false;
  };

  void match(const vpCueFrame &frame, const vpModelView &view, const vpEdgeCueSettings &settings);
  void shareCandidates();
  double agreementOf(const Match &match, const vpLineProjector &project, double reach) const;
  void addRow(const Match &match, int choice, const vpLineProjector &project, std::vector<vpResidual> &rows) const;
  const Memory *recall(const vpControlPoint &point) const;
  void remember(const Match &match, const Memory &memory);

  double evidenceOf(const Match &match, const vpLineProjector &project) const;

  vpEdgeCueSettings m_settings;
  double m_uncertainty = 0.; // Pixels.
  vpCameraParameters m_camera;
  std::vector<Match> m_matches;
  std::vector<Candidate> m_candidates;
  std::vector<Memory> m_memory;
};

END_VISP_NAMESPACE
#endif
