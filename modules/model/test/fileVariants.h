// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef fileVariants_h
#define fileVariants_h

#include <visp3/core/vpException.h>
#include <visp3/model/vpTrackedModel.h>

#include <algorithm>
#include <chrono>
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

//! What one can tell of a model without knowing it.
inline std::string shapeOf(const vpTrackedModel &model)
{
  const vpModelReport &report = model.report();
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(5);
  text << report.size.transpose() << " m, centre " << report.centreOffset.transpose() << ", " << report.triangles
       << " triangles, " << report.edges << " edges, " << report.cylinders << " cylinders, " << report.circles
       << " circles, " << model.appearance().color.size() << " colours";
  return text.str();
}

inline bool warns(const vpTrackedModel &model)
{
  std::ostringstream text;
  text << model.report();
  return text.str().find("warning:") != std::string::npos;
}

//! \return What is wrong with the way a variant was taken; empty where it was taken well.
inline std::string fault(const Variant &variant, const std::string &name, const std::string &right,
                         const std::function<vpTrackedModel(const std::string &)> &read)
{
  const auto start = std::chrono::steady_clock::now();
  std::string result;
  try {
    const vpTrackedModel model = read(variant.content);
    if (variant.sameNumbers && shapeOf(model) != right && !warns(model)) {
      result = "read without a word as " + shapeOf(model);
    }
  } catch (const vpException &e) {
    const std::string message = e.getMessage();
    result = message.find(name) == std::string::npos ? "refused without its name: " + message : "";
  } catch (const std::exception &e) {
    result = std::string("another exception: ") + e.what();
  }
  if (std::chrono::steady_clock::now() - start > std::chrono::seconds(5)) {
    result += " after more than 5 s";
  }
  return result.empty() ? "" : variant.what + ": " + result;
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
