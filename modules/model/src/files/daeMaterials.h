// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef daeMaterials_h
#define daeMaterials_h

#include <visp3/se3/vpCompatibility.h>

#include <Eigen/Core>
#include <pugixml.hpp>

#include <map>
#include <optional>
#include <string>
#include <vector>

BEGIN_VISP_NAMESPACE
namespace vpMeshDetail {
//! What is of use in a <material> of COLLADA.
struct DaeMaterial
{
  std::optional<Eigen::Vector3f> color; //!< In [0, 1].
  std::string image;                    //!< As the file names it; empty where there is none.
};

//! The materials of a file of COLLADA. What is wrong with them is a warning: they say how a surface looks.
class DaeMaterials
{
public:
  //! \param warnings Where they are added.
  DaeMaterials(const std::string &file, const pugi::xml_node &root, std::vector<std::string> &warnings);

  //! \param target Reference to a <material>: #id. \return The material; a plain one where it is missing.
  const DaeMaterial &find(const std::string &target);

private:
  void collect(const pugi::xml_node &library, const char *name);
  pugi::xml_node referred(const char *name, const std::string &reference) const;
  DaeMaterial read(const std::string &target);
  std::optional<Eigen::Vector3f> colorOf(const pugi::xml_node &color);
  std::string imageOf(const pugi::xml_node &profile, const std::string &texture);

  std::string m_file;
  std::vector<std::string> &m_warnings;
  std::map<std::string, pugi::xml_node> m_byId; // By name and id of an element, "effect#red" for instance.
  std::map<std::string, DaeMaterial> m_read;    // By their targets.
};
} // namespace vpMeshDetail
END_VISP_NAMESPACE
#endif
