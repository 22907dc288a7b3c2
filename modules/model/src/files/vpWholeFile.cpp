// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/model/vpWholeFile.h>

#include <visp3/core/vpException.h>

#include <random>
#include <sstream>

#ifdef __unix__
#include <fcntl.h>
#include <unistd.h>
#endif

BEGIN_VISP_NAMESPACE

namespace {
namespace fs = std::filesystem;

// Nothing can be put in the place of a device or a pipe, or of a link to what is not there.
bool isReplaceable(const fs::path &file)
{
  std::error_code ignored;
  const fs::file_status status = fs::status(file, ignored);
  return fs::is_regular_file(status) || (!fs::exists(status) && !fs::is_symlink(fs::symlink_status(file, ignored)));
}

// Another program may write the same file just now.
fs::path besideOf(const fs::path &target)
{
  std::ostringstream name;
  name << target.string() << '.' << std::hex << std::random_device()() << ".part";
  return name.str();
}

// Without it the name may reach the disk before the content does.
bool bringToDisk(const fs::path &file)
{
#ifdef __unix__
  const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
  const bool isThere = descriptor >= 0 && ::fsync(descriptor) == 0;
  return (descriptor < 0 || ::close(descriptor) == 0) && isThere;
#else
  static_cast<void>(file);
  return true;
#endif
}
} // namespace

vpWholeFile::vpWholeFile(const std::string &file) : m_file(file), m_target(file)
{
  std::error_code error;
  const bool isThere = fs::is_regular_file(m_target, error);
  if (isThere) {
    // To put another file in its place would need no right to write to it.
    if (!std::ofstream(m_target, std::ios::binary | std::ios::app)) {
      refuse();
    }
    m_target = fs::canonical(m_target);
  }
  m_path = isReplaceable(m_target) ? besideOf(m_target) : m_target;
  m_stream.open(m_path, std::ios::binary);
  m_isOpen = m_stream.is_open();
  if (!m_isOpen) {
    refuse();
  }
  if (isThere) {
    fs::permissions(m_path, fs::status(m_target, error).permissions(), error); // Who could read it still can.
  }
}

vpWholeFile::~vpWholeFile()
{
  drop();
}

void vpWholeFile::close()
{
  m_stream.close();
  std::error_code error;
  if (!m_stream || (!isInPlace() && !bringToDisk(m_path))) {
    refuse();
  }
  if (!isInPlace()) {
    fs::rename(m_path, m_target, error);
  }
  if (error) {
    refuse();
  }
  m_isOpen = false;
}

void vpWholeFile::write(const std::string &file, const std::string &content)
{
  vpWholeFile whole(file);
  whole.stream() << content;
  whole.close();
}

void vpWholeFile::refuse()
{
  drop();
  throw vpException(
      vpException::ioError,
      "'%s' cannot be written: check that its folder is there and may be written to, and that the disk is "
      "not full",
      m_file.c_str());
}

void vpWholeFile::drop() noexcept
{
  if (m_isOpen && !isInPlace()) {
    m_stream.close();
    std::error_code ignored;
    fs::remove(m_path, ignored);
  }
  m_isOpen = false;
}

END_VISP_NAMESPACE
