// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpPoseMixture_h
#define vpPoseMixture_h

#include <visp3/se3/vpPoseNoise.h>

#include <vector>

BEGIN_VISP_NAMESPACE

/*!
  \class vpPoseMixture
  \ingroup group_se3
  \brief Mixture of Gaussians on poses with one common kernel: sum_k w_k N(mean_k, Sigma) / sum_k w_k, the form of
  [T10] eq. 8-9.

  The density is that of vpPoseNoise, with respect to the measure that all poses share, so ratios of two mixtures are
  right whatever their kernels and frames.

  Kernels that cannot matter are left out. The means are sorted along the axis on which they spread most, and a pose
  looks at its neighbours in both directions until all that follow are too far away by their translations. What the
  density lacks is bounded for each pose and is relative: also far from all kernels, where the density is 1e-200, the
  nearest ones are added up.

  Usage: clear(), add() for each kernel, prepare(), then logDensity() from any number of threads. Nothing is allocated
  once the mixture has had its largest number of kernels.

  \sa \ref se3_mixture
*/
class VISP_EXPORT vpPoseMixture
{
public:
  //! How much work densities were: sums over poses are formed by handing the same object to several calls.
  struct Effort
  {
    std::size_t visited = 0;   //!< Kernels whose distance was bounded.
    std::size_t evaluated = 0; //!< Kernels whose density was computed.
  };

  /*!
    \param kernel Of all kernels.
    \param relativeError The density is never too large, and too small by this factor of itself at most: 0 < error < 1.
    \throw vpException::badValue if \e relativeError is out of range.
  */
  explicit vpPoseMixture(const vpPoseNoise &kernel, double relativeError = 1e-3);

  //! Drops all kernels. \param kernel Of those that follow.
  void clear(const vpPoseNoise &kernel);

  /*!
    Adds a kernel. One that follows its own copy, as resampled particles do, costs nothing later.

    \param mean Its centre. \param weight >= 0, of any scale; a kernel of weight 0 is left out.
    \throw vpException::badValue if the weight is negative, or it or the mean is not finite.
  */
  void add(const vpHomogeneousMatrix &mean, double weight = 1.);
  void add(const Eigen::Isometry3d &mean, double weight = 1.);

  //! Sorts the kernels: after the last add(), before the first logDensity().
  void prepare();

  /*!
    \param cMo Where the density is asked for.
    \param effort Where given, what it took is added to it.
    \return The natural logarithm of the density, 1 / (m^3 rad^3); -infinity where the mixture has no kernels, or the
    pose is not finite.
    \throw vpException::notInitialized if kernels were added after the last prepare().
  */
  double logDensity(const vpHomogeneousMatrix &cMo, Effort *effort = nullptr) const;

  //! \return The number of kernels, copies in a row counted once.
  std::size_t size() const { return m_kernels.size(); }
  //! \return The kernels' noise.
  const vpPoseNoise &kernel() const { return m_noise; }

private:
  // A pose for which the noise is on the right: cMo itself, or its inverse where the noise is in the camera's frame.
  struct Place
  {
    Eigen::Quaterniond rotation;
    Eigen::Vector3d translation;
  };
  struct Kernel
  {
    Place mean;
    double weight;
  };
  // What a kernel adds: weight * factor * exp(-exponent), in units of the density at the mean.
  struct Term
  {
    double exponent;
    double factor;
  };
  // Kernels side by side, as vector units like them.
  static constexpr std::size_t lanes = 8;
  using Lanes = Eigen::Array<double, static_cast<int>(lanes), 1>;
  struct Block
  {
    Lanes w, x, y, z; // The rotation.
    Lanes tx, ty, tz;
    Lanes weight;
    void set(int lane, const Eigen::Quaterniond &rotation, const Eigen::Vector3d &translation, double kernelWeight);
  };
  class Sum;

  Place placeOf(const Eigen::Isometry3d &cMo) const;
  Term termOf(const Place &place, const Kernel &kernel) const;
  std::size_t nearest(double position) const;
  void visit(const Place &place, const Kernel &kernel, Sum &sum, Effort &effort) const;
  bool visitTogether(const Place &place, const Block &block, Sum &sum) const;
  void visitBlock(const Place &place, std::size_t index, Sum &sum, Effort &effort) const;
  void setBounds();

  vpPoseNoise m_noise;
  double m_relativeError;
  vpPoseMatrix6 m_whitening;      // The inverse of the noise's root.
  bool m_isIsotropic = false;     // The same variance for all translations, and for all rotations.
  double m_rotationFactor = 0.;   // Of the squared angle in the exponent of such a kernel.
  double m_translationBound = 0.; // The exponent of a kernel is at least this times a squared distance of translations,
  double m_rotationBound = 0.;    // plus this times the square of the least angle,
  double m_constantBound = 0.;    // plus this.
  std::vector<Kernel> m_kernels;
  std::vector<Block> m_blocks; // The same ones.
  double m_totalWeight = 0.;
  int m_axis = 0; // Along which the kernels are sorted.
  bool m_isPrepared = true;
};

END_VISP_NAMESPACE

#endif
