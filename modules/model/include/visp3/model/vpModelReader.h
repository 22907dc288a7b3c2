// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpModelReader_h
#define vpModelReader_h

#include <visp3/core/vpHomogeneousMatrix.h>
#include <visp3/model/vpTrackedModelBuilder.h>

BEGIN_VISP_NAMESPACE

/*!
  \ingroup group_model_geometry
  Reads meshes: .obj, .ply and .stl to the letter, scenes (.dae, .gltf, .glb) through assimp. ViSP's own .cao and .wrl
  files are read by the tracker.

  A file from anywhere is read rightly, or refused with its name and what is wrong. What is missing beside it, or left
  out of it (material files, skeletons, morph targets), is in vpModelReport::warnings.

  Coordinates are those of the file, with the transformations of its nodes; axes are never turned, so the up axis that a
  .dae file names has no effect. A .dae file's own unit does count: it is in metres once it was read, and
  vpModelOptions::unit comes on top of that (leave it at 1). .gltf and .glb files are in metres by their standard.
  Colours are those of the vertices or of the material; texture images (PNG, JPEG and what else OpenCV reads) may be
  inside the file or beside it. Builds without OpenCV have no textures.
*/
class VISP_EXPORT vpModelReader
{
public:
  //! True for the file name extensions listed above, in any case.
  static bool isMesh(const std::string &file);

  /*!
    \param file Path of the mesh; texture images are looked for beside it.
    \param options Unit, crease angle, limits of size.
    \param oMm Pose of the mesh's frame in the object frame (metres), as the argument T of vpMbTracker::loadModel().
    \throw vpException naming the file where it is missing, broken, empty, has no triangles, or an unbelievable size.
  */
  static vpTrackedModel read(const std::string &file, const vpModelOptions &options = vpModelOptions(),
                             const vpHomogeneousMatrix &oMm = vpHomogeneousMatrix());

  /*!
    Adds a mesh to what a builder has already.
    \param builder Where the triangles go; unchanged where the file cannot be read.
    \param file, oMm As for read().
    \param unit Metres per unit of the file, > 0; the builder's own unit may be another one.
    \throw vpException naming the file where it is missing, broken, empty or has no triangles.
  */
  static void addTo(vpTrackedModelBuilder &builder, const std::string &file, double unit,
                    const vpHomogeneousMatrix &oMm = vpHomogeneousMatrix());
};

END_VISP_NAMESPACE
#endif
