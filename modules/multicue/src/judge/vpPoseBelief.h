// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpPoseBelief_h
#define vpPoseBelief_h

#include <visp3/se3/vpCompatibility.h>

BEGIN_VISP_NAMESPACE

/*!
  Probability that the pose is right, by a Bayes filter with two states over the frames.

  What one image shows at a wrong pose may be as good as at the right one; what tells them apart is how the pose came
  about. One that was followed for long is right; one that jumped there, or was found after a loss, has to explain
  several images.

  Prediction, with the probability p of the frame before and a jump of s squared deviations:
  \f[ p^- = (1 - J) (a p + b (1 - p)) + J c,  J = s / (s_0 + s) \f]
  Correction by the share e that the pose explains of what right ones do:
  \f[ \frac{p}{1 - p} = \frac{p^-}{1 - p^-} \exp(k (e - e_0)) \f]
  k is far below what single images would give, since those on end are alike. Of a pose that is followed e_0 is higher,
  and one image costs no more than a limit; where it jumped, there is nothing but the logarithm l of its odds in this
  frame to go by, with the logistic function:
  \f[ p = (1 - J) p_{followed} + J \sigma(l + o) \f]
*/
class vpPoseBelief
{
public:
  //! \param probability Of the pose that is begun with.
  void start(double probability) { m_probability = probability; }
  //! Of a pose that was found. \param jump Squared distance to the expected pose, in deviations. \param explained
  //! Share, about 1 where all is well.
  void update(double jump, double explained);
  //! Of one that is followed from frame to frame. \param odds Of it among others by this image and how it moved, as a
  //! logarithm: what there is to go by where it jumped.
  void updateFollowed(double jump, double explained, double odds);
  //! The pose has to be confirmed: nothing but the images of this frame and those to come speaks for it.
  void doubt();
  //! There is no pose.
  void lose();
  double probability() const { return m_probability; }
  //! The same as a logarithm of odds.
  double odds() const;

private:
  //! Probability that the object jumped. \param jump Squared distance to the expected pose, in deviations.
  static double jumped(double jump);
  //! Expected from the frame before.
  double followed() const;
  //! \param gained Logarithm of the factor of the odds.
  static double corrected(double before, double gained);
  void set(double probability);

  double m_probability = 0.;
};

END_VISP_NAMESPACE
#endif
