// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef benchObjectRenderer_h
#define benchObjectRenderer_h

#include "generate/light.h"
#include "generate/motion.h"
#include "generate/shadowMap.h"

namespace bench {

//! An object as it was read back from its files.
struct LoadedObject
{
  std::shared_ptr<const vpTrackedModel> model;
  std::vector<SurfaceMaterial> materials; //!< Per face of the model.
};

//! Writes an object's files. \param folder Of the data set. \throw vpException naming the file that cannot be written.
void writeObject(const std::string &dataset, const SyntheticObject &object,
                 const std::string &folder = programs::bopModels);

/*!
  Writes an object's files and reads the one with its looks back, so that the truth belongs to the files.
  \throw vpException naming the file that cannot be written or read.
*/
LoadedObject writeAndLoad(const std::string &dataset, const SyntheticObject &object,
                          const std::string &folder = programs::bopModels);

//! A picture with its share of each pixel.
struct ImageLayer
{
  cv::Rect area;    //!< Where it lies in the image; it may be partly or wholly outside.
  cv::Mat color;    //!< Blue, green, red times coverage, gray levels, 32-bit floats.
  cv::Mat coverage; //!< [0, 1], 32-bit floats.
};

//! Renders an object with light and shadow, several samples to a pixel. One thread at a time.
class ObjectRenderer
{
public:
  ObjectRenderer(const LoadedObject &object, const SceneCamera &camera);

  /*!
    \param samples Samples to a pixel along each axis, > 0.
    \param layer The whole object, the part outside the image too. A pixel's colour and coverage are the means over its
    square.
  */
  void render(const vpHomogeneousMatrix &cMo, const Light &light, int samples, ImageLayer &layer);

private:
  cv::Rect boundingBox(const vpHomogeneousMatrix &cMo) const;
  Eigen::Vector3f shadeSample(std::size_t sample, const Eigen::Vector3f &ray, const Light &light) const;

  LoadedObject m_object;
  SceneCamera m_camera;
  vpCpuRenderer m_renderer;
  ShadowMap m_shadow;
  vpRenderedView m_view;
  Eigen::Matrix3f m_oRc;
  Eigen::Vector3f m_oTc;
};

} // namespace bench
#endif
