// SPDX-License-Identifier: GPL-2.0-or-later
#include "files/mtlFile.h"

#include "files/fileBytes.h"
#include "files/meshSink.h"

#include <visp3/core/vpException.h>

BEGIN_VISP_NAMESPACE
namespace vpMeshDetail {
namespace {
// One number or three; a spectrum or another colour space is none.
std::optional<Eigen::Vector3f> colorOf(std::string_view text)
{
  Eigen::Vector3d color;
  int count = 0;
  for (std::string_view word = takeWord(text); !word.empty(); word = takeWord(text)) {
    if (count == 3 || !parseNumber(word, color[count])) {
      return std::nullopt;
    }
    ++count;
  }
  if (count == 1) {
    color.setConstant(color[0]);
  }
  return (count == 1 || count == 3) && color.allFinite()
             ? std::optional<Eigen::Vector3f>(toColor(color, color.maxCoeff()))
             : std::nullopt;
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

class MtlReader
{
public:
  MtlReader(const std::string &file, std::map<std::string, MtlMaterial> &materials)
      : m_file(file), m_materials(materials)
  {
  }

  std::vector<std::string> read()
  {
    std::string text = readBytes(m_file);
    dropByteOrderMark(m_file, text);
    LineWalk lines(text);
    bool isEmpty = true;
    while (lines.next()) {
      const std::string_view line = trimmed(lines.line());
      isEmpty = line.empty();
      readLine(line, lines.number());
    }
    if (lines.endsInLine() && !isEmpty) {
      m_warnings.push_back("'" + m_file + "' has no line end after its last line: is it whole?");
    }
    return m_warnings;
  }

private:
  void readLine(std::string_view line, std::size_t number)
  {
    const std::string key = lowerCase(takeWord(line));
    if (key == "newmtl") {
      // Of two with one name, the last one counts.
      m_material = &(m_materials[std::string(trimmed(line))] = MtlMaterial());
    } else if (m_material != nullptr && key == "kd") {
      m_material->color = colorOf(line);
      if (!m_material->color) {
        m_warnings.push_back("the colour in line " + std::to_string(number) + " of '" + m_file +
                             "' is neither one number nor three, and left out");
      }
    } else if (m_material != nullptr && key == "map_kd") {
      m_material->image = imageName(line);
    }
  }

  const std::string &m_file;
  std::map<std::string, MtlMaterial> &m_materials;
  MtlMaterial *m_material = nullptr;
  std::vector<std::string> m_warnings;
};
} // namespace

int ObjMaterials::index(const std::string &name)
{
  const auto [known, isNew] = m_indices.emplace(name, static_cast<int>(m_names.size()));
  if (isNew) {
    m_names.push_back(name);
  }
  return known->second;
}

void ObjMaterials::addFiles(const std::string &names)
{
  const std::string whole = m_sink.findBeside(names);
  if (!whole.empty()) {
    addFile(whole);
    return;
  }
  std::string_view rest = names;
  for (std::string_view word = takeWord(rest); !word.empty(); word = takeWord(rest)) {
    const std::string found = m_sink.findBeside(std::string(word));
    if (found.empty()) {
      m_isFileMissing = true;
      m_sink.builder().addWarning("the material file '" + std::string(word) + "' is missing: its colours are, too");
    } else {
      addFile(found);
    }
  }
}

void ObjMaterials::addFile(const std::string &file)
{
  try {
    for (const std::string &warning : MtlReader(file, m_materials).read()) {
      m_sink.builder().addWarning(warning);
    }
  } catch (const vpException &e) {
    m_isFileMissing = true;
    m_sink.builder().addWarning("the material file '" + file +
                                "' cannot be read, its colours are missing: " + e.getMessage());
  }
}

const MtlMaterial &ObjMaterials::at(int index)
{
  static const MtlMaterial plain;
  if (index < 0) {
    return plain;
  }
  const auto i = static_cast<std::size_t>(index);
  m_found.resize(m_names.size());
  if (!m_found[i]) {
    m_found[i] = find(m_names[i]);
  }
  return *m_found[i];
}

MtlMaterial ObjMaterials::find(const std::string &name)
{
  const auto found = m_materials.find(name);
  if (found == m_materials.end()) {
    if (!m_isFileMissing) {
      m_sink.builder().addWarning("the material '" + name + "' is in none of the material files of '" + m_sink.file() +
                                  "'");
    }
    return MtlMaterial();
  }
  if (!found->second.color && found->second.image.empty()) {
    m_sink.builder().addWarning("the material '" + name + "' of '" + m_sink.file() +
                                "' has neither a colour (Kd) nor an image (map_Kd)");
  }
  return found->second;
}
} // namespace vpMeshDetail
END_VISP_NAMESPACE
