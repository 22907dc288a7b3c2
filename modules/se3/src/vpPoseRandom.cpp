// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/se3/vpPoseRandom.h>

#include <visp3/core/vpException.h>

#include <cmath>

BEGIN_VISP_NAMESPACE

namespace {
const std::uint64_t goldenRatio = 0x9e3779b97f4a7c15ULL; // 2^64 divided by the golden ratio
const std::uint64_t half = 1ULL << 63;                   // 1/2 as a 64-bit fraction

// The output function of SplitMix64 (Steele, Lea and Flood): a bijection that changes half of the bits.
std::uint64_t mixed(std::uint64_t x)
{
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
  return x ^ (x >> 31);
}

std::uint64_t rotatedLeft(std::uint64_t x, int count)
{
  return (x << count) | (x >> (64 - count));
}

// A 64-bit fraction as a number of [0, 1): the 53 bits that a double holds exactly.
double fractionOfOne(std::uint64_t fraction)
{
  return std::ldexp(static_cast<double>(fraction >> 11), -53);
}
} // namespace

vpPoseRandom::vpPoseRandom(std::uint64_t seed, std::initializer_list<std::uint64_t> names) : m_state()
{
  std::uint64_t key = mixed(seed + goldenRatio);
  for (const std::uint64_t name : names) {
    key = mixed(mixed(key + goldenRatio) ^ name);
  }
  // Four different arguments of a bijection: at most one word of the state can be zero.
  for (std::uint64_t &word : m_state) {
    key += goldenRatio;
    word = mixed(key);
  }
}

// One step of xoshiro256++.
std::uint64_t vpPoseRandom::bits()
{
  const std::uint64_t result = rotatedLeft(m_state[0] + m_state[3], 23) + m_state[0];
  const std::uint64_t shifted = m_state[1] << 17;
  m_state[2] ^= m_state[0];
  m_state[3] ^= m_state[1];
  m_state[1] ^= m_state[2];
  m_state[0] ^= m_state[3];
  m_state[2] ^= shifted;
  m_state[3] = rotatedLeft(m_state[3], 45);
  return result;
}

double vpPoseRandom::uniform()
{
  return fractionOfOne(bits());
}

std::uint64_t vpPoseRandom::index(std::uint64_t count)
{
  if (count == 0) {
    throw vpException(vpException::badValue, "A random index needs at least one choice, but the count is 0");
  }
  return bits() % count;
}

// Algorithm N of C. F. F. Karney, "Sampling exactly from the normal distribution", ACM TOMS 42(1), 2016: |y| = k + x
// is drawn by comparisons of uniform numbers alone. The density falls apart as exp(-y^2 / 2) =
// exp(-k / 2) exp(-k (k - 1) / 2) exp(-x (2 k + x) / 2), and each factor is a game that is won with that probability.
double vpPoseRandom::normal()
{
  while (true) {
    unsigned int k = 0;
    while (isHeadsOfExpHalf()) {
      k++;
    }
    bool accepted = true;
    for (unsigned int i = 0; accepted && k > 1 && i < k * (k - 1); i++) {
      accepted = isHeadsOfExpHalf();
    }
    const std::uint64_t x = bits();
    for (unsigned int i = 0; accepted && i <= k; i++) {
      accepted = isHeadsOfExpOverlap(k, x);
    }
    if (accepted) {
      const double y = k + fractionOfOne(x);
      return bits() < half ? -y : y;
    }
  }
}

// Won with probability exp(-1/2), by von Neumann's method: a falling sequence below p has length n with a probability
// whose alternating sum is exp(-p).
bool vpPoseRandom::isHeadsOfExpHalf()
{
  std::uint64_t last = half;
  bool isEven = true;
  for (std::uint64_t next = bits(); next < last; next = bits()) {
    last = next;
    isEven = !isEven;
  }
  return isEven;
}

// Won with probability exp(-x (2 k + x) / (2 k + 2)): the falling sequence below x, thinned at each step.
bool vpPoseRandom::isHeadsOfExpOverlap(unsigned int k, std::uint64_t fraction)
{
  std::uint64_t last = fraction;
  bool isEven = true;
  for (std::uint64_t next = bits(); next < last && isHeadsOfRatio(k, fraction); next = bits()) {
    last = next;
    isEven = !isEven;
  }
  return isEven;
}

// Won with probability (2 k + x) / (2 k + 2).
bool vpPoseRandom::isHeadsOfRatio(unsigned int k, std::uint64_t fraction)
{
  const std::uint64_t side = index(2 * k + 2);
  return side < 2 * k || (side == 2 * k && bits() < fraction);
}

vpPoseTangent vpPoseRandom::normalTangent()
{
  vpPoseTangent tangent;
  for (double &coordinate : tangent) {
    coordinate = normal();
  }
  return tangent;
}

END_VISP_NAMESPACE
