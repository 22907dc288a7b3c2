// SPDX-License-Identifier: GPL-2.0-or-later
#include "dataset/datasetFiles.h"

#include "frames/filePattern.h"

#include <visp3/core/vpException.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <locale>
#include <sstream>

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

namespace fs = std::filesystem;

namespace bench {
namespace {
// Of two files for one image, the type that stands first here is taken.
const std::array<const char *, 5> imageTypes = {{".png", ".tif", ".tiff", ".jpg", ".jpeg"}};

std::size_t typeRank(const fs::path &file)
{
  std::string type = file.extension().string();
  std::transform(type.begin(), type.end(), type.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  const auto *found = std::find(imageTypes.begin(), imageTypes.end(), type);
  return static_cast<std::size_t>(found - imageTypes.begin());
}
} // namespace

void fail(const std::string &text)
{
  throw vpException(vpException::ioError, text);
}

std::string inQuotes(const fs::path &path)
{
  return "'" + path.string() + "'";
}

std::string listed(const std::vector<std::string> &names, std::size_t most)
{
  std::string text;
  for (std::size_t i = 0; i < std::min(most, names.size()); ++i) {
    text += (i == 0 ? "" : ", ") + names[i];
  }
  return names.empty() ? "none" : names.size() > most ? text + ", ..." : text;
}

std::vector<fs::path> entriesOf(const fs::path &folder)
{
  std::error_code error;
  std::vector<fs::path> entries;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    entries.push_back(entry->path());
  }
  if (error) {
    fail("The folder " + inQuotes(folder) + " cannot be read: " + error.message());
  }
  std::sort(entries.begin(), entries.end());
  return entries;
}

void requireFile(const fs::path &file, const std::string &hint)
{
  std::error_code ignored;
  if (!fs::is_regular_file(file, ignored)) {
    fail("The file " + inQuotes(file) + " is missing" + (hint.empty() ? "" : ": " + hint));
  }
}

int numberOf(const std::string &text)
{
  if (text.empty() || text.size() > 9 || text.find_first_not_of("0123456789") != std::string::npos) {
    return -1;
  }
  int number = 0;
  for (const char digit : text) {
    number = 10 * number + (digit - '0');
  }
  return number;
}

std::map<int, fs::path> numberedImages(const fs::path &folder)
{
  std::map<int, fs::path> images;
  for (const fs::path &file : entriesOf(folder)) {
    const int number = numberOf(file.stem().string());
    const std::size_t rank = typeRank(file);
    if (number < 0 || rank == imageTypes.size()) {
      continue;
    }
    const auto known = images.find(number);
    if (known == images.end() || rank < typeRank(known->second)) {
      images[number] = file;
    }
  }
  return images;
}

std::string numberedPath(const std::string &pattern, int number)
{
  return programs::FilePattern(pattern).name(number);
}

std::vector<double> parseNumbers(const std::string &text, const std::string &place)
{
  std::istringstream words(text);
  std::vector<double> numbers;
  for (std::string word; words >> word;) {
    std::istringstream stream(word);
    stream.imbue(std::locale::classic());
    double number = 0.;
    char rest = 0;
    if (!(stream >> number) || stream >> rest || !std::isfinite(number)) {
      fail(place + ": '" + word + "' is no finite number");
    }
    numbers.push_back(number);
  }
  return numbers;
}

std::string readText(const fs::path &file)
{
  requireFile(file);
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  if (!stream) {
    fail("The file " + inQuotes(file) + " cannot be read");
  }
  const std::string mark = "\xEF\xBB\xBF"; // Of UTF-8, which some editors put before a text.
  const std::string content = text.str();
  return content.compare(0, mark.size(), mark) == 0 ? content.substr(mark.size()) : content;
}

} // namespace bench
