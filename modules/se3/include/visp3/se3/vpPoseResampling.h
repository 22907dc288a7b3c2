// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpPoseResampling_h
#define vpPoseResampling_h

#include <visp3/se3/vpCompatibility.h>

#include <cstddef>
#include <vector>

BEGIN_VISP_NAMESPACE

/*!
  \class vpPoseResampling
  \ingroup group_se3
  \brief Weights of particles: from logarithms, how many of them count, and which to keep.

  \sa \ref se3_particles
*/
class VISP_EXPORT vpPoseResampling
{
public:
  /*!
    Turns logarithms of weights into weights whose sum is 1, whatever the logarithms' size.

    \param logWeights Natural logarithms. -infinity, +infinity and NaN all give the weight 0: no likelihood that failed
    can spread.
    \param weights Gets as many weights. Where all of them vanish they are all the same, or all 0 for none.
    \return The logarithm of the weights' sum before; -infinity where all of them vanish.
  */
  static double normalise(const std::vector<double> &logWeights, std::vector<double> &weights);

  /*!
    \param weights >= 0, of any scale.
    \return How many equal weights have as much variance: (sum w)^2 / sum w^2, from 1 to the number of weights; 0 where
    all weights are 0.
  */
  static double effectiveSize(const std::vector<double> &weights);

  /*!
    Systematic resampling: picks at equal distances on the cumulated weights, all shifted by one random number. Weight
    w of a sum of 1 is picked count * w times, rounded down or up.

    \param weights >= 0, finite, not all 0, of any scale.
    \param count Number of picks.
    \param shift Of the uniform distribution on [0, 1).
    \param picks Gets \e count indices of weights above 0, in ascending order.
    \throw vpException::badValue if a weight or \e shift is out of range.
  */
  static void systematic(const std::vector<double> &weights, std::size_t count, double shift,
                         std::vector<std::size_t> &picks);
};

END_VISP_NAMESPACE

#endif
