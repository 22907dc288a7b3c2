// SPDX-License-Identifier: GPL-2.0-or-later
#include <catchMain.h>

#include "throwingTracker.h"

#include <algorithm>
#include <cstdlib>
#include <new>

namespace {
long allocationsLeft = -1; // Until memory runs out for once; negative: it does not.
} // namespace

// Throws in places that no derived class comes to.
void *operator new(std::size_t size)
{
  void *memory = allocationsLeft >= 0 && allocationsLeft-- == 0 ? nullptr : std::malloc(std::max<std::size_t>(size, 1));
  if (memory == nullptr) {
    throw std::bad_alloc();
  }
  return memory;
}

// std::stable_sort() asks for memory in this way, and frees it in the other.
void *operator new(std::size_t size, const std::nothrow_t &) noexcept
{
  return allocationsLeft >= 0 && allocationsLeft-- == 0 ? nullptr : std::malloc(std::max<std::size_t>(size, 1));
}

void operator delete(void *memory) noexcept
{
  std::free(memory);
}

void operator delete(void *memory, std::size_t) noexcept
{
  std::free(memory);
}

namespace {
using namespace throwingTracker;

//! After some allocations. \param isEnough Set where there are not so many.
bool throwsWithoutMemory(Followed &followed, const vpImage<vpRGBa> &I, long allocations, bool &isEnough)
{
  allocationsLeft = allocations;
  const bool hasThrown = followed.throwsWith(I);
  isEnough = allocationsLeft >= 0;
  allocationsLeft = -1;
  return hasThrown;
}

// Of lacks of memory ever later in a frame: the next one, or one farther on, to which the object jumps.
std::vector<Outcome> outcomesIn(std::size_t frame)
{
  std::vector<Outcome> made;
  for (const Kind &kind : kinds) {
    bool isEnough = false;
    for (long allocations = 0; !isEnough; allocations += 1 + allocations / 6) {
      Followed followed(kind);
      const Before before(followed.tracker);
      if (throwsWithoutMemory(followed, imageOf(kind, frame), allocations, isEnough)) { // Some lacks are made up for.
        made.emplace_back(", allocation " + std::to_string(allocations), followed, before);
      }
    }
  }
  return made;
}
} // namespace

TEST_CASE("A lack of memory leaves the settings, the motions that are estimated and the last pose", "[exception]")
{
  for (const Outcome &outcome : outcomesIn(11)) {
    CAPTURE(outcome.text);
    CHECK(outcome.keepsSettings);
    CHECK(outcome.keepsMotions);
    CHECK(outcome.keepsPose);
  }
}

TEST_CASE("After a lack of memory the tracker goes on", "[exception]")
{
  for (const Outcome &outcome : outcomesIn(Followed::last + 1)) {
    CAPTURE(outcome.text);
    CHECK(outcome.goesOn);
  }
}
