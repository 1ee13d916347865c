// Lines on patches with control points on a tiny grid, where every kind of coincidence occurs: exchanging the
// patches, exchanging or reversing parameters must rename the answer, and the parts on the patch are those a
// search in doubles sees.
#include <exsect/solver/line_patch.h>

#include <algorithm>
#include <array>
#include <random>
#include <vector>

#include "line_shapes.h"
#include "point_checks.h"
#include "support/catch.h"

namespace exsect::line_symmetry_test {

namespace {

/// Where the parameter of the other answer is found, and whether it is reversed there.
struct Renaming {
  std::array<std::size_t, 4> parameter;
  std::array<bool, 4> reversed;
};

ParameterBox renamed(const ParameterBox& box, const Renaming& names) {
  ParameterBox result;
  for (std::size_t i = 0; i < 4; ++i) {
    const RationalInterval& from = box[names.parameter[i]];
    result[i] = names.reversed[i] ? RationalInterval{1 - from.upper, 1 - from.lower} : from;
  }
  return result;
}

bool have_common_point(const ParameterBox& a, const ParameterBox& b) {
  for (std::size_t i = 0; i < 4; ++i)
    if (a[i].upper < b[i].lower || b[i].upper < a[i].lower) return false;
  return true;
}

void check_renamed(const LinePoints& a, const LinePoints& b, const Renaming& names) {
  CHECK(!b.incomplete);
  REQUIRE(a.points.size() == b.points.size());
  for (const CertifiedPoint& p : a.points)
    CHECK(std::ranges::count_if(b.points, [&](const CertifiedPoint& q) {
            return have_common_point(p.box(), renamed(q.box(), names)) &&
                   p.sides().size() == q.sides().size() && (p.multiplicity() == 1) == (q.multiplicity() == 1);
          }) == 1);
  REQUIRE(a.on_patch.size() == b.on_patch.size());
  const bool reversed = names.reversed[1];
  for (std::size_t i = 0; i < a.on_patch.size(); ++i) {
    const AlgebraicInterval& p = a.on_patch[i];
    const AlgebraicInterval& q = b.on_patch[reversed ? b.on_patch.size() - 1 - i : i];
    if (reversed) {
      CHECK(p.from.to_double() == Approx(1 - q.to.to_double()).margin(1e-14));
      CHECK(p.to.to_double() == Approx(1 - q.from.to_double()).margin(1e-14));
    } else {
      CHECK((p.from == q.from && p.to == q.to));
    }
  }
}

using DoubleNet = std::array<std::array<std::array<double, 3>, 3>, 3>;

DoubleNet half(const DoubleNet& n, bool upper, bool rows) {
  DoubleNet h = n;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto at = [&](std::size_t j) -> double { return rows ? n[j][i][k] : n[i][j][k]; };
      const double a = (at(0) + at(1)) / 2;
      const double b = (at(1) + at(2)) / 2;
      const std::array<double, 3> part =
          upper ? std::array{(a + b) / 2, b, at(2)} : std::array{at(0), a, (a + b) / 2};
      for (std::size_t j = 0; j < 3; ++j) (rows ? h[j][i] : h[i][j])[k] = part[j];
    }
  return h;
}

/// Whether a piece of the patch of side 2^-depth has the point in its bounding box.
bool near_patch(const DoubleNet& n, const std::array<double, 3>& p, int depth) {
  for (std::size_t k = 0; k < 3; ++k) {
    double low = 1e9;
    double high = -1e9;
    for (const auto& row : n)
      for (const auto& q : row) low = std::min(low, q[k]), high = std::max(high, q[k]);
    if (p[k] < low - 1e-12 || p[k] > high + 1e-12) return false;
  }
  if (depth == 0) return true;
  for (int i = 0; i < 4; ++i)
    if (near_patch(half(half(n, (i & 1) != 0, true), (i & 2) != 0, false), p, depth - 1)) return true;
  return false;
}

void check_on_patch(const BezierPatch& x, const BezierPatch& y, const Rational& u, const LinePoints& found) {
  DoubleNet net;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t k = 0; k < 3; ++k) net[i][j][k] = to_double(y.net()[i][j][k]);
  for (int i = 0; i <= 16; ++i) {
    const Rational v(2 * i + 1, 35);
    const Point p = x(u, v);
    const bool expected = std::ranges::any_of(found.on_patch, [&](const AlgebraicInterval& a) {
      return a.from.compare(v) <= 0 && a.to.compare(v) >= 0;
    });
    const bool isolated = std::ranges::any_of(found.points, [&](const CertifiedPoint& q) {
      return abs(q.box()[1].midpoint() - v) < power_of_two(-40);
    });
    INFO("v = " << v);
    if (!isolated)
      CHECK(near_patch(net, {to_double(p[0]), to_double(p[1]), to_double(p[2])}, 16) == expected);
  }
}

}  // namespace

TEST_CASE("lines full of coincidences keep the symmetries") {
  const int range = GENERATE(1, 2);
  const int height = GENERATE(0, 1);
  std::size_t intervals = 0;
  std::size_t points = 0;
  for (unsigned seed = 100; seed < 118; ++seed) {
    INFO("range " << range << ", height " << height << ", seed " << seed);
    std::mt19937 random(seed);
    const auto [x, y] = grid_pair(random, range, height);
    const Rational u(seed % 3 == 0 ? 1 : 0, 2);
    const LinePoints found = line_points(x, y, {Parameter::u, u});
    for (const CertifiedPoint& p : found.points) check_point(x, y, p);
    check_on_patch(x, y, u, found);
    check_renamed(found, line_points(x, y.exchanged(), {Parameter::u, u}), {{0, 1, 3, 2}, {}});
    check_renamed(found, line_points(x, y.reversed_first(), {Parameter::u, u}),
                  {{0, 1, 2, 3}, {false, false, true}});
    check_renamed(found, line_points(x, y.reversed_second(), {Parameter::u, u}),
                  {{0, 1, 2, 3}, {false, false, false, true}});
    check_renamed(found, line_points(x.reversed_second(), y, {Parameter::u, u}),
                  {{0, 1, 2, 3}, {false, true}});
    check_renamed(found, line_points(y, x.exchanged(), {Parameter::s, u}), {{3, 2, 0, 1}, {}});
    intervals += found.on_patch.size();
    points += found.points.size();
  }
  CHECK(intervals + points > 10);
}

}  // namespace exsect::line_symmetry_test
