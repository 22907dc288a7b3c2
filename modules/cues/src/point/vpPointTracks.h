// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpPointTracks_h
#define vpPointTracks_h

#include "point/vpCornerFinder.h"
#include "point/vpPointFlow.h"
#include "point/vpSurfacePatch.h"
#include "point/vpSurfaceReader.h"

BEGIN_VISP_NAMESPACE

/*!
  The points that are known, and the image in which their places are known: the last one whose pose was trusted.
*/
class vpPointTracks
{
public:
  explicit vpPointTracks(const vpPointCueSettings &settings) : m_settings(settings) { forget(); }

  const vpPointCueSettings &settings() const { return m_settings; }
  //! Where new points may lie; forgets those that are known.
  void setFilter(const vpPointCue::SurfaceFilter &filter)
  {
    m_filter = filter;
    forget();
  }
  const vpPointCue::SurfaceFilter &filter() const { return m_filter; }
  std::size_t size() const { return m_tracks.size(); }
  //! True where learn() will ask for depth.
  bool wantsPoints() const { return m_wantsPoints; }

  //! Forgets points and image; what match() found last stays with the caller.
  void forget();
  //! Looks for the points that the view can show. \param matches Result.
  void match(const vpCueFrame &frame, const vpModelView &view, std::vector<vpPointCue::Match> &matches);
  /*!
    Makes the matched image the one to start from.
    \param trusted For each of \e matches, whether it was found where the pose has it.
  */
  void learn(const vpHomogeneousMatrix &cMo, const std::vector<vpPointCue::Match> &matches,
             const std::vector<char> &trusted, const vpPointCue::DepthSource &depth);

private:
  // How a point looked once.
  struct Look
  {
    vpSurfacePatch patch;
    Eigen::Matrix<double, 3, 2> across; // See vpSurfaceElement.
  };

  struct Track
  {
    vpSurfaceElement surface;
    Look first; // Where its 3D position comes from: used wherever the view is similar.
    Look later; // For views that are not.
    bool hasLater = false;
    Eigen::Vector2d pixel; // In the reference image.
    int misses = 0;        // Trusted frames since it was found.
    int trial = 0;         // Trusted frames that it has to agree with yet.
    int id = 0;
  };

  bool lacksPoints() const;
  bool prepareImage(const vpCueFrame &frame, const vpModelView &view);
  void expectTracks(const vpCueFrame &frame, const vpModelView &view, std::vector<vpPointCue::Match> &matches);
  void findTracks(const vpCueFrame &frame, const vpPointCamera &camera, std::vector<vpPointCue::Match> &matches);
  void keepMask(const vpCueFrame &frame);
  const Look &lookFor(const Track &track, const vpPointCamera &camera, Eigen::Matrix2d &distortion) const;
  void renew(Track &track, const vpPointCamera &camera);
  bool isLost(const Track &track, const vpPointCamera &camera) const;
  void addTracks(const vpPointCamera &camera, const vpRenderedView &rendered);
  void markAllowed(const vpSurfaceReader &reader, cv::Mat &mask) const;

  vpPointCueSettings m_settings;
  vpPointCue::SurfaceFilter m_filter;
  vpCameraParameters m_camera;
  cv::Size m_imageSize;
  std::vector<Track> m_tracks;
  vpPointImage m_reference, m_current;
  unsigned long long m_currentNumber = 0; // Of the frame in m_current; 0: none that can be learnt from.
  std::vector<int> m_trackOf;             // For each match its track; -1 once that was forgotten.
  bool m_wantsPoints = false;             // Decided by match(), which keeps the mask for it.
  std::size_t m_found = 0;
  std::size_t m_fullCount = 0; // Points after the last refresh.
  int m_age = 0;               // Trusted frames since.
  int m_nextId = 0;            // Of the next new point.
  bool m_hasStarted = false;   // Points were looked for since forget().

  vpPointFlow m_flow;
  std::vector<std::ptrdiff_t> m_flowOf; // For each match its place in m_flow, -1: none.
  cv::Mat m_masked;                     // A pixel for each block of the area: 255 where nothing may be used.
  cv::Mat m_allowed;
  vpCornerFinder m_finder;
  std::vector<cv::Point2f> m_taken, m_corners;
};

END_VISP_NAMESPACE
#endif
