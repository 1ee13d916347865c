#include "self/star_centres.h"

#include <exsect/algebra/algebraic_value.h>
#include <exsect/solver/line_query.h>

#include <algorithm>
#include <memory>
#include <utility>

#include "answer/exact_source.h"
#include "answer/parameter_box.h"
#include "line/exact_line_points.h"
#include "line/known_tangent.h"
#include "self/singular_pairs.h"
#include "shape/fold_expansion.h"
#include "shape/special_cusps.h"

namespace exsect {
namespace {

/// Of the polynomial of a value over which singular pairs are looked for.
constexpr int kLargestDegree = 8;

/// Singular points may be this far from where a trace came to an end.
Rational nearness() { return power_of_two(-5); }

std::vector<Side> sides_at(const std::array<RealAlgebraic, 4>& value) {
  std::vector<Side> sides;
  for (const Parameter p : all_parameters)
    for (const int end : {0, 1})
      if (value[index(p)].compare(end) == 0) sides.push_back({p, end});
  return sides;
}

class AlgebraicPair : public CertifiedPoint::Source {
 public:
  explicit AlgebraicPair(std::array<RealAlgebraic, 4> value) : value_(std::move(value)) {}

  ParameterBox box(const Rational& width) const override {
    ParameterBox result;
    for (std::size_t j = 0; j < 4; ++j) result[j] = value_[j].refined_to(width).interval();
    return result;
  }

 private:
  std::array<RealAlgebraic, 4> value_;
};

bool may_be(const ParameterBox& box, const std::array<RealAlgebraic, 4>& value) {
  for (std::size_t j = 0; j < 4; ++j)
    if (value[j].compare(box[j].lower) < 0 || value[j].compare(box[j].upper) > 0) return false;
  return true;
}

/// All of them, narrow enough to be told from the ends of most boxes.
std::vector<TriangularPoint> pairs_over(const BivariatePolynomial& projection, const RealAlgebraic& value) {
  std::vector<TriangularPoint> points = roots_at(projection, value, 0, 1);
  for (TriangularPoint& point : points) point = point.refined_to(power_of_two(-40));
  return points;
}

class CentreSearch {
 public:
  CentreSearch(const BezierPatch& x, const std::vector<CertifiedPoint>& boundary,
               const std::vector<ParameterBox>& where, const SelfValues& values)
      : x_(x), exchanged_(x.exchanged()), boundary_(boundary), where_(where), values_(values) {}

  std::vector<SelfCentre> run() {
    add_cuspidal();
    for (const std::size_t fixed : {0, 1}) add_on_folded_lines(fixed);
    for (const CertifiedPoint& point : boundary_)
      if (is_near(point.box()) && lies_in_a_side(point)) add_rational(point);
    for (const std::size_t sweep : {0, 1}) add_multiple(sweep);
    for (const std::size_t sweep : {0, 1}) add_algebraic(sweep);
    return std::move(centres_);
  }

 private:
  bool is_near(const ParameterBox& box) const {
    ParameterBox wide = box;
    for (RationalInterval& range : wide) range = {range.lower - nearness(), range.upper + nearness()};
    const ParameterBox exchanged = {wide[2], wide[3], wide[0], wide[1]};
    return std::ranges::any_of(
        where_, [&](const ParameterBox& place) { return meet(wide, place) || meet(exchanged, place); });
  }

  static std::vector<Rational> rational(const std::optional<std::vector<RealAlgebraic>>& values) {
    std::vector<Rational> result;
    if (values)
      for (const RealAlgebraic& value : *values)
        if (value.is_rational()) result.push_back(value.rational());
    return result;
  }

  void add_cuspidal() {
    for (const Rational& u : rational(values_.cuspidal[0]))
      for (const Rational& v : rational(values_.cuspidal[1])) {
        if (!is_zero(cross(x_.derivative_first(u, v), x_.derivative_second(u, v)))) continue;
        const std::array<RealAlgebraic, 4> value = {u, v, u, v};
        const CertifiedPoint point = certified_pair(value);
        if (is_near(point.box())) centres_.push_back({point, value, true, {0, 1}, {}, {}});
      }
  }

  /// The line u = c (fixed: 0) or v = c; along it the pairs t, 2 turn - t.
  void add_on_folded_lines(std::size_t fixed) {
    const BezierPatch lines = fixed == 0 ? x_.exchanged() : x_;  // the line is v = c of these
    for (const FoldedLine& line : folded_lines(lines)) {
      const auto place = rational_turn(line);
      if (!place) continue;
      const auto& [turn, c] = *place;
      const auto fold = fold_expansion(lines, turn, c);
      if (!fold) continue;
      const Polynomial contact = fold->contact.compose(Polynomial{turn * turn, -2 * turn, 1});
      for (const RealAlgebraic& t : real_roots(contact, turn, std::min<Rational>(1, 2 * turn)))
        if (t.compare(turn) != 0) add_on_folded_line(fixed, c, turn, t);
    }
  }

  void add_on_folded_line(std::size_t fixed, const Rational& c, const Rational& turn,
                          const RealAlgebraic& t) {
    const std::size_t along = 1 - fixed;
    const TriangularPoint at(t, BivariatePolynomial::r() - BivariatePolynomial::constant(c), {c, c});
    const BivariatePolynomial other = BivariatePolynomial::constant(2 * turn) - BivariatePolynomial::s();
    std::array<RealAlgebraic, 4> value = {c, c, c, c};
    value[along] = t;
    value[along + 2] = t.is_rational() ? RealAlgebraic(2 * turn - t.rational()) : value_at(other, at);
    const CertifiedPoint point = certified_pair(value);
    if (!is_near(point.box())) return;
    SelfCentre centre = {point, value, false, {along}, landmark(value), {}};
    if (!t.is_rational()) {
      const SelfProjection projection = self_projection(fixed == 0 ? x_ : x_.exchanged());
      const bool alone = std::ranges::any_of(projection.minors, [&](const BivariatePolynomial& minor) {
        return sign_at(minor.at_r(c), t) != 0;
      });
      if (!alone || reduced_at(projection.curve, t).is_zero()) return;
      centre.over_value = pairs_over(projection.curve, t);
    }
    centres_.push_back(std::move(centre));
  }

  /// The tangent field lies in one of the point's sides.
  bool lies_in_a_side(const CertifiedPoint& point) const {
    const std::array<bool, 4> zero = known_zero_tangent(x_, x_, point);
    return std::ranges::any_of(point.sides(), [&](const Side& side) { return zero[index(side.parameter)]; });
  }

  void add_rational(const CertifiedPoint& point) {
    const auto exact = rational_solution(x_, x_, point);
    if (!exact || ((*exact)[0] == (*exact)[2] && (*exact)[1] == (*exact)[3])) return;
    const std::array<RealAlgebraic, 4> value = {(*exact)[0], (*exact)[1], (*exact)[2], (*exact)[3]};
    const bool known = std::ranges::any_of(centres_, [&](const SelfCentre& c) { return c.value == value; });
    if (!known) centres_.push_back({certified_pair(value), value, false, {0, 1}, landmark(value), {}});
  }

  void add_multiple(std::size_t sweep) {
    for (const Rational& value : rational(values_.turning[sweep])) {
      const LinePoints line = exact_line_points(x_, x_, {static_cast<Parameter>(sweep), value});
      for (const CertifiedPoint& point : line.points) {
        if (point.multiplicity() == 1 || !is_near(point.box())) continue;
        if (is_known_singular(x_, x_, point)) add_rational(point);
      }
    }
  }

  /// Singular pairs over irrational values.
  void add_algebraic(std::size_t sweep) {
    if (!values_.turning[sweep]) return;
    const BezierPatch& owner = sweep == 1 ? x_ : exchanged_;
    std::optional<SelfProjection> projection;
    for (const RealAlgebraic& value : *values_.turning[sweep]) {
      if (value.is_rational() || value.polynomial().degree() > kLargestDegree || !is_near(value, sweep))
        continue;
      if (!projection) projection = self_projection(owner);
      for (ExactParameters& pair : singular_pairs_over(owner, *projection, value)) {
        if (sweep == 0)
          for (auto* list : {&pair.numerator, &pair.denominator}) {
            std::swap((*list)[0], (*list)[1]);
            std::swap((*list)[2], (*list)[3]);
          }
        add_algebraic(sweep, std::move(pair), projection->curve);
      }
    }
  }

  bool is_near(const RealAlgebraic& value, std::size_t parameter) const {
    const RationalInterval at = value.interval();
    return std::ranges::any_of(where_, [&](const ParameterBox& place) {
      return std::ranges::any_of(std::array{parameter, parameter + 2}, [&](std::size_t j) {
        return at.lower <= place[j].upper + nearness() && place[j].lower - nearness() <= at.upper;
      });
    });
  }

  void add_algebraic(std::size_t sweep, ExactParameters pair, const BivariatePolynomial& projection) {
    std::array<RealAlgebraic, 4> value = {0, 0, 0, 0};
    for (std::size_t j = 0; j < 4; ++j) {
      const auto& known = values_.turning[j % 2];
      if (!known) return;
      const auto own = std::ranges::find_if(
          *known, [&](const RealAlgebraic& candidate) { return has_value(pair, j, candidate); });
      if (own == known->end()) return;
      value[j] = *own;
    }
    const CertifiedPoint point = certified(std::move(pair), sides_at(value));
    if (is_near(point.box()))
      centres_.push_back(
          {point, value, false, {sweep}, landmark(value), pairs_over(projection, value[sweep])});
  }

  std::optional<std::size_t> landmark(const std::array<RealAlgebraic, 4>& value) const {
    return boundary_point(boundary_, value);
  }

  const BezierPatch& x_;
  BezierPatch exchanged_;
  const std::vector<CertifiedPoint>& boundary_;
  const std::vector<ParameterBox>& where_;
  const SelfValues& values_;
  std::vector<SelfCentre> centres_;
};

}  // namespace

CertifiedPoint certified_pair(const std::array<RealAlgebraic, 4>& value) {
  return {std::make_shared<AlgebraicPair>(value), power_of_two(-100), sides_at(value), 0, 0};
}

std::optional<std::size_t> boundary_point(const std::vector<CertifiedPoint>& boundary,
                                          const std::array<RealAlgebraic, 4>& value) {
  const std::vector<Side> sides = sides_at(value);
  const bool listed = std::ranges::any_of(sides, [&](const Side& side) {
    const auto other = static_cast<Parameter>((index(side.parameter) + 2) % 4);
    return std::ranges::count(sides, Side{other, side.value}) == 0;
  });
  if (!listed) return std::nullopt;
  for (Rational width = power_of_two(-60);; width *= width) {
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < boundary.size(); ++i)
      if (may_be(boundary[i].refined_to(width).box(), value)) found.push_back(i);
    if (found.size() < 2) return found.empty() ? std::nullopt : std::optional(found.front());
  }
}

bool is_only_root(const SelfCentre& centre, const ParameterBox& box) {
  const std::size_t sweep = centre.sweeps.front();
  const RationalInterval& range = box[3 - sweep];
  const auto is_inside = [&](const TriangularPoint& p) {
    const RationalInterval& r = p.r_interval();
    if (r.upper < range.lower || r.lower > range.upper) return false;
    if (range.lower <= r.lower && r.upper <= range.upper) return true;
    const auto from = [](const Rational& c) {
      return BivariatePolynomial::r() - BivariatePolynomial::constant(c);
    };
    return sign_at(from(range.lower), p) >= 0 && sign_at(from(range.upper), p) <= 0;
  };
  return std::ranges::count_if(*centre.over_value, is_inside) == 1;
}

std::vector<SelfCentre> self_star_centres(const BezierPatch& x, const std::vector<CertifiedPoint>& boundary,
                                          const std::vector<ParameterBox>& where, const SelfValues& values) {
  return CentreSearch(x, boundary, where, values).run();
}

}  // namespace exsect
