// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef benchForeground_h
#define benchForeground_h

#include "generate/objectRenderer.h"

#include <memory>
#include <vector>

namespace bench {

//! Something in front of the object. An object's position in time is given in frames.
class Foreground
{
public:
  virtual ~Foreground() = default;

  /*!
    Draws itself over an image.
    \param time In frames.
    \param image 32-bit BGR.
    \param hidden Share of each pixel that it hides, 32-bit floats, the image's size.
  */
  virtual void draw(double time, cv::Mat &image, cv::Mat &hidden) const = 0;
};

/*!
  A printed blob that moves to and fro over the object, and to and from the camera so that at least 0.6 of the object is
  seen.
  \param object Coverage of the whole object per frame, with its place; its colours are not used.
*/
std::unique_ptr<Foreground> makeOccluder(const SceneCamera &camera, const std::vector<ImageLayer> &object,
                                         std::uint64_t seed);

/*!
  An opaque board that sweeps over the image about every 100 frames and hides the object for 10 to 15 of them.
  \param object As for makeOccluder().
*/
std::unique_ptr<Foreground> makeBoard(const SceneCamera &camera, const std::vector<ImageLayer> &object,
                                      std::uint64_t seed);

} // namespace bench
#endif
