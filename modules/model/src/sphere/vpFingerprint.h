// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpFingerprint_h
#define vpFingerprint_h

#include <visp3/model/vpTrackedModel.h>

#include <cstdint>
#include <type_traits>

BEGIN_VISP_NAMESPACE

struct vpViewSphereOptions;

//! A number that differs where data differ: FNV-1a with 64 bits. Not for what an attacker chooses.
class vpFingerprint
{
public:
  void addBytes(const void *data, std::size_t bytes)
  {
    const unsigned char *byte = static_cast<const unsigned char *>(data);
    for (std::size_t i = 0; i < bytes; ++i) {
      m_value = (m_value ^ byte[i]) * 1099511628211ULL;
    }
  }
  template <typename T, std::enable_if_t<std::is_arithmetic<T>::value, int> = 0> void add(T value)
  {
    addBytes(&value, sizeof(value));
  }
  template <typename T, int Rows> void add(const Eigen::Matrix<T, Rows, 1> &value)
  {
    addBytes(value.data(), sizeof(T) * Rows);
  }
  template <typename T, std::size_t N> void add(const std::array<T, N> &values)
  {
    for (const T &value : values) {
      add(value);
    }
  }
  // The number of elements, too, so that what leaves one list cannot be taken for the start of the next one.
  template <typename T> void add(const std::vector<T> &values)
  {
    add(values.size());
    for (const T &value : values) {
      add(value);
    }
  }

  std::uint64_t value() const { return m_value; }

private:
  std::uint64_t m_value = 14695981039346656037ULL;
};

//! Of all that decides what the views of a sphere hold.
std::uint64_t fingerprintOf(const vpTrackedModel &model, const vpViewSphereOptions &options);

END_VISP_NAMESPACE
#endif
