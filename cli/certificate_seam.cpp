#include "certificate_seam.h"

#include <exsect/geometry/number.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "certificate_algebraic.h"

namespace exsect::cli {
namespace {

using checker::others;
using checker::Star;
/// The subdivision of a chart without a solution.
class EmptyChart {
 public:
  EmptyChart(const Map& map, std::size_t axis) : map_(map), axis_(axis) {}

  std::string entries() {
    Parameters middle{};
    Parameters half = {1, 1, 1, 1};
    middle[axis_] = half[axis_] = 0.5;
    add(middle, half, 0);
    return entries_;
  }

 private:
  void add(const Parameters& middle, const Parameters& half, int depth) {
    if (++count_ > max_entries || depth > 60) throw NotAlone();
    const std::string leaf = one_sign(map_, middle, half, axis_);
    const std::size_t parameter = leaf.empty() ? widest(middle, half) : 0;
    entries_ += (entries_.empty() ? "" : " ") + (leaf.empty() ? std::string(1, "uvrs"[parameter]) : leaf);
    if (!leaf.empty()) return;
    Parameters less = half;
    less[parameter] /= 2;
    for (const int side : {-1, 1}) {
      Parameters moved = middle;
      moved[parameter] += side * less[parameter];
      add(moved, less, depth + 1);
    }
  }

  /// The variable on which the map depends most.
  std::size_t widest(const Parameters& middle, const Parameters& half) const {
    const Map local = map_.at(middle);
    Parameters most{};
    for (std::size_t j = 0; j < 4; ++j)
      for (const auto& range : local.first(j, half)) most[j] = std::max(most[j], half[j] * range.magnitude());
    return static_cast<std::size_t>(std::max_element(most.begin(), most.end()) - most.begin());
  }

  static constexpr std::size_t max_entries = 6000;
  const Map& map_;
  std::size_t axis_;
  std::string entries_;
  std::size_t count_ = 0;
};

/// The vector c with c_axis = 0 that the derivative maps to 0, if its rank is 2, largest entry 1.
std::array<Rational, 4> kernel(const checker::Map<Rational>& local, std::size_t axis) {
  std::array<Point, 3> rows;
  for (std::size_t j = 0; j < 3; ++j) {
    const auto column = local.first(others(axis)[j], {});
    for (std::size_t d = 0; d < 3; ++d) rows[d][j] = column[d].middle;
  }
  Point c = cross(rows[0], rows[1]);
  if (is_zero(c)) c = cross(rows[0], rows[2]);
  if (is_zero(c)) c = cross(rows[1], rows[2]);
  std::size_t most = 0;
  for (std::size_t d = 1; d < 3; ++d)
    if (abs(c[d]) > abs(c[most])) most = d;
  if (is_zero(c)) throw NoCertificate("a line along which the patches are singular");
  std::array<Rational, 4> result = {};
  for (std::size_t j = 0; j < 3; ++j) result[others(axis)[j]] = c[j] / c[most];
  return result;
}

/// The map on the plane through `at` with these directions is 0.
bool is_plane_of_solutions(const checker::Map<Rational>& equation, const checker::Vector4<Rational>& at,
                           const Direction& a, const Direction& b) {
  for (int m = -2; m <= 2; ++m) {  // of degree <= 4 in either
    for (int n = -2; n <= 2; ++n) {
      checker::Vector4<Rational> w;
      for (std::size_t i = 0; i < 4; ++i) w[i] = at[i] + m * a[i] + n * b[i];
      const auto f = equation.value(w);
      if (!is_zero(Point{f[0], f[1], f[2]})) return false;
    }
  }
  return true;
}

/// Of the parameters in which neither direction is the coordinate: a seam of a line, `a` with the weight 0,
/// or of a plane. c has its largest entry for the parameter m.
Star frame(const checker::Vector4<Rational>& at, std::size_t axis, const Direction& a, std::size_t m,
           const Direction& c, bool plane, const Rational& size) {
  const std::size_t weight = plane ? 1 : 2;
  Star star = {{},        {}, {at[0], at[1], at[2], at[3]}, {}, {}, {weight, weight, weight, weight}, {},
               {1, 1, 1}, {}};
  star.weights[axis] = 0;
  star.weights[m] = plane ? 0 : 1;
  for (std::size_t i = 0; i < 4; ++i) {
    if (i != axis && i != m) star.axes[i][i] = size;
    star.axes[i][m] = c[i];
    star.axes[i][axis] = a[i];
  }
  star.coordinates = inverse(star.axes);
  for (std::size_t d = 0; d < 3; ++d) star.rows[d][d] = 1;
  return star;
}

/// The widest tube around the line in the seam.
Tube tube_in(const Star& star, std::size_t axis, double reach) {
  Tube tube = {star.of, {}, axis, {}, reach, 1, {}};
  for (std::size_t i = 0; i < 4; ++i) {
    tube.centre[i] = checker::number<double>(star.at[i]);
    tube.slope[i] = to_double(Rational(star.axes[i][axis].rational() / star.axes[axis][axis].rational()));
  }
  for (std::size_t j = 0; j < 4; ++j) {
    double sum = 0;
    for (const std::size_t i : others(axis)) sum += std::abs(checker::number<double>(star.coordinates[j][i]));
    if (sum > 0) tube.width = std::min(tube.width, 0.98 / sum);
    if (j != axis && tube.chart == Chart::star)
      tube.width = std::min(tube.width, 0.98 * (1 - std::abs(tube.centre[j])));
  }
  tube.width = std::ldexp(std::floor(std::ldexp(tube.width, 20)), -20);
  return tube;
}

}  // namespace

std::string one_sign(const Map& map, const Parameters& middle, const Parameters& half, std::size_t axis) {
  const Map local = map.at(middle);
  std::vector<Vector> normals = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, local.value(Parameters{})};
  if (const auto c = inverse(local, axis)) normals.insert(normals.end(), c->begin(), c->end());
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < i; ++j) normals.push_back(checker::cross(column(local, i), column(local, j)));
  for (const auto& normal : normals) {
    const auto n = rounded_direction(normal);
    const checker::Ball<double> range =
        checker::along({double(n[0]), double(n[1]), double(n[2])}, local, half);
    if (std::abs(range.middle) > range.radius * (1 + 1e-9) + 1e-11)
      return fmt::format("{},{},{}", n[0], n[1], n[2]);
  }
  return "";
}

std::array<Map, 8> scaled_maps(Star& star, const checker::Map<Rational>& equation) {
  const checker::Terms terms = checker::centred(equation, star);
  std::array<std::size_t, 3> orders = {100, 100, 100};
  for (const auto& [power, c] : terms) {
    std::size_t degree = 0;
    for (std::size_t j = 0; j < 4; ++j) degree += star.weights[j] * static_cast<std::size_t>(power[j]);
    for (std::size_t d = 0; d < 3; ++d)
      if (checker::dot(star.rows[d], c) != 0) orders[d] = std::min(orders[d], degree);
  }
  star.orders = orders;
  for (std::size_t& order : star.orders) {
    if (order == 0) throw NotAlone();
    if (order == 100) order = 1;  // no term at all
  }
  std::array<Map, 8> maps;
  for (int pass = 0; pass < 2; ++pass) {
    std::array<double, 3> most{};
    for (std::size_t direction = 0; direction < 8; ++direction) {
      if (star.weights[direction / 2] == 0) continue;
      maps[direction] = checker::in_direction<double>(terms, star, direction, star.rows, star.orders);
      for (const auto& term : maps[direction].terms())
        for (std::size_t d = 0; d < 3; ++d) most[d] = std::max(most[d], std::abs(term.c[d]));
    }
    for (std::size_t d = 0; pass == 0 && d < 3; ++d)
      for (checker::Algebraic& q : star.rows[d])
        q = q * checker::Algebraic(power_of_two(most[d] > 0 ? -std::ilogb(most[d]) : 0));
  }
  return maps;
}

namespace {

/// The subdivisions of all charts.
FoundSeam with_charts(Star star, const checker::Map<Rational>& equation) {
  FoundSeam result = {std::move(star), {}, {}};
  const std::array<Map, 8> maps = scaled_maps(result.claim, equation);
  for (std::size_t direction = 0; direction < 8; ++direction)
    if (result.claim.weights[direction / 2] > 0)
      result.subdivisions[direction] = EmptyChart(maps[direction], direction / 2).entries();
  return result;
}

Direction times(const Rational& factor, Direction d) {
  for (Rational& q : d) q *= factor;
  return d;
}

}  // namespace

checker::Matrix4 inverse(checker::Matrix4 m) {
  checker::Matrix4 result = {};
  for (std::size_t i = 0; i < 4; ++i) result[i][i] = 1;
  for (std::size_t i = 0; i < 4; ++i) {
    std::size_t pivot = i;
    while (pivot < 4 && m[pivot][i] == 0) ++pivot;
    if (pivot == 4) throw NoCertificate("coordinates that depend on each other");
    std::swap(m[i], m[pivot]);
    std::swap(result[i], result[pivot]);
    const checker::Algebraic factor = reciprocal(m[i][i]);
    for (std::size_t j = 0; j < 4; ++j) m[i][j] = m[i][j] * factor, result[i][j] = result[i][j] * factor;
    for (std::size_t row = 0; row < 4; ++row) {
      const checker::Algebraic times = m[row][i];
      for (std::size_t j = 0; row != i && j < 4; ++j) {
        m[row][j] = m[row][j] - times * m[i][j];
        result[row][j] = result[row][j] - times * result[i][j];
      }
    }
  }
  return result;
}

FoundSeam seam_along(const checker::Map<Rational>& equation, const checker::MapName& of,
                     const checker::OnAxis<Rational>& on, std::size_t axis, const Rational& middle,
                     const Rational& half, std::size_t index, int line) {
  Direction c = {};
  for (int n = -3; n <= 3; n += 2) {
    Direction w;
    for (std::size_t i = 0; i < 4; ++i)
      w[i] = checker::value(on[i], Rational(middle + half * Rational(n, 4)));
    const Direction here = kernel(equation.at(w), axis);
    if (n > -3 && here != c)
      throw NoCertificate("a line along which the patches touch in changing directions");
    c = here;
  }
  Direction at;
  Direction along;
  std::size_t m = others(axis)[0];
  for (std::size_t i = 0; i < 4; ++i) {
    at[i] = checker::value(on[i], middle);
    along[i] = on[i][1];
    if (abs(c[i]) > abs(c[m])) m = i;
  }
  const bool plane = of.chart == Chart::pair && is_plane_of_solutions(equation, at, along, c);
  for (int e = 1; e < 12; ++e) {
    const Rational size = power_of_two(-e);
    Star star = frame(at, axis, times(half * Rational(33, 32), along), m, times(size, c), plane, size);
    star.of = of;
    try {
      FoundSeam result = with_charts(star, equation);
      result.tube = tube_in(star, axis, to_double(half) * (1 + 1.0 / 64));
      result.tube.line = line;
      result.tube.seam = static_cast<int>(index);
      return result;
    } catch (const NotAlone&) {
    }
  }
  throw NotAlone();
}

FoundSeam seam_of_plane(const checker::Map<Rational>& equation, const Direction& at, const Direction& first,
                        const Direction& second) {
  if (!is_plane_of_solutions(equation, at, first, second))
    throw NoCertificate("an overlap of patches whose parameters do not depend on each other linearly");
  for (int e = 1; e < 12; ++e) {
    try {
      return with_charts(frame(at, 0, first, 1, second, true, power_of_two(-e)), equation);
    } catch (const NotAlone&) {
    }
  }
  throw NoCertificate("an overlap next to other solutions");
}

}  // namespace exsect::cli
