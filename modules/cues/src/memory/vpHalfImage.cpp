// SPDX-License-Identifier: GPL-2.0-or-later
#include "memory/vpHalfImage.h"

#include <cstddef>
#include <cstring>

BEGIN_VISP_NAMESPACE

namespace {
const std::uint32_t everyOther = 0x00FF00FFU;

// Four levels fit into the 16 bits that a level of every other byte has to itself, so two bytes of a pixel are averaged
// at once; half is rounded upwards. The order of the bytes in a number does not matter.
std::uint32_t meanOf(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d)
{
  const std::uint32_t two = 0x00020002U;
  const std::uint32_t low = (a & everyOther) + (b & everyOther) + (c & everyOther) + (d & everyOther) + two;
  const std::uint32_t high =
      ((a >> 8U) & everyOther) + ((b >> 8U) & everyOther) + ((c >> 8U) & everyOther) + ((d >> 8U) & everyOther) + two;
  return ((low >> 2U) & everyOther) | (((high >> 2U) & everyOther) << 8U);
}

std::uint32_t load(const vpRGBa *pixel)
{
  std::uint32_t number = 0;
  static_assert(sizeof(*pixel) == sizeof(number), "red, green, blue and alpha");
  std::memcpy(&number, pixel, sizeof(number));
  return number;
}

// Writes one row of the result.
void halve(const vpRGBa *above, const vpRGBa *below, unsigned int width, std::uint8_t *__restrict pixels)
{
  for (std::size_t j = 0; j < width; ++j) {
    const std::uint32_t mean =
        meanOf(load(above + 2 * j), load(above + 2 * j + 1), load(below + 2 * j), load(below + 2 * j + 1));
    std::memcpy(pixels + 4 * j, &mean, sizeof(mean));
  }
}

void halve(const unsigned char *above, const unsigned char *below, unsigned int width, std::uint8_t *__restrict pixels)
{
  for (std::size_t j = 0; j < width; ++j) {
    const std::uint32_t sum = 2U + above[2 * j] + above[2 * j + 1] + below[2 * j] + below[2 * j + 1];
    const std::uint32_t mean = (sum >> 2U) * 0x01010101U;
    std::memcpy(pixels + 4 * j, &mean, sizeof(mean));
  }
}

template <typename Pixel> void halveAll(const vpImage<Pixel> &I, std::vector<std::uint8_t> &pixels)
{
  const unsigned int width = I.getWidth() / 2;
  const unsigned int height = I.getHeight() / 2;
  pixels.resize(std::size_t{4} * width * height);
  for (unsigned int i = 0; i < height; ++i) {
    halve(I[2 * i], I[2 * i + 1], width, pixels.data() + std::size_t{4} * width * i);
  }
}
} // namespace

void vpHalveImage(const vpImage<unsigned char> &I, std::vector<std::uint8_t> &pixels)
{
  halveAll(I, pixels);
}

void vpHalveImage(const vpImage<vpRGBa> &I, std::vector<std::uint8_t> &pixels)
{
  halveAll(I, pixels);
}

END_VISP_NAMESPACE
