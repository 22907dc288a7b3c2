// SPDX-License-Identifier: GPL-2.0-or-later
#include "judge/vpPoseBelief.h"

#include <algorithm>
#include <cmath>

BEGIN_VISP_NAMESPACE

namespace {
const double unsurprising = 18.; // Of the squared distance: one pose in two that is as far off has jumped.
const double staysRight = 0.995;
const double becomesRight = 0.03;
const double rightAfterJump = 0.3;
const double rightAfterLoss = 0.6; // At most.
// One share more of what is explained makes the odds exp(gain) times better; at the middle they stay as they are.
const double gain = 3.;
const double middle = 0.7;
// A pose that is followed is measured by its own frames before, so that a slip explains much: in rendered sequences
// 15300 poses were right and 150 wrong, and for each wrong one that explained 0.9 or more, 0.85, 0.8, or 0.6 to 0.8,
// there were 670, 73, 21 and 5 right ones. What explains still less is hidden rather than wrong, so that one frame
// makes the odds at most exp(-mostLoss) times worse.
const double middleOfFollowed = 0.8;
const double mostLoss = 0.2;
const double mostExplained = 1.1;
// So that some frames can turn it.
const double least = 0.002;
const double most = 0.995;
const double lossFactor = 0.5;
// Of a pose that the object jumped to, beside the logarithm of its odds: of those that vpJudgedPose::oddsOf() tells of,
// there were exp(1.5) right ones for each wrong one at 0, exp(3) at 1, exp(4.1) at 2. Less than that counts, since
// those that jumped are wrong more often: with 1.8, TRACKING though wrong was 3.8 % of the frames of hand-like motion
// at every fourth image, with this 2.2 %.
const double oddsOfJump = 0.7;
} // namespace

void vpPoseBelief::update(double jump, double explained)
{
  const double before = (1. - jumped(jump)) * followed() + jumped(jump) * rightAfterJump;
  set(corrected(before, gain * (std::min(explained, mostExplained) - middle)));
}

void vpPoseBelief::updateFollowed(double jump, double explained, double odds)
{
  const double gained = std::max(gain * (std::min(explained, mostExplained) - middleOfFollowed), -mostLoss);
  set((1. - jumped(jump)) * corrected(followed(), gained) + jumped(jump) * corrected(0.5, odds + oddsOfJump));
}

double vpPoseBelief::jumped(double jump)
{
  return jump / (unsurprising + jump);
}

double vpPoseBelief::followed() const
{
  return staysRight * m_probability + becomesRight * (1. - m_probability);
}

double vpPoseBelief::corrected(double before, double gained)
{
  const double odds = before / (1. - before) * std::exp(gained);
  return odds / (1. + odds);
}

void vpPoseBelief::set(double probability)
{
  m_probability = std::min(std::max(probability, least), most);
}

double vpPoseBelief::odds() const
{
  return std::log(m_probability / (1. - m_probability));
}

void vpPoseBelief::doubt()
{
  m_probability = std::min(m_probability, rightAfterLoss);
}

void vpPoseBelief::lose()
{
  m_probability *= lossFactor;
}

END_VISP_NAMESPACE
