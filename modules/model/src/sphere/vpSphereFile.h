// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpSphereFile_h
#define vpSphereFile_h

#include <visp3/model/vpSphereView.h>

#include <cstdint>
#include <string>

BEGIN_VISP_NAMESPACE

/*!
  Views in a file: what it is with a version, a fingerprint of what they are of, the views that are made (number,
  points, silhouettes, arrays), and a checksum. Numbers are as this machine has them; the file of one with another order
  of bytes has another fingerprint.
*/
class vpSphereFile
{
public:
  vpSphereFile(const std::string &name, std::uint64_t fingerprint) : m_name(name), m_fingerprint(fingerprint) {}

  //! \throw vpException that names the file.
  void write(const std::vector<vpSphereView> &views, const std::vector<char> &isMade) const;
  //! Adds the views that are not made yet. Changes nothing where it throws.
  //! \param most Most points of a view.
  //! \throw vpException that names the file.
  void read(std::size_t most, std::vector<vpSphereView> &views, std::vector<char> &isMade) const;

private:
  // A view with its place in the sphere.
  struct Entry
  {
    std::uint32_t place = 0;
    vpSphereView view;
  };
  class Reader;

  [[noreturn]] void refuse(const std::string &reason) const;
  std::string content() const;
  Entry readView(Reader &reader, std::size_t most) const;

  std::string m_name;
  std::uint64_t m_fingerprint;
};

END_VISP_NAMESPACE
#endif
