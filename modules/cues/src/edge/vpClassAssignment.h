// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpClassAssignment_h
#define vpClassAssignment_h

#include <visp3/se3/vpCompatibility.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

BEGIN_VISP_NAMESPACE

/*!
  Gives the candidates of one control point to classes, at most one to each, with the least sum of squared distances.
  Both lie on the control point's normal, where the best assignment keeps the order; so it is a shortest path.
*/
template <std::size_t Max> class vpClassAssignment
{
public:
  //! \param label Name of the class. \param place Where its mean crosses the normal.
  void add(int label, double place)
  {
    std::size_t at = m_count++;
    for (; at > 0 && m_place[at - 1] > place; --at) {
      m_place[at] = m_place[at - 1];
      m_label[at] = m_label[at - 1];
    }
    m_place[at] = place;
    m_label[at] = label;
  }

  /*!
    \param places, count Candidates, in order.
    \param limit A candidate that is farther from its class gets none; infinite: only what finds no class gets none.
    \param labels In and out: the candidates' classes, -1 for none.
    \return True where a label changed.
  */
  bool assign(const double *places, int count, double limit, int *labels)
  {
    if (count == 1) {
      return assignOne(places[0], limit, labels[0]);
    }
    const std::size_t n = static_cast<std::size_t>(count);
    findCosts(places, n, std::min(limit * limit, 1e12));
    bool changed = false;
    std::size_t c = m_count;
    for (std::size_t i = n; i > 0; --i) {
      while (c > 0 && m_step[i][c] == SKIP_CLASS) {
        --c;
      }
      int label = -1;
      if (c > 0 && m_step[i][c] == TAKE) {
        label = m_label[--c];
      }
      changed = changed || labels[i - 1] != label;
      labels[i - 1] = label;
    }
    return changed;
  }

private:
  enum Step
  {
    SKIP_CLASS,
    SKIP_CANDIDATE,
    TAKE
  };

  bool assignOne(double place, double limit, int &label) const
  {
    int best = -1;
    double least = limit;
    for (std::size_t c = 0; c < m_count; ++c) {
      const double distance = std::fabs(place - m_place[c]);
      if (distance < least) {
        least = distance;
        best = m_label[c];
      }
    }
    const bool changed = label != best;
    label = best;
    return changed;
  }

  // m_cost[i][c]: of the first i candidates and the first c classes.
  void findCosts(const double *places, std::size_t n, double none)
  {
    std::fill_n(m_cost[0].begin(), m_count + 1, 0.);
    for (std::size_t i = 1; i <= n; ++i) {
      m_cost[i][0] = m_cost[i - 1][0] + none;
      m_step[i][0] = SKIP_CANDIDATE;
      for (std::size_t c = 1; c <= m_count; ++c) {
        const double distance = places[i - 1] - m_place[c - 1];
        double least = m_cost[i - 1][c - 1] + distance * distance;
        Step step = TAKE;
        if (m_cost[i][c - 1] < least) {
          least = m_cost[i][c - 1];
          step = SKIP_CLASS;
        }
        if (m_cost[i - 1][c] + none < least) {
          least = m_cost[i - 1][c] + none;
          step = SKIP_CANDIDATE;
        }
        m_cost[i][c] = least;
        m_step[i][c] = step;
      }
    }
  }

  std::size_t m_count = 0;
  std::array<double, Max> m_place;
  std::array<int, Max> m_label;
  std::array<std::array<double, Max + 1>, Max + 1> m_cost;
  std::array<std::array<Step, Max + 1>, Max + 1> m_step;
};

END_VISP_NAMESPACE
#endif
