// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpJsonWatch_h
#define vpJsonWatch_h

#include <visp3/core/vpConfig.h>
#include <visp3/se3/vpCompatibility.h>

#include <functional>
#include <set>
#include <string>
#include <utility>
#include <vector>

BEGIN_VISP_NAMESPACE

/*!
  \ingroup group_model
  Refuses JSON in which a key stands twice, of which nlohmann's parser keeps the last one in silence, and JSON that is
  nested so deep that functions which call themselves would end the program. It is handed to that parser, as the
  function that it calls while it reads.
*/
class vpJsonWatch
{
public:
  //! \param deepest Level of the innermost values that are read. \param refuse Throws; gets what is wrong, as a
  //! sentence.
  vpJsonWatch(int deepest, std::function<void(const std::string &)> refuse)
      : m_deepest(deepest), m_refuse(std::move(refuse))
  {
  }

  template <typename Event, typename Json> bool operator()(int depth, Event event, const Json &parsed)
  {
    if (depth > m_deepest) {
      m_refuse("it is nested more than " + std::to_string(m_deepest) + " deep");
    }
    if (event == Event::object_start) {
      m_keys.emplace_back();
    } else if (event == Event::object_end) {
      m_keys.pop_back();
    } else if (event == Event::key && !m_keys.back().insert(parsed.template get<std::string>()).second) {
      m_refuse("'" + parsed.template get<std::string>() + "' is there twice: delete one of both");
    }
    return true;
  }

private:
  int m_deepest;
  std::function<void(const std::string &)> m_refuse;
  std::vector<std::set<std::string>> m_keys; // Of the objects that are open.
};

END_VISP_NAMESPACE
#endif
