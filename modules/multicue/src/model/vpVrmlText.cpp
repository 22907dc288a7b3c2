// SPDX-License-Identifier: GPL-2.0-or-later
#include "model/vpVrmlText.h"

#include "model/vpTextLines.h"

#include <visp3/core/vpException.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

BEGIN_VISP_NAMESPACE

namespace {
constexpr int deepestNesting = 200;
// Nodes that make Coin read other files.
const std::array<std::string_view, 3> includes = {{"File", "Inline", "WWWInline"}};

[[noreturn]] void refuse(const vpTextLine &line, const std::string &reason)
{
  throw vpException(vpException::badValue, "line " + std::to_string(line.number) + ": " + reason);
}

bool isNamePart(char c)
{
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

// Goes through the text outside of strings and comments.
class Scanner
{
public:
  void scan(const vpTextLine &line)
  {
    const std::string &text = line.text;
    for (std::size_t i = 0; i < text.size(); ++i) {
      if (m_quoted) {
        i += text[i] == '\\' ? 1U : 0U;
        m_quoted = i >= text.size() || text[i] != '"';
      } else if (text[i] == '"') {
        m_quoted = true;
      } else if (text[i] == '{' || text[i] == '[') {
        m_depth += 1;
        requireShallow(line);
      } else if (text[i] == '}' || text[i] == ']') {
        m_depth -= 1;
      } else if (isNamePart(text[i])) {
        const std::size_t start = i;
        i = static_cast<std::size_t>(
                std::find_if_not(text.begin() + static_cast<std::ptrdiff_t>(i), text.end(), isNamePart) -
                text.begin()) -
            1;
        checkName(line, std::string_view(text).substr(start, i + 1 - start));
      }
    }
  }

private:
  void requireShallow(const vpTextLine &line) const
  {
    if (m_depth > deepestNesting) {
      refuse(line, "nodes are nested more than " + std::to_string(deepestNesting) +
                       " deep: is a closing bracket missing? Give the shapes less groups");
    }
  }

  static void checkName(const vpTextLine &line, std::string_view name)
  {
    if (std::find(includes.begin(), includes.end(), name) != includes.end()) {
      refuse(line,
             "the node " + std::string(name) + " is not followed to another file: export the model as a single file");
    }
  }

  int m_depth = 0;
  bool m_quoted = false;
};
} // namespace

void requireHarmlessVrml(const std::string &modelFile)
{
  const std::string first = firstBytes(modelFile, 64);
  if (first.compare(0, 2, "\x1F\x8B") == 0) {
    throw vpException(vpException::badValue, "it is compressed: unpack it (gunzip) first");
  }
  if (first.compare(0, 3, "\xEF\xBB\xBF") == 0) {
    throw vpException(vpException::badValue, "line 1: a byte order mark stands before #VRML: save it without one");
  }
  const std::string header = first.substr(0, first.find_first_of("\r\n"));
  if (header.compare(0, 5, "#VRML") != 0 && header.compare(0, 9, "#Inventor") != 0) {
    throw vpException(vpException::badValue, "it is no VRML file: it starts with neither #VRML V2.0 utf8 nor #VRML "
                                             "V1.0 ascii");
  }
  if (header.find("binary") != std::string::npos) {
    throw vpException(vpException::badValue, "it is a binary Inventor file: save it as text (VRML V2.0 utf8)");
  }
  Scanner scanner;
  for (const vpTextLine &line : vpTextLines::read(modelFile).lines) {
    scanner.scan(line);
  }
}

END_VISP_NAMESPACE
