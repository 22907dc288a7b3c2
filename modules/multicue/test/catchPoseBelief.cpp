// SPDX-License-Identifier: GPL-2.0-or-later
#include "judge/vpPoseBelief.cpp" // The library keeps it to itself.

#include <catchMain.h>

namespace {
//! Updates on end with the same image. \return The last belief.
double after(vpPoseBelief &belief, unsigned int frames, double jump, double explained)
{
  for (unsigned int i = 0; i < frames; ++i) {
    belief.update(jump, explained);
  }
  return belief.probability();
}

vpPoseBelief begunWith(double probability)
{
  vpPoseBelief belief;
  belief.start(probability);
  return belief;
}
} // namespace

TEST_CASE("One update is Bayes' rule", "[pose-belief]")
{
  vpPoseBelief belief = begunWith(0.8);
  belief.update(0., 0.9);
  const double before = 0.995 * 0.8 + 0.03 * 0.2;
  const double odds = before / (1. - before) * std::exp(3. * 0.2);
  CHECK(belief.probability() == Approx(odds / (1. + odds)).epsilon(1e-12));
}

TEST_CASE("A jump forgets what was believed", "[pose-belief]")
{
  vpPoseBelief right = begunWith(0.99);
  vpPoseBelief wrong = begunWith(0.01);
  right.update(1e9, 0.7);
  wrong.update(1e9, 0.7);
  CHECK(right.probability() == Approx(wrong.probability()).epsilon(1e-6));
  CHECK(right.probability() < 0.5);

  vpPoseBelief followed = begunWith(0.99);
  followed.update(0.01, 0.7);
  CHECK(followed.probability() > 0.95);
}

TEST_CASE("What explains the images comes to be believed, and what does not is doubted", "[pose-belief]")
{
  vpPoseBelief belief = begunWith(0.3);
  CHECK(after(belief, 10, 0., 1.) > 0.9);
  CHECK(after(belief, 20, 0., 0.3) < 0.1);
  CHECK(after(belief, 10, 0., 1.) > 0.7);
}

TEST_CASE("Some doubtful images on end do not end what was followed for long", "[pose-belief]")
{
  vpPoseBelief belief = begunWith(0.98);
  CHECK(after(belief, 3, 0., 0.5) > 0.7);
}

TEST_CASE(
    "A followed pose that goes on to explain less than usual is doubted, and one that is hidden for a while is not",
    "[pose-belief]")
{
  const auto followed = [](unsigned int frames, double explained) {
    vpPoseBelief belief = begunWith(0.99);
    for (unsigned int i = 0; i < frames; ++i) {
      belief.updateFollowed(0., explained, 0.);
    }
    return belief.probability();
  };
  CHECK(followed(30, 0.73) < 0.5);
  CHECK(followed(30, 0.9) > 0.97);
  CHECK(followed(8, 0.) > 0.8);
  CHECK(followed(8, 0.) == exactly(followed(8, 0.6)));
}

TEST_CASE("A followed pose that jumped is believed as far as this image and its motion go", "[pose-belief]")
{
  const auto jumped = [](double before, double odds) {
    vpPoseBelief belief = begunWith(before);
    belief.updateFollowed(1e9, 1., odds);
    return belief.probability();
  };
  CHECK(jumped(0.99, 2.) == Approx(jumped(0.1, 2.)).epsilon(1e-6));
  CHECK(jumped(0.99, 2.) > 0.9);
  CHECK(jumped(0.99, -3.) < 0.2);
  CHECK(jumped(0.99, 0.) > jumped(0.99, -1.));
  CHECK(jumped(0.99, -HUGE_VAL) > 0.); // It can be turned.
}

TEST_CASE("The belief stays a probability that can be turned", "[pose-belief]")
{
  for (const double explained : {-1e6, 0., 1e6}) {
    for (const double jump : {0., 1e6}) {
      vpPoseBelief belief = begunWith(0.5);
      const double end = after(belief, 1000, jump, explained);
      CHECK(end > 0.);
      CHECK(end < 1.);
    }
  }
  vpPoseBelief belief = begunWith(0.98);
  after(belief, 1000, 0., 1.);
  CHECK(after(belief, 12, 0., 0.) < 0.5);
}

TEST_CASE("A loss has to be made good", "[pose-belief]")
{
  vpPoseBelief belief = begunWith(0.98);
  belief.lose();
  CHECK(belief.probability() < 0.5);
  belief = begunWith(0.98);
  belief.doubt();
  CHECK(belief.probability() <= 0.6);
  belief = begunWith(0.2);
  belief.doubt();
  CHECK(belief.probability() == exactly(0.2));
}
