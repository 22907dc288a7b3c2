// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpMbTrackerCalls_h
#define vpMbTrackerCalls_h

#include <visp3/klt/vpKltOpencv.h>
#include <visp3/mbt/vpMbTracker.h>
#include <visp3/me/vpMe.h>
#include <visp3/se3/vpCompatibility.h>

#include <list>
#include <map>
#include <string>
#include <vector>

BEGIN_VISP_NAMESPACE

class vpMbtDistanceKltCylinder;
class vpMbtDistanceKltPoints;

/*!
  \ingroup group_multicue
  Calls of vpMbEdgeTracker, vpMbKltTracker and vpMbEdgeKltTracker that vpMbTracker has not, for programs that were
  written for them; see \ref multicue_coming.

  Faces and primitives are ViSP's own, of the .cao and .wrl files that were loaded: a mesh has none of them. Their
  visibility is that of the last pose, as ViSP's trackers have it; it is kept up to date from the first of these calls
  on, so that programs which do not ask for it lose no time.
*/
class VISP_EXPORT vpMbTrackerCalls : public vpMbTracker
{
public:
  /** @name Faces and primitives */
  //@{
  vpMbHiddenFaces<vpMbtPolygon> &getFaces() override;
  vpMbtPolygon *getPolygon(unsigned int index) override;
  std::pair<std::vector<vpPolygon>, std::vector<std::vector<vpPoint>>>
  getPolygonFaces(bool orderPolygons = true, bool useVisibility = true, bool clipPolygon = false) override;
  /*!
    ViSP's lines. They are for reading: tracked are the edges of vpMbMultiCueTracker::getModel(), so that they have no
    moving edges of their own. \param linesList Becomes the lines. \param level Must be 0, as in the next two.
    \throw vpException where the model has meshes only: getModelForDisplay() shows their edges.
  */
  virtual void getLline(std::list<vpMbtDistanceLine *> &linesList, unsigned int level = 0) const;
  //! ViSP's cylinders. \param cylindersList, level See getLline().
  virtual void getLcylinder(std::list<vpMbtDistanceCylinder *> &cylindersList, unsigned int level = 0) const;
  //! ViSP's circles. \param circlesList, level See getLline().
  virtual void getLcircle(std::list<vpMbtDistanceCircle *> &circlesList, unsigned int level = 0) const;
  //! ViSP's circles; the list stays valid until the next call.
  virtual std::list<vpMbtDistanceCircle *> &getFeaturesCircle();
  //! \throw vpException Always: points belong to the surface and not to faces; getKltImagePointsWithId() has them.
  virtual std::list<vpMbtDistanceKltPoints *> &getFeaturesKlt();
  //! \throw vpException Always, see getFeaturesKlt().
  virtual std::list<vpMbtDistanceKltCylinder *> &getFeaturesKltCylinder();
  /*!
    Adds a circle to the model; it is tracked, too, while vpMbKltTracker only displays it. As after loadModel(), the
    tracker has to be started anew.
    \param P1 Centre. \param P2, P3 Two more points of its plane, counter-clockwise from the side it is seen from;
    object frame. \param r Radius, metres, > 0. \param name For setUseEdgeTracking().
  */
  virtual void addCircle(const vpPoint &P1, const vpPoint &P2, const vpPoint &P3, double r,
                         const std::string &name = "") = 0;
  /*!
    Leaves edges out, or takes them in again.
    \param name Of faces, as the model file has it. \param useEdgeTracking False: an edge that is seen of such faces
    alone takes no part in the pose. Forgotten by reInitModel() and resetTracker().
  */
  virtual void setUseEdgeTracking(const std::string &name, const bool &useEdgeTracking) = 0;
  //! Likewise for points. \param name Of flat faces. \param useKltTracking False: no points on them; all points are
  //! looked for anew.
  virtual void setUseKltTracking(const std::string &name, const bool &useKltTracking) = 0;
  //@}

  /** @name Points */
  //@{
  //! \return The points that were found in the last image, in the image as it was taken, by their numbers.
  virtual std::map<int, vpImagePoint> getKltImagePointsWithId() const = 0;
  //! The same without numbers.
  virtual std::vector<vpImagePoint> getKltImagePoints() const;
  //! The same as OpenCV's points, (column, row).
  virtual std::vector<cv::Point2f> getKltPoints() const;
  //! How many they are.
  virtual int getKltNbPoints() const;
  virtual unsigned int getKltMaskBorder() const = 0;
  //! \param border Points nearer to the border of a face are left out, pixels, [0, 100].
  virtual void setKltMaskBorder(const unsigned int &border) = 0;
  virtual vpKltOpencv getKltOpencv() const = 0;
  //! How points are chosen and followed; they take part where getTrackerType() has KLT_TRACKER.
  virtual void setKltOpencv(const vpKltOpencv &klt) = 0;
  //! \param threshold Points with a smaller robust weight are outliers, [0, 1); 0.1 by default where ViSP has 0.5,
  //! since each point's own patch is compared before.
  virtual void setKltThresholdAcceptation(double threshold) = 0;
  virtual double getKltThresholdAcceptation() const = 0;
  //@}

  /** @name Older names of the same */
  //@{
  unsigned int getMaskBorder() const { return getKltMaskBorder(); }
  void setMaskBorder(const unsigned int &border) { setKltMaskBorder(border); }
  int getNbKltPoints() const { return getKltNbPoints(); }
  double getThresholdAcceptation() const { return getKltThresholdAcceptation(); }
  void setThresholdAcceptation(double threshold) { setKltThresholdAcceptation(threshold); }
  //@}

  /** @name Others */
  //@{
  //! \return {true}: edges are looked for in the image itself.
  virtual std::vector<bool> getScales() const;
  //! \param scales Its first must be true and the others false. \throw vpException else: a wider range of vpMe, or
  //! vpMbMultiCueTracker::setSearch(), reaches farther.
  virtual void setScales(const std::vector<bool> &scales);
  virtual void setTrackerType(int type) = 0;
  virtual int getTrackerType() const = 0;
  virtual void setMovingEdge(const vpMe &me) = 0;
  virtual vpMe getMovingEdge() const = 0;
  virtual unsigned int getNbPoints(unsigned int level = 0) const = 0;
  virtual std::vector<std::vector<double>> getFeaturesForDisplay() = 0;
  virtual void reInitModel(const vpImage<unsigned char> &I, const std::string &modelFile,
                           const vpHomogeneousMatrix &cMo, bool verbose = false,
                           const vpHomogeneousMatrix &odTo = vpHomogeneousMatrix()) = 0;
  virtual void reInitModel(const vpImage<vpRGBa> &I_color, const std::string &modelFile, const vpHomogeneousMatrix &cMo,
                           bool verbose = false, const vpHomogeneousMatrix &odTo = vpHomogeneousMatrix()) = 0;
  //@}

protected:
  //! Tells that the pose is that of an image of this size, pixels.
  void followFaces(unsigned int width, unsigned int height);
  //! Forgets ViSP's faces and primitives.
  void forgetPrimitives();
  //! \throw vpException where the level is not 0.
  static void requireLevel(unsigned int level);

private:
  void updateFaces();
  void requirePrimitives(unsigned int level) const;

  bool m_facesAreAsked = false;
  unsigned int m_facesWidth = 0; // 0: no pose yet.
  unsigned int m_facesHeight = 0;
  std::list<vpMbtDistanceCircle *> m_circles; // For getFeaturesCircle().
};

END_VISP_NAMESPACE
#endif
