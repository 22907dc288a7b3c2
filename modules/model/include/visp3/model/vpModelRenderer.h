// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpModelRenderer_h
#define vpModelRenderer_h

#include <visp3/core/vpCameraParameters.h>
#include <visp3/core/vpHomogeneousMatrix.h>
#include <visp3/model/vpTrackedModel.h>

#include <memory>

BEGIN_VISP_NAMESPACE

/*!
  \ingroup group_model_rendering
  What to render.
*/
struct VISP_EXPORT vpRenderOptions
{
  enum Channel : unsigned int
  {
    DEPTH = 1U,
    NORMAL = 2U,
    FACE = 4U,
    COLOR = 8U
  };

  unsigned int channels = DEPTH; //!< Which buffers are filled, Channel values or-ed; DEPTH is always filled.
  unsigned int maxSize =
      0;              //!< Largest side of the rendered crop, pixels; the scale is lowered to keep it. 0: no limit.
  double scale = 1.;  //!< Rendered pixels per image pixel, (0, 1].
  double margin = 2.; //!< Pixels of the image added around the object's projected box, >= 0.
  double nearDistance = 0.001; //!< Nothing closer is drawn, metres, > 0.

  //! \throw vpException naming the first member out of range.
  void check() const;
};

/*!
  \ingroup group_model_rendering
  A crop around the projected object, row by row.

  Pixel (row i, column j) of the crop is seen at (u, v) = ((left + j + 0.5) / scale - 0.5, (top + i + 0.5) / scale -
  0.5) of the image, pixel centres being at integers in both. Nothing outside the image is rendered, so a crop may be
  empty.
*/
struct VISP_EXPORT vpRenderedView
{
  int left = 0;             //!< Column of the crop's first pixel in the scaled image.
  int top = 0;              //!< Row of the crop's first pixel in the scaled image.
  int width = 0;            //!< Columns.
  int height = 0;           //!< Rows.
  double scale = 1.;        //!< Rendered pixels per image pixel that was used.
  std::vector<float> depth; //!< Distance along the optical axis, metres; 0 where there is no object.
  std::vector<Eigen::Vector3f>
      normal;                //!< Unit surface normal, camera frame, towards the camera; 0 where there is no object.
  std::vector<int> face;     //!< Index into vpTrackedModel::faces(), -1 where there is no object.
  std::vector<vpRGBa> color; //!< Unlit surface colour, A = 255 on the object and 0 elsewhere.

  //! Nearest crop pixel of image point (u, v), or -1 outside the crop.
  int index(double u, double v) const;
};

/*!
  \ingroup group_model_rendering
  Draws a model at a pose into a crop of the image. All surfaces are drawn from both sides, cylinders included.
  One renderer serves one model and one thread at a time.
*/
class VISP_EXPORT vpModelRenderer
{
public:
  enum Preference
  {
    AUTOMATIC, //!< EGL on a real GPU for meshes of more than 20,000 triangles, else the CPU.
    EGL,       //!< EGL even where Mesa renders in software; the CPU where there is no EGL at all.
    CPU        //!< Never EGL.
  };

  virtual ~vpModelRenderer() = default;

  /*!
    \param cMo Pose of the object in the camera frame.
    \param cam Camera without distortion (distortion coefficients are ignored).
    \param imageWidth, imageHeight Size of the image, pixels, 1 to 16384.
    \param options What to fill.
    \param view Result; its memory is used again from call to call.
    \throw vpException where the size, the camera or the options are unusable.
  */
  virtual void render(const vpHomogeneousMatrix &cMo, const vpCameraParameters &cam, unsigned int imageWidth,
                      unsigned int imageHeight, const vpRenderOptions &options, vpRenderedView &view) = 0;

  //! \return True where render() may be called in another thread than the renderer was made in, one at a time; false by
  //! default, as OpenGL needs it.
  virtual bool mayChangeThread() const { return false; }

  //! What renders, for messages and reports ("CPU", "EGL (llvmpipe ...)").
  virtual std::string name() const = 0;

  //! \return What failed, as a sentence, so that the CPU renders in the place of what was asked for; empty by default.
  virtual std::string failure() const { return std::string(); }

  /*!
    Makes a renderer. Where EGL was asked for, or AUTOMATIC would take it, and it cannot be had, a CPU renderer is
    returned, and the reason is printed once per process. Where EGL fails later, with an error, depths that the object
    cannot have or nothing where it is in sight, the CPU renders that view and those after it: see failure().

    AUTOMATIC goes by the number of triangles alone: drawing on the CPU takes time in proportion to it, a GPU's time
    for a crop is mostly that of giving the order and reading the result. Mesa in software is slower than the CPU
    renderer at every size that was measured (12 to 240,000 triangles), so AUTOMATIC never takes it.
    \param model Kept alive by the renderer.
    \throw vpException where \e model is null.
  */
  static std::unique_ptr<vpModelRenderer> create(const std::shared_ptr<const vpTrackedModel> &model,
                                                 Preference preference = AUTOMATIC);

protected:
  /*!
    Sets left, top, width, height and scale of \e view to the crop of the image that holds the projected bounding box,
    the whole image where the box reaches behind the near plane, and nothing where it is outside the image.
  */
  static void placeCrop(const vpTrackedModel &model, const vpHomogeneousMatrix &cMo, const vpCameraParameters &cam,
                        unsigned int imageWidth, unsigned int imageHeight, const vpRenderOptions &options,
                        vpRenderedView &view);
};

END_VISP_NAMESPACE
#endif
