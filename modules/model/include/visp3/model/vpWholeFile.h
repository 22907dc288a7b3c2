// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpWholeFile_h
#define vpWholeFile_h

#include <visp3/core/vpConfig.h>
#include <visp3/se3/vpCompatibility.h>

#include <filesystem>
#include <fstream>
#include <string>

BEGIN_VISP_NAMESPACE

/*!
  \ingroup group_model
  A file that is written whole or not at all: where the disk is full, or the program ends while it writes, the file that
  was there before is still there.

  What is written goes into a file beside it, which gets the name when close() has brought all of it to the disk. So the
  folder has to take another file. Where the name is that of a link, the file that it leads to is replaced; a device or
  a pipe is written to as it is. After a crash the rest is in "<name>.<number>.part".
*/
class VISP_EXPORT vpWholeFile
{
public:
  //! \throw vpException naming the file that cannot be written.
  explicit vpWholeFile(const std::string &file);
  //! Without close(), nothing was written.
  ~vpWholeFile();
  vpWholeFile(const vpWholeFile &) = delete;
  vpWholeFile &operator=(const vpWholeFile &) = delete;

  //! Takes what is to be in the file.
  std::ostream &stream() { return m_stream; }
  //! Puts the file in its place. \throw vpException naming the file that cannot be written; then the old one stays.
  void close();

  //! Writes a file that is known as a whole. \throw vpException naming the file that cannot be written.
  static void write(const std::string &file, const std::string &content);

private:
  [[noreturn]] void refuse();
  void drop() noexcept;
  bool isInPlace() const { return m_path == m_target; }

  std::string m_file;             // As it was named.
  std::filesystem::path m_target; // Behind all links.
  std::filesystem::path m_path;   // What is written to.
  std::ofstream m_stream;
  bool m_isOpen = false;
};

END_VISP_NAMESPACE
#endif
