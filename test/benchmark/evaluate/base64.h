// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef benchBase64_h
#define benchBase64_h

#include <string>
#include <vector>

namespace bench {

//! Bytes as text for a data URL (RFC 4648).
inline std::string toBase64(const std::vector<unsigned char> &bytes)
{
  static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    unsigned int group = 0;
    for (std::size_t j = 0; j < 3; ++j) {
      group = group << 8U | (i + j < bytes.size() ? bytes[i + j] : 0U);
    }
    for (unsigned int j = 0; j < 4; ++j) {
      text += i + j > bytes.size() ? '=' : digits[group >> (18U - 6U * j) & 63U];
    }
  }
  return text;
}

} // namespace bench
#endif
