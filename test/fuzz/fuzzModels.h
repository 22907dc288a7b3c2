// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef fuzzModels_h
#define fuzzModels_h

#include <meshFiles.h>

#include <string>
#include <vector>

namespace fuzz {
#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

//! Small models of all kinds, and of the odd ones: a face seen end-on, lines alone, points that coincide.
class Models
{
public:
  //! \return One of them, for any number.
  const std::string &file(unsigned int number) const { return files()[number % files().size()]; }

private:
  static const std::vector<std::string> &files()
  {
    static const std::vector<std::string> written = write();
    return written;
  }

  static std::vector<std::string> write()
  {
    static const meshFiles::TemporaryFolder folder;
    const modelShapes::Point size(0.12, 0.08, 0.06);
    std::vector<modelShapes::Triangle> step = modelShapes::boxTriangles(size);
    for (const auto &triangle :
         modelShapes::boxTriangles(modelShapes::Point(0.04, 0.08, 0.05), 1, modelShapes::Point(-0.04, 0., 0.055))) {
      step.push_back(triangle);
    }
    const std::string corners = "V1\n8\n-.06 -.04 -.03\n.06 -.04 -.03\n.06 .04 -.03\n-.06 .04 -.03\n"
                                "-.06 -.04 .03\n.06 -.04 .03\n.06 .04 .03\n-.06 .04 .03\n";
    return {folder.write("box.stl", meshFiles::asciiStl(modelShapes::boxTriangles(size))),
            folder.write("step.stl", meshFiles::asciiStl(step)),
            folder.write("ball.stl", meshFiles::asciiStl(modelShapes::sphereTriangles(0.06, 10, 20))),
            folder.write("can.stl", meshFiles::asciiStl(modelShapes::cylinderTriangles(0.04, 0.1, 24))),
            folder.write("box.cao",
                         corners + "0\n0\n6\n4 0 3 2 1\n4 4 5 6 7\n4 0 1 5 4\n4 2 3 7 6\n4 1 2 6 5\n4 0 4 7 3\n0\n0\n"),
            folder.write("face.cao", corners + "0\n0\n1\n4 0 1 2 3\n0\n0\n"),
            folder.write("lines.cao", corners + "3\n0 1\n1 2\n0 6\n0\n0\n0\n0\n"),
            folder.write("round.cao", corners + "0\n0\n0\n1\n0 6 0.03\n1\n0.05 0 1 2\n"),
            folder.write("same.cao", "V1\n4\n0 0 0\n0 0 0\n.1 0 0\n0 .1 0\n0\n0\n1\n4 0 1 2 3\n0\n0\n"),
            folder.write("none.obj", "v 0 0 0\n")};
  }
};
} // namespace fuzz

#endif
