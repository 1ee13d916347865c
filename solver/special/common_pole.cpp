#include "special/common_pole.h"

#include <exsect/algebra/nearest_double.h>
#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "special/pole_directions.h"
#include "special/remaining_squares.h"

namespace exsect {
namespace {

constexpr std::array<int, 2> kCells = {8, 64};  // of each side
const Rational kNextStrip(4);                   // of y, by the reach, and by the last one

using EnclosedVector = std::array<DoubleBall, 3>;

DoubleBall product(const EnclosedVector& a, const EnclosedVector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

bool is_pole(const RationalPatch& x) {
  const PolynomialVector z = coordinates_from(x, x(0, 0));
  return std::ranges::all_of(z, [](const BivariatePolynomial& f) { return f.coefficient(0).is_zero(); });
}

/// One of two patches, near the pole.
struct Blowup {
  Blowup(const RationalPatch& patch, const Point& p)
      : weight(patch.component(3)), d(pole_directions(patch, p)) {}
  /// Sets the height over the plane, as that of the directions is 0 in the pole.
  void set_plane(const Point& normal) { height = divided_by_first(dot(normal, d)); }

  BivariatePolynomial weight;
  PolynomialVector d;
  BivariatePolynomial height;
};

/// What is known of it over an interval along the side.
struct Cell {
  EnclosedVector d;
  DoubleBall square;  // of d
  DoubleBall bend;    // height times weight
};

std::vector<Cell> cells_of(const Blowup& blowup, const Rational& reach, int count) {
  std::vector<Cell> result;
  for (int i = 0; i < count; ++i) {
    const Rectangle on = {{0, reach}, {Rational(i, count), Rational(i + 1, count)}};
    Cell& cell = result.emplace_back();
    for (std::size_t c = 0; c < 3; ++c) cell.d[c] = range_on(blowup.d[c], on);
    cell.square = product(cell.d, cell.d);
    cell.bend = range_on(blowup.height, on) * range_on(blowup.weight, on);
  }
  return result;
}

/// (14.109), (14.110): no points a D(a,t)/w and b E(b,s)/W are equal.
bool are_apart(const Cell& x, const Cell& y) {
  for (std::size_t c = 0; c < 3; ++c) {
    const std::size_t i = (c + 1) % 3, j = (c + 2) % 3;
    if ((x.d[i] * y.d[j] - x.d[j] * y.d[i]).certain_sign() != 0) return true;
  }
  return product(x.d, y.d).certain_sign() < 0 || (x.bend * y.square - y.bend * x.square).certain_sign() != 0;
}

/// (14.108): b is below it in all solutions with a <= reach; empty if no such bound below 1 is found.
std::optional<Rational> strip_of(const Blowup& x, const RationalPatch& y, const Point& p,
                                 const Rational& reach) {
  std::vector<BivariatePolynomial> tests;
  const PolynomialVector z = coordinates_from(y, p);
  const Rectangle near = {{0, reach}, {0, 1}};
  const Rational least_weight = range_bound(x.weight, near).lower;
  if (least_weight <= 0) return std::nullopt;
  for (std::size_t c = 0; c < 3; ++c) {
    const Rational most =
        reach * from_double(kSlack * range_on(x.d[c], near).upper_magnitude()) / least_weight;
    for (const int sign : {1, -1})
      tests.push_back(z[c] * Polynomial(sign) + y.component(3) * Polynomial(-most));
  }
  for (Rational strip = kNextStrip * reach; strip < 1; strip *= kNextStrip) {
    const auto is_inside = [&](const Rectangle& square) { return square.r.upper <= strip; };
    if (remaining_squares(tests, is_inside)) return strip;
  }
  return std::nullopt;
}

}  // namespace

bool have_common_pole(const RationalPatch& x, const RationalPatch& y) {
  return x(0, 0) == y(0, 0) && is_pole(x) && is_pole(y);
}

bool meet_in_pole_alone(const RationalPatch& x, const RationalPatch& y, const Rational& reach) {
  const Point p = x(0, 0);
  Blowup first(x, p), second(y, p);
  const auto strip = strip_of(first, y, p, reach);
  if (!strip) return false;
  std::vector<Point> directions = directions_in_pole(first.d);
  std::ranges::copy(directions_in_pole(second.d), std::back_inserter(directions));
  const Point normal = common_normal(directions);
  if (!is_zero(normal)) {
    first.set_plane(normal);
    second.set_plane(normal);
  }
  for (const int count : kCells) {
    const std::vector<Cell> of_x = cells_of(first, reach, count), of_y = cells_of(second, *strip, count);
    const bool all_apart = std::ranges::all_of(of_x, [&](const Cell& a) {
      return std::ranges::all_of(of_y, [&](const Cell& b) { return are_apart(a, b); });
    });
    if (all_apart) return true;
  }
  return false;
}

}  // namespace exsect
