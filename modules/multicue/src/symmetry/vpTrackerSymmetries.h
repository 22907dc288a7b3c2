// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpTrackerSymmetries_h
#define vpTrackerSymmetries_h

#include <visp3/model/vpModelSymmetries.h>
#include <visp3/se3/vpPoseExponential.h>

#include <memory>
#include <string>

BEGIN_VISP_NAMESPACE

//! What a tracker knows of poses that look alike.
class vpTrackerSymmetries
{
public:
  //! As vpMultiCueSettings::symmetries says; to be used with set().
  static constexpr const char *none = "none";
  static constexpr const char *find = "find";

  //! \return The symmetries that settings ask for. \param model Null before there is one.
  //! \throw vpException naming the file that is missing or broken.
  static vpModelSymmetries read(const std::string &from, unsigned int object, const vpTrackedModel *model);

  const vpModelSymmetries &known() const { return m_known; }
  //! Where they are from: empty for those that a program gave.
  const std::string &from() const { return m_from; }
  unsigned int object() const { return m_object; }
  //! \param model Null before there is one.
  void set(const vpModelSymmetries &symmetries, const std::string &from, unsigned int object,
           const vpTrackedModel *model);
  //! The model has more parts, or is another one: symmetries that are to be found are found again.
  void setModel(const vpTrackedModel &model);
  //! Forgets those of a model that is replaced; those that are to be found will be.
  void forget();

  //! Null where all poses look different.
  const vpModelSymmetries *get() const { return m_known.isEmpty() ? nullptr : &m_known; }
  /*!
    Of the poses that look like one, the nearest to another one; that one itself without symmetries.
    \param model Its middle and size.
  */
  vpHomogeneousMatrix nearest(const vpHomogeneousMatrix &cMo, const vpHomogeneousMatrix &reference,
                              const vpTrackedModel &model) const;
  //! True where a step from a pose to another one is hardly one, because the object looks the same after it.
  bool hides(const vpHomogeneousMatrix &cMo, const vpHomogeneousMatrix &reference, const vpTrackedModel &model) const;

  //! True where turns about an axis leave the outline as it is: one that is known, or else one of the model's shape.
  bool hasAxis() const { return !m_turns.axes().empty(); }
  //! True where the model's colours are not the same all around such an axis, and none was declared.
  bool printShowsTurns() const { return m_known.axes().empty() && m_isPrinted; }
  //! A pose with the turn about the axes, where there are any, that is nearest to another pose's.
  vpHomogeneousMatrix unturned(const vpHomogeneousMatrix &cMo, const vpHomogeneousMatrix &reference,
                               const vpTrackedModel &model) const;
  /*!
    Takes the turns about the axes out of small motions, object frame, metres and radians. What is left is perpendicular
    to them where a turn counts as the path of a point at half the diameter.
  */
  const vpPoseMatrix6 &visibleMotions() const { return m_visible; }
  //! Covariance of a pose's error, camera frame, where turns about the axes are what they were said to be: to a filter,
  //! a turn of which nothing is known is one that may have any speed.
  vpPoseMatrix6 settled(const vpPoseMatrix6 &covariance, const vpHomogeneousMatrix &cMo) const;
  //! The turns about the axes as small motions, object frame.
  Eigen::Matrix<double, 6, Eigen::Dynamic> hiddenMotions() const;

private:
  void measure(const vpTrackedModel &model);

  vpModelSymmetries m_known;
  vpModelSymmetries m_shape; // Of the model without its colours: axes alone count.
  bool m_isPrinted = false;  // And its colours have none of these.
  vpModelSymmetries m_turns; // The axes that count.
  vpPoseMatrix6 m_visible = vpPoseMatrix6::Identity();
  std::string m_from;
  unsigned int m_object = 0;
};

END_VISP_NAMESPACE
#endif
