// Tubes around curves along which patches touch: against exact solutions, and the equations by evaluation.
#include "trace/tangential_tube.h"

#include "support/catch.h"
#include "support/families.h"
#include "support/random_pairs.h"
#include "trace/contact_expansion.h"
#include "trace/tangential_enclosure.h"
#include "trace/tube_points.h"

namespace exsect::tangential_tube_test {
namespace {

using System = PairSystem<DoubleBall>;
using Point4 = BallPoint<DoubleBall>;

System system_of(const ExactCase& c) { return {c.x, c.y, {0, 0, 0}, 0}; }

bool holds(const DoubleBall& ball, double value) { return (ball - DoubleBall(value)).lower_magnitude() == 0; }

/// (u - v/3 - 1/4)^2 over (u,v) touches (r,s,0) at u = r = v/3 + 1/4.
Point4 on_line(double v) { return {v / 3 + 0.25, v, v / 3 + 0.25, v}; }

}  // namespace

TEST_CASE("contact equations are Taylor polynomials of F and T", "[tangential_tube]") {
  const std::uint64_t seed = 31;
  INFO("seed " << seed);
  random_pairs::Generator generator(seed);
  const auto pair = random_pairs::small_rationals(generator);
  const System system(pair.x, pair.y, {0, 0, 0}, 0);
  const Point4 p = {0.3, 0.6, 0.45, 0.2};
  const std::array<double, 4> step = {0.01, -0.02, 0.015, 0.03};
  Point4 moved;
  for (std::size_t j = 0; j < 4; ++j) moved[j] = p[j] + DoubleBall(step[j]);
  const Expansion<DoubleBall> there(system, moved);
  for (std::size_t axis = 0; axis < 4; ++axis) {
    const auto phi = contact_equations(Expansion<DoubleBall>(system, p), {0, 2}, axis);
    const std::array<DoubleBall, 3> expected = {there.value()[0], there.value()[2], there.tangent()[axis]};
    for (std::size_t row = 0; row < 3; ++row) {
      DoubleBall sum;
      phi.for_each_term([&](const std::array<std::size_t, 4>& e, const BallVector<DoubleBall>& c) {
        DoubleBall term = c[row];
        for (std::size_t v = 0; v < 4; ++v)
          for (std::size_t n = 0; n < e[v]; ++n) term *= DoubleBall(step[v]);
        sum += term;
      });
      INFO("axis " << axis << ", row " << row);
      CHECK((sum - expected[row]).lower_magnitude() == 0);
      CHECK(sum.radius() < 1e-12);
    }
  }
}

TEST_CASE("a tangential tube holds the contact curve", "[tangential_tube]") {
  const System system = system_of(families::tangent_curve(Rational(1, 3), families::Plane::square));
  const auto tube = certify_tangential_tube(system, on_line(0.5), 0.125);
  REQUIRE(tube);
  CHECK(tube->contraction <= 0.5);
  CHECK(tube->core > 0.01);
  for (const double tau : {-0.12, -0.03, 0.0, 0.1}) {
    const Point4 expected = on_line(tube->axis % 2 == 1 ? 0.5 + tau : 0.5 + 3 * tau);
    const Point4 w = point_at(system, *tube, tau);
    CHECK(contains(*tube, expected));
    CHECK_FALSE(excludes(*tube, expected));
    for (std::size_t j = 0; j < 4; ++j) {
      CHECK(holds(w[j], expected[j].approximation()));
      CHECK(w[j].radius() < 1e-12);
    }
    const auto all = enclosure_between(system, *tube, -0.125, 0.125);
    for (std::size_t j = 0; j < 4; ++j) {
      CHECK(holds(all.at[j], expected[j].approximation()));
      CHECK(holds(all.slope[j], tube->slope[j]));
    }
  }
  CHECK(excludes(*tube, on_line(0.9)));
  CHECK(excludes(*tube, Point4{0.9, 0.5, 0.4, 0.5}));
  CHECK_FALSE(contains(*tube, Point4{DoubleBall(0.41, 0.3), 0.5, 0.41, 0.5}));
}

TEST_CASE("no tangential tube beside a contact; in a node F does not vanish on it", "[tangential_tube]") {
  const System crossing = system_of(families::crossing(families::Plane::square));
  CHECK_FALSE(certify_tangential_tube(crossing, Point4{0.75, 0.75, 0.75, 0.75}, 0x1p-10));
  const auto node = certify_tangential_tube(crossing, Point4{0.5, 0.5, 0.5, 0.5}, 0x1p-10);
  REQUIRE(node);
  const Point4 w = point_at(crossing, *node, 0x1p-11);
  CHECK(Expansion<DoubleBall>(crossing, w).value()[2].certain_sign() != 0);
  const System line = system_of(families::tangent_curve(Rational(1, 3), families::Plane::square));
  Point4 beside = on_line(0.5);
  beside[0] = beside[0] + DoubleBall(0.1);
  beside[2] = beside[0];
  CHECK_FALSE(certify_tangential_tube(line, beside, 0x1p-6));
}

}  // namespace exsect::tangential_tube_test
