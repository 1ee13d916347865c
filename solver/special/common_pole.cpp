#include "special/common_pole.h"

#include <exsect/algebra/double_matrix.h>
#include <exsect/algebra/nearest_double.h>
#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <utility>

#include "answer/parameter_box.h"
#include "special/pole_directions.h"
#include "special/remaining_squares.h"

namespace exsect {
namespace {

constexpr int kFirstLevel = 3;  // 2^3 cells of each side
constexpr std::size_t kMostPairs = 512;
const Rational kFinestWidth(1, 4);  // of cells, by the reach
const Rational kMargin(1, 4);       // of boxes, by the finest width, and of ratios, by their width
const Rational kNextStrip(4);       // of y, by the reach, and by the last one

/// What is known of a patch over an interval along its side.
struct SideCell {
  EnclosedVector d;
  DoubleBall square;  // of d
  DoubleBall bend;    // height times weight
};

/// One of two patches, near the pole: over a <= reach.
struct Blowup {
  Blowup(const RationalPatch& patch, const Point& p)
      : weight(patch.component(3)), direction(pole_directions(patch, p)) {}

  const SideCell& cell(int level, long i) {
    const auto [found, is_new] = cells.try_emplace({level, i});
    SideCell& result = found->second;
    if (!is_new) return result;
    const Rectangle on = {{0, reach}, dyadic(level, i)};
    for (std::size_t c = 0; c < 3; ++c) result.d[c] = range_on(direction[c], on);
    result.square = product(result.d, result.d);
    result.bend = range_on(height, on) * range_on(weight, on);
    return result;
  }
  static RationalInterval dyadic(int level, long i) {
    const Rational width = power_of_two(-level);
    return {i * width, (i + 1) * width};
  }

  BivariatePolynomial weight;
  PolynomialVector direction;  // D
  BivariatePolynomial height;  // G of n.D = a G, if there is a plane of all directions
  Rational reach;
  std::map<std::pair<int, long>, SideCell> cells;
};

/// (14.109), (14.110): no points a D(a,t)/w and b E(b,s)/W are equal.
bool are_apart(const SideCell& x, const SideCell& y) {
  const EnclosedVector across = cross(x.d, y.d);
  return std::ranges::any_of(across, [](const DoubleBall& f) { return f.certain_sign() != 0; }) ||
         product(x.d, y.d).certain_sign() < 0 || (x.bend * y.square - y.bend * x.square).certain_sign() != 0;
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
        reach * from_double(kSlack * range_on(x.direction[c], near).upper_magnitude()) / least_weight;
    for (const int sign : {1, -1})
      tests.push_back(z[c] * Polynomial(sign) + y.component(3) * Polynomial(-most));
  }
  for (Rational strip = kNextStrip * reach; strip < 1; strip *= kNextStrip) {
    const auto is_inside = [&](const Rectangle& square) { return square.r.upper <= strip; };
    if (remaining_squares(tests, is_inside)) return strip;
  }
  return std::nullopt;
}

bool overlap(const RationalInterval& a, const RationalInterval& b) {
  return a.lower <= b.upper && b.lower <= a.upper;
}

/// Disjoint rectangles that hold these.
std::vector<Rectangle> united_where_they_meet(const std::vector<Rectangle>& all) {
  std::vector<Rectangle> result;
  for (Rectangle next : all) {
    const auto meets = [&](const Rectangle& other) {
      return overlap(other.r, next.r) && overlap(other.s, next.s);
    };
    for (auto found = std::ranges::find_if(result, meets); found != result.end();
         found = std::ranges::find_if(result, meets)) {
      next = {hull(found->r, next.r), hull(found->s, next.s)};
      result.erase(found);
    }
    result.push_back(next);
  }
  return result;
}

/// One of (14.111): W f - c^power w g.
struct Row {
  BivariatePolynomial f, g;
  int power;
};

/// Proof of (14.108) to (14.112) near the pole.
class CommonPoleProof {
 public:
  CommonPoleProof(const RationalPatch& x, const RationalPatch& y, const Rational& reach,
                  const std::vector<Parameter>& turning)
      : first_(x, x(0, 0)),
        second_(y, x(0, 0)),
        a_(DoubleBall::enclosing(RationalInterval{0, reach})),
        turning_(turning) {
    first_.reach = reach;
    if (const auto strip = strip_of(first_, y, x(0, 0), reach)) second_.reach = *strip;
    set_rows();
  }

  std::optional<std::vector<PoleArc>> arcs() {
    if (second_.reach == 0 || !divide_all()) return std::nullopt;
    std::vector<PoleArc> result;
    for (const Rectangle& box : united_where_they_meet(left_)) {
      const auto ratio = ratio_on(box);
      if (!is_inside(box.r) || !is_inside(box.s) || !ratio) return std::nullopt;
      const Columns columns = columns_on(box, *ratio);
      if (!has_solution(box, *ratio, columns) || !all_monotone(*ratio, columns)) return std::nullopt;
      result.push_back(arc_over(box, *ratio));
    }
    return result;
  }

 private:
  /// Derivatives of (14.111) by t, s, c and a.
  struct Columns {
    EnclosedVector t, s, c, a;
  };

  static bool is_inside(const RationalInterval& t) { return t.lower > 0 && t.upper < 1; }

  void set_rows() {
    std::vector<Point> directions = directions_in_pole(first_.direction);
    std::ranges::copy(directions_in_pole(second_.direction), std::back_inserter(directions));
    const Point normal = common_normal(directions);
    std::array<Point, 3> rows = {Point{1, 0, 0}, Point{0, 1, 0}, Point{0, 0, 1}};
    if (!is_zero(normal)) rows = {normal, directions[0], cross(normal, directions[0])};
    for (std::size_t i = 0; i < 3; ++i)
      rows_[i] = {dot(rows[i], first_.direction), dot(rows[i], second_.direction), 1};
    if (is_zero(normal)) return;
    first_.height = divided_by_first(rows_[0].f);
    second_.height = divided_by_first(rows_[0].g);
    rows_[0] = {first_.height, second_.height, 2};
  }

  /// Sets rectangles of (t,s), with a margin, out of which there are no solutions.
  bool divide_all() {
    const long count = 1L << kFirstLevel;
    for (long i = 0; i < count; ++i)
      for (long j = 0; j < count; ++j)
        if (!divide(kFirstLevel, i, j)) return false;
    return true;
  }

  /// False if too many are left.
  bool divide(int level, long i, long j) {
    if (are_apart(first_.cell(level, i), second_.cell(level, j))) return true;
    const Rational finest = kFinestWidth * first_.reach;
    if (power_of_two(-level) <= finest) {
      const Rational margin = kMargin * finest;
      const RationalInterval t = Blowup::dyadic(level, i), s = Blowup::dyadic(level, j);
      left_.push_back({{t.lower - margin, t.upper + margin}, {s.lower - margin, s.upper + margin}});
      return left_.size() < kMostPairs;
    }
    for (const long k : {2 * i, 2 * i + 1})
      for (const long l : {2 * j, 2 * j + 1})
        if (!divide(level + 1, k, l)) return false;
    return true;
  }

  Rectangle on_first(const Rectangle& box) const { return {{0, first_.reach}, box.r}; }
  Rectangle on_second(const Rectangle& box) const { return {{0, second_.reach}, box.s}; }

  /// Inside of it is c = b/a = D.E W / (E.E w) of all solutions; empty if it is not proved positive and
  /// finite.
  std::optional<RationalInterval> ratio_on(const Rectangle& box) const {
    EnclosedVector d, e;
    for (std::size_t c = 0; c < 3; ++c) {
      d[c] = range_on(first_.direction[c], on_first(box));
      e[c] = range_on(second_.direction[c], on_second(box));
    }
    const DoubleBall above = product(d, e) * range_on(second_.weight, on_second(box));
    const DoubleBall below = product(e, e) * range_on(first_.weight, on_first(box));
    if (!above.is_positive() || !below.is_positive()) return std::nullopt;
    const RationalInterval p = above.interval(), q = below.interval();
    const Rational least = p.lower / q.upper, most = p.upper / q.lower, margin = kMargin * (most - least);
    if (least <= margin) return std::nullopt;
    return RationalInterval{least - margin, most + margin};
  }

  Columns columns_on(const Rectangle& box, const RationalInterval& ratio) const {
    const Rectangle x = on_first(box);
    const Rectangle y = {{0, std::min<Rational>(second_.reach, first_.reach * ratio.upper)}, box.s};
    const DoubleBall w = range_on(first_.weight, x), w_a = range_on(first_.weight.derivative_r(), x),
                     w_t = range_on(first_.weight.derivative_s(), x);
    const DoubleBall omega = range_on(second_.weight, y),
                     omega_b = range_on(second_.weight.derivative_r(), y),
                     omega_s = range_on(second_.weight.derivative_s(), y);
    const DoubleBall c = DoubleBall::enclosing(ratio);
    Columns result;
    for (std::size_t i = 0; i < 3; ++i) {
      const Row& row = rows_[i];
      const DoubleBall power = row.power == 2 ? c * c : c, power_c = row.power == 2 ? c + c : DoubleBall(1);
      const DoubleBall f = range_on(row.f, x), g = range_on(row.g, y);
      const DoubleBall by_b = omega_b * f - power * w * range_on(row.g.derivative_r(), y);
      result.t[i] = omega * range_on(row.f.derivative_s(), x) - power * w_t * g;
      result.s[i] = omega_s * f - power * w * range_on(row.g.derivative_s(), y);
      result.c[i] = a_ * by_b - power_c * w * g;
      result.a[i] = omega * range_on(row.f.derivative_r(), x) - power * w_a * g + c * by_b;
    }
    return result;
  }

  /// (14.111) for a = 0.
  EnclosedVector value_at(const Rational& t, const Rational& s, const Rational& c) const {
    EnclosedVector result;
    for (std::size_t i = 0; i < 3; ++i) {
      const Row& row = rows_[i];
      const Rational power = row.power == 2 ? Rational(c * c) : c;
      result[i] = DoubleBall::enclosing(second_.weight(0, s) * row.f(0, t) -
                                        power * first_.weight(0, t) * row.g(0, s));
    }
    return result;
  }

  /// (14.112).
  bool has_solution(const Rectangle& box, const RationalInterval& ratio, const Columns& columns) const {
    const std::array<const EnclosedVector*, 3> column = {&columns.t, &columns.s, &columns.c};
    std::array<Row3, 3> middle;
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t i = 0; i < 3; ++i) middle[k][i] = (*column[k])[i].approximation();
    const auto inverse = approximate_inverse(middle);
    if (!inverse) return false;
    const EnclosedVector value = value_at(box.r.midpoint(), box.s.midpoint(), ratio.midpoint());
    const std::array<RationalInterval, 3> sides = {box.r, box.s, ratio};
    for (std::size_t k = 0; k < 3; ++k) {
      const EnclosedVector row = {(*inverse)[k][0], (*inverse)[k][1], (*inverse)[k][2]};
      DoubleBall moved = DoubleBall(product(row, value).upper_magnitude());
      for (std::size_t j = 0; j < 3; ++j) {
        const DoubleBall off = product(row, *column[j]) - DoubleBall(k == j ? 1 : 0);
        moved += DoubleBall(off.upper_magnitude()) * DoubleBall::enclosing(sides[j].width() / 2);
      }
      if (!(DoubleBall::enclosing(sides[k].width() / 2) - moved).is_positive()) return false;
    }
    return true;
  }

  /// D depends on t alone, and E on s alone.
  bool are_cones() const {
    const auto is_constant = [](const BivariatePolynomial& f) { return f.degree_r() <= 0; };
    return std::ranges::all_of(first_.direction, is_constant) &&
           std::ranges::all_of(second_.direction, is_constant);
  }

  bool is_asked_for(std::size_t j) const { return std::ranges::count(turning_, all_parameters[j]) > 0; }

  /// By Cramer's rule, c' for b = a c; t and s are constant along rulings.
  bool all_monotone(const RationalInterval& ratio, const Columns& columns) const {
    const auto& [t, s, c, a] = columns;
    const DoubleBall whole = determinant(t, s, c);
    const DoubleBall b = DoubleBall::enclosing(ratio) * whole - a_ * determinant(t, s, a);
    const auto is_known = [&](std::size_t j, const DoubleBall& rate) {
      return !is_asked_for(j) || rate.certain_sign() != 0;
    };
    return whole.certain_sign() != 0 && is_known(2, b) &&
           (are_cones() || (is_known(1, determinant(a, s, c)) && is_known(3, determinant(t, a, c))));
  }

  PoleArc arc_over(const Rectangle& box, const RationalInterval& ratio) const {
    PoleArc result{
        box.r, {RationalInterval{0, first_.reach * ratio.upper}, box.s}, {}, Contact::transversal, {}, 0};
    add_room(result, {RationalInterval{0, 1}, RationalInterval{0, 1}});
    set_chord(result, first_.direction, first_.weight, on_first(box));
    return result;
  }

  Blowup first_, second_;
  const DoubleBall a_;
  const std::vector<Parameter>& turning_;
  std::array<Row, 3> rows_;
  std::vector<Rectangle> left_;
};

}  // namespace

bool have_common_pole(const RationalPatch& x, const RationalPatch& y) {
  return x(0, 0) == y(0, 0) && is_pole(x) && is_pole(y);
}

std::optional<std::vector<PoleArc>> arcs_at_common_pole(const RationalPatch& x, const RationalPatch& y,
                                                        const Rational& reach,
                                                        const std::vector<Parameter>& turning) {
  return CommonPoleProof(x, y, reach, turning).arcs();
}

}  // namespace exsect
