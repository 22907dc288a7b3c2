// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpPointPoses_h
#define vpPointPoses_h

#include <visp3/cues/vpKeyframes.h>

#include <Eigen/Geometry>

BEGIN_VISP_NAMESPACE

//! A place on the object and where an image may show it.
struct vpPointMatch
{
  Eigen::Vector3d position; // Object frame, metres.
  Eigen::Vector2d place;    // Normalised coordinates.
  double doubt = 0.;        // Low for those that are likely to be right.
};

/*
  Poses that many of the matches agree on, however many are wrong (Fischler and Bolles 1981): drawn from three matches
  at a time, those with little doubt more often (as Chum and Matas 2005).
*/
class vpPointPoses
{
public:
  // \param reach How far the image may show a place from where the pose has it, normalised coordinates.
  vpPointPoses(std::vector<vpPointMatch> matches, double reach);

  static unsigned int agreeing(const std::vector<vpPointMatch> &matches, const Eigen::Isometry3d &pose, double reach);

  // Draws poses, and keeps the best two that differ. \param centre Of the object.
  void draw(const Eigen::Vector3d &centre, double diameter, const vpKeyframes::Where &where);
  // The best first. Poses are refined with all the matches that agree.
  const std::vector<vpKeyframePose> &poses() const { return m_poses; }

private:
  struct Vote
  {
    double value = 0.;
    unsigned int agreeing = 0;
  };
  Vote vote(const Eigen::Isometry3d &pose) const;
  bool isAllowed(const Eigen::Isometry3d &pose) const;
  void consider(const Eigen::Isometry3d &pose);
  Eigen::Isometry3d refined(const Eigen::Isometry3d &pose) const;

  struct Drawn
  {
    Eigen::Isometry3d pose;
    Vote vote;
  };
  std::vector<vpPointMatch> m_matches;
  double m_reach;
  Eigen::Vector3d m_centre = Eigen::Vector3d::Zero();
  double m_diameter = 1.;
  Eigen::Isometry3d m_expected = Eigen::Isometry3d::Identity();
  double m_shift = 0.; // Metres.
  double m_turn = 0.;
  std::vector<Drawn> m_best;
  std::vector<vpKeyframePose> m_poses;
};

END_VISP_NAMESPACE
#endif
