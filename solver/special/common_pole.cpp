#include "special/common_pole.h"

#include <exsect/algebra/nearest_double.h>
#include <exsect/algebra/rounding_bounds.h>
#include <exsect/geometry/vector_algebra.h>

#include <algorithm>
#include <array>
#include <utility>

#include "answer/parameter_box.h"
#include "special/common_ray.h"
#include "special/pole_blowup.h"
#include "special/ray_equations.h"
#include "special/remaining_squares.h"

namespace exsect {
namespace {

constexpr int kFirstLevel = 4;  // 2^4 cells of each side, and one beyond each end
constexpr std::size_t kMostPairs = 512;
const Rational kFinestWidth(1, 4);  // of cells, by the reach
const Rational kMargin(1, 4);       // of boxes, by the finest width
const Rational kNextStrip(4);       // of y, by the reach, and by the last one

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

/// The value of b after a, along a ray.
Rational ratio_at(const CommonRay& ray, const Rational& a) { return ray.ratio / (1 + ray.bend * a); }

/// Proof of (14.108) to (14.112) near the pole.
class CommonPoleProof {
 public:
  CommonPoleProof(const RationalPatch& x, const RationalPatch& y, const Rational& reach,
                  const std::vector<Parameter>& turning)
      : x_(x),
        y_(y),
        first_(x, x(0, 0)),
        second_(y, x(0, 0)),
        equations_(first_, second_),
        turning_(turning) {
    first_.reach = reach;
    if (const auto strip = strip_of(first_, y, x(0, 0), reach)) second_.reach = *strip;
  }

  std::optional<std::vector<PoleArc>> arcs() {
    if (second_.reach == 0 || !divide_all()) return std::nullopt;
    std::vector<PoleArc> result;
    for (const Rectangle& box : united_where_they_meet(left_)) {
      if (is_outside(box.r) || is_outside(box.s)) continue;
      const auto found = arc_in(box);
      if (!found) return std::nullopt;
      if (*found) result.push_back(**found);
    }
    return result;
  }

 private:
  /// How an arc lies at an end of a side: 1, inside but for the pole; -1, outside; 0, not known.
  static constexpr int kOutside = -1;

  static bool is_outside(const RationalInterval& t) { return t.upper < 0 || t.lower > 1; }
  /// The end of [0,1] that the interval reaches beyond.
  static std::optional<Rational> end_in(const RationalInterval& t) {
    if (t.lower > 0 && t.upper < 1) return std::nullopt;
    return Rational(t.lower <= 0 ? 0 : 1);
  }

  /// The one arc over the box, or none; empty if that is not known.
  std::optional<std::optional<PoleArc>> arc_in(const Rectangle& box) {
    const auto ratio = equations_.ratio_on(box);
    if (!ratio || !is_within(box.r, first_) || !is_within(box.s, second_)) return std::nullopt;
    const RayColumns columns = equations_.columns_on(box, *ratio);
    const bool is_simple = determinant_over(columns.t, columns.s, columns.c).certain_sign() != 0;
    if (const auto ray = ray_in(box, *ratio)) {
      if (!is_simple && !(ray->is_contact && equations_.isolates_contact(box, *ratio, columns)))
        return std::nullopt;
      PoleArc arc =
          arc_over(box, *ratio, sides_of(*ray), ray->is_contact ? Contact::tangential : Contact::transversal);
      arc.ray = {ray->t, {{{0, ray->ratio}, {ray->s, ray->s * ray->bend}}}, ray->bend};
      return arc;
    }
    if (!is_simple || !equations_.has_solution(box, *ratio, columns)) return std::nullopt;
    const int place = place_at_ends(box, *ratio, columns);
    if (place == kOutside) return std::optional<PoleArc>();
    if (place == 0 || !all_monotone(*ratio, columns)) return std::nullopt;
    return arc_over(box, *ratio, {}, Contact::transversal);
  }

  /// The box is inside of what was divided.
  static bool is_within(const RationalInterval& t, const Blowup& patch) {
    return t.lower > patch.along.lower && t.upper < patch.along.upper;
  }

  /// Lines of simple numbers in the box that are one curve, of which c stays in the ratios (14.140).
  std::optional<CommonRay> ray_in(const Rectangle& box, const RationalInterval& ratio) const {
    const Rational t = simplest_between(box.r.lower, box.r.upper);
    const Rational s = simplest_between(box.s.lower, box.s.upper);
    const auto ray = common_ray(x_, y_, t, s);
    const auto holds = [&](const Rational& c) { return ratio.lower < c && c < ratio.upper; };
    if (!ray || 1 + ray->bend * first_.reach <= 0) return std::nullopt;
    return holds(ray->ratio) && holds(ratio_at(*ray, first_.reach)) ? ray : std::nullopt;
  }

  static std::vector<Side> sides_of(const CommonRay& ray) {
    std::vector<Side> on;
    for (const auto& [parameter, at] : {std::pair(Parameter::v, ray.t), std::pair(Parameter::s, ray.s)})
      if (at == 0 || at == 1) on.push_back({parameter, at == 0 ? 0 : 1});
    return on;
  }

  /// (14.142): 1: all of the arc has t and s in (0,1), but for the pole.
  int place_at_ends(const Rectangle& box, const RationalInterval& ratio, const RayColumns& columns) const {
    const auto t = end_in(box.r), s = end_in(box.s);
    if (!t && !s) return 1;
    if (first_.reach * ratio.upper > second_.reach || !equations_.begins_at(t, s, box)) return 0;
    const int whole = determinant_over(columns.t, columns.s, columns.c).certain_sign();
    const auto inwards = [&](const std::optional<Rational>& end, const DoubleBall& rate) {
      const int sign = -whole * rate.certain_sign();
      return !end ? 1 : *end == 0 ? sign : -sign;
    };
    const int of_t = inwards(t, determinant_over(columns.a, columns.s, columns.c));
    const int of_s = inwards(s, determinant_over(columns.t, columns.a, columns.c));
    return std::min(of_t, of_s);
  }

  /// Sets rectangles of (t,s), with a margin, out of which there are no solutions.
  bool divide_all() {
    const long count = 1L << kFirstLevel;
    const auto set_range = [&](Blowup& patch) {
      const long begin = patch.reaches_to(kFirstLevel, -1) ? -1 : 0;
      const long end = patch.reaches_to(kFirstLevel, count) ? count + 1 : count;
      patch.along = {Blowup::dyadic(kFirstLevel, begin).lower, Blowup::dyadic(kFirstLevel, end).lower};
      return std::pair(begin, end);
    };
    const auto [first_begin, first_end] = set_range(first_);
    const auto [second_begin, second_end] = set_range(second_);
    for (long i = first_begin; i < first_end; ++i)
      for (long j = second_begin; j < second_end; ++j)
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

  /// D depends on t alone, and E on s alone.
  bool are_cones() const {
    const auto is_constant = [](const BivariatePolynomial& f) { return f.degree_r() <= 0; };
    return std::ranges::all_of(first_.direction, is_constant) &&
           std::ranges::all_of(second_.direction, is_constant);
  }

  bool is_asked_for(std::size_t j) const { return std::ranges::count(turning_, all_parameters[j]) > 0; }

  /// By Cramer's rule, c' for b = a c; t and s are constant along rulings.
  bool all_monotone(const RationalInterval& ratio, const RayColumns& columns) const {
    const auto& [t, s, c, a] = columns;
    const DoubleBall whole = determinant_over(t, s, c), all_a = DoubleBall::enclosing({0, first_.reach});
    const DoubleBall b = DoubleBall::enclosing(ratio) * whole - all_a * determinant_over(t, s, a);
    const auto is_known = [&](std::size_t j, const DoubleBall& rate) {
      return !is_asked_for(j) || rate.certain_sign() != 0;
    };
    return is_known(2, b) && (are_cones() || (is_known(1, determinant_over(a, s, c)) &&
                                              is_known(3, determinant_over(t, a, c))));
  }

  PoleArc arc_over(const Rectangle& box, const RationalInterval& ratio, std::vector<Side> on,
                   Contact contact) const {
    PoleArc result{
        box.r, {RationalInterval{0, first_.reach * ratio.upper}, box.s}, std::move(on), contact, {}, 0};
    add_room(result, {RationalInterval{0, 1}, RationalInterval{0, 1}});
    set_chord(result, first_.direction, first_.weight, first_.over(box.r));
    return result;
  }

  const RationalPatch &x_, &y_;
  Blowup first_, second_;
  const RayEquations equations_;
  const std::vector<Parameter>& turning_;
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
