// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef benchScene_h
#define benchScene_h

#include "generate/background.h"
#include "generate/foreground.h"
#include "generate/webcam.h"

#include <functional>
#include <string>

namespace bench {

//! One sequence: which object moves in front of what, and what makes it difficult.
struct SceneOptions
{
  std::string object = "box";       //!< One of objectNames(), or the path of a mesh.
  std::string variant = "regular";  //!< One of variantNames(), or several of them joined by +.
  std::string motion = "smooth";    //!< One of motionNames(), or the path of a file with poses in RBOT's format.
  double motionScale = 1.;          //!< Multiplies the motion from frame to frame.
  std::vector<std::string> effects; //!< Of effectNames().
  int frames = 300;
  std::uint64_t seed = 1; //!< The same one gives the same bytes.
  std::string dataset;    //!< Folder of the data set; made where it is missing.
  std::string background; //!< "photo", "wall", "plain", "space", or empty for the one that suits the object.
  unsigned int width = 640;
  unsigned int height = 480;
  double unit = 1.;      //!< Metres per unit of a mesh.
  double meshError = 0.; //!< Strength of the errors of the mesh in models/; the one that is rendered is exact.
  int jpegQuality = 0;   //!< Of images in JPEG, 1 to 100; 0: in PNG.
  bool video = false;    //!< Write the images as a video too, beside the scene's folder.
  int jobs = 1;          //!< Threads; the result does not depend on their number.
};

//! Name of a scene's folder: <object>_<variant>, or <object>_<motion>_<effects>_<variant> with what is not usual.
std::string sceneName(const SceneOptions &options);

/*!
  Renders a scene frame by frame; writes nothing but the object's files.
*/
class Scene
{
public:
  //! \throw vpException where an option is out of range or unknown, or a file cannot be read or written.
  explicit Scene(const SceneOptions &options);

  const SceneOptions &options() const { return m_options; }
  const SceneCamera &camera() const { return m_camera; }
  const LoadedObject &object() const { return m_object; }
  int objectId() const { return m_synthetic.id; }
  const Motion &motion() const { return *m_motion; }
  //! True pose of a frame: that of the middle of the exposure of the row that shows the object's centre.
  vpHomogeneousMatrix pose(int frame) const { return m_motion->pose(timeOf(frame)); }

  //! Makes what a thread needs to render frames.
  ObjectRenderer makeRenderer() const { return ObjectRenderer(m_object, m_camera); }

  /*!
    \param frame In [0, frames).
    \param truth What is known about it.
    \return The image, 8-bit BGR.
  */
  cv::Mat render(int frame, ObjectRenderer &renderer, programs::BopFrame &truth) const;

private:
  cv::Mat renderInstant(double time, int samples, const Light &light, ObjectRenderer &renderer,
                        programs::BopFrame *truth) const;
  //! The mean of several instants, time being the middle of the exposure.
  cv::Mat renderExposure(double time, ObjectRenderer &renderer) const;
  //! As m_webcam sees it.
  cv::Mat renderShutter(int frame, ObjectRenderer &renderer) const;
  double timeOf(int frame) const;
  Light lightOf(double time, int instant) const;
  void fillTruth(const ImageLayer &object, const cv::Mat &hidden, programs::BopFrame &truth) const;
  void writeModels();
  void planForeground();
  void addNoise(int frame, cv::Mat &image) const;

  SceneOptions m_options;
  SceneCamera m_camera;
  SyntheticObject m_synthetic;
  LoadedObject m_object;
  std::unique_ptr<Motion> m_motion;
  std::unique_ptr<Background> m_background;
  std::unique_ptr<Webcam> m_webcam;
  std::vector<std::unique_ptr<Foreground>> m_foreground; //!< What is in front, the nearest last.
  std::vector<float> m_noise;                            //!< Numbers of the normal distribution.
};

/*!
  Renders a scene and writes it, as BOP does, into the folder sceneName() of the data set.
  \param progress Called after each frame with the number of finished frames, by one thread at a time.
  \return The truth of all frames.
  \throw vpException as Scene does, and where a file cannot be written.
*/
std::vector<programs::BopFrame> generateScene(const SceneOptions &options,
                                              const std::function<void(int)> &progress = nullptr);

} // namespace bench
#endif
