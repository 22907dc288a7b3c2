// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef benchScene_h
#define benchScene_h

#include "stages/benchShapes.h"
#include "stages/drawnImages.h"

#include <visp3/core/vpImageConvert.h>
#include <visp3/mbt/vpMbGenericTracker.h>
#include <visp3/multicue/vpMbMultiCueTracker.h>

#include <cmath>
#include <iostream>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

namespace bench {

//! Size of an image, by the name that benchmarks have in their own names.
struct BenchSize
{
  const char *name;
  unsigned int width;
  unsigned int height;
};

inline const std::vector<BenchSize> &benchSizes()
{
  static const std::vector<BenchSize> sizes = {{"320x240", 320, 240}, {"640x480", 640, 480}, {"1280x960", 1280, 960}};
  return sizes;
}

//! Keeps ViSP's parser, which counts aloud what it reads, out of the results.
class SilentOutput
{
public:
  SilentOutput() : m_buffer(std::cout.rdbuf(nullptr)) {}
  ~SilentOutput() { std::cout.rdbuf(m_buffer); }
  SilentOutput(const SilentOutput &) = delete;
  SilentOutput &operator=(const SilentOutput &) = delete;

private:
  std::streambuf *m_buffer;
};

/*!
  A model that moves to and fro before a camera, in images of one size, and the trackers that follow it. The camera's
  focal length goes with the size of the image, so that the object fills the same share of it: about 200 of 640 columns.
*/
class BenchScene
{
public:
  //! Images before the motion repeats itself.
  static constexpr int period = 16;

  BenchScene(const BenchShape &shape, const BenchSize &size) : m_size(size), m_file(writeShape(shape, m_folder))
  {
    prepare(m_tracker);
    m_drawn = std::make_unique<DrawnImages>(model());
    for (int k = 0; k < period; ++k) {
      m_images.push_back(m_drawn->draw(pose(k), camera(), width(), height()));
    }
    vpImageConvert::convert(m_images[1], m_colorImage);
  }

  unsigned int width() const { return m_size.width; }
  unsigned int height() const { return m_size.height; }
  vpCameraParameters camera() const
  {
    const double focal = 600. * width() / 640.;
    return vpCameraParameters(focal, focal, 0.5 * (width() - 1.), 0.5 * (height() - 1.));
  }
  //! With the distortion of a wide-angle lens.
  vpCameraParameters distortedCamera() const
  {
    vpCameraParameters cam = camera();
    cam.initPersProjWithDistortion(cam.get_px(), cam.get_py(), cam.get_u0(), cam.get_v0(), -0.1, 0.1);
    return cam;
  }

  //! Pose in an image: between two of them the object moves by about 1.5 pixels of 640 and turns by 0.7 degrees.
  static vpHomogeneousMatrix pose(int k)
  {
    const double phase = 2. * M_PI * k / period;
    const double turn = 0.03 * std::sin(phase);
    return vpHomogeneousMatrix(0.02 + 0.004 * std::sin(phase), -0.01 + 0.003 * std::cos(phase), 0.6, 0.9, 0.5 + turn,
                               -0.2 + turn);
  }
  //! \param k Any number that is not negative: the motion goes on and on.
  const vpImage<unsigned char> &image(int k) const { return m_images[static_cast<std::size_t>(k % period)]; }
  const vpImage<vpRGBa> &colorImage() const { return m_colorImage; }

  std::shared_ptr<const vpTrackedModel> model() const { return m_tracker.getModel(); }
  const vpModelViewOptions &viewOptions() const { return m_viewOptions; }

  //! Our tracker, with the model and settings loaded.
  vpMbMultiCueTracker &tracker() { return m_tracker; }
  //! ViSP's, with the same files. \pre The model is a .cao.
  vpMbGenericTracker &vispTracker()
  {
    if (!m_vispTracker) {
      m_vispTracker = std::make_unique<vpMbGenericTracker>(1, vpMbGenericTracker::EDGE_TRACKER);
      prepare(*m_vispTracker);
    }
    return *m_vispTracker;
  }

private:
  // The values of ViSP's own examples. Its threshold is in the old scale, which all versions read.
  template <typename Tracker> void prepare(Tracker &tracker) const
  {
    const std::string config = m_folder.write(
        "tracker.xml",
        "<?xml version=\"1.0\"?>\n<conf><ecm><mask><size>5</size><nb_mask>180</nb_mask></mask><range><tracking>8"
        "</tracking></range><contrast><edge_threshold>10000</edge_threshold><mu1>0.5</mu1><mu2>0.5</mu2></contrast>"
        "<sample><step>4</step></sample></ecm></conf>\n");
    tracker.loadConfigFile(config, false);
    tracker.setCameraParameters(camera());
    const SilentOutput silent;
    tracker.loadModel(m_file, false);
  }

  BenchSize m_size;
  meshFiles::TemporaryFolder m_folder;
  std::string m_file;
  vpModelViewOptions m_viewOptions;
  vpMbMultiCueTracker m_tracker{vpMbMultiCueTracker::EDGE_TRACKER};
  std::unique_ptr<vpMbGenericTracker> m_vispTracker;
  std::unique_ptr<DrawnImages> m_drawn;
  std::vector<vpImage<unsigned char>> m_images;
  vpImage<vpRGBa> m_colorImage;
};

//! The scene of a shape and a size, by their places in benchShapes() and benchSizes(); made when it is needed first.
inline BenchScene &benchScene(std::size_t shape, std::size_t size)
{
  static std::map<std::pair<std::size_t, std::size_t>, std::unique_ptr<BenchScene>> scenes;
  std::unique_ptr<BenchScene> &scene = scenes[{shape, size}];
  if (!scene) {
    scene = std::make_unique<BenchScene>(benchShapes()[shape], benchSizes()[size]);
  }
  return *scene;
}

} // namespace bench
#endif
