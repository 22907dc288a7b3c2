// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef mtlFile_h
#define mtlFile_h

#include <visp3/se3/vpCompatibility.h>

#include <Eigen/Core>

#include <map>
#include <optional>
#include <string>
#include <vector>

BEGIN_VISP_NAMESPACE
namespace vpMeshDetail {
//! What is of use in a material of an .obj file.
struct MtlMaterial
{
  std::optional<Eigen::Vector3f> color; //!< In [0, 1].
  std::string image;                    //!< As the file names it; empty where there is none.
};

class MeshSink;

//! The materials of an .obj file. What is wrong with them is a warning: they say how a surface looks, not its shape.
class ObjMaterials
{
public:
  explicit ObjMaterials(MeshSink &sink) : m_sink(sink) {}

  //! \return A number for the material of this name, the same one for the same name.
  int index(const std::string &name);
  //! Reads the .mtl files of a line mtllib: one whose name may have blanks, or several.
  void addFiles(const std::string &names);
  //! \param index -1 for no material. \return The material; a plain one where it is missing.
  const MtlMaterial &at(int index);

private:
  void addFile(const std::string &file);
  MtlMaterial find(const std::string &name);

  MeshSink &m_sink;
  std::map<std::string, int> m_indices;
  std::vector<std::string> m_names;
  std::map<std::string, MtlMaterial> m_materials;
  std::vector<std::optional<MtlMaterial>> m_found; // By index, once it was asked for.
  bool m_isFileMissing = false;
};
} // namespace vpMeshDetail
END_VISP_NAMESPACE
#endif
