// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef centroidCue_h
#define centroidCue_h

#include <visp3/multicue/vpCueKind.h>

#include <cmath>

BEGIN_VISP_NAMESPACE

/*!
  \file centroidCue.h
  A cue that the library does not know: the middle of the object's outline is where that of the reddish pixels is. It
  shows what a new cue takes: the two classes below, and the line kind() that brings them into the trackers.
*/
class vpCentroidCue : public vpPoseCue
{
public:
  //! [Match]
  void match(const vpCueFrame &frame, const vpModelView &view) override
  {
    m_camera = frame.camera();
    m_outline.clear();
    for (const vpControlPoint &point : view.points()) {
      if (point.kind == vpEdgeKind::SILHOUETTE) {
        m_outline.push_back(point.position);
      }
    }
    m_pixels = 0;
    m_seen.setZero();
    for (unsigned int i = 0; frame.hasColor() && i < frame.height(); ++i) {
      for (unsigned int j = 0; j < frame.width(); ++j) {
        if (isOutline(frame.color(), i, j)) {
          m_seen += Eigen::Vector2d(j, i);
          ++m_pixels;
        }
      }
    }
  }
  //! [Match]

  //! [Residuals]
  void residuals(const vpHomogeneousMatrix &cMo, vpResidualBlock &block) const override
  {
    block.rows.assign(hasData() ? 2 : 0, vpResidual());
    block.noise = 1. / m_camera.get_px(); // A pixel; the error is in metres at 1 m, as that of edges.
    for (const Eigen::Vector3d &position : m_outline) {
      for (unsigned int k = 0; k < block.rows.size(); ++k) {
        const Eigen::Vector3d at = toEye(cMo, position);
        const double x = at.x() / at.z();
        const double y = at.y() / at.z();
        Eigen::Matrix<double, 6, 1> row;
        if (k == 0) {
          row << -1. / at.z(), 0., x / at.z(), x * y, -(1. + x * x), y;
        } else {
          row << 0., -1. / at.z(), y / at.z(), 1. + y * y, -x * y, -x;
        }
        const double share = 1. / static_cast<double>(m_outline.size());
        block.rows[k].error += share * (k == 0 ? x : y);
        block.rows[k].jacobian += share * row;
      }
    }
    if (hasData()) {
      block.rows[0].error -= (m_seen.x() / m_pixels - m_camera.get_u0()) / m_camera.get_px();
      block.rows[1].error -= (m_seen.y() / m_pixels - m_camera.get_v0()) / m_camera.get_py();
    }
  }
  //! [Residuals]

  void updateReference(const vpHomogeneousMatrix &, const std::vector<double> &) override {}
  void reset() override {}

  void getFeatures(const vpHomogeneousMatrix &, const std::vector<double> &weights,
                   std::vector<vpCueFeature> &features) const override
  {
    features.assign(weights.size(), vpCueFeature());
    for (vpCueFeature &feature : features) {
      feature.u = m_seen.x() / m_pixels;
      feature.v = m_seen.y() / m_pixels;
    }
  }

  bool hasData() const { return !m_outline.empty() && m_pixels > 0.; }

private:
  static bool isRed(const vpImage<vpRGBa> &I, unsigned int i, unsigned int j) { return I[i][j].R > 35; }

  // On the border of what is red.
  static bool isOutline(const vpImage<vpRGBa> &I, unsigned int i, unsigned int j)
  {
    const bool hasNeighbours = i > 0 && j > 0 && i + 1 < I.getHeight() && j + 1 < I.getWidth();
    return hasNeighbours && isRed(I, i, j) &&
           !(isRed(I, i - 1, j) && isRed(I, i + 1, j) && isRed(I, i, j - 1) && isRed(I, i, j + 1));
  }

  static Eigen::Vector3d toEye(const vpHomogeneousMatrix &cMo, const Eigen::Vector3d &p)
  {
    Eigen::Vector3d at;
    for (unsigned int i = 0; i < 3; ++i) {
      at[i] = cMo[i][0] * p.x() + cMo[i][1] * p.y() + cMo[i][2] * p.z() + cMo[i][3];
    }
    return at;
  }

  vpCameraParameters m_camera;
  std::vector<Eigen::Vector3d> m_outline; // Object frame.
  Eigen::Vector2d m_seen = Eigen::Vector2d::Zero();
  double m_pixels = 0.;
};

//! [Kind]
class vpTrackedCentroid : public vpTrackedCue
{
public:
  static constexpr int type = 1 << 5;

  vpPoseCue &cue() override { return m_cue; }
  unsigned int expected() const override { return 2; }
  std::string missing() const override { return "no reddish pixel is in the image"; }
  std::optional<double> agreement(const vpHomogeneousMatrix &cMo, const vpCameraParameters &camera) override
  {
    if (!m_cue.hasData()) {
      return std::nullopt;
    }
    vpResidualBlock block;
    m_cue.residuals(cMo, block);
    const double pixels = camera.get_px() * std::hypot(block.rows[0].error, block.rows[1].error);
    return std::exp(-pixels / 10.);
  }

  static vpCueKind kind()
  {
    return {type, "centroid", "CENTROID", vpCueVote::BESIDE_EDGES,
            [] { return std::make_unique<vpTrackedCentroid>(); }};
  }

private:
  vpCentroidCue m_cue;
};
//! [Kind]

END_VISP_NAMESPACE
#endif
