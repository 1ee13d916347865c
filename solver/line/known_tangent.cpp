#include "line/known_tangent.h"

#include "answer/parameter_box.h"
#include "line/exact_line_points.h"
#include "line/exact_tangent.h"
#include "line/half_rational_point.h"

namespace exsect {

namespace {

Rational fine_width() { return power_of_two(-200); }

}  // namespace

std::optional<std::array<Rational, 4>> rational_solution(const BezierPatch& x, const BezierPatch& y,
                                                         const CertifiedPoint& point) {
  const ParameterBox box = point.refined_to(fine_width()).box();
  std::array<Rational, 4> p;
  for (std::size_t j = 0; j < 4; ++j) {
    p[j] = simplest_near(box[j], fine_width());
    if (p[j] < box[j].lower || p[j] > box[j].upper) {
      return std::nullopt;
    }
  }
  return is_zero(x(p[0], p[1]) - y(p[2], p[3])) ? std::optional(p) : std::nullopt;
}

namespace {

/// The point's parameters, if they are known exactly from one of the sides it lies on.
std::optional<ExactParameters> exactly(const BezierPatch& x, const BezierPatch& y,
                                       const CertifiedPoint& point) {
  if (auto exact = point.exact()) return exact;
  const ParameterBox box = point.refined_to(fine_width()).box();
  for (const Side& side : point.sides()) {
    const LinePoints line = exact_line_points(x, y, {side.parameter, side.value});
    if (line.incomplete || !line.on_patch.empty()) continue;
    std::vector<const CertifiedPoint*> near;
    for (const CertifiedPoint& other : line.points)
      if (meet(other.refined_to(fine_width()).box(), box)) near.push_back(&other);
    if (near.size() != 1) continue;  // the point is one of them
    if (auto exact = near.front()->exact()) return exact;
  }
  return std::nullopt;
}

}  // namespace

std::array<bool, 4> known_zero_tangent(const BezierPatch& x, const BezierPatch& y,
                                       const CertifiedPoint& point) {
  if (const auto exact = exactly(x, y, point)) return zero_tangent_components(x, y, *exact);
  std::array<bool, 4> zero{};
  if (point.multiplicity() >= 2 && !point.sides().empty()) {
    zero[index(point.sides().front().parameter)] = true;  // the point was found on this line
  }
  const ParameterBox box = point.box();
  const ParameterBox fine = point.refined_to(fine_width()).box();
  for (const bool of_x : {true, false}) {
    const std::size_t first = of_x ? 0 : 2;
    if (box[first].width() != 0 && box[first + 1].width() != 0) {
      continue;  // the point is told from others on a line across one of these parameters
    }
    const std::array<Rational, 2> at = {simplest_near(fine[first], fine_width()),
                                        simplest_near(fine[first + 1], fine_width())};
    if (at[0] < 0 || at[0] > 1 || at[1] < 0 || at[1] > 1) {
      continue;
    }
    for (const HalfRationalPoint& candidate : half_rational_points(x, y, of_x, at)) {
      if (lies_in(candidate.point.refined_to(fine_width()).box(), box)) {
        return candidate.tangent_is_zero;
      }
    }
  }
  return zero;
}

namespace {

/// The simplest number of the interval, if its denominator is far below those of most numbers there.
std::optional<Rational> outstanding_number(const RationalInterval& in) {
  const Rational number = simplest_near(in, 0);
  const Rational rarity = power_of_two(10) * in.width() * denominator(number) * denominator(number);
  return rarity < 1 && number >= 0 && number <= 1 ? std::optional(number) : std::nullopt;
}

}  // namespace

std::optional<ParameterBox> common_tangent_zero(const BezierPatch& x, const BezierPatch& y,
                                                const ParameterBox& where, std::size_t i, std::size_t j) {
  for (const Parameter p : all_parameters) {
    const std::optional<Rational> value = outstanding_number(where[index(p)]);
    if (!value) continue;
    for (const CertifiedPoint& point : exact_line_points(x, y, {p, *value}).points) {
      const ParameterBox box = point.refined_to(fine_width()).box();
      const auto exact = lies_in(box, where) ? point.exact() : std::nullopt;
      if (!exact) continue;
      const std::array<bool, 4> zero = zero_tangent_components(x, y, *exact);
      if (zero[i] && zero[j]) return box;
    }
  }
  return std::nullopt;
}

bool is_known_singular(const BezierPatch& x, const BezierPatch& y, const CertifiedPoint& point) {
  const std::array<bool, 4> zero = known_zero_tangent(x, y, point);
  return zero[0] && zero[1] && zero[2] && zero[3];
}

}  // namespace exsect
