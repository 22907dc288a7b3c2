// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpPrimitiveCollector_h
#define vpPrimitiveCollector_h

#include <visp3/mbt/vpMbTracker.h>
#include <visp3/model/vpTrackedModelBuilder.h>

BEGIN_VISP_NAMESPACE

struct vpCaoFile;

/*!
  Hands what is in a .cao or .wrl file to a model builder. For .wrl files it is a tracker that tracks nothing, with
  which ViSP's own parser calls back. A file that turns out broken half way has then changed nothing else.
*/
class vpPrimitiveCollector : public vpMbTracker
{
public:
  /*!
    \param builder What the model has already.
    \param modelFile Path of a .cao or .wrl file.
    \param odTo Pose of the file's frame in the object frame.
    \return The builder with the file's primitives added.
    \throw vpException naming the file where it is missing or broken.
  */
  static vpTrackedModelBuilder add(const vpTrackedModelBuilder &builder, const std::string &modelFile,
                                   const vpHomogeneousMatrix &odTo);

protected:
  void initCircle(const vpPoint &centre, const vpPoint &second, const vpPoint &third, double radius, int idFace,
                  const std::string &name) override;
  void initCylinder(const vpPoint &start, const vpPoint &end, double radius, int idFace,
                    const std::string &name) override;
  void initFaceFromCorners(vpMbtPolygon &polygon) override;
  void initFaceFromLines(vpMbtPolygon &polygon) override;

private:
  explicit vpPrimitiveCollector(const vpTrackedModelBuilder &builder) : m_builder(builder) {}
  //! Leaves Coin, the library behind .wrl files, running: the application's other trackers may use it.
  ~vpPrimitiveCollector() override { m_sodb_init_called = false; }
  void addCao(const vpCaoFile &file);
  void addPolygonLines(const std::vector<Eigen::Vector3d> &corners, bool closed, const std::string &name, int index);

  // What vpMbTracker demands of a tracker and reading does not use.
  void computeVVSInit() override {}
  void computeVVSInteractionMatrixAndResidu() override {}
  void display(const vpImage<unsigned char> &, const vpHomogeneousMatrix &, const vpCameraParameters &, const vpColor &,
               unsigned int, bool) override
  {
  }
  void display(const vpImage<vpRGBa> &, const vpHomogeneousMatrix &, const vpCameraParameters &, const vpColor &,
               unsigned int, bool) override
  {
  }
  std::vector<std::vector<double>> getModelForDisplay(unsigned int, unsigned int, const vpHomogeneousMatrix &,
                                                      const vpCameraParameters &, bool) override
  {
    return std::vector<std::vector<double>>();
  }
  vpColVector getError() const override { return vpColVector(); }
  vpColVector getRobustWeights() const override { return vpColVector(); }
  void init(const vpImage<unsigned char> &) override {}
  void resetTracker() override {}
  void setPose(const vpImage<unsigned char> &, const vpHomogeneousMatrix &) override {}
  void setPose(const vpImage<vpRGBa> &, const vpHomogeneousMatrix &) override {}
  void testTracking() override {}
  void track(const vpImage<unsigned char> &) override {}
  void track(const vpImage<vpRGBa> &) override {}

  vpTrackedModelBuilder m_builder;
};

END_VISP_NAMESPACE
#endif
