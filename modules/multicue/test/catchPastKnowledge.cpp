// SPDX-License-Identifier: GPL-2.0-or-later
#include "knowledge/vpPastKnowledge.h"

#include <algorithm>
#include <vector>

#include <catchMain.h>

namespace {
using Past = vpPastKnowledge<unsigned long>; // The number of the frame.

void learn(Past &past, unsigned long first, unsigned long last)
{
  for (unsigned long frame = first; frame <= last; ++frame) {
    if (past.count()) {
      past.keep(frame);
    }
  }
}

//! The number of the frame that is recalled; 0: none.
unsigned long recalled(Past &past, unsigned int level)
{
  const unsigned long *frame = past.recall(level);
  return frame == nullptr ? 0 : *frame;
}

std::vector<unsigned long> allOf(Past &past)
{
  std::vector<unsigned long> frames;
  for (unsigned int level = 0; frames.empty() || recalled(past, level) < frames.back(); ++level) {
    frames.push_back(recalled(past, level));
  }
  return frames;
}
} // namespace

TEST_CASE("Of what was learnt, the newest is forgotten as far as it is wrong", "[past-knowledge]")
{
  Past past;
  learn(past, 1, 100);
  past.dropNewest([](unsigned long frame) { return frame > 50; });
  CHECK(recalled(past, 0) > 0);
  CHECK(recalled(past, 0) <= 50);
  std::vector<unsigned long> old;
  past.forEachOld([&old](unsigned long frame) { old.push_back(frame); });
  std::vector<unsigned long> all = allOf(past);
  std::sort(all.begin(), all.end());
  CHECK(old == all);
  past.dropNewest([](unsigned long) { return true; });
  CHECK(past.size() == 0);
  CHECK(past.recall(1) == nullptr);
}

TEST_CASE("What was learnt just now is not old", "[past-knowledge]")
{
  Past past;
  unsigned long newest = 0;
  learn(past, 1, 2 * Past::interval + 1);
  past.forEachOld([&newest](unsigned long frame) { newest = frame; });
  CHECK(newest == 1 + Past::interval);
}

TEST_CASE("What one frame told is no better than what all of them did", "[past-knowledge]")
{
  Past past;
  CHECK(past.recall(0) == nullptr);
  CHECK(past.recall(1) == nullptr);
  for (unsigned long frame = 1; frame <= 2 * Past::interval; ++frame) {
    learn(past, frame, frame);
    CHECK(past.recall(0) == nullptr);
    CHECK(recalled(past, 1) == (frame > Past::interval ? 1 : 0)); // Where nothing else is left.
  }
  learn(past, 2 * Past::interval + 1, 2 * Past::interval + 1);
  CHECK(recalled(past, 0) == Past::interval + 1);
  past.clear();
  CHECK(past.recall(1) == nullptr);
}

TEST_CASE("What is recalled first is some frames old, and not many more", "[past-knowledge]")
{
  Past past;
  learn(past, 1, 2 * Past::interval);
  for (unsigned long frame = 2 * Past::interval + 1; frame <= 500; ++frame) {
    learn(past, frame, frame);
    const unsigned long age = frame - recalled(past, 0);
    CHECK(age < 2 * Past::interval);
    CHECK(age >= Past::interval);
  }
}

TEST_CASE("The farther back, the sparser, down to the first frame", "[past-knowledge]")
{
  Past past;
  for (unsigned long frame = 1; frame <= 2000; ++frame) {
    learn(past, frame, frame);
    CHECK(past.size() <= 20);
  }
  const std::vector<unsigned long> frames = allOf(past);
  REQUIRE(frames.size() >= 5);
  CHECK(frames.back() == 1);
  for (std::size_t i = 1; i < frames.size(); ++i) {
    // Nothing is missing between a state and one that is about four times as old.
    CHECK(2000 - frames[i] <= 4 * (2000 - frames[i - 1] + Past::interval));
  }
  CHECK(recalled(past, static_cast<unsigned int>(frames.size())) == frames[0]); // It begins again.
}

TEST_CASE("What was learnt since then is forgotten where older knowledge was right", "[past-knowledge]")
{
  Past past;
  learn(past, 1, 100);
  const unsigned long right = recalled(past, 1);
  past.settle();
  CHECK(recalled(past, 0) == right);
  learn(past, 101, 100 + Past::interval - 1);
  CHECK(recalled(past, 0) == right);
  learn(past, 100 + Past::interval, 100 + 2 * Past::interval);
  CHECK(recalled(past, 0) == 100 + Past::interval);
  CHECK(recalled(past, 1) == right);
}
