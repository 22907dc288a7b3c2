// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpEdgeClustering_h
#define vpEdgeClustering_h

#include <visp3/se3/vpCompatibility.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <vector>

BEGIN_VISP_NAMESPACE

/*!
  \ingroup group_cues_edge
  Segments the candidates of one contour into potential edges ([T10] II-B): a k-means whose means are curves.

  A candidate is a place along a control point's normal. A mean is the displacement along the normals as a function of
  the arc length: a line for a straight contour, a polynomial of up to the third order for a curved one (the more it
  turns, the higher), harmonics for a closed one. There are as many classes at the start as the control point with the
  most candidates has, each with the candidates that come at its place in the order along the normal. Then means, by
  robust least squares, and assignments take turns until no assignment changes. Two candidates of one control point are
  never in one class, and what is far from every mean is in none.

  Knows neither images nor poses. Once its memory suffices, nothing is allocated.
*/
class VISP_EXPORT vpEdgeClustering
{
public:
  static constexpr int maxClasses = 8;      //!< Candidates beyond this number are ignored for a control point.
  static constexpr int maxCoefficients = 5; //!< Of a mean.

  enum class Shape
  {
    STRAIGHT,
    OPEN_CURVE,
    CLOSED_CURVE //!< The last point is a step away from the first.
  };

  //! What counts as an edge.
  struct Settings
  {
    double noise = 0.7; //!< Standard deviation of candidates about their edge, pixels, > 0.
    //! Candidates farther from a mean than this are not of its class, pixels, > 0.
    double cutoff = 3.;
    //! Classes with fewer members than this share of the control points are dropped, [0, 1].
    double smallestShare = 0.3;
  };

  //! A potential edge.
  struct Class
  {
    Eigen::Matrix<double, maxCoefficients, 1> mean; //!< Coefficients of the displacement.
    int size = 0;                                   //!< Number of members.
    /*!
      r of [T10]: root of the mean squared distance to the mean over all control points of the contour, pixels. Points
      without a member count the cut-off, as outliers do in a robust least squares.
    */
    double residue = 0.;
  };

  vpEdgeClustering() = default;
  //! \throw vpException naming the setting that is out of range.
  explicit vpEdgeClustering(const Settings &settings);

  //! Begins a contour. \param turn Angle that its normal turns by from one end to the other, radians, >= 0.
  void begin(Shape shape, double turn = 0.);
  /*!
    Adds the next control point. \param arcLength Pixels, growing. \param offsets, count Its candidates along the
    normal, pixels, in any order.
  */
  void add(double arcLength, const double *offsets, int count);
  //! Segments what was added since begin().
  void compute();

  //! The classes that were not dropped, in the order along the normal at the contour's middle.
  const std::vector<Class> &classes() const { return m_classes; }
  //! Number of control points.
  int points() const { return static_cast<int>(m_points.size()); }
  //! \return Which of the candidates given to add() for \e point is in class \e label, -1 for none.
  int member(int label, int point) const
  {
    return m_members[static_cast<std::size_t>(label)][static_cast<std::size_t>(point)];
  }
  //! \return Displacement of the class's mean, pixels. \param arcLength Pixels.
  double displacement(int label, double arcLength) const;
  //! How often means and assignments were computed.
  int iterations() const { return m_iterations; }

  /*!
    Weights of the classes in a draw, [T10] eq. 4: 1 for the least residue, exp(-lambda) for the largest one.
    \param lambda Selectivity, >= 0. \param weights Result, one for each class.
  */
  void drawWeights(double lambda, std::vector<double> &weights) const;

private:
  using Coefficients = Eigen::Matrix<double, maxCoefficients, 1>;

  struct Point
  {
    double arcLength = 0.;
    Coefficients basis;
    int count = 0;
    std::array<double, maxClasses> offset{}; // In order along the normal.
    std::array<int, maxClasses> source{};    // Index among the candidates given.
    std::array<int, maxClasses> label{};     // Class of each, -1 for none.
  };

  Coefficients basis(double arcLength) const;
  void prepareBasis();
  bool fit(int label, Coefficients &mean, double noise, bool fresh) const;
  bool assign(Point &point, bool cut) const;
  void dropFarMembers();
  void collect();
  void describe(Class &found, int label) const;

  Settings m_settings;
  Shape m_shape = Shape::STRAIGHT;
  int m_order = 2; // Number of coefficients.
  int m_wantedOrder = 2;
  double m_middle = 0.;
  double m_halfLength = 1.;
  std::size_t m_used = 0; // Points of m_memory.
  int m_k = 0;
  int m_iterations = 0;
  std::vector<Point> m_points;
  std::array<Coefficients, maxClasses> m_means{};
  std::array<bool, maxClasses> m_alive{};
  std::vector<Class> m_classes;
  std::array<std::vector<int>, maxClasses> m_members;
};

END_VISP_NAMESPACE
#endif
