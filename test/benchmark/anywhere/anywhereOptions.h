// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef benchAnywhereOptions_h
#define benchAnywhereOptions_h

#include <string>
#include <vector>

namespace bench {

//! What multicue-anywhere is asked to do.
struct AnywhereOptions
{
  std::string dataset;
  std::vector<std::string> scenes;
  std::string tracker = "robust";
  std::string config;
  int every = 5;       //!< Of the frames, so many apart.
  int most = 1000000;  //!< Images of each object.
  int follow = 0;      //!< Images that are tracked after a start that was accepted.
  bool absent = false; //!< Each object's model on the images of the others.
  bool gray = false;
  double nearest = 0.;  //!< Metres; 0: the tracker's default.
  double farthest = 0.; //!< Likewise.
  std::string overlays; //!< Folder for pictures of what went wrong; empty: none.

  /*!
    \return False where help was asked for and given.
    \throw vpException naming the option that is missing or wrong.
  */
  bool read(int argc, const char *const argv[]);
};

} // namespace bench
#endif
