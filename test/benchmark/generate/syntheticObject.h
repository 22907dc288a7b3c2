// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef benchSyntheticObject_h
#define benchSyntheticObject_h

#include "dataset/bopWriter.h"

#include <cstdint>
#include <string>
#include <vector>

namespace bench {

//! How a part of an object reflects light; the colour itself belongs to the mesh.
struct SurfaceMaterial
{
  float specular = 0.12F;  //!< Strength of the highlight, gray levels of 255.
  float shininess = 20.F;  //!< Exponent of the highlight.
  float crinkle = 0.F;     //!< Slope of crinkles of foil, 0 for a smooth surface.
  float crinkleSize = 0.F; //!< Size of a crinkle, metres.
};

//! A triangle of the surface and what it is made of.
struct ColoredTriangle : programs::BopTriangle
{
  int part = 0; //!< Index into SyntheticObject::materials.
};

//! An object before it is written into files: its surface, and what is to be done with it.
struct SyntheticObject
{
  std::string name; //!< Name in the names of scenes.
  int id = 1;       //!< Number in BOP's file names.
  std::vector<ColoredTriangle> triangles;
  std::vector<cv::Mat> images;            //!< Textures, 8-bit BGR.
  std::vector<SurfaceMaterial> materials; //!< At least one.
  std::string cao;                        //!< ViSP's model, empty where polygons do not make sense.
  double pixelDiameter = 225.;            //!< Mean size in an image of 640 x 480 pixels.
  bool frontOnly = false;                 //!< Seen within 60 degrees of its z axis only.
  bool inSpace = false;                   //!< Sunlight without an atmosphere, and space behind it by default.
};

/*!
  Names of the objects that makeObject() knows, in the order of their numbers.
*/
std::vector<std::string> objectNames();

/*!
  Makes an object, the same one for the same seed.
  \param name One of objectNames(), or the path of a mesh.
  \param seed Of pictures and colours.
  \param unit Metres per unit of a mesh.
  \throw vpException where there is no such object, naming those that there are, or the mesh cannot be read.
*/
SyntheticObject makeObject(const std::string &name, std::uint64_t seed, double unit = 1.);

// The objects by themselves; see makeObject().
SyntheticObject makeBox(std::uint64_t seed);
SyntheticObject makeBands(std::uint64_t seed);
SyntheticObject makeWindow(std::uint64_t seed);
SyntheticObject makeSatellite(std::uint64_t seed);
SyntheticObject makeFigurine(std::uint64_t seed);
SyntheticObject makeFromMesh(const std::string &file, double unit);

} // namespace bench
#endif
