#include "line/rational_line_points.h"

#include <exsect/algebra/nearest_rounding.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

#include "curve/plane_curve.h"
#include "line/isolated_points.h"
#include "line/line_carrier.h"
#include "line/line_curve.h"
#include "line/rational_line.h"

namespace exsect {
namespace {

using PolynomialList = std::vector<BivariatePolynomial>;
using LineParameters = std::vector<RealAlgebraic>;

/// The 2 x 2 minors: zero where the vectors are proportional.
PolynomialList minors(const ComponentsOfPatch& a, const ComponentsOfPatch& b) {
  PolynomialList result;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i + 1; j < 4; ++j) result.push_back(a[i] * b[j] - a[j] * b[i]);
  return result;
}

class LineOnPatch {
 public:
  LineOnPatch(const HomogeneousCurve& curve, const RationalPatch& patch)
      : curve_(curve), x_(components_of(patch)) {}

  RationalLinePoints run() {
    if (degree(curve_) == 0) {
      if (is_on_patch(0, {})) result_.on_patch.push_back({RealAlgebraic(0), RealAlgebraic(1)});
      return result_;
    }
    const LineCarrier carrier(curve_, x_);
    const CommonZeros zeros = common_zeros(carrier.equations());
    if (zeros.curve.is_zero()) {
      result_.incomplete = "the patch is a piece of the line's carrier";
      return result_;
    }
    for (const TriangularPoint& p : zeros.points)
      for (const LinePosition& at : positions(carrier, {p}))
        result_.points.push_back({at.t, p, at.is_transversal});
    if (zeros.curve.degree_r() > 0 || zeros.curve.degree_s() > 0) add_curve(carrier, squarefree(zeros.curve));
    std::ranges::stable_sort(result_.points, [](const RationalLinePoint& a, const RationalLinePoint& b) {
      return a.parameters.s() < b.parameters.s();
    });
    return result_;
  }

 private:
  void note_base_point() { result_.incomplete = "a base point of the patch is beside a point of the line"; }

  std::vector<LinePosition> positions(const LineCarrier& carrier,
                                      const std::vector<TriangularPoint>& points) {
    std::vector<LinePosition> result;
    for (const TriangularPoint& p : points)
      if (!carrier.add_positions(p, result)) note_base_point();
    return result;
  }

  LineParameters parameters(const LineCarrier& carrier, const std::vector<TriangularPoint>& points) {
    LineParameters result;
    for (const TriangularPoint& p : points)
      if (!carrier.add_numbers(p, result)) note_base_point();
    return result;
  }

  /// Whether the point at t has parameters in the square, zeros of the other equations too.
  bool is_on_patch(const Rational& t, PolynomialList equations) const {
    ComponentsOfPatch point;
    for (std::size_t k = 0; k < 4; ++k) point[k] = BivariatePolynomial::constant(curve_[k](t));
    const PolynomialList same = minors(x_, point);
    equations.insert(equations.end(), same.begin(), same.end());
    return have_common_zero(equations);
  }

  /// Where the point of the patch stands still along c = 0.
  PolynomialList standstill(const BivariatePolynomial& c) const {
    ComponentsOfPatch along;
    for (std::size_t k = 0; k < 4; ++k) along[k] = jacobian(c, x_[k]);
    return minors(x_, along);
  }

  /// Adds the isolated points of the part of c = 0 with t in [0,1] to the result, and gives them back.
  std::vector<TriangularPoint> add_isolated(const LineCarrier& carrier, const BivariatePolynomial& c) {
    const auto is_on_line = [&](const TriangularPoint& p) { return !positions(carrier, {p}).empty(); };
    std::vector<TriangularPoint> isolated;
    for (const IsolatedPoint& p : isolated_points(c, {carrier.borders(), is_on_line})) {
      for (const LinePosition& at : positions(carrier, {p.at})) result_.points.push_back({at.t, p.at, false});
      isolated.push_back(p.at);
    }
    return isolated;
  }

  void add_curve(const LineCarrier& carrier, const BivariatePolynomial& c) {
    const std::vector<TriangularPoint> isolated = add_isolated(carrier, c);
    const auto is_isolated = [&](const TriangularPoint& p) {
      return std::ranges::any_of(isolated, [&](const TriangularPoint& q) { return same_point(p, q); });
    };
    std::vector<TriangularPoint> points;
    const auto append = [&](const std::vector<TriangularPoint>& more) {
      std::ranges::remove_copy_if(more, std::back_inserter(points), is_isolated);
    };
    append(component_points(c));
    append(side_points(c));
    PolynomialList still = standstill(c);
    still.push_back(c);
    const BivariatePolynomial constant = common_zeros(still).curve;
    const BivariatePolynomial varying = exact_quotient(c, gcd(c, constant));
    if (varying.degree_r() > 0 || varying.degree_s() > 0) {
      still = standstill(c);
      still.push_back(varying);
      append(common_zeros(still).points);
    }
    LineParameters met = parameters(carrier, points);
    sort_unique(met);
    LineParameters values = standstills(curve_);
    values.insert(values.end(), met.begin(), met.end());
    const LineParameters beside = parameters(carrier, isolated);  // a sample must not be at one of them
    values.insert(values.end(), beside.begin(), beside.end());
    values.emplace_back(0);
    values.emplace_back(1);
    sort_unique(values);
    for (std::size_t i = 0; i + 1 < values.size(); ++i)
      if (is_on_patch(sample_between(values[i], values[i + 1]), {c}))
        result_.on_patch.push_back({values[i], values[i + 1]});
    for (const RealAlgebraic& t : met) result_.on_patch.push_back({t, t});
    result_.on_patch = merged(std::move(result_.on_patch));
  }

  HomogeneousCurve curve_;
  ComponentsOfPatch x_;
  RationalLinePoints result_;
};

}  // namespace

RationalLinePoints rational_line_points(const RationalPatch& x, const RationalPatch& y,
                                        const LineQuery& query) {
  return in_nearest_rounding([&] {
    const RationalLine line = rational_line(x, y, query);
    return LineOnPatch(line.curve, line.patch).run();
  });
}

}  // namespace exsect
