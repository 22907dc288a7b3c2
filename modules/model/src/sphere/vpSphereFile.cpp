// SPDX-License-Identifier: GPL-2.0-or-later
#include "sphere/vpSphereFile.h"

#include "sphere/vpFingerprint.h"

#include <visp3/core/vpException.h>
#include <visp3/model/vpWholeFile.h>

#include <cstring>
#include <fstream>
#include <sstream>
#include <utility>

BEGIN_VISP_NAMESPACE

namespace {
// The number is that of the version: another one where the file's layout changes, or what the same view shows.
const std::string title = "vpViewSphere 1\n";

std::uint64_t checksum(const std::string &content, std::size_t bytes)
{
  vpFingerprint print;
  print.addBytes(content.data(), bytes);
  return print.value();
}

template <typename T> void append(std::string &content, const T *values, std::size_t count)
{
  content.append(reinterpret_cast<const char *>(values), count * sizeof(T));
}

void append32(std::string &content, std::size_t value)
{
  const std::uint32_t number = static_cast<std::uint32_t>(value);
  append(content, &number, 1);
}
} // namespace

// Goes through the content of a file and never beyond its end.
class vpSphereFile::Reader
{
public:
  Reader(const vpSphereFile &file, const std::string &content, std::size_t end)
      : m_file(file), m_content(content), m_end(end)
  {
  }

  template <typename T> void take(T *values, std::size_t count)
  {
    if (m_at > m_end || count > (m_end - m_at) / sizeof(T)) {
      m_file.refuse("is damaged: delete it and save the views again");
    }
    if (count > 0) {
      std::memcpy(values, m_content.data() + m_at, count * sizeof(T));
      m_at += count * sizeof(T);
    }
  }
  template <typename T> T take()
  {
    T value;
    take(&value, 1);
    return value;
  }
  bool isAtEnd() const { return m_at == m_end; }

private:
  const vpSphereFile &m_file;
  const std::string &m_content;
  std::size_t m_end;
  std::size_t m_at = title.size();
};

void vpSphereFile::refuse(const std::string &reason) const
{
  throw vpException(vpException::ioError, "The file '%s' of a view sphere %s", m_name.c_str(), reason.c_str());
}

void vpSphereFile::write(const std::vector<vpSphereView> &views, const std::vector<char> &isMade) const
{
  std::string content = title;
  append(content, &m_fingerprint, 1);
  for (std::size_t i = 0; i < views.size(); ++i) {
    if (isMade[i]) {
      append32(content, i);
      append32(content, views[i].m_size);
      append32(content, views[i].m_silhouettes);
      append(content, views[i].m_values.data(), views[i].m_values.size());
    }
  }
  const std::uint64_t sum = checksum(content, content.size());
  append(content, &sum, 1);
  vpWholeFile::write(m_name, content);
}

// Unlike the iterators of a stream's buffer, the operator throws nothing of its own where the file is a folder.
std::string vpSphereFile::content() const
{
  const std::ifstream stream(m_name, std::ios::binary);
  std::ostringstream content;
  if (!stream || !(content << stream.rdbuf())) {
    refuse("cannot be read, or is empty: check that it is there and may be read");
  }
  return content.str();
}

vpSphereFile::Entry vpSphereFile::readView(Reader &reader, std::size_t most) const
{
  Entry entry;
  entry.place = reader.take<std::uint32_t>();
  entry.view.m_size = reader.take<std::uint32_t>();
  entry.view.m_silhouettes = reader.take<std::uint32_t>();
  if (entry.view.m_size > most || entry.view.m_silhouettes > entry.view.m_size) {
    refuse("has a view with more points than there can be: delete it and save the views again");
  }
  entry.view.m_values.resize(vpSphereView::arrays * entry.view.m_size);
  reader.take(entry.view.m_values.data(), entry.view.m_values.size());
  return entry;
}

void vpSphereFile::read(std::size_t most, std::vector<vpSphereView> &views, std::vector<char> &isMade) const
{
  const std::string bytes = content();
  if (bytes.compare(0, title.size(), title) != 0) {
    refuse("is none, or of another version: delete it and save the views again");
  }
  std::uint64_t sum = 0;
  if (bytes.size() < title.size() + 2 * sizeof(sum)) {
    refuse("is damaged: delete it and save the views again");
  }
  const std::size_t end = bytes.size() - sizeof(sum);
  std::memcpy(&sum, bytes.data() + end, sizeof(sum));
  Reader reader(*this, bytes, end);
  const std::uint64_t fingerprint = reader.take<std::uint64_t>();
  if (sum != checksum(bytes, end)) {
    refuse("is damaged: delete it and save the views again");
  }
  if (fingerprint != m_fingerprint) {
    refuse("is of another model or other options: save the views of this one to a file of its own");
  }
  std::vector<Entry> entries;
  while (!reader.isAtEnd()) {
    entries.push_back(readView(reader, most));
    if (entries.back().place >= views.size()) {
      refuse("has a view in a direction that the sphere does not have: delete it and save the views again");
    }
  }
  for (Entry &entry : entries) {
    if (!isMade[entry.place]) {
      views[entry.place] = std::move(entry.view);
      isMade[entry.place] = 1;
    }
  }
}

END_VISP_NAMESPACE
