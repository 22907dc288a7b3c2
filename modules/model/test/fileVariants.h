// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef fileVariants_h
#define fileVariants_h

#include <visp3/core/vpException.h>
#include <visp3/model/vpTrackedModel.h>

#include "memoryLimit.h"

#include <processorTime.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <functional>
#include <locale>
#include <sstream>
#include <string>
#include <vector>

/*!
  \file fileVariants.h
  Makes broken files of a good one, and looks what becomes of them: a file is read rightly, with a warning, or refused
  by name.
*/

BEGIN_VISP_NAMESPACE
namespace fileVariants {
//! A changed file and how it was changed.
struct Variant
{
  std::string what;
  std::string content;
  bool sameNumbers = true; //!< False where a number became another one, which no reader can notice.
};

//! The file without its end, at every tenth byte.
inline std::vector<Variant> cuts(const std::string &content)
{
  std::vector<Variant> variants;
  for (std::size_t length = 0; length < content.size(); length += 10) {
    variants.push_back({"cut to " + std::to_string(length) + " bytes", content.substr(0, length)});
  }
  return variants;
}

//! The same of a list of numbers that nothing follows: that its last one has lost digits cannot be seen.
inline std::vector<Variant> cutsOfNumbers(const std::string &content)
{
  std::vector<Variant> variants = cuts(content);
  for (Variant &variant : variants) {
    const std::size_t length = variant.content.size();
    variant.sameNumbers = length == 0 || std::isspace(static_cast<unsigned char>(content[length])) != 0 ||
                          std::isspace(static_cast<unsigned char>(content[length - 1])) != 0;
  }
  return variants;
}

//! All of several lists.
inline std::vector<Variant> together(const std::vector<std::vector<Variant>> &lists)
{
  std::vector<Variant> all;
  for (const std::vector<Variant> &list : lists) {
    all.insert(all.end(), list.begin(), list.end());
  }
  return all;
}

//! Every word in turn left out, doubled, or replaced. \param stride Take every so many words only.
inline std::vector<Variant> tokenEdits(const std::string &content, std::size_t stride = 1)
{
  const char *const blanks = " \t\r\n,";
  std::vector<Variant> variants;
  std::size_t number = 0;
  for (std::size_t start = content.find_first_not_of(blanks); start != std::string::npos; ++number) {
    const std::size_t end = std::min(content.find_first_of(blanks, start), content.size());
    const std::string word = content.substr(start, end - start);
    const auto with = [&](const std::string &text) { return content.substr(0, start) + text + content.substr(end); };
    if (number % stride == 0) {
      const std::string place = "word " + std::to_string(number) + " '" + word.substr(0, 30) + "' ";
      variants.push_back({place + "left out", with("")});
      variants.push_back({place + "twice", with(word + " " + word)});
      variants.push_back({place + "garbage", with("?!")});
      variants.push_back({place + "with comma", with("0,5")});
      for (const char *other : {"-1", "0", "3", "99999999", "4294967296", "1e300", "nan"}) {
        variants.push_back({place + "now " + other, with(other), false});
      }
    }
    start = content.find_first_not_of(blanks, end);
  }
  return variants;
}

//! One to three bytes changed, at places that are drawn.
inline std::vector<Variant> byteFlips(const std::string &content, int count)
{
  std::vector<Variant> variants;
  std::uint32_t state = 1;
  const auto draw = [&state](std::size_t below) {
    state = state * 1664525U + 1013904223U;
    return static_cast<std::size_t>(state >> 8U) % below;
  };
  for (int i = 0; i < count; ++i) {
    Variant variant = {"flip " + std::to_string(i), content, false};
    for (std::size_t left = 1 + draw(3); left > 0; --left) {
      const std::size_t at = draw(content.size());
      variant.content[at] = static_cast<char>(draw(256));
      variant.what += ", byte " + std::to_string(at);
    }
    variants.push_back(std::move(variant));
  }
  return variants;
}

//! The same characters in UTF-16. \param mark With the mark that tells so.
inline std::string utf16(const std::string &ascii, bool bigEndian, bool mark)
{
  std::string result;
  const auto add = [&](char high, char low) { (result += bigEndian ? high : low) += bigEndian ? low : high; };
  if (mark) {
    add('\xFE', '\xFF');
  }
  for (const char c : ascii) {
    add('\0', c);
  }
  return result;
}

//! The same text as editors and other systems save it.
inline std::vector<Variant> encodings(const std::string &content)
{
  const auto withEnds = [&content](const std::string &end) {
    std::string result;
    for (const char c : content) {
      result += c == '\n' ? end : std::string(1, c);
    }
    return result;
  };
  return {{"ends of Windows", withEnds("\r\n")},
          {"ends of old Macs", withEnds("\r")},
          {"byte order mark", "\xEF\xBB\xBF" + content},
          {"byte order mark, ends of Windows", "\xEF\xBB\xBF" + withEnds("\r\n")},
          {"UTF-16, little endian, mark", utf16(content, false, true)},
          {"UTF-16, big endian, mark", utf16(content, true, true)},
          {"UTF-16, little endian", utf16(content, false, false)},
          {"UTF-16, big endian", utf16(content, true, false)}};
}

//! What one can tell of a model without knowing it.
inline std::string shapeOf(const vpTrackedModel &model)
{
  const vpModelReport &report = model.report();
  double area = 0.;
  for (const vpModelTriangle &triangle : model.triangles()) {
    const auto at = [&](std::size_t k) { return model.vertices()[static_cast<std::size_t>(triangle.vertex[k])]; };
    area += 0.5 * (at(1) - at(0)).cross(at(2) - at(0)).norm();
  }
  Eigen::Vector3f color = Eigen::Vector3f::Zero();
  for (const auto &corners : model.appearance().color) {
    color += corners[0] + corners[1] + corners[2];
  }
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(5);
  text << report.size.transpose() << " m, centre " << report.centreOffset.transpose() << ", " << report.triangles
       << " triangles, " << report.edges << " edges, " << report.cylinders << " cylinders, " << report.circles
       << " circles, " << area << " m2, " << model.appearance().color.size() << " colours of sum " << color.transpose()
       << ", " << model.appearance().images.size() << " images";
  return text.str();
}

inline bool warns(const vpTrackedModel &model)
{
  std::ostringstream text;
  text << model.report();
  return text.str().find("warning:") != std::string::npos;
}

//! What came out of a file.
struct Outcome
{
  std::string what;   //!< The same text for the same meaning.
  bool warns = false; //!< Whether the user is told that something may be wrong.
};

/*!
  \param name Part of the file's name, which a refusal has to say.
  \param right What comes out of the good file.
  \param read Reads the variant.
  \return What is wrong with the way a variant was taken; empty where it was taken well.
*/
inline std::string fault(const Variant &variant, const std::string &name, const std::string &right,
                         const std::function<Outcome(const std::string &)> &read)
{
  const double start = processorTime();
  std::string result;
  try {
    const Outcome outcome = read(variant.content);
    if (variant.sameNumbers && outcome.what != right && !outcome.warns) {
      result = "read without a word as " + outcome.what;
    }
  } catch (const vpException &e) {
    const std::string message = e.getMessage();
    result = message.find(name) == std::string::npos ? "refused without its name: " + message : "";
  } catch (const std::exception &e) {
    result = std::string("another exception: ") + e.what();
  }
  if (processorTime() - start > 5.) {
    result += " after more than 5 s";
  }
  return result.empty() ? "" : variant.what + ": " + result + "\n";
}

//! The faults of all variants, one a line, with no more than 1 GB of memory for each.
inline std::string faults(const std::vector<Variant> &variants, const std::string &name, const std::string &right,
                          const std::function<Outcome(const std::string &)> &read)
{
  const MemoryLimit limit(std::size_t(1) << 30U);
  std::string all;
  for (const Variant &variant : variants) {
    all += fault(variant, name, right, read);
  }
  return all;
}

//! What came out of a file of a model.
inline Outcome outcomeOf(const vpTrackedModel &model)
{
  return {shapeOf(model), warns(model)};
}

//! A locale with 1.234,5 for 1234.5, in streams that are made while it lives; none has to be installed for it.
class CommaLocale
{
public:
  CommaLocale() : m_before(std::locale::global(std::locale(std::locale::classic(), new Punctuation))) {}
  ~CommaLocale() { std::locale::global(m_before); }
  CommaLocale(const CommaLocale &) = delete;
  CommaLocale &operator=(const CommaLocale &) = delete;
  //! True where it is the global one still.
  static bool isGlobal() { return std::use_facet<std::numpunct<char>>(std::locale()).decimal_point() == ','; }

private:
  class Punctuation : public std::numpunct<char>
  {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
  };

  std::locale m_before;
};
} // namespace fileVariants
END_VISP_NAMESPACE
#endif
