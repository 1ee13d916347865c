#include "filter/corner_branches.h"

#include <exsect/algebra/descartes.h>

#include "support/catch.h"
#include "support/power_nets.h"
#include "support/random_pairs.h"

namespace exsect::corner_branches_test {
namespace {

using filter::Bicubic;
using filter::corner_branches;
using filter::CornerNet;
using testing::power_patch;
using testing::Terms;

const Terms kNone, kMinus = {{{0, 0}, -1}}, kU = {{{1, 0}, 1}}, kV = {{{0, 1}, 1}};
const Terms kTwo = {{{0, 0}, 2}};

CornerNet net_of(const RationalPatch& patch, std::size_t corner = 0) {
  return filter::corner_net<Bicubic>(filter::elevated<Bicubic>(patch), corner, std::nullopt);
}

/// How many branches the zeros of the height have in the square, -1 where that is not proved; the same in
/// other orders of patches and parameters, and with upper ends.
int count(const Terms& height, const Terms& r = kU, const Terms& s = kV) {
  const RationalPatch x = power_patch({kU, kV, height}, 3), y = power_patch({r, s, kNone}, 3);
  const auto of = [](const CornerNet& a, const CornerNet& b) {
    const auto found = corner_branches(a, b);
    return found ? static_cast<int>(found->branches.size()) : -1;
  };
  const int result = of(net_of(x), net_of(y));
  CHECK(of(net_of(y), net_of(x)) == result);
  CHECK(of(net_of(x.transposed()), net_of(y)) == result);
  CHECK(of(net_of(x), net_of(y.transposed())) == result);
  return result;
}

Terms term(std::size_t i, std::size_t j, int c = 1) { return Terms{{{i, j}, c}}; }

}  // namespace

TEST_CASE("corner branches: cusps, lines, and points alone", "[filter]") {
  CHECK(count(term(0, 2) + term(3, 0, -1)) == 1);
  CHECK(count(term(0, 2) + term(3, 0)) == 0);
  CHECK(count(term(0, 2) + term(1, 1, -3) + term(2, 0, 2)) == 2);  // (v - u)(v - 2u)
  CHECK(count(term(0, 2) + term(1, 1, 3) + term(2, 0, 2)) == 0);   // (v + u)(v + 2u)
  CHECK(count(term(0, 2) + term(2, 0)) == 0);
  CHECK(count(term(0, 3) + term(1, 1, -3) + term(3, 0)) == 2);  // two edges
  CHECK(count(term(0, 3) + term(1, 1, 3) + term(3, 0, -1)) == 1);
  CHECK(count(term(0, 3) + term(2, 0, -1)) == 1);
}

TEST_CASE("corner branches: not where they are double, or along a side", "[filter]") {
  CHECK(count(term(0, 2) + term(1, 1, -2) + term(2, 0)) == -1);
  CHECK(count(term(0, 2) + term(1, 1, -1)) == -1);
  CHECK(count(kNone) == -1);
  // (v - u)^2 = u^3: two branches of one direction.
  CHECK(count(term(0, 2) + term(1, 1, -2) + term(2, 0) + term(3, 0, -1)) == -1);
}

TEST_CASE("corner branches: those beyond sides of the other patch are none", "[filter]") {
  const Terms line = term(1, 0) * term(1, 0) + term(0, 2, -1);  // u = v, and u = -v
  CHECK(count(line) == 1);
  CHECK(count(line, kMinus * kU) == 0);
  CHECK(count(line, kMinus * kU, kMinus * kV) == 0);
  // The cusp v^2 = u^3 is where v < u: r = u - v > 0 along it, and not its opposite.
  const Terms cusp = term(0, 2) + term(3, 0, -1);
  CHECK(count(cusp, kU + kV, kV) == 1);
  CHECK(count(cusp, kV + kMinus * kU, kV) == 0);
  // r^2 = u: in no tangent plane, where one of the patches is singular there.
  CHECK(count(term(0, 2) + term(3, 0, -1), kU * kU, kV) == 1);
}

TEST_CASE("corner branches: beside common sides", "[filter]") {
  const filter::SideAtCorner u = {{0, 2}, false}, twice_u = {{0, 2}, true}, v = {{1, 3}, false};
  const auto count_beside = [](const Terms& height, const std::vector<filter::SideAtCorner>& sides) {
    const CornerNet x = net_of(power_patch({kU, kV, height}, 3)), y = net_of(power_patch({kU, kV, kNone}, 3));
    const auto found = corner_branches(x, y, sides);
    return found ? static_cast<int>(found->branches.size()) : -1;
  };
  CHECK(count_beside(term(1, 1) + term(2, 0, -1), {u}) == 1);  // u (v - u)
  CHECK(count_beside(term(1, 1) + term(2, 0, -1), {}) == -1);
  CHECK(count_beside(term(1, 1) + term(2, 0), {u}) == 0);
  CHECK(count_beside(term(1, 2) + term(2, 1, -3) + term(3, 0, 2), {u}) == 2);
  CHECK(count_beside(term(1, 2) + term(3, 0, -1), {u}) == 1);
  CHECK(count_beside(term(2, 0), {twice_u}) == 0);
  CHECK(count_beside(term(2, 1) + term(3, 0, -1), {twice_u}) == 1);
  CHECK(count_beside(term(1, 1), {u, v}) == 0);
  CHECK(count_beside(term(1, 2) + term(2, 1, -1), {u, v}) == 1);  // u v (v - u)
  CHECK(count_beside(term(1, 2) + term(2, 1, -1), {u}) == -1);
  CHECK(count_beside(term(0, 2) + term(2, 0, -1), {u}) == -1);  // not on that side
  CHECK(count_beside(term(1, 1), {u, u}) == -1);
}

TEST_CASE("corner branches: as many as cross the sides of a square", "[filter]") {
  int proved = 0, met = 0;
  for (std::uint64_t seed = 1; seed <= 150; ++seed) {
    INFO("seed " << seed);
    random_pairs::Generator generator(seed);
    Terms height;
    for (std::size_t i = 0; i <= 3; ++i)
      for (std::size_t j = 0; j <= 3; ++j)
        if (i + j > 1 && random_pairs::integer(generator, 0, 2) > 0)
          height = height + term(i, j, static_cast<int>(random_pairs::integer(generator, -3, 3)));
    const RationalPatch x = power_patch({kU, kV, height}, 3), y = power_patch({kU, kV, kNone}, 3);
    const auto found = corner_branches(net_of(x), net_of(y));
    if (!found) continue;
    ++proved;
    // Each branch leaves the square once, through one of the two other sides.
    std::array<std::vector<Rational>, 2> on_side = {std::vector<Rational>(4), std::vector<Rational>(4)};
    for (const auto& [power, c] : height) {
      const std::array<std::size_t, 2> at = {power.first, power.second};
      for (std::size_t k = 0; k < 2; ++k) {
        Rational factor = c;
        for (std::size_t n = 0; n < at[k]; ++n) factor *= found->reach;
        on_side[k][at[1 - k]] += factor;
      }
    }
    std::size_t leaving = 0;
    for (const auto& coefficients : on_side)
      leaving += isolate_roots(Polynomial(coefficients), 0, found->reach).size();
    CHECK(found->branches.size() == leaving);
    met += leaving > 0 ? 1 : 0;
  }
  CHECK(proved >= 60);
  CHECK(met >= 20);
}

}  // namespace exsect::corner_branches_test
