// SPDX-License-Identifier: GPL-2.0-or-later
#include "files/mtlFile.h"

#include "files/fileBytes.h"
#include "files/meshSink.h"

#include <algorithm>

BEGIN_VISP_NAMESPACE
namespace vpMeshDetail {
namespace {
// One number or three; a spectrum or another colour space is none.
std::optional<Eigen::Vector3f> colorOf(std::string_view text)
{
  Eigen::Vector3d color;
  for (int i = 0; i < 3; ++i) {
    const std::string_view word = takeWord(text);
    if (i > 0 && word.empty()) {
      color[i] = color[0];
    } else if (!parseNumber(word, color[i])) {
      return std::nullopt;
    }
  }
  return color.allFinite() ? std::optional<Eigen::Vector3f>(toColor(color, color.maxCoeff())) : std::nullopt;
}

// The name after options like -s 1 1 1 or -clamp on; it may have blanks.
std::string imageName(std::string_view text)
{
  text = trimmed(text);
  while (!text.empty() && text.front() == '-') {
    const std::string option = lowerCase(takeWord(text));
    const bool isVector = option == "-o" || option == "-s" || option == "-t";
    const int most = isVector ? 3 : option == "-mm" ? 2 : 1;
    for (int i = 0; i < most; ++i) {
      std::string_view rest = text;
      const std::string_view word = takeWord(rest);
      double ignored = 0.;
      if (isVector && !parseNumber(word, ignored)) {
        break;
      }
      text = rest;
    }
    text = trimmed(text);
  }
  return std::string(text);
}
} // namespace

void readMtl(const std::string &file, std::map<std::string, MtlMaterial> &materials)
{
  std::string text = readBytes(file);
  dropByteOrderMark(file, text);
  MtlMaterial *material = nullptr;
  for (LineWalk lines(text); lines.next();) {
    std::string_view line = lines.line();
    const std::string key = lowerCase(takeWord(line));
    if (key == "newmtl") {
      // Of two with one name, the last one counts.
      material = &(materials[std::string(trimmed(line))] = MtlMaterial());
    } else if (material != nullptr && key == "kd") {
      material->color = colorOf(line);
    } else if (material != nullptr && key == "map_kd") {
      material->image = imageName(line);
    }
  }
}
} // namespace vpMeshDetail
END_VISP_NAMESPACE
