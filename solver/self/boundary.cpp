#include "self/boundary.h"

#include <exsect/algebra/bivariate_polynomial.h>
#include <exsect/solver/line_query.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "answer/exact_source.h"
#include "answer/model_scale.h"
#include "answer/parameter_box.h"
#include "curve/plane_curve.h"
#include "curve/polynomial_vector.h"
#include "line/exact_line_points.h"
#include "line/line_curve.h"
#include "line/line_place.h"
#include "line/line_point.h"
#include "line/line_system.h"
#include "side/boundary_lines.h"

namespace exsect {
namespace {

Parameter partner(Parameter p) { return static_cast<Parameter>((index(p) + 2) % 4); }

ParameterBox exchanged(const ParameterBox& box) { return {box[2], box[3], box[0], box[1]}; }

class ExchangedSource : public CertifiedPoint::Source {
 public:
  explicit ExchangedSource(CertifiedPoint point) : point_(std::move(point)) {}
  ParameterBox box(const Rational& width) const override { return exchanged(point_.refined_to(width).box()); }
  std::optional<ExactParameters> exact_parameters() const override {
    std::optional<ExactParameters> exact = point_.exact();
    if (exact) {
      std::rotate(exact->numerator.begin(), exact->numerator.begin() + 2, exact->numerator.end());
      std::rotate(exact->denominator.begin(), exact->denominator.begin() + 2, exact->denominator.end());
    }
    return exact;
  }

 private:
  CertifiedPoint point_;
};

std::vector<Side> exchanged(std::vector<Side> sides) {
  for (Side& side : sides) side.parameter = partner(side.parameter);
  std::ranges::sort(sides, {}, [](const Side& side) {
    return 2 * index(side.parameter) + static_cast<std::size_t>(side.value);
  });
  return sides;
}

CertifiedPoint exchanged(const CertifiedPoint& point) {
  return {std::make_shared<ExchangedSource>(point), initial_width(), exchanged(point.sides()),
          point.multiplicity(), point.branch()};
}

/// r or s minus a constant.
BivariatePolynomial side_form(std::size_t fixed, const Rational& value) {
  return (fixed == 0 ? BivariatePolynomial::r() : BivariatePolynomial::s()) -
         BivariatePolynomial::constant(value);
}

bool divides_evenly(const BivariatePolynomial& line, const BivariatePolynomial& f) {
  return gcd(line, f).degree_r() + gcd(line, f).degree_s() > 0;
}

/// f without its factors that vanish on the line.
BivariatePolynomial without_line(BivariatePolynomial f, const BivariatePolynomial& line) {
  while (!f.is_zero() && divides_evenly(line, f)) f = exact_quotient(f, line);
  return f;
}

/// f without its factors that vanish on sides along which the patch is injective.
BivariatePolynomial without_sides(BivariatePolynomial f, const InjectiveRectangles& injective) {
  for (const auto& [fixed, value] : injective.along_sides)
    f = without_line(std::move(f), side_form(static_cast<std::size_t>(fixed), value));
  return f;
}

/// A side that is one point Q: whether Q = x(r,s) for other (r,s) as well.
std::string obstacle_at_point(const BezierPatch& x, const Point& q, const BivariatePolynomial& side) {
  std::vector<BivariatePolynomial> equations;
  for (const BivariatePolynomial& e : coordinates_from(x, q)) equations.push_back(without_line(e, side));
  return have_common_zero(equations) ? "is one point, and so are other points of the patch" : "";
}

/// The line against the patch without the line itself: empty, or why its points are not isolated.
std::string obstacle(const BezierPatch& x, const LineQuery& query, const InjectiveRectangles& injective) {
  const LineAndPatch problem = line_and_patch(x, x, query);
  const std::size_t fixed = index(query.fixed);
  if (shape(problem.line) == LineShape::point)
    return injective.along(fixed, query.value == 0 ? 0 : 1)
               ? obstacle_at_point(x, problem.line.a[0], side_form(fixed, query.value))
               : "is one point, near which the patch may meet itself";
  const LineSystem system = line_system(problem);
  const BivariatePolynomial line = side_form(fixed, query.value);
  const BivariatePolynomial shared =
      without_sides(gcd(exact_quotient(system.first, line), exact_quotient(system.second, line)), injective);
  if (shared.is_zero()) return "lies in the plane of the whole patch";
  if (shared.degree_r() <= 0 && shared.degree_s() <= 0) return "";
  return curve_on_line(shared, system.lambda, lambda_range(system)).lambda.empty()
             ? ""
             : "meets the patch along a curve, apart from itself, or is cuspidal in whole";
}

/// The side on whose line a point with the given sides is found and kept: the first one of (u1,v1) that does
/// not hold both points of the pair; those pairs are on the line itself and are not found by it. Empty if
/// there is none.
std::optional<Side> finding_side(const std::vector<Side>& sides) {
  for (const Side& side : sides)
    if (index(side.parameter) < 2 && !std::ranges::count(sides, Side{partner(side.parameter), side.value}))
      return side;
  return std::nullopt;
}

void add_side(SelfBoundary& result, const BezierPatch& x, const LineQuery& query,
              const InjectiveRectangles& injective) {
  const LinePoints line = exact_line_points(x, x, query);
  const std::string why = line.incomplete ? *line.incomplete : obstacle(x, query, injective);
  if (!why.empty()) {
    ParameterBox where = {{{0, 1}, {0, 1}, {0, 1}, {0, 1}}};
    where[index(query.fixed)] = {query.value, query.value};
    result.problems.push_back(
        {where, std::string("the side ") + name(query.fixed) + "1 = " + query.value.str() + " " + why});
  }
  const Side side = {query.fixed, query.value == 0 ? 0 : 1};
  for (const CertifiedPoint& point : line.points)
    if (finding_side(point.sides()) == side) result.points.push_back(point);
}

/// The index of the point that is points[i] exchanged: boxes are refined until one alone qualifies.
std::size_t find_mate(const std::vector<CertifiedPoint>& points, std::size_t i) {
  const std::vector<Side> sides = exchanged(points[i].sides());
  for (Rational width = initial_width();; width *= width) {
    const ParameterBox box = exchanged(points[i].refined_to(width).box());
    std::vector<std::size_t> found;
    for (std::size_t j = 0; j < points.size(); ++j)
      if (points[j].sides() == sides && meet(points[j].refined_to(width).box(), box)) found.push_back(j);
    if (found.size() == 1) return found.front();
  }
}

void find_mates(SelfBoundary& boundary) {
  for (std::size_t i = 0; i < boundary.points.size(); ++i)
    boundary.mate.push_back(find_mate(boundary.points, i));
}

bool on_one_side(const CertifiedPoint& point) {
  return std::ranges::any_of(point.sides(), [&](const Side& side) {
    return index(side.parameter) < 2 && point.on({partner(side.parameter), side.value});
  });
}

bool is_rational(const ParameterBox& box) {
  return std::ranges::all_of(box, [](const RationalInterval& range) { return range.width() == 0; });
}

/// u1 = u2 and v1 = v2; empty if that cannot be told.
std::optional<bool> is_equal_pair(const CertifiedPoint& point) {
  const ParameterBox& box = point.box();
  if (!meet({box[0], box[1], box[0], box[1]}, {box[2], box[3], box[2], box[3]})) return false;
  if (is_rational(box)) return true;
  const std::optional<ExactParameters> exact = point.exact();
  if (!exact) return std::nullopt;
  return agree(*exact, 0) && agree(*exact, 1);
}

/// The boundary of a patch of which a side lies on it in part. Arcs with both points on one side are that
/// side itself, or a folded one, which is found from its turn. Empty where this is not clear.
class GluedBoundary {
 public:
  explicit GluedBoundary(const BezierPatch& x) : lines_(boundary_lines(x, x, model_scale(x, x), 1, {})) {}

  std::optional<SelfBoundary> run() {
    const bool collapsed = std::ranges::any_of(lines_.arcs, &SideArc::collapsed);
    if (!lines_.incomplete.empty() || collapsed || !lines_.poles.empty()) return std::nullopt;
    for (const CertifiedPoint& point : lines_.points) {
      new_index_.push_back(result_.points.size());
      const std::optional<bool> equal = is_equal_pair(point);
      if (!equal) return std::nullopt;
      if (*equal)
        new_index_.back() = lines_.points.size();  // no pair
      else
        result_.points.push_back(point);
    }
    separate(result_.points);
    find_mates(result_);
    return add_arcs() ? std::optional(std::move(result_)) : std::nullopt;
  }

 private:
  bool add_arcs() {
    std::vector<const SideArc*> arcs;
    for (const SideArc& arc : lines_.arcs)
      if (!on_one_side(arc.inside)) arcs.push_back(&arc);
    for (std::size_t i = 0; i < arcs.size(); ++i) {
      if (!is_pair(arcs[i]->from) && !is_pair(arcs[i]->to)) return false;
      for (const std::size_t end : {arcs[i]->from, arcs[i]->to})
        if (!is_pair(end) && !is_rational(lines_.points[end].box())) return false;
      std::vector<std::size_t> mates;
      for (std::size_t k = 0; k < arcs.size(); ++k)
        if (are_exchanged(*arcs[i], *arcs[k])) mates.push_back(k);
      if (mates.size() != 1 || mates.front() == i) return false;
      if (mates.front() > i) result_.arcs.push_back(glued(*arcs[i]));
    }
    return true;
  }

  /// The two points of the pair are different.
  bool is_pair(std::size_t end) const { return new_index_[end] != lines_.points.size(); }

  /// Different numbers for different ends; those of cuspidal points are their own exchanged ones.
  std::size_t number(std::size_t end) const {
    return is_pair(end) ? new_index_[end] : lines_.points.size() + end;
  }
  std::size_t exchanged_number(std::size_t end) const {
    return is_pair(end) ? result_.mate[new_index_[end]] : number(end);
  }

  bool are_exchanged(const SideArc& a, const SideArc& b) const {
    const std::size_t from = exchanged_number(a.from);
    const std::size_t to = exchanged_number(a.to);
    const bool ends =
        (number(b.from) == from && number(b.to) == to) || (number(b.from) == to && number(b.to) == from);
    return ends && exchanged(a.inside.sides()) == b.inside.sides();
  }

  GluedArc glued(const SideArc& arc) const {
    const bool forward = is_pair(arc.from);
    const std::size_t from = forward ? arc.from : arc.to;
    const std::size_t to = forward ? arc.to : arc.from;
    const std::size_t along = index(line_place({arc.side.parameter, arc.side.value}).roles.line);
    const ParameterBox& end = lines_.points[to].box();
    const int direction = lines_.points[from].box()[along].lower <= end[along].lower ? 1 : -1;
    GluedArc result{new_index_[from], {}, {}, arc.inside.sides(), static_cast<Parameter>(along), direction};
    if (is_pair(to))
      result.to = new_index_[to];
    else
      result.cusp = {end[0].lower, end[1].lower};
    return result;
  }

  BoundaryLines lines_;
  std::vector<std::size_t> new_index_;
  SelfBoundary result_;
};

}  // namespace

SelfBoundary self_boundary(const BezierPatch& x, const InjectiveRectangles& injective) {
  SelfBoundary result;
  for (const Parameter p : {Parameter::u, Parameter::v})
    for (const int value : {0, 1}) add_side(result, x, {p, value}, injective);
  if (!result.problems.empty()) {
    if (injective.along_sides.empty())
      if (auto glued = GluedBoundary(x).run()) return std::move(*glued);
    result.points.clear();
    return result;
  }
  const std::size_t found = result.points.size();
  for (std::size_t i = 0; i < found; ++i)
    if (!finding_side(exchanged(result.points[i].sides())))
      result.points.push_back(exchanged(result.points[i]));
  separate(result.points);
  find_mates(result);
  return result;
}

}  // namespace exsect
