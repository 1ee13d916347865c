#include "lift/torus_curve.h"

#include <exsect/algebra/bivariate_factors.h>
#include <exsect/algebra/interruption.h>
#include <exsect/geometry/surface_pull_back.h>

#include <algorithm>
#include <utility>

#include "answer/parameter_box.h"
#include "answer/proof_failure.h"
#include "curve/curve_values.h"

namespace exsect {
namespace {

constexpr int kMostTurns = 100;

/// The parts in order: (half_u, half_v) = (0,0), (0,1), (1,0), (1,1).
constexpr std::size_t part_of(std::size_t half_u, std::size_t half_v) { return 2 * half_u + half_v; }

/// Every zero on a side is simple along it, and none is in a corner.
bool crosses_sides_simply(const BivariatePolynomial& f) {
  for (const int side : {0, 1}) {
    for (const Polynomial& on : {f.at_r(side), f.at_s(side)})
      if (on.is_zero() || !is_squarefree(on)) return false;
    for (const int other : {0, 1})
      if (f(side, other) == 0) return false;
  }
  return true;
}

/// No bound of the region, without its factors in common with f, vanishes on f = 0 on a side.
bool crosses_sides_inside(const BivariatePolynomial& f, const SurfaceRegion& region,
                          const RationalPatch& patch) {
  const auto are_apart_on_side = [](const Polynomial& a, const Polynomial& b) {
    return !b.is_zero() && gcd(a, b).degree() < 1;
  };
  return std::ranges::all_of(region.bounds, [&](const SurfaceBound& bound) {
    const BivariatePolynomial form = pull_back(bound.form, patch);
    if (form.is_zero()) return true;
    const BivariatePolynomial h = without_factors_of(f, form);
    return std::ranges::all_of(std::array{0, 1}, [&](int side) {
      return are_apart_on_side(f.at_r(side), h.at_r(side)) && are_apart_on_side(f.at_s(side), h.at_s(side));
    });
  });
}

/// Factors for these turns; empty if a factor may be lost beyond the patch with halves 0, or the curve does
/// not cross the sides of all patches simply and off the bounds of the region.
class TurnedCurve {
 public:
  TurnedCurve(const SpacePolynomial& f, const SurfaceRegion& region, const TorusFrame& frame,
              const TorusTurns& turns) {
    const RationalPatch first = torus_chart(frame, turns, 0, 0);
    const BivariatePolynomial section = pull_back(f, first);
    is_zero = section.is_zero();
    if (is_zero) return;
    const int degree = 2 * f.degree();
    if (section.degree_r() != degree || section.degree_s() != degree) return;
    for (const BivariatePower& power : irreducible_factors(section))
      if (!is_nowhere_real(power.factor)) factors.push_back({power.factor, power.multiplicity});
    is_general = true;
    for (const int half_u : {0, 1})
      for (const int half_v : {0, 1}) {
        TorusPart part{torus_chart(frame, turns, half_u, half_v), {}, {}};
        for (const TorusFactor& factor : factors)
          part.factors.push_back(on_other_half(factor.factor, half_u == 1, half_v == 1));
        is_general =
            is_general && (factors.empty() || (crosses_sides_simply(product(part)) &&
                                               crosses_sides_inside(product(part), region, part.patch)));
        parts.push_back(std::move(part));
      }
  }

  static BivariatePolynomial product(const TorusPart& part) {
    BivariatePolynomial result = BivariatePolynomial::constant(1);
    for (const BivariatePolynomial& factor : part.factors) result = result * factor;
    return result;
  }

  bool is_zero = false;
  bool is_general = false;
  std::vector<TorusFactor> factors;
  std::vector<TorusPart> parts;
};

/// Nodes of a graph on one side, in order along it.
std::vector<std::size_t> nodes_on_side(const CurveGraph& graph, bool on_u, int side) {
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < graph.nodes.size(); ++i) {
    const CurveNode& node = graph.nodes[i];
    if (!node.is_on_side) continue;
    const bool is_on_u = node.u == RealAlgebraic(0) || node.u == RealAlgebraic(1);
    if (is_on_u != on_u) continue;
    if (on_u ? node.u == RealAlgebraic(side) : node.v.lower == side && node.v.upper == side)
      result.push_back(i);
  }
  // Those of one u by v, which has disjoint intervals; others ascend in u already.
  if (on_u)
    std::sort(result.begin(), result.end(),
              [&](std::size_t a, std::size_t b) { return graph.nodes[a].v.lower < graph.nodes[b].v.lower; });
  return result;
}

/// Puts the graphs of the parts together.
class Gluing {
 public:
  explicit Gluing(TorusCurve& curve) : curve_(curve) {
    std::size_t count = 0;
    for (const TorusPart& part : curve.parts) {
      first_.push_back(count);
      count += part.curve.graph.nodes.size();
    }
    partner_.assign(count, count);
  }

  void run() {
    for (const std::size_t half : {std::size_t{0}, std::size_t{1}})
      for (const std::size_t from : {std::size_t{0}, std::size_t{1}}) {
        glue(true, part_of(from, half), part_of(1 - from, half));
        glue(false, part_of(half, from), part_of(half, 1 - from));
      }
    add_nodes();
    for (std::size_t part = 0; part < curve_.parts.size(); ++part)
      for (std::size_t i = 0; i < curve_.parts[part].curve.graph.arcs.size(); ++i) add_arc(part, i);
  }

 private:
  /// The side 1 of one part is the side 0 of the next one; the curve has the same simple zeros on both.
  void glue(bool on_u, std::size_t part, std::size_t next) {
    const std::vector<std::size_t> before = nodes_on_side(curve_.parts[part].curve.graph, on_u, 1);
    const std::vector<std::size_t> after = nodes_on_side(curve_.parts[next].curve.graph, on_u, 0);
    if (before.size() != after.size()) throw ProofFailure(whole_domain(), "parts of a torus do not fit");
    for (std::size_t k = 0; k < before.size(); ++k) {
      partner_[first_[part] + before[k]] = first_[next] + after[k];
      partner_[first_[next] + after[k]] = first_[part] + before[k];
    }
  }

  void add_nodes() {
    position_.assign(partner_.size(), 0);
    for (std::size_t part = 0; part < curve_.parts.size(); ++part) {
      const std::vector<CurveNode>& nodes = curve_.parts[part].curve.graph.nodes;
      for (std::size_t i = 0; i < nodes.size(); ++i) {
        const std::size_t at = first_[part] + i, other = partner_[at];
        if (nodes[i].is_on_side && (other == partner_.size() || nodes[i].degree() != 1))
          throw ProofFailure(whole_domain(), "a curve on a torus ends on a side of a part");
        if (other < at) {
          position_[at] = position_[other];
          ++curve_.nodes[position_[at]].degree;
          continue;
        }
        position_[at] = curve_.nodes.size();
        curve_.nodes.push_back({part, i, nodes[i].degree(), nodes[i].is_singular,
                                bound_positions_at(curve_.parts[part].curve, i)});
      }
    }
  }

  void add_arc(std::size_t part, std::size_t i) {
    const TorusPart& at = curve_.parts[part];
    const CurveBranch& arc = at.curve.graph.arcs[i];
    for (std::size_t k = 0; k < at.factors.size(); ++k) {
      if (sign_at(at.factors[k].exchanged(), arc.inside) != 0) continue;
      curve_.arcs.push_back(
          {part, i, position_[first_[part] + arc.from], position_[first_[part] + arc.to], k});
      return;
    }
  }

  TorusCurve& curve_;
  std::vector<std::size_t> first_;     // of the nodes of each part, numbered through
  std::vector<std::size_t> partner_;   // the same node of another part; the count of all for none
  std::vector<std::size_t> position_;  // in curve_.nodes
};

}  // namespace

std::optional<TorusCurve> torus_curve(const ImplicitSurface& torus, const ImplicitSurface& other,
                                      const SurfaceRegion& region) {
  const std::optional<TorusFrame> frame = torus_frame(*torus.data());
  if (!frame) return std::nullopt;
  for (int i = 0; i < kMostTurns; ++i) {
    interruption_point();
    const TorusTurns turns = {turn_by(i == 0 ? Rational(0) : Rational(1, i + 1)),
                              turn_by(i == 0 ? Rational(0) : Rational(1, 2 * i + 1))};
    TurnedCurve turned(other.equation(), region, *frame, turns);
    if (!turned.is_zero && !turned.is_general) continue;
    TorusCurve result{*frame, turns, turned.is_zero, std::move(turned.factors), {}, {}, {}};
    if (result.is_same || result.factors.empty()) return result;
    result.parts = std::move(turned.parts);
    for (TorusPart& part : result.parts)
      part.curve = curve_in(region, TurnedCurve::product(part), part.patch);
    Gluing(result).run();
    return result;
  }
  throw ProofFailure(whole_domain(), "no general position of the parts of a torus is found");
}

}  // namespace exsect
