// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef programsStartFiles_h
#define programsStartFiles_h

#include <visp3/core/vpHomogeneousMatrix.h>
#include <visp3/core/vpImagePoint.h>
#include <visp3/core/vpPoint.h>

#include <string>
#include <vector>

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

namespace programs {

/*!
  \param file Text of numbers with # comments: 6 of them, translation (metres) and theta u (radians) as in ViSP's .pos
  files, or 12 or 16, the rows of a matrix.
  \return The pose.
  \throw vpException naming the file and what is wrong with it.
*/
vpHomogeneousMatrix readPose(const std::string &file);

//! Points of the object and where they are in the image, in the same order.
struct PointPairs
{
  std::vector<vpPoint> object;     //!< Metres, in the object's frame.
  std::vector<vpImagePoint> image; //!< Rows and columns, pixels.
};

/*!
  \param file ViSP's .init file: how many points, X Y Z of each, metres; # comments.
  \return The points, at least 4. \throw vpException naming the file and what is wrong with it.
*/
std::vector<vpPoint> readClickPoints(const std::string &file);

/*!
  \param file Text of numbers with # comments, as ViSP's initFromPoints() reads: how many points, X Y Z of each, again
  how many, row and column of each.
  \return The points, at least 4.
  \throw vpException naming the file and what is wrong with it.
*/
PointPairs readPoints(const std::string &file);

} // namespace programs
#endif
