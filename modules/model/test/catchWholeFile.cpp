// SPDX-License-Identifier: GPL-2.0-or-later
#include <catchMain.h>
#include <exceptionMessage.h>

#include "meshFiles.h"

#include "diskLimit.h"

#include <visp3/core/vpException.h>
#include <visp3/model/vpWholeFile.h>

#include <iterator>

#ifdef __unix__
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>
#endif

namespace {
namespace fs = std::filesystem;

std::string textOf(const std::string &file)
{
  std::ifstream stream(file, std::ios::binary);
  return std::string((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
}

std::size_t filesIn(const std::string &folder)
{
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), {}));
}

const std::string longText(100000, 'x'); // More than a stream keeps before it writes.
} // namespace

TEST_CASE("A file is replaced as a whole, and nothing else is left beside it", "[file]")
{
  const meshFiles::TemporaryFolder folder;
  const std::string file = folder.path("file");
  for (const std::string &text : {std::string("first"), longText, std::string("a\r\n\0b", 5), std::string()}) {
    vpWholeFile::write(file, text);
    CHECK(textOf(file) == text);
  }
  vpWholeFile parts(file);
  parts.stream() << "two " << 2;
  CHECK(textOf(file).empty());
  parts.close();
  CHECK(textOf(file) == "two 2");
  CHECK(filesIn(folder.path("")) == 1);
}

TEST_CASE("What is not closed was not written", "[file]")
{
  const meshFiles::TemporaryFolder folder;
  const std::string file = folder.write("file", "old");
  {
    vpWholeFile given(file);
    given.stream() << longText;
  }
  CHECK(textOf(file) == "old");
  CHECK(filesIn(folder.path("")) == 1);
}

TEST_CASE("Where the disk is full the file is named, and the old one stays", "[file]")
{
  const meshFiles::TemporaryFolder folder;
  const std::string file = folder.write("file", "old");
  for (const std::size_t bytes : {std::size_t{100}, longText.size()}) { // Found out at the end, and in between.
    const DiskLimit limit(bytes - 1);
    if (!limit.isSet) {
      WARN("Left out: no limit of the size of files");
      return;
    }
    CHECK_THAT(messageOf([&] { vpWholeFile::write(file, longText.substr(0, bytes)); }), ContainsSubstring(file));
  }
  CHECK(textOf(file) == "old");
  CHECK(filesIn(folder.path("")) == 1);
}

TEST_CASE("A file in a folder that is not there is named, and so is a folder", "[file]")
{
  const meshFiles::TemporaryFolder folder;
  CHECK_THAT(messageOf([&] { vpWholeFile::write(folder.path("none/file"), "x"); }), ContainsSubstring("none/file"));
  fs::create_directory(folder.path("folder"));
  CHECK_THAT(messageOf([&] { vpWholeFile::write(folder.path("folder"), "x"); }), ContainsSubstring("folder"));
  CHECK(filesIn(folder.path("")) == 1);
}

#ifdef __unix__
TEST_CASE("Where the program is ended while it writes, the old file stays", "[file]")
{
  const meshFiles::TemporaryFolder folder;
  const std::string file = folder.write("file", "old");
  const pid_t child = fork();
  if (child == 0) {
    const DiskLimit limit(longText.size() / 2);
    std::signal(SIGXFSZ, SIG_DFL); // The system ends what writes beyond its limit.
    vpWholeFile::write(file, longText);
    _exit(0);
  }
  int status = 0;
  REQUIRE(waitpid(child, &status, 0) == child);
  REQUIRE(WIFSIGNALED(status));
  CHECK(textOf(file) == "old");
}

TEST_CASE("A link stays one, and the rights of the old file are those of the new one", "[file]")
{
  const meshFiles::TemporaryFolder folder;
  const std::string file = folder.write("file", "old");
  fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write);
  fs::create_symlink("file", folder.path("link")); // As seen from the folder.
  vpWholeFile::write(folder.path("link"), "new");
  CHECK(fs::is_symlink(folder.path("link")));
  CHECK(textOf(file) == "new");
  CHECK(fs::status(file).permissions() == (fs::perms::owner_read | fs::perms::owner_write));

  fs::create_symlink("later", folder.path("early"));
  vpWholeFile::write(folder.path("early"), "new");
  CHECK(fs::is_symlink(folder.path("early")));
  CHECK(textOf(folder.path("later")) == "new");
}

TEST_CASE("A file that may not be written to is refused", "[file]")
{
  if (geteuid() == 0) {
    WARN("Left out: root may write to any file");
    return;
  }
  const meshFiles::TemporaryFolder folder;
  const std::string file = folder.write("file", "old");
  fs::permissions(file, fs::perms::owner_read);
  CHECK_THAT(messageOf([&] { vpWholeFile::write(file, "new"); }), ContainsSubstring(file));
  CHECK(textOf(file) == "old");
}

TEST_CASE("A pipe gets what is written, and stays", "[file]")
{
  const meshFiles::TemporaryFolder folder;
  const std::string pipe = folder.path("pipe");
  REQUIRE(mkfifo(pipe.c_str(), 0600) == 0);
  const pid_t child = fork();
  if (child == 0) {
    _exit(textOf(pipe) == longText ? 0 : 1);
  }
  vpWholeFile::write(pipe, longText);
  int status = 1;
  REQUIRE(waitpid(child, &status, 0) == child);
  CHECK(status == 0);
  CHECK(fs::is_fifo(pipe));
}
#endif
