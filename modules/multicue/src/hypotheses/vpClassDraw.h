// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpClassDraw_h
#define vpClassDraw_h

#include "hypotheses/vpContourClasses.h"

#include <visp3/se3/vpPoseRandom.h>

BEGIN_VISP_NAMESPACE

//! Draws one class for each contour, again and again, and keeps of the draws that lead to one motion the best.
class vpClassDraw
{
public:
  struct Draw
  {
    std::vector<int> classes; //!< For each contour, -1 where it has none.
    vpPoseTangent motion;     //!< That the classes tell, to first order.
    //! Mean squared distance of all control points after that motion, square pixels; what is far counts the cut-off.
    double error = 0.;
  };

  /*!
    \param prior Standard deviation of a motion, metres.
    \param tolerance Motions closer than this are one, see vpContourClasses::difference().
    \param count Largest number of draws.
    \param seed, stream Names of the random numbers.
  */
  void compute(const vpContourClasses &classes, double prior, double tolerance, unsigned int count, std::uint64_t seed,
               std::uint64_t stream);

  void clear() { m_size = 0; }
  //! The draws that lead to different motions.
  std::size_t size() const { return m_size; }
  const Draw &operator[](std::size_t i) const { return m_draws[i]; }

private:
  using Chances = std::array<double, vpEdgeClustering::maxClasses>;

  void drawOnce(const vpContourClasses &classes, vpPoseRandom &random, Draw &draw);
  std::size_t pick(const vpContourClasses &classes, vpPoseRandom &random);
  double findChances(const vpContourClasses &classes, const vpContourClasses::Contour &contour, Chances &chance) const;
  int drawClass(const vpContourClasses &classes, const vpContourClasses::Contour &contour, vpPoseRandom &random) const;
  int likeliestClass(const vpContourClasses &classes, const vpContourClasses::Contour &contour) const;
  void believe(const vpContourClasses::Class &chosen);
  void estimate();
  void conclude(const vpContourClasses &classes, Draw &draw);

  std::vector<Draw> m_draws; // Memory; the first m_size are in use.
  std::size_t m_size = 0;
  std::vector<char> m_open; // Contours that were not drawn yet.
  double m_openPoints = 0.;
  double m_prior = 1.;
  vpPoseMatrix6 m_information;
  vpPoseTangent m_gradient;
  vpPoseMatrix6 m_covariance;
  vpPoseTangent m_motion;
};

END_VISP_NAMESPACE
#endif
