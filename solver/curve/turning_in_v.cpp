#include "curve/turning_in_v.h"

#include <exsect/algebra/interruption.h>
#include <exsect/algebra/resultant.h>

#include <algorithm>
#include <utility>

#include "curve/curve_values.h"
#include "curve/plane_curve.h"

namespace exsect {
namespace {

/// All u in [0,1] of points with f = f_u = 0, lines v = const apart.
std::vector<RealAlgebraic> turning_values(const BivariatePolynomial& f) {
  const BivariatePolynomial part = split_content(f).primitive;
  if (part.degree_r() < 1 || part.degree_s() < 1) return {};
  return real_roots(resultant_s(part, part.derivative_r()), 0, 1);
}

/// Both lists as one, ascending, with disjoint closed intervals.
std::vector<RealAlgebraic> all_values(std::vector<RealAlgebraic> values,
                                      const std::vector<RealAlgebraic>& more) {
  values.insert(values.end(), more.begin(), more.end());
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  for (std::size_t i = 0; i + 1 < values.size(); ++i)
    for (Rational width = power_of_two(-20); !are_apart(values[i], values[i + 1]); width *= width) {
      values[i] = values[i].refined_to(width);
      values[i + 1] = values[i + 1].refined_to(width);
    }
  return values;
}

/// Follows the arcs from value to value and cuts them where their slope changes its sign.
class Cutter {
 public:
  explicit Cutter(CurveGraph graph) : old_(std::move(graph)), pieces_(old_.arcs.size()) {
    f_u_ = old_.swept.derivative_r();
    f_v_ = old_.swept.derivative_s();
    new_.nodes = old_.nodes;
    new_.swept = old_.swept;
    new_.factors = old_.factors;
    new_.is_monotone_in_v = true;
  }

  CurveGraph run(const std::vector<RealAlgebraic>& turning) {
    new_.values = all_values(old_.values, turning);
    for (std::size_t i = 0, column = 0; i + 1 < new_.values.size(); ++i) {
      interruption_point();
      if (i > 0 && new_.values[i] == old_.values[column + 1]) ++column;
      pass(i, old_.columns[column]);
    }
    for (std::size_t arc = 0; arc < old_.arcs.size(); ++arc)
      if (!pieces_[arc]) new_.arcs.push_back(old_.arcs[arc]);  // on a line u = const
    return std::move(new_);
  }

 private:
  /// The last piece of an arc so far, and the sign of its slope.
  struct Piece {
    std::size_t arc;
    int slope;
  };

  void pass(std::size_t i, const CurveColumn& arcs) {
    const Rational u = simplest_between(new_.values[i].interval().upper, new_.values[i + 1].interval().lower);
    const std::vector<RealAlgebraic> points = real_roots(old_.swept.at_r(u), 0, 1);
    const Polynomial slope_u = f_u_.at_r(u), slope_v = f_v_.at_r(u);
    CurveColumn column;
    for (std::size_t k = 0; k < arcs.size(); ++k) {
      const int slope =
          arcs[k] == CurveGraph::dropped ? 0 : -sign_at(slope_u, points.at(k)) * sign_at(slope_v, points[k]);
      column.push_back(arcs[k] == CurveGraph::dropped ? CurveGraph::dropped
                                                      : piece_of(arcs[k], slope, i, u, points[k]));
    }
    new_.columns.push_back(std::move(column));
  }

  std::size_t piece_of(std::size_t arc, int slope, std::size_t i, const Rational& u, const RealAlgebraic& v) {
    std::optional<Piece>& piece = pieces_[arc];
    if (piece && slope * piece->slope >= 0) return piece->arc;
    CurveBranch next = old_.arcs[arc];
    if (piece) {
      next.from = new_.nodes.size();
      next.inside = point_over(u, v);
      new_.nodes.push_back({new_.values[i], {0, 1}, std::nullopt, false, false, 1, 1, 0, true});
      new_.arcs[piece->arc].to = next.from;
    }
    piece = Piece{new_.arcs.size(), slope};
    new_.arcs.push_back(std::move(next));
    return piece->arc;
  }

  static TriangularPoint point_over(const Rational& u, const RealAlgebraic& v) {
    const BivariatePolynomial in_v =
        BivariatePolynomial(std::vector<Polynomial>(1, v.polynomial())).exchanged();
    return {u, in_v, v.interval()};
  }

  CurveGraph old_;
  CurveGraph new_;
  BivariatePolynomial f_u_, f_v_;
  std::vector<std::optional<Piece>> pieces_;  // of arcs of the old graph
};

}  // namespace

CurveGraph with_turning_in_v(CurveGraph graph) {
  graph.is_monotone_in_v = true;
  if (graph.columns.empty() || graph.swept.degree_r() < 1) return graph;
  const std::vector<RealAlgebraic> turning = turning_values(graph.swept);
  return turning.empty() ? graph : Cutter(std::move(graph)).run(turning);
}

}  // namespace exsect
