// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpPointCue_h
#define vpPointCue_h

#include <visp3/cues/vpPoseCue.h>

#include <functional>
#include <memory>

BEGIN_VISP_NAMESPACE

/*!
  \ingroup group_cues_point
  How points are chosen and followed: the parameters of ViSP's vpKltOpencv.
*/
struct VISP_EXPORT vpPointCueSettings
{
  int maxFeatures = 100;       //!< Largest number of points, [1, 100000]; each takes some microseconds per frame.
  int windowSize = 5;          //!< Side of the window that is followed from frame to frame, pixels, [3, 63].
  double quality = 0.01;       //!< Corners below this share of the best one's strength are left out, (0, 1].
  double minDistance = 5.;     //!< Of two points, pixels, [0, 1000].
  double harris = 0.01;        //!< Free parameter of Harris' measure, [0, 1].
  int blockSize = 3;           //!< Side of the window for the corner's strength, pixels, [1, 63].
  int pyramidLevels = 3;       //!< Levels of the image pyramid above the image itself, as in ViSP, [0, 10].
  unsigned int maskBorder = 5; //!< Points closer than this to the silhouette, a crease or a step of the depth are left
                               //!< out, pixels, [0, 100]; 5 where a wider one would leave nothing of a face.
  bool useHarris = true;       //!< Harris' measure of corners ([P14] III-C); false: Shi and Tomasi's.
  double leastWeight = 0.1;    //!< Points with a smaller robust weight are outliers and teach nothing, [0, 1).

  //! Takes over all that a vpKltOpencv says. \throw vpException naming the first member out of range.
  template <class Klt> void set(const Klt &klt)
  {
    vpPointCueSettings changed = *this;
    changed.maxFeatures = klt.getMaxFeatures();
    changed.windowSize = klt.getWindowSize();
    changed.quality = klt.getQuality();
    changed.minDistance = klt.getMinDistance();
    changed.harris = klt.getHarrisFreeParameter();
    changed.blockSize = klt.getBlockSize();
    changed.pyramidLevels = klt.getPyramidLevels();
    changed.check();
    *this = changed;
  }

  //! \throw vpException naming the first member out of range.
  void check() const;
};

/*!
  \ingroup group_cues_point
  Distances between projected points of the surface and where the image shows them ([P14] III-C, eq. 10 and 11).

  Corners of the image inside the rendered silhouette become points of the model when updateReference() is given a pose:
  each keeps its 3D position and a patch of that image until it is lost. In a new frame a point is followed by
  pyramidal KLT from the last trusted frame, starting where the view's pose projects it, there and back; and then placed
  on its own patch, as its surface looks from the view's pose. So errors do not add up from frame to frame. The
  error is the distance in normalised coordinates (metres at 1 m), two rows for each point.

  A point is lost where its patch is not found for several trusted frames, or its surface has turned away or is hidden.

  **Depth.** The cue knows no model. New points need the rendered depth at the trusted pose: updateReference() asks
  the function given to setDepthSource() for it, at most once per call and only where wantsPoints() is true: after a
  quarter of the points was lost, or every ten trusted frames while there are less than asked for. The caller may
  answer with a buffer that it has already. Without the function no points are made.

  Same frames, same result, whatever the number of OpenCV's threads.
*/
class VISP_EXPORT vpPointCue : public vpPoseCue
{
public:
  //! A point in the matched frame.
  struct Match
  {
    Eigen::Vector3d position; //!< Object frame, metres.
    Eigen::Vector2d pixel;    //!< Where it was found, else where it was expected, pixels.
    bool found = false;
    //! A new point has to agree with the pose of other points and cues for some frames before it gives rows: what
    //! passes in front of the object has points too.
    bool proven = true;
    int id = -1; //!< Number of the point, as long as it is known.
  };
  //! \return Depth of the object at a pose for the image of the last match(), any scale; null where it cannot be had.
  using DepthSource = std::function<const vpRenderedView *(const vpHomogeneousMatrix &cMo)>;

  //! False where the library was built without OpenCV's video, features2d or calib3d module: the constructor then
  //! throws.
  static bool isAvailable();

  //! \throw vpException naming the setting out of range, or where the cue is not available.
  explicit vpPointCue(const vpPointCueSettings &settings = vpPointCueSettings());
  ~vpPointCue() override;

  //! Forgets the points. \throw vpException naming the member that is out of range; nothing changes then.
  void setSettings(const vpPointCueSettings &settings);
  const vpPointCueSettings &settings() const;
  //! \param source Draws the object's depth, see above; empty: no new points.
  void setDepthSource(const DepthSource &source);
  //! \return True where points may lie. \param position On the surface, object frame, metres.
  using SurfaceFilter = std::function<bool(const Eigen::Vector3d &position)>;
  //! Leaves parts of the surface out, and forgets the points. \param filter Empty: points may lie everywhere.
  void setSurfaceFilter(const SurfaceFilter &filter);

  //! \e view has to be of the pose that is expected: pose() and, where it has one, depth() of it are used. A frame of
  //! another size or camera than the one before makes the cue forget its points.
  void match(const vpCueFrame &frame, const vpModelView &view) override;
  //! Two rows, x and y, for each point found and proven, in the order of matches().
  void residuals(const vpHomogeneousMatrix &cMo, vpResidualBlock &block) const override;
  void updateReference(const vpHomogeneousMatrix &cMo, const std::vector<double> &weights) override;
  void reset() override;
  void getFeatures(const vpHomogeneousMatrix &cMo, const std::vector<double> &weights,
                   std::vector<vpCueFeature> &features) const override;

  //! True where updateReference() will ask for depth, should the last match be trusted.
  bool wantsPoints() const;
  //! Points that the view of the last match could show.
  const std::vector<Match> &matches() const;
  //! Number of points that are known now.
  std::size_t pointCount() const;

private:
  class Impl;
  std::unique_ptr<Impl> m_impl;
};

END_VISP_NAMESPACE
#endif
