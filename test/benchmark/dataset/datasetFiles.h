// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef benchDatasetFiles_h
#define benchDatasetFiles_h

#include <filesystem>
#include <map>
#include <string>
#include <vector>

/*!
  \file datasetFiles.h
  Folders and numbered files, with errors that say which one it is about.
*/

namespace bench {

//! \throw vpException with \e text.
[[noreturn]] void fail(const std::string &text);

//! A path between quotation marks, for messages.
std::string inQuotes(const std::filesystem::path &path);

//! The first names of a list, for messages. \param most How many are told at most.
std::string listed(const std::vector<std::string> &names, std::size_t most = 10);

//! Paths in a folder, sorted by name. \throw vpException naming the folder where it cannot be read.
std::vector<std::filesystem::path> entriesOf(const std::filesystem::path &folder);

//! \throw vpException naming the file where it is missing, with \e hint: what to do about it.
void requireFile(const std::filesystem::path &file, const std::string &hint = "");

//! \return The number that a text of digits alone stands for, up to nine of them; -1 for any other text.
int numberOf(const std::string &text);

//! Number and path of a folder's images, whose names are numbers (000012.png); of two types of one image one is taken.
std::map<int, std::filesystem::path> numberedImages(const std::filesystem::path &folder);

/*!
  \param pattern A path with one conversion of printf for a whole number: image-%04d.png.
  \throw vpException naming the pattern where it has another conversion, or none, or several.
*/
std::string numberedPath(const std::string &pattern, int number);

//! All numbers of a line or file. \param place Where they are from, for messages.
//! \throw vpException where there is anything but finite numbers.
std::vector<double> parseNumbers(const std::string &text, const std::string &place);

//! What stands in a text file. \throw vpException naming the file where it cannot be read.
std::string readText(const std::filesystem::path &file);

} // namespace bench
#endif
