// SPDX-License-Identifier: GPL-2.0-or-later
#include "frame/vpSearchBudget.cpp" // The library keeps it to itself.

#include <catchMain.h>

#include <visp3/multicue/vpMbMultiCueTracker.h>

#include <limits>
#include <thread>

TEST_CASE("Without a limit everything is looked for", "[search-budget]")
{
  vpSearchBudget budget;
  budget.startFrame();
  budget.learn(2000, 0., 1e6);
  CHECK(budget.number(2000) == 2000);
  CHECK_FALSE(budget.isSpent());
}

TEST_CASE("The number of poses follows the time that a search takes", "[search-budget]")
{
  vpSearchBudget budget;
  budget.set(60.);
  const double each = 0.05; // Milliseconds.
  const double before = 20.;
  for (unsigned int i = 0; i < 20; ++i) {
    const std::size_t number = budget.number(100000);
    budget.learn(number, before, each * static_cast<double>(number));
  }
  // Half of what is left for the search.
  CHECK(static_cast<double>(budget.number(100000)) == Approx(0.5 * (60. - before) / each).epsilon(0.01));
  CHECK(budget.number(300) == 300);

  for (unsigned int i = 0; i < 20; ++i) {
    budget.learn(budget.number(2000), 70., 10.);
  }
  CHECK(budget.number(2000) == 100);
}

TEST_CASE("A budget is spent after its time, and whole again in the next frame", "[search-budget]")
{
  vpSearchBudget budget;
  budget.set(1.);
  budget.startFrame();
  std::this_thread::sleep_for(std::chrono::milliseconds(2));
  CHECK(budget.isSpent());
  budget.set(10000.);
  budget.startFrame();
  CHECK_FALSE(budget.isSpent());
}

TEST_CASE("A budget out of range is refused and the last one kept", "[search-budget]")
{
  vpMbMultiCueTracker tracker(vpMbMultiCueTracker::EDGE_TRACKER);
  CHECK(tracker.getSearchBudget() == exactly(0.));
  tracker.setSearchBudget(40.);
  for (const double value : {-1., 10001., std::numeric_limits<double>::quiet_NaN()}) {
    CHECK_THROWS_AS(tracker.setSearchBudget(value), vpException);
    CHECK(tracker.getSearchBudget() == exactly(40.));
  }
}
