// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef benchSequence_h
#define benchSequence_h

#include <visp3/core/vpCameraParameters.h>
#include <visp3/core/vpHomogeneousMatrix.h>

#include <Eigen/Core>

#include <string>
#include <vector>

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

namespace bench {

//! An object that looks the same however far it is turned about a line.
struct SymmetryAxis
{
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ(); //!< Unit vector, object frame.
  Eigen::Vector3d point = Eigen::Vector3d::Zero();      //!< A point of the line, object frame, metres.
};

//! The tracked object and its files.
struct SequenceObject
{
  int id = 1;                                //!< As in BOP's file names.
  std::string mesh;                          //!< Path; empty where there is only a .cao.
  double meshUnit = 1.;                      //!< Metres per unit of the mesh.
  std::string cao;                           //!< Path of ViSP's model, metres; empty where there is none.
  double diameter = 0.;                      //!< Largest distance of two vertices, metres.
  std::vector<vpHomogeneousMatrix> symmetry; //!< cMo and cMo * symmetry look the same; without the identity.
  std::vector<SymmetryAxis> axis;            //!< Continuous symmetries.
};

//! One image and what is known about it.
struct SequenceFrame
{
  int id = 0;              //!< Its number in the data set.
  std::string image;       //!< Path.
  vpCameraParameters cam;  //!< With the distortion that the data set states.
  bool hasTruth = false;   //!< False where the data set does not have the object's pose.
  vpHomogeneousMatrix cMo; //!< True pose, metres.
  double visibility = 1.;  //!< Visible share of the object's silhouette, [0, 1].
};

//! One object in the images of one scene, in the order of time.
struct Sequence
{
  std::string scene;
  SequenceObject object;
  std::vector<SequenceFrame> frames; //!< At least two, the first with truth.
  std::vector<std::string> notes;    //!< What of the data set was left out, and why.
};

/*!
  Names of the scenes of a data set in BOP's or RBOT's layout, sorted: the scene's folder relative to \e dataset for BOP
  ("test/000001", "." where \e dataset is the scene), "ape/a_regular" for RBOT. The layouts are told in bopReader.h and
  rbotReader.h.
  \throw vpException naming the folder where it is missing or has no scene.
*/
std::vector<std::string> listScenes(const std::string &dataset);

/*!
  Opens a scene in BOP's or RBOT's layout. All its files are looked for now, so that a broken data set is found before a
  run of an hour. Images before the first one that shows the object are left out; of several instances of the object in
  an image the first one counts.
  \param scene One of listScenes(); its last folder ("000001"), or that one's number ("1"), where no other has the same.
  \param object BOP's number of the object; 0 for the only one, or the first, of the scene. RBOT's objects are all 1.
  \throw vpException naming the file that is missing or broken, and the frame and key; for a scene or object that is not
  there, those that are.
*/
Sequence openSequence(const std::string &dataset, const std::string &scene, int object = 0);

//! A recording outside any data set: numbered images (no video), and a text file of 16 numbers for each pose. Images
//! without such a file are frames without truth; the first image needs one.
struct Recording
{
  std::string name = "recording"; //!< Name of the scene in results.
  std::string images;             //!< printf pattern of the images' paths.
  std::string poses;              //!< printf pattern of vpHomogeneousMatrix text files (4 x 4 numbers).
  std::string model;              //!< .cao, .wrl or mesh.
  double unit = 1.;               //!< Metres per unit of a mesh.
  std::string camera; //!< ViSP's XML file with a camera (a tracker's configuration, or vpXmlParserCamera's).
  int first = -1;     //!< Number of the first image, -1 for the first that there is.
  int last = -1;      //!< Number of the last one, -1 for as many as there are.
  int step = 1;       //!< Distance of the numbers.
};

//! \throw vpException naming the file that is missing or broken.
Sequence openRecording(const Recording &recording);

} // namespace bench
#endif
