#include "trace/landmark_tangent.h"

#include "support/ball_checks.h"
#include "support/catch.h"
#include "support/graph_patches.h"

namespace exsect::landmark_tangent_test {
namespace {

using Ball = ArbBall<256>;
using testing::Terms;

/// (u, v, h) and the plane (r, s, 0).
PairSystem<Ball> system_of(const Terms& h) {
  return {testing::graph(h), testing::plane_patch(), {0, 0, 0}, 0};
}

}  // namespace

TEST_CASE("landmark tangents: signs of T = (h_v, -h_u, h_v, -h_u)", "[trace]") {
  const Terms h = {{{1, 0}, 1}, {{0, 1}, -2}, {{0, 0}, Rational(1, 2)}};
  const Rational half(1, 2);
  const TangentSigns signs = tangent_signs(system_of(h), testing::ball_point<Ball>({half, half, half, half}));
  const std::array<int, 4> expected = {-1, -1, -1, -1};
  for (std::size_t j = 0; j < 4; ++j) {
    REQUIRE(signs[j]);
    CHECK(*signs[j] == expected[j]);
  }
}

TEST_CASE("landmark tangents: what is not certain is asked for, and only then", "[trace]") {
  // v = 1/4 + (u - 1/2)^2: T_v = 0 at u = 1/2, which no ball decides.
  const Terms square = {{{0, 0}, Rational(1, 2)}, {{1, 0}, -1}, {{2, 0}, 1}, {{0, 1}, -1}};
  const Rational half(1, 2), quarter(1, 4);
  BallPoint<Ball> at = testing::ball_point<Ball>({half, quarter, half, quarter});
  for (Ball& c : at) c = c.widened(0x1p-100);
  const PairSystem<Ball> system = system_of(square);
  int asked = 0;
  const TangentSigns known = tangent_signs(system, at, [&] {
    ++asked;
    return std::array<bool, 4>{false, true, false, true};
  });
  CHECK(asked == 1);
  CHECK(known[0] == -1);
  CHECK(known[1] == 0);
  CHECK(known[3] == 0);
  const TangentSigns unknown = tangent_signs(system, at);
  CHECK(unknown[0] == -1);
  CHECK_FALSE(unknown[1]);
  tangent_signs(system_of({{{1, 0}, 1}, {{0, 1}, -2}}), at, [&] {
    ++asked;
    return std::array<bool, 4>{};
  });
  CHECK(asked == 1);
}

TEST_CASE("landmark tangents: the bend of graphs v = f(u) and u = f(v)", "[trace]") {
  const Rational half(1, 2), quarter(1, 4);
  for (const int bend : {-3, -1, 1, 2}) {
    // h = 1/4 + bend (u - 1/2)^2 - v, and the same with u and v exchanged.
    const Rational b(bend);
    const Terms h = {{{0, 0}, quarter + b / 4}, {{1, 0}, -b}, {{2, 0}, b}, {{0, 1}, -1}};
    Terms exchanged;
    for (const auto& [i, c] : h) exchanged[{i.second, i.first}] = c;
    const auto sign = [&](const Terms& f, const std::array<Rational, 4>& w, std::size_t j) {
      return bend_sign(system_of(f), testing::ball_point<Ball>(w), j);
    };
    const int expected = bend > 0 ? 1 : -1;
    CHECK(sign(h, {half, quarter, half, quarter}, 1) == expected);
    CHECK(sign(h, {half, quarter, half, quarter}, 3) == expected);
    CHECK(sign(exchanged, {quarter, half, quarter, half}, 0) == expected);
    CHECK(sign(exchanged, {quarter, half, quarter, half}, 2) == expected);
  }
  // A straight line does not bend.
  CHECK(bend_sign(system_of({{{0, 1}, 1}, {{0, 0}, -quarter}}),
                  testing::ball_point<Ball>({half, quarter, half, quarter}), 1) == 0);
}

}  // namespace exsect::landmark_tangent_test
