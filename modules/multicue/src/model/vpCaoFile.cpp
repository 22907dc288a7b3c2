// SPDX-License-Identifier: GPL-2.0-or-later
#include "model/vpCaoFile.h"

#include "model/vpCaoLines.h"
#include "model/vpCaoParameters.h"

#include <visp3/core/vpException.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <system_error>
#include <utility>

BEGIN_VISP_NAMESPACE

namespace {
// Each takes 6.3 KB with what vpMbTracker keeps of it, and all of them are to stay below 1 GB.
constexpr std::size_t mostShapes = 150000;
constexpr std::size_t mostFiles = 10000;
constexpr std::size_t deepestLoad = 32;

// One file; the ones that it loads are read by more of these.
class CaoReader
{
public:
  CaoReader(vpCaoFile &result, std::size_t &files, const std::string &file, const vpHomogeneousMatrix &oMf,
            const std::vector<std::string> &parents)
      : m_result(result), m_files(files), m_file(file), m_oMf(oMf), m_parents(parents), m_lines(file)
  {
    m_parents.push_back(file);
  }

  void read()
  {
    readVersion();
    const bool loads = readLoads();
    if (loads && m_lines.atEnd()) {
      return; // A file may consist of nothing but its parts.
    }
    readPoints(loads);
    readSegments();
    readFacesOfSegments();
    addFreeSegments();
    readFaces();
    if (endsBefore("sections of cylinders and circles")) { // As files of the first versions do.
      return;
    }
    readCylinders();
    if (endsBefore("section of circles")) {
      return;
    }
    readCircles();
    if (m_lines.mayBeCut()) {
      warn("has no line end after its last circle");
    }
    if (!m_lines.atEnd() && vpLineWords(m_lines.ahead()).numberIsNext()) {
      m_lines.next("");
      m_lines.refuse("numbers follow the last section: is a count before too small?");
    }
  }

private:
  void warn(const std::string &what) { m_result.warnings.push_back("'" + m_file + "' " + what + ": is it whole?"); }

  bool endsBefore(const std::string &sections)
  {
    if (m_lines.atEnd()) {
      warn("ends before its " + sections);
    }
    return m_lines.atEnd();
  }

  void readVersion()
  {
    const std::string &line = m_lines.next("the version (V1)");
    vpLineWords words(line);
    std::size_t version = 0;
    if (!words.takeVersion(version)) {
      m_lines.refuse("'" + line.substr(0, 20) + "' is no version: a .cao file starts with V1");
    }
    m_hasPixels = version == 2;
  }

  bool readLoads()
  {
    bool any = false;
    while (!m_lines.atEnd() && (m_lines.ahead().front() == 'l' || m_lines.ahead().front() == 'L')) {
      const std::string &line = m_lines.next("");
      any = true;
      vpCaoLoad load;
      try {
        load = vpCaoLoad::parse(line, m_file);
      } catch (const vpException &e) {
        m_lines.refuse(e.getMessage());
      }
      readPart(load);
    }
    return any;
  }

  void readPart(const vpCaoLoad &load)
  {
    const auto same = [&](const std::string &parent) {
      std::error_code ignored;
      return std::filesystem::equivalent(parent, load.file, ignored);
    };
    if (std::any_of(m_parents.begin(), m_parents.end(), same)) {
      m_lines.refuse("'" + load.file + "' loads itself: take out the load() that leads back to it");
    }
    if (m_parents.size() >= deepestLoad || ++m_files > mostFiles) {
      m_lines.refuse("the files load each other more than " + std::to_string(deepestLoad) + " deep, or more than " +
                     std::to_string(mostFiles) + " times in all");
    }
    try {
      CaoReader(m_result, m_files, load.file, m_oMf * load.pose, m_parents).read();
    } catch (const vpException &e) {
      m_lines.refuse("in '" + load.file + "', " + e.getMessage());
    }
  }

  // What follows the numbers: parameters and words, but no more numbers.
  void finish(const vpLineWords &words, const std::string &element, vpCaoShape &shape) const
  {
    m_lines.requireNoMore(words, element);
    try {
      readCaoParameters(words.rest(), shape);
    } catch (const vpException &e) {
      m_lines.refuse(e.getMessage());
    }
  }

  void add(vpCaoShape &&shape)
  {
    if (m_result.shapes.size() >= mostShapes) {
      m_lines.refuse("there are more than " + std::to_string(mostShapes) + " shapes with those of the loaded files");
    }
    m_result.shapes.push_back(std::move(shape));
  }

  const vpPoint &takePoint(vpLineWords &words, const std::string &element) const
  {
    return m_points[m_lines.index(words, m_points.size(), "point", element)];
  }

  void readPoints(bool loads)
  {
    const std::size_t count = m_lines.count("points");
    if (count == 0 && !loads) {
      m_lines.refuse("there are no points");
    }
    for (std::size_t k = 0; k < count; ++k) {
      const std::string element = "point " + std::to_string(k);
      vpLineWords words(m_lines.next(element));
      vpColVector position(4, 1.);
      for (unsigned int i = 0; i < 3; ++i) {
        position[i] = m_lines.number(words, std::string(1, "xyz"[i]), element);
      }
      for (int i = 0; m_hasPixels && i < 2; ++i) {
        m_lines.number(words, "its pixel", element);
      }
      m_lines.requireNoMore(words, element);
      position = m_oMf * position;
      m_points.emplace_back(position[0], position[1], position[2]);
    }
  }

  void readSegments()
  {
    const std::size_t count = m_lines.count("lines");
    for (std::size_t k = 0; k < count; ++k) {
      const std::string element = "line " + std::to_string(k);
      vpLineWords words(m_lines.next(element));
      Segment segment;
      segment.ends.first = m_lines.index(words, m_points.size(), "point", element);
      segment.ends.second = m_lines.index(words, m_points.size(), "point", element);
      segment.shape.isLine = true;
      segment.shape.points = {m_points[segment.ends.first], m_points[segment.ends.second]};
      finish(words, element, segment.shape);
      m_segments.push_back(std::move(segment));
    }
  }

  void readFacesOfSegments()
  {
    const std::size_t count = m_lines.count("faces of lines");
    for (std::size_t k = 0; k < count; ++k) {
      const std::string element = "face " + std::to_string(k) + " of lines";
      vpLineWords words(m_lines.next(element));
      vpCaoShape shape;
      shape.kind = vpCaoShape::FACE_OF_LINES;
      for (std::size_t left = m_lines.size(words, "lines", element, 1); left > 0; --left) {
        const Segment &segment = m_segments[m_lines.index(words, m_segments.size(), "line", element)];
        shape.points.insert(shape.points.end(), segment.shape.points.begin(), segment.shape.points.end());
        m_used.insert(segment.ends);
      }
      finish(words, element, shape);
      add(std::move(shape));
    }
  }

  // Lines that no face has, in ViSP's order: by their points, of two with the same ones the last.
  void addFreeSegments()
  {
    std::map<Ends, vpCaoShape> free;
    for (Segment &segment : m_segments) {
      if (m_used.count(segment.ends) == 0) {
        free[segment.ends] = std::move(segment.shape);
      }
    }
    for (auto &segment : free) {
      add(std::move(segment.second));
    }
  }

  void readFaces()
  {
    const std::size_t count = m_lines.count("faces of points");
    for (std::size_t k = 0; k < count; ++k) {
      const std::string element = "face " + std::to_string(k);
      vpLineWords words(m_lines.next(element));
      vpCaoShape shape;
      for (std::size_t left = m_lines.size(words, "points", element, 2); left > 0; --left) {
        shape.points.push_back(takePoint(words, element));
      }
      finish(words, element, shape);
      add(std::move(shape));
    }
  }

  void readCylinders()
  {
    const std::size_t count = m_lines.count("cylinders");
    for (std::size_t k = 0; k < count; ++k) {
      const std::string element = "cylinder " + std::to_string(k);
      vpLineWords words(m_lines.next(element));
      vpCaoShape shape;
      shape.kind = vpCaoShape::CYLINDER;
      shape.points = {takePoint(words, element), takePoint(words, element)};
      shape.radius = m_lines.radius(words, element);
      finish(words, element, shape);
      add(std::move(shape));
    }
  }

  void readCircles()
  {
    const std::size_t count = m_lines.count("circles");
    for (std::size_t k = 0; k < count; ++k) {
      const std::string element = "circle " + std::to_string(k);
      vpLineWords words(m_lines.next(element));
      vpCaoShape shape;
      shape.kind = vpCaoShape::CIRCLE;
      shape.radius = m_lines.radius(words, element);
      shape.points = {takePoint(words, element), takePoint(words, element), takePoint(words, element)};
      finish(words, element, shape);
      add(std::move(shape));
    }
  }

  using Ends = std::pair<std::size_t, std::size_t>;
  struct Segment
  {
    Ends ends;
    vpCaoShape shape;
  };

  vpCaoFile &m_result;
  std::size_t &m_files; // Read so far, with those of other readers.
  std::string m_file;
  vpHomogeneousMatrix m_oMf;
  std::vector<std::string> m_parents;
  vpCaoLines m_lines;
  bool m_hasPixels = false;
  std::vector<vpPoint> m_points;
  std::vector<Segment> m_segments;
  std::set<Ends> m_used; // By faces of lines.
};
} // namespace

vpCaoFile vpCaoFile::read(const std::string &file, const vpHomogeneousMatrix &oMf)
{
  vpCaoFile result;
  std::size_t files = 1;
  CaoReader(result, files, file, oMf, {}).read();
  return result;
}

END_VISP_NAMESPACE
