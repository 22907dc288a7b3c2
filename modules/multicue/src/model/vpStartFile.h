// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpStartFile_h
#define vpStartFile_h

#include <visp3/core/vpImagePoint.h>
#include <visp3/core/vpPoint.h>
#include <visp3/core/vpPoseVector.h>
#include <visp3/se3/vpCompatibility.h>

#include <string>
#include <vector>

BEGIN_VISP_NAMESPACE

/*!
  ViSP's files that a tracker starts from. ViSP's own readers leave what a file lacks at 0, and read in the program's
  locale; these want every number. As in ViSP, the ending of a name (.init, .pos) may be left out.
*/
namespace vpStartFile {
//! What a file of initFromPoints() holds.
struct Points
{
  std::vector<vpPoint> object;
  std::vector<vpImagePoint> image;
};

//! \return The pose of a .pos file. \throw vpException naming the file that lacks a number or has too many.
vpPoseVector readPose(const std::string &file);
//! \throw vpException naming file and line where numbers are missing, or there are less than four points.
Points readPoints(const std::string &file);
//! \throw vpException likewise for a file of initClick(), which may have nothing but the object's points.
void requirePointsToClick(const std::string &file);
} // namespace vpStartFile

END_VISP_NAMESPACE
#endif
