#include "curve/curve_graph.h"

#include <exsect/algebra/interruption.h>
#include <exsect/algebra/nearest_rounding.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>

#include "answer/parameter_box.h"
#include "answer/proof_failure.h"
#include "curve/curve_factors.h"
#include "curve/curve_values.h"
#include "curve/factor_points.h"
#include "curve/kept_part.h"
#include "curve/plane_curve.h"

namespace exsect {
namespace {

/// A rational number between the two points over the same u.
Rational cut_between(TriangularPoint a, TriangularPoint b) {
  for (Rational width = power_of_two(-10); a.r_interval().upper >= b.r_interval().lower; width *= width) {
    a = a.refined_to(width);
    b = b.refined_to(width);
  }
  return simplest_between(a.r_interval().upper, b.r_interval().lower);
}

/// The point (u,v) for rational v.
TriangularPoint point_over(const RealAlgebraic& u, const Rational& v) {
  return {u, BivariatePolynomial::r() - BivariatePolynomial::constant(v), {v, v}};
}

bool is_at(const TriangularPoint& p, const Rational& v) {
  return p.r_interval().lower == v && p.r_interval().upper == v;
}

/// Sweeps the curve in the direction of u. In polynomials of points v is the first variable.
class CurveSweep {
 public:
  CurveSweep(std::vector<CurveFactor> factors, const CurveRegion& region)
      : factors_(std::move(factors)), bounds_(region.bounds), region_(region) {
    Polynomial lines{1};
    for (const CurveFactor& factor : factors_) {
      const ContentAndPart parts = split_content(factor.factor.exchanged());
      lines = lines * parts.content;
      if (parts.primitive.degree_r() < 1) continue;
      swept_.push_back(parts.primitive);
      graph_.factors.push_back(parts.primitive.exchanged());
      multiplicities_.push_back(factor.multiplicity);
    }
    values_ = curve_values(graph_.factors, lines, bounds_);
  }

  CurveGraph run() {
    for (std::size_t i = 0; i < values_.size(); ++i) {
      interruption_point();
      const std::vector<FactorRoot> next =
          i + 1 < values_.size() ? points_after(i) : std::vector<FactorRoot>{};
      pass(i, next.size());
      open_arcs(i, next);
      graph_.values.push_back(values_[i].u);
      if (i + 1 < values_.size()) add_column();
    }
    graph_.swept = BivariatePolynomial::constant(1);
    for (const BivariatePolynomial& factor : graph_.factors) graph_.swept = graph_.swept * factor;
    return kept_part(std::move(graph_), region_);
  }

 private:
  /// An arc on its way: which one, or none yet.
  struct Front {
    std::optional<std::size_t> arc;
    std::optional<std::size_t> from;
  };

  Rational sample_after(std::size_t i) const {
    return simplest_between(values_[i].u.interval().upper, values_[i + 1].u.interval().lower);
  }
  std::vector<FactorRoot> points_after(std::size_t i) const {
    return roots_over(graph_.factors, sample_after(i));
  }

  /// Closed, with the value inside, or at its end for 0 and 1, and no other one; smaller with every round.
  RationalInterval window_around(std::size_t i, int round) const {
    const Rational reach = power_of_two(-(16L << round));
    const RationalInterval at = values_[i].u.refined_to(reach).interval();
    if (at.lower < at.upper) return at;
    RationalInterval window = at;
    if (i > 0)
      window.lower = std::max<Rational>(at.lower - reach, (at.lower + values_[i - 1].u.interval().upper) / 2);
    if (i + 1 < values_.size())
      window.upper = std::min<Rational>(at.upper + reach, (at.upper + values_[i + 1].u.interval().lower) / 2);
    return window;
  }

  /// Rational numbers between the points over value i, and a window in which f(u,c) != 0 for each of them.
  RationalInterval window_between(std::size_t i, const std::vector<Rational>& cuts) const {
    for (int round = 0;; ++round) {
      const RationalInterval window = window_around(i, round);
      if (std::all_of(cuts.begin(), cuts.end(),
                      [&](const Rational& c) { return has_no_zero_along(graph_.factors, c, window); }))
        return window;
    }
  }

  /// The `total` points over u, on an end of a window; none beyond the square, where the window ends in the
  /// value itself.
  std::vector<FactorRoot> points_before(const Rational& u, std::size_t total) const {
    if (total == 0) return {};
    std::vector<FactorRoot> points = roots_over(graph_.factors, u);
    if (points.size() != total)
      throw ProofFailure(whole_domain(), "the number of points of a curve changes between critical values");
    return points;
  }

  /// Their number below each cut, and of all.
  static std::vector<std::size_t> counts_below(const std::vector<FactorRoot>& points,
                                               const std::vector<Rational>& cuts) {
    std::vector<std::size_t> counts;
    for (const Rational& c : cuts)
      counts.push_back(static_cast<std::size_t>(std::count_if(
          points.begin(), points.end(), [&](const FactorRoot& point) { return point.v.compare(c) < 0; })));
    counts.push_back(points.size());
    return counts;
  }

  /// On a line of the curve also the points where a bound is 0.
  std::vector<FactorPoint> points_at(const CriticalValue& value) const {
    std::vector<BivariatePolynomial> factors = swept_;
    if (value.is_vertical)
      for (const BivariatePolynomial& h : bounds_)
        if (!reduced_at(h.exchanged(), value.u).is_zero()) factors.push_back(h.exchanged());
    return points_over(factors, value.u);
  }
  /// A factor of the curve, not a bound.
  bool is_of_curve(std::size_t factor) const { return factor < swept_.size(); }

  /// The points over value i, their order among the arcs on both sides, and where they lie.
  struct Meeting {
    std::size_t left_from, left_to, right_from, right_to;
    RationalInterval v;
    std::optional<TriangularPoint> at;  // empty: a regular point inside the square
    std::vector<std::size_t> factors;   // with a point there, if `at` is known
    bool is_on_side;
  };

  /// Joins the arcs on both sides of value i in the points over it.
  void pass(std::size_t i, std::size_t next) {
    std::vector<Meeting> meetings;
    if (values_[i].is_exact || !meet_in_strips(i, next, meetings)) meetings = meet_in_points(i, next);
    const std::vector<Front> before = std::move(fronts_);
    fronts_.assign(next, {});
    std::vector<std::size_t> on_line;
    for (const Meeting& meeting : meetings) {
      const std::optional<std::size_t> node = join(i, meeting, before);
      if (node) on_line.push_back(*node);
    }
    if (values_[i].is_vertical) add_line(i, std::move(on_line));
  }

  /// Whatever happens over value i (Lemma 17.1).
  std::vector<Meeting> meet_in_points(std::size_t i, std::size_t next) const {
    const std::vector<FactorPoint> over = points_at(values_[i]);
    std::vector<Rational> cuts;
    for (std::size_t k = 0; k + 1 < over.size(); ++k) cuts.push_back(cut_between(over[k].at, over[k + 1].at));
    const RationalInterval window = window_between(i, cuts);
    const std::vector<std::size_t> left = counts_below(points_before(window.lower, fronts_.size()), cuts);
    const std::vector<std::size_t> right = counts_below(points_before(window.upper, next), cuts);
    if (over.empty() && !(fronts_.empty() && next == 0))
      throw ProofFailure(whole_domain(), "arcs of a curve end where it has no point");
    const bool at_end = i == 0 || i + 1 == values_.size();
    std::vector<Meeting> meetings;
    for (std::size_t k = 0; k < over.size(); ++k)
      meetings.push_back({k > 0 ? left[k - 1] : 0, left[k], k > 0 ? right[k - 1] : 0, right[k],
                          over[k].at.r_interval(), over[k].at, over[k].factors,
                          at_end || is_at(over[k].at, 0) || is_at(over[k].at, 1)});
    return meetings;
  }

  /// The same by counting arcs in strips alone (Lemma 17.2); false if strips with three arcs remain.
  bool meet_in_strips(std::size_t i, std::size_t next, std::vector<Meeting>& meetings) const {
    for (int round = 0; round < strip_rounds; ++round) {
      const RationalInterval window = window_around(i, round);
      const std::vector<FactorRoot> left = points_before(window.lower, fronts_.size());
      const std::vector<FactorRoot> right = points_before(window.upper, next);
      const std::vector<Rational> cuts = strip_cuts(window, left, right);
      if (values_[i].side && cuts.empty() && left.size() + right.size() > 1) continue;
      meetings = strips_between(cuts, counts_below(left, cuts), counts_below(right, cuts));
      const std::optional<int> side = values_[i].side;
      bool settled = true;
      for (std::size_t k = 0; k < meetings.size(); ++k) {
        Meeting& strip = meetings[k];
        const std::size_t arcs = strip.left_to - strip.left_from + strip.right_to - strip.right_from;
        strip.is_on_side = side && k == (*side == 0 ? 0 : meetings.size() - 1);
        if (strip.is_on_side) {
          strip.at = point_over(values_[i].u, *side);
          strip.v = {*side, *side};
        }
        settled = settled && (strip.is_on_side ? arcs == 1 : arcs == 0 || arcs == 2);
      }
      if (!settled) continue;
      std::erase_if(meetings, [](const Meeting& strip) {
        return strip.left_from == strip.left_to && strip.right_from == strip.right_to;
      });
      return true;
    }
    return false;
  }

  /// Numbers between the points on both ends of a window, ascending, with f(u,c) != 0 in it.
  std::vector<Rational> strip_cuts(const RationalInterval& window, const std::vector<FactorRoot>& left,
                                   const std::vector<FactorRoot>& right) const {
    std::vector<RealAlgebraic> points;
    for (const std::vector<FactorRoot>* side : {&left, &right})
      for (const FactorRoot& point : *side) points.push_back(point.v);
    std::sort(points.begin(), points.end());
    std::vector<Rational> cuts;
    for (std::size_t k = 0; k + 1 < points.size(); ++k) {
      RealAlgebraic a = points[k], b = points[k + 1];
      if (a == b) continue;
      for (Rational width = power_of_two(-10); !are_apart(a, b); width *= width) {
        a = a.refined_to(width);
        b = b.refined_to(width);
      }
      const Rational c = simplest_between(a.interval().upper, b.interval().lower);
      if (has_no_zero_along(graph_.factors, c, window)) cuts.push_back(c);
    }
    return cuts;
  }

  static std::vector<Meeting> strips_between(const std::vector<Rational>& cuts,
                                             const std::vector<std::size_t>& left,
                                             const std::vector<std::size_t>& right) {
    std::vector<Meeting> strips;
    for (std::size_t k = 0; k <= cuts.size(); ++k)
      strips.push_back({k > 0 ? left[k - 1] : 0,
                        left[k],
                        k > 0 ? right[k - 1] : 0,
                        right[k],
                        {k > 0 ? cuts[k - 1] : Rational(0), k < cuts.size() ? cuts[k] : Rational(1)},
                        std::nullopt,
                        {},
                        false});
    return strips;
  }

  /// The node, unless one regular arc passes there, or nothing but a line u = const.
  std::optional<std::size_t> join(std::size_t i, const Meeting& meeting, const std::vector<Front>& before) {
    const CriticalValue& value = values_[i];
    const int left = static_cast<int>(meeting.left_to - meeting.left_from);
    const int right = static_cast<int>(meeting.right_to - meeting.right_from);
    const bool singular = value.is_exact && is_singular(value, meeting);
    const bool is_rim = value.is_exact && region_.place_of(*meeting.at) == RegionPlace::rim;
    const bool is_line = value.is_vertical && left == 0 && right == 0;
    if (is_line && !singular && !meeting.is_on_side && !is_rim) return std::nullopt;
    const bool passes = left == 1 && right == 1 && !singular && !value.is_vertical &&
                        !(meeting.is_on_side && !runs_along_side(before[meeting.left_from], meeting)) &&
                        !is_rim;
    if (passes) {
      fronts_[meeting.right_from] = before[meeting.left_from];
      return std::nullopt;
    }
    const std::size_t node = graph_.nodes.size();
    graph_.nodes.push_back({value.u, meeting.v, meeting.at, singular, meeting.is_on_side, left, right, 0});
    for (std::size_t k = meeting.left_from; k < meeting.left_to; ++k) graph_.arcs[*before[k].arc].to = node;
    for (std::size_t k = meeting.right_from; k < meeting.right_to; ++k) fronts_[k].from = node;
    return node;
  }

  /// On two parts of the curve, or at a singular point of one.
  bool is_singular(const CriticalValue& value, const Meeting& meeting) const {
    const std::vector<std::size_t>& on = meeting.factors;
    const auto count = std::ranges::count_if(on, [&](std::size_t i) { return is_of_curve(i); });
    if (count + (value.is_vertical ? 1 : 0) != 1) return count > 0;
    if (count == 0) return false;
    const BivariatePolynomial& f = swept_[on.front()];
    return sign_at(f.derivative_r(), *meeting.at) == 0 && sign_at(f.derivative_s(), *meeting.at) == 0;
  }

  bool runs_along_side(const Front& front, const Meeting& meeting) const {
    const TriangularPoint& inside = graph_.arcs[*front.arc].inside;
    return (is_at(*meeting.at, 0) && is_at(inside, 0)) || (is_at(*meeting.at, 1) && is_at(inside, 1));
  }

  /// The line u = const through these nodes, and through the ends of the square.
  void add_line(std::size_t i, std::vector<std::size_t> nodes) {
    const RealAlgebraic& u = values_[i].u;
    const auto add_end = [&](int v) {
      graph_.nodes.push_back({u, {v, v}, point_over(u, v), false, true, 0, 0, 0});
      return graph_.nodes.size() - 1;
    };
    if (nodes.empty() || !is_at(*graph_.nodes[nodes.front()].exact, 0))
      nodes.insert(nodes.begin(), add_end(0));
    if (!is_at(*graph_.nodes[nodes.back()].exact, 1)) nodes.push_back(add_end(1));
    for (std::size_t k = 0; k + 1 < nodes.size(); ++k) {
      CurveNode &from = graph_.nodes[nodes[k]], &to = graph_.nodes[nodes[k + 1]];
      const TriangularPoint inside = point_over(u, cut_between(*from.exact, *to.exact));
      ++from.vertical;
      ++to.vertical;
      graph_.arcs.push_back({nodes[k], nodes[k + 1], multiplicity_on_line(inside), inside});
    }
  }

  /// Arcs that start at value i; v of each over the sample after it.
  void open_arcs(std::size_t i, const std::vector<FactorRoot>& points) {
    for (std::size_t k = 0; k < points.size(); ++k) {
      if (fronts_[k].arc) continue;
      const auto& [v, factor] = points[k];
      const BivariatePolynomial in_v =
          BivariatePolynomial(std::vector<Polynomial>(1, v.polynomial())).exchanged();
      const TriangularPoint inside = v.is_rational() ? point_over(sample_after(i), v.rational())
                                                     : TriangularPoint(sample_after(i), in_v, v.interval());
      fronts_[k].arc = graph_.arcs.size();
      graph_.arcs.push_back({*fronts_[k].from, 0, multiplicities_[factor], inside, factor});
    }
  }

  void add_column() {
    CurveColumn column;
    for (const Front& front : fronts_) column.push_back(*front.arc);
    graph_.columns.push_back(std::move(column));
  }

  int multiplicity_on_line(const TriangularPoint& inside) const {
    if (factors_.size() == 1) return factors_.front().multiplicity;
    for (const CurveFactor& factor : factors_)
      if (sign_at(factor.factor.exchanged(), inside) == 0) return factor.multiplicity;
    throw ProofFailure(whole_domain(), "an arc of a curve is on none of its factors");
  }

  static constexpr int strip_rounds = 4;

  std::vector<CurveFactor> factors_;         // squarefree, pairwise coprime
  std::vector<BivariatePolynomial> swept_;   // those of graph_, without lines u = const, with v for r
  std::vector<int> multiplicities_;          // of these
  std::vector<BivariatePolynomial> bounds_;  // of the region
  PlacedRegion region_;
  std::vector<CriticalValue> values_;
  std::vector<Front> fronts_;  // ascending in v
  CurveGraph graph_;
};

}  // namespace

int CurveGraph::isolated_points() const {
  return static_cast<int>(
      std::count_if(nodes.begin(), nodes.end(), [](const CurveNode& node) { return node.degree() == 0; }));
}

int CurveGraph::components() const {
  std::vector<std::size_t> parent(nodes.size());
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  const auto root = [&](std::size_t node) {
    while (parent[node] != node) node = parent[node];
    return node;
  };
  int count = static_cast<int>(nodes.size());
  for (const CurveBranch& arc : arcs) {
    const std::size_t a = root(arc.from), b = root(arc.to);
    if (a == b) continue;
    parent[a] = b;
    --count;
  }
  return count;
}

CurveGraph curve_graph(const BivariatePolynomial& f, const CurveRegion& region) {
  if (f.is_zero()) throw std::domain_error("curve_graph: the zero polynomial");
  return in_nearest_rounding([&] { return CurveSweep(curve_factors(f), region).run(); });
}

CurveGraph curve_graph_of_factors(const std::vector<BivariatePolynomial>& factors,
                                  const CurveRegion& region) {
  std::vector<CurveFactor> once;
  for (const BivariatePolynomial& factor : factors) once.push_back({factor, 1});
  return in_nearest_rounding([&] { return CurveSweep(once, region).run(); });
}

}  // namespace exsect
