#include "trace/tangential_enclosure.h"

#include <cmath>

#include "support/bent_contact.h"
#include "support/catch.h"

namespace exsect::tangential_enclosure_test {
namespace {

using System = PairSystem<DoubleBall>;
using Point4 = BallPoint<DoubleBall>;

}  // namespace

TEST_CASE("tangential enclosure: second derivatives along a contact curve are bounded", "[trace]") {
  // (u v + v - 1/2)² touches the plane along v = 1/(2 (1 + u)).
  ControlNet net{};
  net[1][0] = {1, 0, 0};
  net[0][1] = {0, 1, 0};
  const Rational half(1, 2);
  const std::array<std::array<Rational, 3>, 3> h = {{{half * half, -1, 1}, {0, -1, 2}, {0, 0, 1}}};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) net[i][j][2] = h[i][j];
  ControlNet flat{};
  flat[1][0] = {1, 0, 0};
  flat[0][1] = {0, 1, 0};
  const System system(BezierPatch::from_power_basis(net), BezierPatch::from_power_basis(flat), {0, 0, 0}, 0);
  const auto v_at = [](double u) { return 1 / (2 * (1 + u)); };
  const auto tube = certify_tangential_tube(system, {0.5, v_at(0.5), 0.5, v_at(0.5)}, 0x1p-5, 0);
  REQUIRE(tube);
  for (const auto& [from, to] :
       {std::pair(-0x1p-5, 0x1p-5), std::pair(0.0, 0x1p-7), std::pair(0x1p-6, 0x1p-6)}) {
    const double bound = second_derivative_bound(system, *tube, from, to);
    const double largest = 1 / std::pow(1.5 + from, 3);  // of v''
    CHECK(bound >= largest * (1 - 1e-12));
    CHECK(bound <= largest * (from == to ? 1 + 1e-9 : 2));
  }
}

TEST_CASE("tangential enclosure: points and directions of a bent contact, by its formula", "[trace]") {
  const testing::BentContact contact;
  int checked = 0;
  for (const auto& piece : contact.traced().pieces) {
    for (const auto& [a, b] : {std::pair(0.0, 1.0), std::pair(0.3, 0.4), std::pair(0.5, 0.5)}) {
      const double first = piece.range.at(a), last = piece.range.at(b);
      const auto all = enclosure_between(contact.system, piece.tube, first, last);
      for (const double tau : {first, 0.5 * (first + last), last}) {
        const std::size_t k = piece.tube.axis;
        if (k == 2) continue;  // u is no rational function of r
        ++checked;
        const Rational u = piece.tube.centre[k].interval().lower + from_double(tau);
        const auto at = testing::BentContact::at(u);
        for (std::size_t j = 0; j < 4; ++j) CHECK(testing::encloses(all.at[j].widened(1e-15), at[j]));
        CHECK(testing::encloses(all.slope[2].widened(1e-15), 1 - 4 * (u - Rational(1, 2))));
      }
      // What is enclosed is not much wider than the arc: r' changes by 4 over u.
      CHECK(all.slope[2].radius() <= 4 * std::fabs(last - first) + 1e-9);
    }
  }
  CHECK(checked > 9);
}

}  // namespace exsect::tangential_enclosure_test
