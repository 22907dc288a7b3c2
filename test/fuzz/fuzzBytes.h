// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef fuzzBytes_h
#define fuzzBytes_h

#include <cstddef>
#include <cstdint>
#include <limits>

namespace fuzz {
/*!
  Choices that are made by the bytes of an input, one after the other; all 0 beyond its end. libFuzzer ships a class for
  this with clang alone, and the inputs are replayed by the tests of every compiler.
*/
class Bytes
{
public:
  Bytes(const std::uint8_t *data, std::size_t size) : m_at(data), m_end(data + size) {}

  bool isOver() const { return m_at == m_end; }
  std::uint8_t byte() { return isOver() ? std::uint8_t{0} : *m_at++; }
  //! \return Below \e count, which is at most 256.
  unsigned int choice(unsigned int count) { return byte() % count; }
  bool flag() { return choice(2) == 1; }
  //! In steps of 1/255 of the range.
  double number(double first, double last) { return first + (last - first) * byte() / 255.; }
  //! The same; one in sixteen is none that a program would mean to give.
  double anyNumber(double first, double last)
  {
    const double odd[] = {
        0., -1., 1e-300, 1e300, -1e9, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
        1e9};
    return choice(16) == 15 ? odd[choice(8)] : number(first, last);
  }

private:
  const std::uint8_t *m_at;
  const std::uint8_t *m_end;
};
} // namespace fuzz

#endif
