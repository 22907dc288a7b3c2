// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef groupedIndices_h
#define groupedIndices_h

#include <visp3/se3/vpCompatibility.h>

#include <cstddef>
#include <vector>

BEGIN_VISP_NAMESPACE
namespace vpMeshDetail {
//! The numbers 0 to n - 1 sorted into groups, in two vectors however many groups there are.
class GroupedIndices
{
public:
  /*!
    \param groupCount Number of groups.
    \param itemCount Number of items n.
    \param groupOf Function from item to group, both int.
  */
  template <class GroupOf>
  GroupedIndices(std::size_t groupCount, std::size_t itemCount, GroupOf groupOf)
      : m_start(groupCount + 1, 0), m_items(itemCount)
  {
    for (std::size_t i = 0; i < itemCount; ++i) {
      ++m_start[static_cast<std::size_t>(groupOf(static_cast<int>(i))) + 1];
    }
    for (std::size_t g = 0; g < groupCount; ++g) {
      m_start[g + 1] += m_start[g];
    }
    std::vector<int> next(m_start.begin(), m_start.end() - 1);
    for (std::size_t i = 0; i < itemCount; ++i) {
      const auto group = static_cast<std::size_t>(groupOf(static_cast<int>(i)));
      m_items[static_cast<std::size_t>(next[group]++)] = static_cast<int>(i);
    }
  }

  int *begin(std::size_t group) { return m_items.data() + m_start[group]; }
  int *end(std::size_t group) { return m_items.data() + m_start[group + 1]; }
  const int *begin(std::size_t group) const { return m_items.data() + m_start[group]; }
  const int *end(std::size_t group) const { return m_items.data() + m_start[group + 1]; }

private:
  std::vector<int> m_start;
  std::vector<int> m_items;
};
} // namespace vpMeshDetail
END_VISP_NAMESPACE
#endif
