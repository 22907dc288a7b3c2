// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpSphereView_h
#define vpSphereView_h

#include <visp3/model/vpModelView.h>

BEGIN_VISP_NAMESPACE

//! \ingroup group_model_view
//! One point of a vpSphereView.
struct vpSphereViewPoint
{
  Eigen::Vector3f position;  //!< Object frame, metres.
  Eigen::Vector3f direction; //!< Unit direction of the edge there, object frame.
  float side = 1.F;          //!< 1 where the outward image normal is the image of direction turned from u towards v,
                             //!< else -1.
  bool silhouette = true;    //!< Background behind the edge.
};

/*!
  \ingroup group_model_view
  Some control points of one view, packed for loops over many poses: seven arrays of floats, one after the other in
  memory, silhouette points before the others. It does not change after it was made.
*/
class VISP_EXPORT vpSphereView
{
public:
  //! A view without points.
  vpSphereView() = default;
  //! Takes all points where they are not more than \e most, else this number, as evenly spread over all contours as
  //! their distances allow.
  vpSphereView(const std::vector<vpControlPoint> &points, std::size_t most);

  std::size_t size() const { return m_size; }
  //! Number of silhouette points, the first ones.
  std::size_t silhouettes() const { return m_silhouettes; }
  //! Number of the other points, the last ones.
  std::size_t inner() const { return m_size - m_silhouettes; }

  //! \name Arrays of size() numbers
  //! See vpSphereViewPoint: position, direction, side.
  //! @{
  const float *x() const { return array(0); }
  const float *y() const { return array(1); }
  const float *z() const { return array(2); }
  const float *dx() const { return array(3); }
  const float *dy() const { return array(4); }
  const float *dz() const { return array(5); }
  const float *side() const { return array(6); }
  //! @}

  //! \param i Less than size(); not checked.
  vpSphereViewPoint point(std::size_t i) const;
  //! Beside the object itself, bytes.
  std::size_t memory() const { return m_values.capacity() * sizeof(float); }

private:
  friend class vpSphereFile;

  static constexpr std::size_t arrays = 7;
  const float *array(std::size_t i) const { return m_values.data() + i * m_size; }
  void set(std::size_t i, const vpControlPoint &point);

  std::vector<float> m_values; // The arrays, m_size each.
  std::size_t m_size = 0;
  std::size_t m_silhouettes = 0;
};

END_VISP_NAMESPACE
#endif
