// SPDX-License-Identifier: GPL-2.0-or-later
//! \file fuzzSphere.cpp Fuzzes the reader of saved results ('{' comes first), and that of saved views: an input is what
//! stands between a file's head and its checksum, which no change would pass.
#include "fuzzFile.h"

#include <sphere/vpFingerprint.h>

#include <visp3/model/vpCpuRenderer.h>
#include <visp3/model/vpViewSphere.h>
#include <visp3/multicue/vpMbTrackingResult.h>

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

namespace {
vpViewSphere makeSphere()
{
  static const auto model = std::make_shared<const vpTrackedModel>(
      modelShapes::build(modelShapes::boxPolygons(modelShapes::Point(0.1, 0.08, 0.06))));
  vpViewSphereOptions options;
  options.level = 0;
  options.points = 4;
  return vpViewSphere(model, options, std::make_unique<vpCpuRenderer>(model));
}

//! Of a file of this sphere.
std::string head()
{
  const meshFiles::TemporaryFolder folder;
  makeSphere().save(folder.path("none"));
  std::ifstream stream(folder.path("none"), std::ios::binary);
  const std::string content((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
  return content.substr(0, content.size() - sizeof(std::uint64_t));
}
} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
  if (size > 0 && data[0] == '{') {
    return fuzz::readFile("result.json", data, size, [](const std::string &file) {
      static_cast<void>(vpMbTrackingResult::readFromJsonFile(file));
    });
  }
  static const std::string first = head();
  std::string content = first + std::string(reinterpret_cast<const char *>(data), size);
  vpFingerprint print;
  print.addBytes(content.data(), content.size());
  meshFiles::append(content, print.value());
  return fuzz::readFile("views", reinterpret_cast<const std::uint8_t *>(content.data()), content.size(),
                        [](const std::string &file) {
                          vpViewSphere sphere = makeSphere();
                          sphere.load(file);
                          for (std::size_t i = 0; i < sphere.size(); ++i) {
                            static_cast<void>(sphere.view(i));
                          }
                        });
}
