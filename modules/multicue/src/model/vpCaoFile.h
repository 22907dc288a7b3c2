// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpCaoFile_h
#define vpCaoFile_h

#include <visp3/core/vpHomogeneousMatrix.h>
#include <visp3/core/vpPoint.h>
#include <visp3/se3/vpCompatibility.h>

#include <optional>
#include <string>
#include <vector>

BEGIN_VISP_NAMESPACE

//! What a line of a .cao file describes.
struct vpCaoShape
{
  enum Kind
  {
    FACE,          //!< Corners, or the two ends of a line.
    FACE_OF_LINES, //!< Ends of a face's lines, two for each.
    CYLINDER,      //!< Ends of the axis.
    CIRCLE         //!< Centre and two more points of its plane.
  };

  Kind kind = FACE;
  std::vector<vpPoint> points; //!< Object frame, metres.
  double radius = 0.;
  std::string name;
  bool isLine = false;                  //!< From the section of lines.
  std::optional<bool> useLod;           //!< What the line says of the level of detail.
  std::optional<double> minLineLength;  //!< Pixels.
  std::optional<double> minPolygonArea; //!< Square pixels.
};

/*!
  A .cao file and the files that it loads.

  ViSP's own parser takes its counts and indices on trust, crashes where they are wrong, reads in the program's locale,
  and does not say what is wrong where. This one wants every shape on a line of its own, and nothing but parameters or a
  comment after its numbers, so that a wrong count is always found.
*/
struct vpCaoFile
{
  std::vector<vpCaoShape> shapes;    //!< In the order of ViSP's parser, which their numbers follow from.
  std::vector<std::string> warnings; //!< What may be wrong.

  /*!
    \param file Path.
    \param oMf Pose of the file's frame in the object frame.
    \throw vpException with line number, and the name of a part that is meant, where the file is broken.
  */
  static vpCaoFile read(const std::string &file, const vpHomogeneousMatrix &oMf);
};

END_VISP_NAMESPACE
#endif
