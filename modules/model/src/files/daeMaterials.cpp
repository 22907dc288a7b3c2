// SPDX-License-Identifier: GPL-2.0-or-later
#include "files/daeMaterials.h"

#include "files/daeText.h"
#include "files/fileBytes.h"
#include "files/meshSink.h"

#include <visp3/core/vpException.h>

BEGIN_VISP_NAMESPACE
namespace vpMeshDetail {
namespace {
std::string trimmedText(const pugi::xml_node &node)
{
  const std::string text = textOf(node);
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(" \t\r\n") + 1 - first);
}

// The <newparam> of a profile with this name.
pugi::xml_node parameter(const pugi::xml_node &profile, const std::string &sid)
{
  return profile.find_child([&](const pugi::xml_node &child) {
    return std::string(child.name()) == "newparam" && sid == child.attribute("sid").value();
  });
}
} // namespace

DaeMaterials::DaeMaterials(const std::string &file, const pugi::xml_node &root, std::vector<std::string> &warnings)
    : m_file(file), m_warnings(warnings)
{
  for (const pugi::xml_node &library : root.children()) {
    collect(library, "material");
    collect(library, "effect");
    collect(library, "image");
  }
}

void DaeMaterials::collect(const pugi::xml_node &library, const char *name)
{
  for (const pugi::xml_node &one : library.children(name)) {
    m_byId.emplace(std::string(name) + "#" + one.attribute("id").value(), one);
  }
}

// An empty node where there is none. \param reference #id
pugi::xml_node DaeMaterials::referred(const char *name, const std::string &reference) const
{
  const auto found = m_byId.find(name + reference);
  return found == m_byId.end() ? pugi::xml_node() : found->second;
}

const DaeMaterial &DaeMaterials::find(const std::string &target)
{
  const auto [known, isNew] = m_read.try_emplace(target);
  if (isNew) {
    known->second = read(target);
  }
  return known->second;
}

DaeMaterial DaeMaterials::read(const std::string &target)
{
  const std::string name = target.substr(target.empty() ? 0 : 1);
  const pugi::xml_node material = referred("material", target);
  const pugi::xml_node profile =
      referred("effect", material.child("instance_effect").attribute("url").value()).child("profile_COMMON");
  DaeMaterial result;
  if (!profile) {
    m_warnings.push_back("the material '" + name + "' of '" + m_file + "', or its effect, is missing");
    return result;
  }
  for (const pugi::xml_node &shading : profile.child("technique").children()) {
    const pugi::xml_node diffuse = shading.child("diffuse");
    if (diffuse.child("texture")) {
      result.image = imageOf(profile, diffuse.child("texture").attribute("texture").value());
    } else if (diffuse.child("color")) {
      result.color = colorOf(diffuse.child("color"));
    }
  }
  return result;
}

std::optional<Eigen::Vector3f> DaeMaterials::colorOf(const pugi::xml_node &color)
{
  std::vector<double> numbers;
  try {
    numbers = numbersOf(m_file, color);
  } catch (const vpException &e) {
    m_warnings.push_back(e.getMessage());
    return std::nullopt;
  }
  if (numbers.size() != 3 && numbers.size() != 4) {
    m_warnings.push_back("a colour of '" + m_file + "' has " + std::to_string(numbers.size()) +
                         " numbers, and is left out");
    return std::nullopt;
  }
  const Eigen::Vector3d rgb(numbers[0], numbers[1], numbers[2]);
  return toColor(rgb, rgb.maxCoeff());
}

// A texture is a sampler, which has a surface, which is made of an image; some files leave steps out.
std::string DaeMaterials::imageOf(const pugi::xml_node &profile, const std::string &texture)
{
  std::string reference = "#" + texture;
  if (const pugi::xml_node sampler = parameter(profile, texture).child("sampler2D")) {
    const pugi::xml_node surface = parameter(profile, trimmedText(sampler.child("source"))).child("surface");
    reference = sampler.child("instance_image") ? sampler.child("instance_image").attribute("url").value()
                                                : "#" + trimmedText(surface.child("init_from"));
  }
  const pugi::xml_node from = referred("image", reference).child("init_from");
  std::string path = trimmedText(from.child("ref") ? from.child("ref") : from);
  if (path.empty()) {
    m_warnings.push_back("the texture '" + texture + "' of '" + m_file + "' leads to no image");
  }
  const std::string scheme = "file://";
  return path.compare(0, scheme.size(), scheme) == 0 ? path.substr(scheme.size()) : path;
}
} // namespace vpMeshDetail
END_VISP_NAMESPACE
