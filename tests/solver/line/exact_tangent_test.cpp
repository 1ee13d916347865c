// Zeros of the tangent field at exact points: against known geometry, and against enclosures in balls.
#include "line/exact_tangent.h"

#include <exsect/solver/line_patch.h>

#include "support/catch.h"
#include "support/families.h"
#include "support/random_pairs.h"
#include "sweep/traced_curves.h"
#include "trace/enclose.h"
#include "trace/pair_system.h"

namespace exsect::exact_tangent_test {
namespace {

using Ball = ArbBall<256>;

/// A flag is set if and only if the enclosure of the component at 2^-200 holds zero.
int compare_with_enclosures(const BezierPatch& x, const BezierPatch& y) {
  const PairSystem<Ball> system(x, y, {0, 0, 0}, 0);
  int zeros = 0;
  for (const Parameter p : all_parameters)
    for (const int side : {0, 1})
      for (const CertifiedPoint& point : line_points(x, y, {p, side}).points) {
        const auto exact = point.exact();
        if (!exact) continue;
        const auto zero = zero_tangent_components(x, y, *exact);
        const auto tangent = Expansion<Ball>(system, enclose<Ball>(point, power_of_two(-200))).tangent();
        for (std::size_t j = 0; j < 4; ++j) {
          CHECK((tangent[j].certain_sign() == 0) == zero[j]);
          zeros += zero[j] ? 1 : 0;
        }
      }
  return zeros;
}

}  // namespace

TEST_CASE("a circle crosses two sides at right angles", "[exact_tangent]") {
  // At (0, 1/sqrt 2) v and s turn, at (1/sqrt 2, 0) u and r; each is found on a side of both patches.
  const ExactCase c = families::quarter_circle(families::Plane::square);
  CHECK(compare_with_enclosures(c.x, c.y) == 8);
  CHECK(compare_with_enclosures(c.y, c.x) == 8);
  CHECK(compare_with_enclosures(c.x.exchanged(), c.y) == 8);
  // On the quadratic plane's lines the parameter is a root over the field of the others, if that is one of s.
  const ExactCase quadratic = families::quarter_circle(families::Plane::quadratic);
  CHECK(compare_with_enclosures(quadratic.x, quadratic.y) == 6);
  const LinePoints side = line_points(c.x, c.y, {Parameter::u, 0});
  REQUIRE(side.points.size() == 1);
  REQUIRE(side.points[0].exact());
  CHECK(zero_tangent_components(c.x, c.y, *side.points[0].exact()) == std::array{false, true, false, true});
}

TEST_CASE("zeros of the tangent agree with enclosures at random points on sides", "[exact_tangent]") {
  const std::uint64_t seed = 20261121;
  INFO("seed " << seed);
  random_pairs::Generator generator(seed);
  for (int i = 0; i < 12; ++i) {
    const auto pair = random_pairs::scattered(generator);
    compare_with_enclosures(pair.x, pair.y);
  }
}

}  // namespace exsect::exact_tangent_test
