// SPDX-License-Identifier: GPL-2.0-or-later
#include "edge/vpEdgeClaims.cpp" // The library keeps it to itself.
#include "edgeScenes.h"

#include <catchMain.h>

using namespace edgeScenes;

namespace {
const Eigen::Vector2f place(100.F, 50.F);

//! Of an upright edge, at a distance from the place along the edge and across it, pixels.
vpEdgeClaims::Claim claim(int edge, float distance, float along = 0.F, float across = 0.F)
{
  return {edge, place + Eigen::Vector2f(across, along), {1.F, 0.F}, distance, 8.F};
}

std::vector<float> sharesOf(const std::vector<vpEdgeClaims::Claim> &added)
{
  vpEdgeClaims claims(added.size());
  for (const vpEdgeClaims::Claim &one : added) {
    claims.add(one);
  }
  return claims.shares();
}

//! Upright, at this column.
Line upright(double u)
{
  return Line{Eigen::Vector2d(u, 60.), M_PI / 2.};
}

//! Mean over the control points of an upright line, all of which found something.
double claimAt(const vpEdgeCue &cue, double u)
{
  return meanAt(cue, u, [](const vpEdgeCue::Match &match) { return match.count > 0 ? match.claim : std::nan(""); });
}
} // namespace

TEST_CASE("What one edge takes is its own", "[edge-claims]")
{
  CHECK(sharesOf({}).empty());
  CHECK(sharesOf({claim(0, 3.F)}) == std::vector<float>{1.F});
  // With its neighbours, whatever their distance.
  CHECK(sharesOf({claim(0, 3.F), claim(0, 0.F, 0.5F), claim(0, 1.F, -2.F)}) == std::vector<float>(3, 1.F));
  CHECK(sharesOf({claim(-1, 3.F), claim(-2, 0.F)}) == std::vector<float>(2, 1.F)); // Without names.
}

TEST_CASE("What two edges take belongs to the nearer one", "[edge-claims]")
{
  const std::vector<float> even = sharesOf({claim(0, 1.F), claim(1, 1.F, 1.5F)});
  CHECK(even[0] == Approx(0.5F));
  CHECK(even[1] == Approx(0.5F));
  const std::vector<float> shares = sharesOf({claim(0, 0.F), claim(1, 1.4F), claim(-1, 30.F)});
  CHECK(shares[0] == Approx(1.F / (1.F + std::exp(-2.F))));
  CHECK(shares[1] == Approx(1.F / (1.F + std::exp(2.F))));
  CHECK(shares[2] < 1e-6F);
  // Each edge counts once, with the claim that is nearest along it.
  const std::vector<float> once = sharesOf({claim(0, 1.F), claim(1, 1.F, 1.F), claim(1, 0.F, 2.F), claim(1, 0.F, 3.F)});
  CHECK(once[0] == Approx(0.5F));
}

TEST_CASE("Edges elsewhere, or of another direction, are no rivals", "[edge-claims]")
{
  vpEdgeClaims::Claim across = claim(1, 0.F);
  across.normal = {0.F, 1.F};
  CHECK(sharesOf({claim(0, 3.F), across})[0] == exactly(1.F));
  CHECK(sharesOf({claim(0, 3.F), claim(1, 0.F, 0.F, 1.5F)})[0] == exactly(1.F));
  CHECK(sharesOf({claim(0, 3.F), claim(1, 0.F, 4.5F)})[0] == exactly(1.F)); // Half a point's length is 4.
  vpEdgeClaims::Claim other = claim(1, 0.F);
  other.normal = {-1.F, 0.F}; // Of the other side: the same direction.
  CHECK(sharesOf({claim(0, 0.F), other})[0] == Approx(0.5F));
}

TEST_CASE("Edges that go on where others end are no rivals", "[edge-claims]")
{
  // One point each, on a bend of short edges.
  std::vector<vpEdgeClaims::Claim> added;
  for (int edge = 0; edge < 8; ++edge) {
    added.push_back(claim(edge, 1.F, 3.F * static_cast<float>(edge)));
    added.back().length = 0.F;
  }
  CHECK(sharesOf(added) == std::vector<float>(added.size(), 1.F));
  // Two, at a quarter and three quarters.
  for (vpEdgeClaims::Claim &one : added) {
    one.length = 1.5F;
  }
  const std::size_t number = added.size();
  for (std::size_t i = 0; i < number; ++i) {
    added.push_back(added[i]);
    added.back().place.y() += 1.5F;
  }
  CHECK(sharesOf(added) == std::vector<float>(added.size(), 1.F));
}

TEST_CASE("Rivals are found across cells, and outside the image", "[edge-claims]")
{
  for (float shift = -200.F; shift < 40.F; shift += 0.7F) {
    std::vector<vpEdgeClaims::Claim> added = {claim(0, 1.F), claim(1, 1.F, 3.F, 0.5F)};
    for (vpEdgeClaims::Claim &one : added) {
      one.place += Eigen::Vector2f(shift, 1.3F * shift);
    }
    CHECK(sharesOf(added)[0] == Approx(0.5F));
  }
}

TEST_CASE("More edges than can be told apart leave a small share", "[edge-claims]")
{
  std::vector<vpEdgeClaims::Claim> added;
  for (int edge = 0; edge < 30; ++edge) {
    added.push_back(claim(edge, 1.F));
  }
  for (const float share : sharesOf(added)) {
    CHECK(share > 0.F);
    CHECK(share <= 1.F / 8.F);
  }
}

TEST_CASE("Of two lines beside one edge of the image, the farther one hardly pulls", "[edge-claims]")
{
  vpEdgeCue cue;
  const vpModelView view = viewOf({upright(60.), upright(64.)});
  const auto isBright = [](double from, double to) {
    return draw([=](const Eigen::Vector2d &pixel) { return pixel.x() > from && pixel.x() < to ? 150. : 50.; });
  };
  match(cue, isBright(60.5, 200.), view);
  CHECK(claimAt(cue, 60.) > 0.95);
  CHECK(claimAt(cue, 64.) < 0.05);
  vpResidualBlock block;
  cue.residuals(vpHomogeneousMatrix(), block);
  std::size_t row = 0;
  for (const vpEdgeCue::Match &match : cue.matches()) {
    if (match.count > 0) {
      const double weight = block.rows[row++].weight;
      CHECK(weight == Approx(std::max(match.claim, 0.05)));
    }
  }
  // Both are there.
  match(cue, isBright(60.5, 64.5), view);
  CHECK(claimAt(cue, 60.) > 0.95);
  CHECK(claimAt(cue, 64.) > 0.95);
}
