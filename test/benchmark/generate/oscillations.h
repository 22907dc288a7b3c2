// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef benchOscillations_h
#define benchOscillations_h

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <vector>

namespace bench {

/*!
  Irregular oscillations, calm and wild by turns, as of a hand: each is a sum of sinusoids of a common phase, which
  proceeds at a speed that changes with time. They are functions of time without memory, so that an instant between two
  frames is as good as a frame.
*/
class Oscillations
{
public:
  //! \param count How many. \param seed The same one gives the same oscillations.
  Oscillations(int count, std::uint64_t seed);

  //! \param time In frames. \param tempo Radians per frame of the middle frequency, in the mean.
  //! \return Values with a mean square of 1.
  Eigen::VectorXd at(double time, double tempo) const;

private:
  struct Wave
  {
    double amplitude = 1.;
    double frequency = 1.;
    double phase = 0.;
  };

  double passed(double time) const;

  std::vector<std::array<Wave, 3>> m_waves;
  std::array<Wave, 2> m_speed; //!< Of the phase, about 1; frequencies are radians per frame.
};

} // namespace bench
#endif
