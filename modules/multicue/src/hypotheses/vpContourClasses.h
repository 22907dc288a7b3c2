// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpContourClasses_h
#define vpContourClasses_h

#include "hypotheses/vpMotionFrame.h"

#include <visp3/cues/vpEdgeClustering.h>
#include <visp3/multicue/vpPoseHypotheses.h>

BEGIN_VISP_NAMESPACE

//! The potential edges of all contours, and what each of them says about the motion, to first order.
class vpContourClasses
{
public:
  //! A potential edge. Its members' squared distances after the motion y add up to y' A y + 2 b' y + c, pixels.
  struct Class
  {
    int size = 0; //!< Number of members.
    double residue = 0.;
    double weight = 1.; //!< [T10] eq. 4.
    vpPoseMatrix6 A;
    vpPoseTangent b;
    double c = 0.;

    //! Mean squared distance of the members after the motion \e y, square pixels.
    double error(const vpPoseTangent &y) const { return std::max((y.dot(A * y + 2. * b) + c) / size, 0.); }
  };

  struct Contour
  {
    int first = 0;      // Of the matches.
    int count = 0;      // Matches.
    int firstClass = 0; // Of classes().
    int classes = 0;
  };

  /*!
    \param toCamera From the motions that are estimated to the camera's velocity.
    \param lambda Of [T10] eq. 4.
  */
  void compute(const vpEdgeCue &edges, const vpModelView &view, const vpHomogeneousMatrix &cMo,
               const vpPoseMatrix6 &toCamera, double lambda);

  const std::vector<Contour> &contours() const { return m_contours; }
  const std::vector<Class> &classes() const { return m_classes; }
  const Class &at(const Contour &contour, int label) const
  {
    return m_classes[static_cast<std::size_t>(contour.firstClass + label)];
  }
  //! For each match the candidate that is in its contour's class \e label, or vpEdgeCue::NO_ROW.
  const std::vector<int> &members(int label) const { return m_members[static_cast<std::size_t>(label)]; }
  //! Displacement of a match by the mean of its contour's class \e label, pixels.
  double displacement(int label, int match) const
  {
    return m_displacements[static_cast<std::size_t>(label)][static_cast<std::size_t>(match)];
  }
  //! Root of the mean squared difference that two motions make to the distances of control points, pixels.
  double difference(const vpPoseTangent &y1, const vpPoseTangent &y2) const;
  //! Number of classes that the contour with the most of them has.
  int most() const { return m_most; }

private:
  void split(const vpEdgeCue &edges, const vpModelView &view);
  int splitCurve(const std::vector<vpEdgeCue::Match> &matches, int first, int end);
  void addContour(const std::vector<vpEdgeCue::Match> &matches, int first, int end, vpEdgeClustering::Shape shape,
                  double turn);
  void cluster(const vpEdgeCue &edges, Contour &contour, vpEdgeClustering::Shape shape, double turn, double lambda);
  void linearise(const vpEdgeCue &edges, const vpHomogeneousMatrix &cMo, const vpPoseMatrix6 &toCamera);

  struct Form
  {
    vpEdgeClustering::Shape shape;
    double turn;
  };

  vpEdgeClustering m_clustering;
  std::vector<Contour> m_contours;
  std::vector<Form> m_forms; // Of the contours.
  std::vector<Class> m_classes;
  std::array<std::vector<int>, vpEdgeClustering::maxClasses> m_members;
  std::array<std::vector<double>, vpEdgeClustering::maxClasses> m_displacements;
  int m_most = 0;
  vpPoseMatrix6 m_meanA = vpPoseMatrix6::Zero(); // Mean of the members' A.
  std::vector<double> m_weights;
  vpResidualBlock m_block;
};

END_VISP_NAMESPACE
#endif
