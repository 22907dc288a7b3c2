// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef programsDemoSequence_h
#define programsDemoSequence_h

#include <visp3/core/vpHomogeneousMatrix.h>

#include <map>
#include <string>
#include <vector>

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

namespace programs {

//! What is known of an image beside its pixels.
struct DemoTruth
{
  vpHomogeneousMatrix cMo; //!< Metres.
  double visibility = 1.;  //!< Visible share of the object, [0, 1].
};

//! A sequence that two trackers are shown on. Both get the same files.
struct DemoSequence
{
  std::string title;
  std::string images;             //!< Pattern of image files.
  std::string model;              //!< .cao, as ViSP's tracker reads no other.
  std::string config;             //!< ViSP's .xml.
  std::string start;              //!< .pos file of the first image.
  double diameter = 0.;           //!< Of the object, metres; 0 where there is no truth.
  std::map<int, DemoTruth> truth; //!< By the number of the image; empty where it is not known.
};

//! \param images Folder of ViSP's data set. \param data The project's folder data. \throw vpException naming the file
//! that is missing or broken.
std::vector<DemoSequence> demoSequences(const std::string &images, const std::string &data);

} // namespace programs
#endif
