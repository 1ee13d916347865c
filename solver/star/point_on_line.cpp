#include "star/point_on_line.h"

#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "answer/parameter_box.h"
#include "answer/proof_failure.h"
#include "line/half_rational_point.h"
#include "line/line_place.h"
#include "star/star_neighbourhood.h"
#include "trace/pair_system.h"

namespace exsect {

namespace {

using Ball = ArbBall<256>;
constexpr int kMostRefinements = 12;

/// A regular sheet of the other patch over an interval of the line's parameter.
class Sheet {
 public:
  Sheet(const BezierPatch& x, const BezierPatch& y, const LineQuery& line, RealAlgebraic along)
      : x_(x), y_(y), line_(line), along_(line_place(line).roles.line), value_(std::move(along)) {}

  bool of_x() const { return index(along_) < 2; }
  Parameter along() const { return along_; }
  const LineQuery& line() const { return line_; }
  const RealAlgebraic& value() const { return value_; }

  std::vector<HalfRationalPoint> points_over(const Rational& value) const {
    std::array<Rational, 2> at;
    at[index(along_) % 2] = value;
    at[index(line_.fixed) % 2] = line_.value;
    return half_rational_points(x_, y_, of_x(), at);
  }

  /// An enclosure of the sheet's points over `range`, where it has the point `known` over the lower end: of
  /// the two equations of two coordinates, Krawczyk's test proves a single solution in a square for every
  /// value of the line's parameter, strictly inside; the sheet cannot leave it.
  std::optional<ParameterBox> enclosure(const RationalInterval& range, const ParameterBox& known) const {
    BallPoint<Ball> centre;
    const std::size_t other = of_x() ? 2 : 0;
    double radius = 0;
    for (std::size_t j = 0; j < 4; ++j) {
      centre[j] = Ball::enclosing(known[j]).midpoint();
      radius = larger_bound(radius, Ball::enclosing(known[j]).radius());
    }
    BallPoint<Ball> over = centre;
    over[index(along_)] = Ball::enclosing(range);
    over[index(line_.fixed)] = Ball::enclosing(line_.value);
    const PairSystem<Ball> system(x_, y_, {0, 0, 0}, 0);
    const Expansion<Ball> at(system, over);
    const TaylorNet<Ball>& patch = of_x() ? at.y : at.x;
    const BallVector<Ball> f = at.value();
    for (const auto& [a, b] : {std::array<std::size_t, 2>{0, 1}, {1, 2}, {2, 0}}) {
      const std::array<double, 4> d = {patch[3][a].approximation(), patch[1][a].approximation(),
                                       patch[3][b].approximation(), patch[1][b].approximation()};
      const double det = d[0] * d[3] - d[1] * d[2];
      if (!std::isfinite(1 / det)) {
        continue;
      }
      const std::array<double, 4> c = {d[3] / det, -d[1] / det, -d[2] / det, d[0] / det};
      const auto mapped = [&](std::size_t row, const Ball& first, const Ball& second) {
        return Ball(c[2 * row]) * first + Ball(c[2 * row + 1]) * second;
      };
      const double residual =
          larger_bound(mapped(0, f[a], f[b]).upper_magnitude(), mapped(1, f[a], f[b]).upper_magnitude());
      const double z = 4 * (residual + radius) + 0x1p-240;
      BallPoint<Ball> box = over;
      box[other] = centre[other].widened(z);
      box[other + 1] = centre[other + 1].widened(z);
      const Expansion<Ball> all(system, box);
      const TaylorNet<Ball>& net = of_x() ? all.y : all.x;
      double rho = 0;
      for (std::size_t row = 0; row < 2; ++row) {
        const Ball first = mapped(row, net[3][a], net[3][b]) - Ball(row == 0 ? 1.0 : 0.0);
        const Ball second = mapped(row, net[1][a], net[1][b]) - Ball(row == 1 ? 1.0 : 0.0);
        rho = larger_bound(rho, first.upper_magnitude() + second.upper_magnitude());
      }
      if (!((residual + rho * z) * kSlack < z)) {
        continue;
      }
      ParameterBox result;
      for (std::size_t j = 0; j < 4; ++j) {
        const RationalInterval i = box[j].interval();
        result[j] = {std::max<Rational>(i.lower, 0), std::min<Rational>(i.upper, 1)};
      }
      result[index(along_)] = range;
      result[index(line_.fixed)] = {line_.value, line_.value};
      return result;
    }
    return std::nullopt;
  }

 private:
  BezierPatch x_;
  BezierPatch y_;
  LineQuery line_;
  Parameter along_;
  RealAlgebraic value_;
};

class PointOnLineSource : public CertifiedPoint::Source {
 public:
  PointOnLineSource(Sheet sheet, ParameterBox first, std::vector<Side> sides,
                    std::optional<ExactParameters> exact)
      : sheet_(std::move(sheet)),
        first_(std::move(first)),
        sides_(std::move(sides)),
        exact_(std::move(exact)) {}

  std::optional<ExactParameters> exact_parameters() const override { return exact_; }

  ParameterBox box(const Rational& width) const override {
    Rational fine = std::min<Rational>(width, power_of_two(-50)) / 16;
    for (int i = 0; i < kMostRefinements; ++i, fine /= 256) {
      const RationalInterval range = sheet_.value().refined_to(fine).interval();
      for (const HalfRationalPoint& p : sheet_.points_over(range.lower)) {
        const ParameterBox known = p.point.refined_to(fine).box();
        // different sheets have disjoint boxes over the first range
        const auto found = meet(known, first_) ? sheet_.enclosure(range, known) : std::nullopt;
        if (found && fits(*found, width)) {
          return on_sides(*found);
        }
      }
    }
    throw ProofFailure(first_, "a point on a line cannot be enclosed so closely");
  }

 private:
  static bool fits(const ParameterBox& box, const Rational& width) {
    return std::all_of(box.begin(), box.end(),
                       [&](const RationalInterval& i) { return i.upper - i.lower <= width; });
  }
  ParameterBox on_sides(ParameterBox box) const {
    for (const Side& side : sides_) box[index(side.parameter)] = {side.value, side.value};
    return box;
  }

  Sheet sheet_;
  ParameterBox first_;
  std::vector<Side> sides_;
  std::optional<ExactParameters> exact_;
};

/// The simplest number that may be parameter j of the sheet's point over `value`, if one point is near.
std::optional<Rational> parameter_over(const Sheet& sheet, const Rational& value, std::size_t j,
                                       const ParameterBox& enclosure) {
  const Rational width = power_of_two(-200);
  for (const HalfRationalPoint& p : sheet.points_over(value)) {
    const ParameterBox box = p.point.refined_to(width).box();
    if (meet(box, enclosure)) return simplest_between(box[j].lower - width, box[j].upper + width);
  }
  return std::nullopt;
}

/// The point exactly, if the sheet runs along a side of the other patch whose parameter is an affine function
/// of the line's. Three points prove that for parabolas.
std::optional<ExactParameters> on_side_of_other(const BezierPatch& x, const BezierPatch& y,
                                                const Sheet& sheet, const RationalInterval& range,
                                                const ParameterBox& enclosure,
                                                const std::vector<Side>& sides) {
  const auto side = std::find_if(sides.begin(), sides.end(), [&](const Side& candidate) {
    return (index(candidate.parameter) < 2) != sheet.of_x();
  });
  if (side == sides.end()) return std::nullopt;
  const std::size_t other = index(side->parameter) ^ 1U;
  const auto first = parameter_over(sheet, range.lower, other, enclosure);
  const auto last = parameter_over(sheet, range.upper, other, enclosure);
  if (!first || !last) return std::nullopt;
  const Rational slope = (*last - *first) / (range.upper - range.lower);
  const Rational offset = *first - slope * range.lower;
  for (int i = 0; i < 3; ++i) {
    std::array<Rational, 4> p;
    p[index(sheet.along())] = i;
    p[index(sheet.line().fixed)] = sheet.line().value;
    p[index(side->parameter)] = side->value;
    p[other] = offset + slope * i;
    if (!is_zero(x(p[0], p[1]) - y(p[2], p[3]))) return std::nullopt;
  }
  using Function = BivariatePolynomial;
  ExactParameters exact{TriangularPoint(sheet.value(), Function::r(), RationalInterval{0, 0}), {}, {}};
  exact.numerator[index(sheet.along())] = Function::s();
  exact.numerator[index(sheet.line().fixed)] = Function::constant(sheet.line().value);
  exact.numerator[index(side->parameter)] = Function::constant(side->value);
  exact.numerator[other] = Function::constant(offset) + Function::constant(slope) * Function::s();
  exact.denominator.fill(Function::constant(1));
  return exact;
}

/// The sides on which the sheet lies over the range: of five points in it at least, all of which the
/// enclosure holds. A line and a side have at most four common points unless one lies on the other's carrier.
std::vector<Side> common_sides(const Sheet& sheet, const RationalInterval& range,
                               const ParameterBox& enclosure, std::vector<Side> sides) {
  for (int k = 1; k < 5; ++k) {
    for (const HalfRationalPoint& p :
         sheet.points_over(range.lower + Rational(k, 4) * (range.upper - range.lower))) {
      if (!meet(p.point.refined_to(power_of_two(-100)).box(), enclosure)) continue;
      std::erase_if(sides, [&](const Side& side) { return !p.point.on(side); });
    }
  }
  return sides;
}

}  // namespace

std::vector<CertifiedPoint> points_on_line(const BezierPatch& x, const BezierPatch& y, const LineQuery& line,
                                           const RealAlgebraic& along) {
  if (along.is_rational()) {
    std::array<Rational, 2> at;
    const Parameter other = line_place(line).roles.line;
    at[index(other) % 2] = along.rational();
    at[index(line.fixed) % 2] = line.value;
    std::vector<CertifiedPoint> result;
    for (HalfRationalPoint& p : half_rational_points(x, y, index(other) < 2, at)) {
      result.push_back(std::move(p.point));
    }
    return result;
  }
  const Sheet sheet(x, y, line, along);
  const RationalInterval range = along.refined_to(power_of_two(-60)).interval();
  std::vector<std::pair<ParameterBox, std::vector<Side>>> sheets;
  for (const HalfRationalPoint& p : sheet.points_over(range.lower)) {
    if (const auto box = sheet.enclosure(range, p.point.refined_to(power_of_two(-80)).box())) {
      sheets.emplace_back(*box, common_sides(sheet, range, *box, p.point.sides()));
    }
  }
  std::vector<CertifiedPoint> result;
  for (std::size_t i = 0; i < sheets.size(); ++i) {
    const bool alone = std::none_of(sheets.begin(), sheets.end(), [&](const auto& other) {
      return &other != &sheets[i] && meet(other.first, sheets[i].first);
    });
    if (alone) {
      auto exact = on_side_of_other(x, y, sheet, range, sheets[i].first, sheets[i].second);
      result.emplace_back(
          std::make_shared<PointOnLineSource>(sheet, sheets[i].first, sheets[i].second, std::move(exact)),
          power_of_two(-50), sheets[i].second, 0, 0);
    }
  }
  return result;
}

}  // namespace exsect
