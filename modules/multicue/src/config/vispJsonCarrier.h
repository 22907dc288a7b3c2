// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vispJsonCarrier_h
#define vispJsonCarrier_h

#include "config/settingsVispJson.h"

#include <map>
#include <string>

BEGIN_VISP_NAMESPACE
namespace vpSettingsDetail {
//! Carries values of a configuration of another tracker over under the names of this one, and says of each value of the
//! file what became of it.
class VispJsonCarrier
{
public:
  using Json = nlohmann::ordered_json;

  //! \return A key as it is written in a JSON pointer.
  static std::string escaped(const std::string &key);

  explicit VispJsonCarrier(const Json &file) : m_file(file) { m_known = Json::object(); }

  //! A value is one of this tracker's as it is. \param theirs JSON pointer, "/lod/useLod" for instance; nothing happens
  //! where the file has no such value. \param ours "lod.enabled". \param difference For the report.
  void take(const std::string &theirs, const std::string &ours, const std::string &difference = "");
  //! Likewise, with another value. \param ours Where several settings come of it, the one that the report names.
  void takeAs(const std::string &theirs, const std::string &ours, const Json &value,
              const std::string &difference = "");
  //! Sets a value of which the file says nothing by itself.
  void set(const std::string &ours, const Json &value);
  //! A value, and all below it, was used up by one that was taken. \param ours The setting's name.
  void note(const std::string &theirs, const std::string &ours, const std::string &difference = "");
  //! Why a value, and all below it, has nothing like it here.
  void leave(const std::string &theirs, const std::string &reason) { m_reasons[theirs] = reason; }

  bool has(const std::string &theirs) const { return m_file.contains(Json::json_pointer(theirs)); }
  //! \return The value there; an empty object where there is none.
  const Json &at(const std::string &theirs) const;
  //! \return The object there; an empty one where there is none. \throw vpException where it is something else.
  const Json &objectAt(const std::string &theirs) const;

  //! \return What was carried over, and a report of all values of the file.
  VispJson result(vpConfigReport::Format format) const;

private:
  struct Taken
  {
    std::string ours;
    std::string difference;
  };
  // True where values of a list were taken or left one by one.
  bool isSplit(const std::string &list) const;
  void report(const Json &json, const std::string &pointer, vpConfigReport &report) const;

  const Json &m_file;
  Json m_known;
  std::map<std::string, Taken> m_taken;
  std::map<std::string, std::string> m_reasons;
};
} // namespace vpSettingsDetail
END_VISP_NAMESPACE
#endif
