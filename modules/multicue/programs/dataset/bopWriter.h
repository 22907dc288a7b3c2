// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef programsBopWriter_h
#define programsBopWriter_h

#include <visp3/core/vpCameraParameters.h>
#include <visp3/core/vpHomogeneousMatrix.h>

#include <Eigen/Core>
#include <opencv2/core.hpp>

#include <array>
#include <string>
#include <vector>

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

namespace programs {

//! Rectangle of an image as BOP writes it; -1 where there is nothing.
using BopBox = std::array<int, 4>;

//! What is known about one image: the truth where it was rendered.
struct BopFrame
{
  int id = 0;
  vpHomogeneousMatrix cMo; //!< Metres.
  bool hasPose = true;
  int pixelsAll = 0;                      //!< Of the whole silhouette, outside the image too; -1 where not counted.
  int pixelsVisible = 0;                  //!< Of the part of it that is seen.
  BopBox boxObject = {{-1, -1, -1, -1}};  //!< Left, top, width, height of the silhouette, beyond the image too.
  BopBox boxVisible = {{-1, -1, -1, -1}}; //!< The same of the part that is seen.
};

//! A triangle of a mesh; colours as for SyntheticObject.
struct BopTriangle
{
  std::array<Eigen::Vector3d, 3> position; //!< Metres.
  std::array<Eigen::Vector3f, 3> color;    //!< Red, green, blue in [0, 1].
  std::array<Eigen::Vector2f, 3> texture;  //!< u right, v down.
  int image = -1;
};

//! The folder of a data set that programs take models from.
constexpr const char *bopModels = "models";

//! The files of one object.
struct BopModel
{
  int id = 1;
  std::vector<BopTriangle> triangles;
  std::vector<cv::Mat> images; //!< Textures, 8-bit BGR.
  std::string cao;             //!< ViSP's model; empty: none is written, and an earlier one is removed.
  std::string folder = bopModels;
};

//! Path of an object's file without its extension: models/obj_000001.
std::string bopModelPath(const std::string &dataset, int id, const std::string &folder = bopModels);

/*!
  Writes <folder>/obj_<id>.ply (millimetres, colours of vertices), .obj with .mtl and .png (metres) where there are
  textures, .cao where there is one, and the object's entry of <folder>/models_info.json; other objects' entries stay.
  \throw vpException naming the file that cannot be written.
*/
void writeBopModel(const std::string &dataset, const BopModel &model);

/*!
  Writes the images and the truth of one scene of one object: rgb, scene_camera.json, scene_gt.json and
  scene_gt_info.json.
*/
class BopSceneWriter
{
public:
  //! Makes the folders. Truth and numbered images of an earlier scene of this name are
  //! removed.
  //! \throw vpException naming the folder that cannot be made.
  //! \param jpegQuality Of images in JPEG, 1 to 100; 0: in PNG.
  BopSceneWriter(const std::string &dataset, const std::string &scene, int objectId, const vpCameraParameters &cam,
                 int jpegQuality = 0);

  //! Writes one image; may be called by several threads at once. \param image 8-bit BGR.
  void writeImage(int id, const cv::Mat &image) const;

  //! Writes the truth of all images.
  void writeTruth(const std::vector<BopFrame> &frames) const;

  const std::string &folder() const { return m_folder; }

private:
  std::string m_folder;
  int m_objectId;
  vpCameraParameters m_cam;
  int m_jpegQuality;
};

} // namespace programs
#endif
