// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpMbOneCamera_h
#define vpMbOneCamera_h

#include <visp3/multicue/vpMbTrackerCalls.h>

#include <type_traits>

BEGIN_VISP_NAMESPACE

/*!
  \ingroup group_multicue
  vpMbGenericTracker's calls that name cameras, for the one camera of this tracker; see \ref multicue_coming.

  Maps have one entry, whose key is the camera's name, "Camera" where none was given. Everything else throws a
  vpException that names the cameras it was given. Calls for two cameras are not there, or deleted where they would
  compile and mean something else.
*/
class VISP_EXPORT vpMbOneCamera : public vpMbTrackerCalls
{
public:
  template <typename T> using PerCamera = std::map<std::string, T>;
  using GrayImages = PerCamera<const vpImage<unsigned char> *>;
  using ColorImages = PerCamera<const vpImage<vpRGBa> *>;
  //! What can be made a std::string of.
  template <typename T> using IfText = std::enable_if_t<std::is_convertible<T, std::string>::value, int>;

  /** @name The camera */
  //@{
  std::vector<std::string> getCameraNames() const { return {m_referenceCameraName}; }
  std::string getReferenceCameraName() const { return m_referenceCameraName; }
  //! \throw vpException where there is no such camera.
  virtual void setReferenceCameraName(const std::string &referenceCameraName);
  PerCamera<int> getCameraTrackerTypes() const { return {{m_referenceCameraName, getTrackerType()}}; }
  //! \throw vpException where the matrix is not the identity: a single camera is its own reference.
  virtual void setCameraTransformationMatrix(const std::string &cameraName, const vpHomogeneousMatrix &cameraMref);
  virtual void setCameraTransformationMatrix(const PerCamera<vpHomogeneousMatrix> &mapOfTransformationMatrix);
  //@}

  /** @name Model and settings */
  //@{
  using vpMbTrackerCalls::reInitModel;
  virtual void reInitModel(const GrayImages &mapOfImages, const PerCamera<std::string> &mapOfModelFiles,
                           const PerCamera<vpHomogeneousMatrix> &mapOfCameraPoses, bool verbose = false,
                           const PerCamera<vpHomogeneousMatrix> &mapOfT = PerCamera<vpHomogeneousMatrix>());
  virtual void reInitModel(const ColorImages &mapOfColorImages, const PerCamera<std::string> &mapOfModelFiles,
                           const PerCamera<vpHomogeneousMatrix> &mapOfCameraPoses, bool verbose = false,
                           const PerCamera<vpHomogeneousMatrix> &mapOfT = PerCamera<vpHomogeneousMatrix>());
  using vpMbTracker::loadModel;
  virtual void loadModel(const PerCamera<std::string> &mapOfModelFiles, bool verbose = false,
                         const PerCamera<vpHomogeneousMatrix> &mapOfT = PerCamera<vpHomogeneousMatrix>());
  //! The models of two cameras: use vpMbGenericTracker. Without this the second name would be taken for \e verbose.
  template <typename Text, IfText<Text> = 0>
  void loadModel(const std::string &modelFile1, const Text &modelFile2, bool verbose = false,
                 const vpHomogeneousMatrix &T1 = vpHomogeneousMatrix(),
                 const vpHomogeneousMatrix &T2 = vpHomogeneousMatrix()) = delete;
  using vpMbTracker::loadConfigFile;
  virtual void loadConfigFile(const PerCamera<std::string> &mapOfConfigFiles, bool verbose = true);
  //! The settings of two cameras: use vpMbGenericTracker, see loadModel().
  template <typename Text, IfText<Text> = 0>
  void loadConfigFile(const std::string &configFile1, const Text &configFile2, bool verbose = true) = delete;

  using vpMbTrackerCalls::setTrackerType;
  virtual void setTrackerType(const PerCamera<int> &mapOfTrackerTypes);
  using vpMbTracker::getCameraParameters;
  virtual void getCameraParameters(PerCamera<vpCameraParameters> &mapOfCameraParameters) const;
  using vpMbTracker::setCameraParameters;
  virtual void setCameraParameters(const PerCamera<vpCameraParameters> &mapOfCameraParameters);
  using vpMbTracker::setAngleAppear;
  virtual void setAngleAppear(const PerCamera<double> &mapOfAngles);
  using vpMbTracker::setAngleDisappear;
  virtual void setAngleDisappear(const PerCamera<double> &mapOfAngles);
  using vpMbTracker::getClipping;
  virtual void getClipping(PerCamera<unsigned int> &mapOfClippingFlags) const;
  using vpMbTracker::setClipping;
  virtual void setClipping(const PerCamera<unsigned int> &mapOfClippingFlags);
  using vpMbTracker::setNearClippingDistance;
  virtual void setNearClippingDistance(const PerCamera<double> &mapOfDists);
  using vpMbTracker::setFarClippingDistance;
  virtual void setFarClippingDistance(const PerCamera<double> &mapOfDists);
  using vpMbTrackerCalls::getMovingEdge;
  virtual void getMovingEdge(PerCamera<vpMe> &mapOfMovingEdges) const;
  using vpMbTrackerCalls::setMovingEdge;
  virtual void setMovingEdge(const PerCamera<vpMe> &mapOfMe);
  using vpMbTrackerCalls::getKltOpencv;
  virtual void getKltOpencv(PerCamera<vpKltOpencv> &mapOfKlts) const;
  using vpMbTrackerCalls::setKltOpencv;
  virtual void setKltOpencv(const PerCamera<vpKltOpencv> &mapOfKlts);
  using vpMbTrackerCalls::setKltMaskBorder;
  virtual void setKltMaskBorder(const PerCamera<unsigned int> &mapOfErosions);
  //@}

  /** @name Tracking */
  //@{
  using vpMbTracker::initClick;
  virtual void initClick(const GrayImages &mapOfImages, const PerCamera<std::string> &mapOfInitFiles,
                         bool displayHelp = false,
                         const PerCamera<vpHomogeneousMatrix> &mapOfT = PerCamera<vpHomogeneousMatrix>());
  virtual void initClick(const ColorImages &mapOfColorImages, const PerCamera<std::string> &mapOfInitFiles,
                         bool displayHelp = false,
                         const PerCamera<vpHomogeneousMatrix> &mapOfT = PerCamera<vpHomogeneousMatrix>());
  using vpMbTracker::initFromPoints;
  virtual void initFromPoints(const GrayImages &mapOfImages, const PerCamera<std::string> &mapOfInitPoints);
  virtual void initFromPoints(const ColorImages &mapOfColorImages, const PerCamera<std::string> &mapOfInitPoints);
  using vpMbTracker::initFromPose;
  virtual void initFromPose(const GrayImages &mapOfImages, const PerCamera<std::string> &mapOfInitPoses);
  virtual void initFromPose(const ColorImages &mapOfColorImages, const PerCamera<std::string> &mapOfInitPoses);
  virtual void initFromPose(const GrayImages &mapOfImages, const PerCamera<vpHomogeneousMatrix> &mapOfCameraPoses);
  virtual void initFromPose(const ColorImages &mapOfColorImages,
                            const PerCamera<vpHomogeneousMatrix> &mapOfCameraPoses);
  using vpMbTracker::setPose;
  virtual void setPose(const GrayImages &mapOfImages, const PerCamera<vpHomogeneousMatrix> &mapOfCameraPoses);
  virtual void setPose(const ColorImages &mapOfColorImages, const PerCamera<vpHomogeneousMatrix> &mapOfCameraPoses);
  using vpMbTracker::track;
  virtual void track(const GrayImages &mapOfImages);
  virtual void track(const ColorImages &mapOfColorImages);
  //@}

  /** @name Results */
  //@{
  using vpMbTracker::getPose;
  virtual void getPose(PerCamera<vpHomogeneousMatrix> &mapOfCameraPoses) const;
  using vpMbTrackerCalls::getFaces;
  virtual vpMbHiddenFaces<vpMbtPolygon> &getFaces(const std::string &cameraName);
  using vpMbTracker::getNbPolygon;
  virtual void getNbPolygon(PerCamera<unsigned int> &mapOfNbPolygons) const;
  using vpMbTrackerCalls::getPolygon;
  virtual vpMbtPolygon *getPolygon(const std::string &cameraName, unsigned int index);
  using vpMbTrackerCalls::getPolygonFaces;
  virtual void getPolygonFaces(PerCamera<std::vector<vpPolygon>> &mapOfPolygons,
                               PerCamera<std::vector<std::vector<vpPoint>>> &mapOfPoints, bool orderPolygons = true,
                               bool useVisibility = true, bool clipPolygon = false);
  using vpMbTrackerCalls::getLline;
  virtual void getLline(const std::string &cameraName, std::list<vpMbtDistanceLine *> &linesList,
                        unsigned int level = 0) const;
  using vpMbTrackerCalls::getLcylinder;
  virtual void getLcylinder(const std::string &cameraName, std::list<vpMbtDistanceCylinder *> &cylindersList,
                            unsigned int level = 0) const;
  using vpMbTrackerCalls::getLcircle;
  virtual void getLcircle(const std::string &cameraName, std::list<vpMbtDistanceCircle *> &circlesList,
                          unsigned int level = 0) const;
  using vpMbTrackerCalls::getNbPoints;
  virtual void getNbPoints(PerCamera<unsigned int> &mapOfNbPoints, unsigned int level = 0) const;
  using vpMbTrackerCalls::getFeaturesForDisplay;
  virtual void getFeaturesForDisplay(PerCamera<std::vector<std::vector<double>>> &mapOfFeatures);
  using vpMbTracker::getModelForDisplay;
  virtual void getModelForDisplay(PerCamera<std::vector<std::vector<double>>> &mapOfModels,
                                  const PerCamera<unsigned int> &mapOfwidths,
                                  const PerCamera<unsigned int> &mapOfheights,
                                  const PerCamera<vpHomogeneousMatrix> &mapOfcMos,
                                  const PerCamera<vpCameraParameters> &mapOfCams, bool displayFullModel = false);
  //! \return 0: depth is not used, as in the next one.
  virtual unsigned int getNbFeaturesDepthDense() const { return 0; }
  virtual unsigned int getNbFeaturesDepthNormal() const { return 0; }
  using vpMbTracker::display;
  virtual void display(const GrayImages &mapOfImages, const PerCamera<vpHomogeneousMatrix> &mapOfCameraPoses,
                       const PerCamera<vpCameraParameters> &mapOfCameraParameters, const vpColor &col,
                       unsigned int thickness = 1, bool displayFullModel = false);
  virtual void display(const ColorImages &mapOfColorImages, const PerCamera<vpHomogeneousMatrix> &mapOfCameraPoses,
                       const PerCamera<vpCameraParameters> &mapOfCameraParameters, const vpColor &col,
                       unsigned int thickness = 1, bool displayFullModel = false);
  //@}

protected:
  //! \throw vpException where it is not the camera's name.
  void requireCamera(const std::string &cameraName) const;
  //! \throw vpException where a number of cameras that was given is not 1.
  static void requireOneCamera(std::size_t cameras);

  std::string m_referenceCameraName = "Camera";

private:
  template <typename T> const T &only(const PerCamera<T> &values) const;
  template <typename Pixel> const vpImage<Pixel> &only(const PerCamera<const vpImage<Pixel> *> &images) const;
  vpHomogeneousMatrix onlyOrNone(const PerCamera<vpHomogeneousMatrix> &matrices) const;
};

END_VISP_NAMESPACE
#endif
