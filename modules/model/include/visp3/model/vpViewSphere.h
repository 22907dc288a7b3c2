// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpViewSphere_h
#define vpViewSphere_h

#include <visp3/model/vpSphereView.h>

#include <memory>
#include <string>
#include <vector>

BEGIN_VISP_NAMESPACE

/*!
  \ingroup group_model_view
  Where the views of a vpViewSphere are taken from, and what is kept of them.
*/
struct VISP_EXPORT vpViewSphereOptions
{
  //! Control points 2 pixels apart, from which those that are kept can be chosen evenly.
  vpViewSphereOptions() { view.sampleStep = 2.; }

  unsigned int level = 4;    //!< How often the edges of an icosahedron are halved, 0 to 4: 12, 42, 162, 642 or 2562
                             //!< directions.
  double distance = 4.;      //!< From the middle of the object's box to the camera, diameters of the object, (1, 1000].
  unsigned int points = 120; //!< Most points kept of a view, 1 to 10000.
  vpModelViewOptions view;   //!< How to look. Lengths in pixels are those of vpViewSphere::camera(). What is seen
                             //!< depends on no view before, and the whole object is in the image: disappearAngle,
                             //!< nearDistance, farDistance and border are not used.

  //! \throw vpException naming the first member out of range.
  void check() const;
};

class vpIcosphere;

/*!
  \ingroup group_model_view
  Views of the object from directions all around, for the many poses of a particle filter and for a search without any
  idea of the pose; see \ref model_views_sphere.

  The directions are the vertices of an icosahedron whose edges are halved \e level times. Those of a lower level come
  first, so that the first size(3) of them are a coarser sphere. A view is made when it is first asked for, and is the
  same whatever was made before. One thread at a time may make views; find() and nearest() may be called by many as
  long as none is made.
*/
class VISP_EXPORT vpViewSphere
{
public:
  //! Side of the virtual camera's square image, pixels.
  static constexpr unsigned int imageSize = 320;

  /*!
    Makes no view yet.
    \param model Not null; kept alive.
    \param options How to look.
    \param renderer Draws the depth buffers of the same model; may be null for a convex one.
    \throw vpException where an option is out of range, or a renderer is missing.
  */
  vpViewSphere(const std::shared_ptr<const vpTrackedModel> &model, const vpViewSphereOptions &options,
               std::unique_ptr<vpModelRenderer> renderer);

  //! Number of directions of a level, 0 to 4.
  static constexpr std::size_t size(unsigned int level) { return (std::size_t{10} << (2 * level)) + 2; }
  //! About how far neighbouring directions of a level are apart, radians.
  static double spacing(unsigned int level);

  const vpTrackedModel &model() const { return m_view.model(); }
  const vpViewSphereOptions &options() const { return m_options; }
  //! Number of directions and of views.
  std::size_t size() const { return m_views.size(); }

  //! \name Directions
  //! @{
  //! Unit vector from the middle of the box to the camera of a view, object frame. \throw vpException from size() on.
  const Eigen::Vector3d &directionOf(std::size_t i) const;
  //! Pose of the object before the camera of a view, its z axis up in the image (y where z is the line of sight).
  vpHomogeneousMatrix poseOf(std::size_t i) const;
  //! The virtual camera: the object's diameter spans 200 pixels.
  const vpCameraParameters &camera() const { return m_camera; }
  //! The direction nearest to that from the middle of the box to a camera, object frame, any length; 0 where it has no
  //! length.
  std::size_t nearest(const Eigen::Vector3d &fromCentre) const { return nearest(fromCentre, m_options.level); }
  //! The nearest one of a coarser level. \throw vpException where the sphere does not have this level.
  std::size_t nearest(const Eigen::Vector3d &fromCentre, unsigned int level) const;
  //! The direction from which a camera sees the object.
  std::size_t nearest(const vpHomogeneousMatrix &cMo) const { return nearest(cMo, m_options.level); }
  //! That of a coarser level. \throw vpException where the sphere does not have this level.
  std::size_t nearest(const vpHomogeneousMatrix &cMo, unsigned int level) const;
  //! @}

  //! \name Views
  //! \throw vpException from size() on.
  //! @{
  bool isMade(std::size_t i) const;
  //! Makes a view that is not made yet.
  void make(std::size_t i);
  //! The view; it is made where it is not made yet. It stays where it is as long as the sphere.
  const vpSphereView &view(std::size_t i);
  //! The view, null where it is not made yet.
  const vpSphereView *find(std::size_t i) const { return isMade(i) ? &m_views[i] : nullptr; }
  //! @}

  /*!
    \name Views in a file
    So that the next start of a program finds them made. A file serves the same model and options on a machine with the
    same order of bytes; the renderer is not compared.
    @{
  */
  //! A name that tells files of other models and options apart, "0123456789abcdef.views".
  std::string fileName() const;
  //! Writes all views that are made; a file that is there is replaced. \throw vpException that names the file.
  void save(const std::string &file) const;
  //! Adds the views of a file that are not made yet. \throw vpException that names the file, where it cannot be read,
  //! is damaged, or is of another model, other options or another version; the sphere then stays as it was.
  void load(const std::string &file);
  //! @}

  //! Of the directions and the views that are made, bytes.
  std::size_t memory() const;

private:
  std::size_t checked(std::size_t i) const;

  vpViewSphereOptions m_options;
  std::shared_ptr<const vpIcosphere> m_directions;
  std::unique_ptr<vpModelRenderer> m_renderer;
  vpCameraParameters m_camera;
  vpModelViewOptions m_viewOptions; // As they are used.
  vpModelView m_view;               // Scratch memory.
  std::vector<vpSphereView> m_views;
  std::vector<char> m_isMade;
};

END_VISP_NAMESPACE
#endif
