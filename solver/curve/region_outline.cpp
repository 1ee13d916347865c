#include "curve/region_outline.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <optional>

#include "answer/parameter_box.h"
#include "answer/proof_failure.h"
#include "curve/curve_sides.h"
#include "curve/factor_points.h"

namespace exsect {
namespace {

/// All zeros of the bounds and the four sides.
std::vector<BivariatePolynomial> lines_of(const CurveRegion& region) {
  const BivariatePolynomial u = BivariatePolynomial::r(), v = BivariatePolynomial::s(),
                            one = BivariatePolynomial::constant(1);
  std::vector<BivariatePolynomial> lines = {u, u - one, v, v - one};
  for (const std::vector<std::size_t>& clause : region.clauses)
    for (const std::size_t i : clause)
      if (!region.bounds[i].is_zero()) lines.push_back(region.bounds[i]);
  return coprime_factors(lines);
}

/// Whether the region has the points beside an arc: at smaller, and at greater v, or u on lines u = const.
struct ArcSides {
  bool before;
  bool beyond;
};

class Outline {
 public:
  explicit Outline(const CurveRegion& region)
      : region_(region), placed_(region), graph_(curve_graph_of_factors(lines_of(region))) {
    for (const BivariatePolynomial& bound : region.bounds) bounds_.push_back(bound.exchanged());
    for (const CurveBranch& arc : graph_.arcs) sides_.push_back(sides_of(arc));
  }

  RegionOutline run() {
    join_strips();
    for (std::size_t i = 0; i < sides_.size(); ++i)
      if (!sides_[i].before && !sides_[i].beyond && placed_.contains(graph_.arcs[i].inside))
        result_.curves.push_back(i);
    for (std::size_t i = 0; i < graph_.nodes.size(); ++i)
      if (is_point(i)) result_.points.push_back(i);
    for (std::size_t i = 0; i < sides_.size(); ++i)
      if (sides_[i].before != sides_[i].beyond && !is_used_[i]) add_chain(i);
    result_.graph = std::move(graph_);
    return std::move(result_);
  }

 private:
  bool is_vertical(const CurveBranch& arc) const {
    return graph_.nodes[arc.from].u == graph_.nodes[arc.to].u;
  }

  template <class Sign>
  bool has(Sign sign_of_bound) const {
    return place_by_signs(region_.clauses, sign_of_bound) != RegionPlace::outside;
  }

  /// Beside the arc a bound has the sign of its first derivative across that is not 0 (17.4).
  int sign_beside(std::size_t bound, const CurveBranch& arc, bool beyond) const {
    const bool in_u = is_vertical(arc);
    BivariatePolynomial derivative = bounds_[bound];
    for (int sign = 1; !derivative.is_zero(); sign = beyond ? 1 : -sign) {
      if (const int s = sign_at(derivative, arc.inside); s != 0) return sign * s;
      derivative = in_u ? derivative.derivative_s() : derivative.derivative_r();
    }
    return 0;
  }

  ArcSides sides_of(const CurveBranch& arc) const {
    const RationalInterval v = arc.inside.r_interval();
    const RealAlgebraic& u = graph_.nodes[arc.from].u;
    const auto is_side = [&](int value) {
      return is_vertical(arc) ? u == RealAlgebraic(value) : v.lower == value && v.upper == value;
    };
    const auto has_beside = [&](bool beyond) {
      return has([&](std::size_t i) { return sign_beside(i, arc, beyond); });
    };
    return {!is_side(0) && has_beside(false), !is_side(1) && has_beside(true)};
  }

  /// In the region, and alone there.
  bool is_point(std::size_t i) const {
    const CurveNode& node = graph_.nodes[i];
    if (!node.exact || !placed_.contains(*node.exact)) return false;
    if (node.degree() == 0)
      return !has([&](std::size_t k) {
        const int s = sign_at(bounds_[k], *node.exact);
        return (s != 0 || bounds_[k].is_zero()) ? s : sign_around(region_.bounds[k], node);
      });
    for (std::size_t k = 0; k < graph_.arcs.size(); ++k) {
      const CurveBranch& arc = graph_.arcs[k];
      if ((arc.from == i || arc.to == i) &&
          (sides_[k].before || sides_[k].beyond || placed_.contains(arc.inside)))
        return false;
    }
    return true;
  }

  // Strips between neighbouring arcs of a column, numbered through, in connected groups.

  std::size_t group(std::size_t strip) const {
    while (group_[strip] != strip) strip = group_[strip];
    return strip;
  }
  void join(std::size_t a, std::size_t b) { group_[group(a)] = group(b); }
  /// Below arc k of column i, above arc k - 1; 0 < k.
  std::size_t strip(std::size_t i, std::size_t k) const { return first_strip_[i] + k; }

  void join_strips() {
    std::size_t count = 0;
    for (const CurveColumn& column : graph_.columns) {
      first_strip_.push_back(count);
      count += column.size() + 1;
    }
    group_.resize(count);
    std::iota(group_.begin(), group_.end(), std::size_t{0});
    beside_.assign(graph_.arcs.size(), {});
    is_used_.assign(graph_.arcs.size(), false);
    for (std::size_t i = 0; i < graph_.columns.size(); ++i)
      for (std::size_t k = 0; k < graph_.columns[i].size(); ++k)
        set_beside(graph_.columns[i][k], {strip(i, k), strip(i, k + 1)});
    for (std::size_t i = 0; i < graph_.values.size(); ++i) join_over(i);
  }

  /// The strips on both sides of an arc; it does not part those of the region.
  void set_beside(std::size_t arc, std::array<std::size_t, 2> strips) {
    beside_[arc] = strips;
    if (sides_[arc].before && sides_[arc].beyond) join(strips[0], strips[1]);
  }

  /// The points over value i from below, each with its arcs, divide the line u = const: its pieces are inside
  /// of one strip from either side, or arcs between them.
  void join_over(std::size_t i) {
    const CurveColumn none;
    const CurveColumn &left = i > 0 ? graph_.columns[i - 1] : none,
                      &right = i < graph_.columns.size() ? graph_.columns[i] : none;
    const std::vector<std::size_t> nodes = nodes_over(i);
    std::size_t l = 0, r = 0, node = 0;
    while (l < left.size() || r < right.size() || node < nodes.size()) {
      const bool passes = l < left.size() && r < right.size() && left[l] == right[r];
      const bool is_node = node < nodes.size() && !(passes && is_below(left[l], i, nodes[node]));
      if (!is_node && !passes)
        throw ProofFailure(whole_domain(), "the arcs of a region's outline have no order");
      l += is_node ? static_cast<std::size_t>(graph_.nodes[nodes[node]].left) : 1;
      r += is_node ? static_cast<std::size_t>(graph_.nodes[nodes[node]].right) : 1;
      const std::optional<std::size_t> line = is_node ? line_from(nodes[node]) : std::nullopt;
      node += is_node ? 1 : 0;
      const bool is_inside = i > 0 && i < graph_.columns.size();
      const std::size_t before = i > 0 ? strip(i - 1, l) : strip(i, r);
      const std::size_t beyond = i < graph_.columns.size() ? strip(i, r) : before;
      if (line)
        set_beside(*line, {before, beyond});
      else if (is_inside)
        join(before, beyond);
    }
  }

  std::vector<std::size_t> nodes_over(std::size_t i) const {
    std::vector<std::size_t> nodes;
    for (std::size_t k = 0; k < graph_.nodes.size(); ++k)
      if (graph_.nodes[k].u == graph_.values[i]) nodes.push_back(k);
    std::ranges::sort(nodes, {}, [&](std::size_t k) { return graph_.nodes[k].v.lower; });
    return nodes;
  }

  /// An arc that passes value i is below a node over it: it leaves the node's own arcs above it, or, where
  /// this has none, the value of v at the node.
  bool is_below(std::size_t arc, std::size_t i, std::size_t node) const {
    const CurveNode& at = graph_.nodes[node];
    const auto is_first = [&](const CurveColumn& column, auto&& is_of_node) {
      for (const std::size_t other : column) {
        if (other == arc) return true;
        if (is_of_node(graph_.arcs[other])) return false;
      }
      return false;
    };
    if (at.left > 0)
      return is_first(graph_.columns[i - 1], [&](const CurveBranch& b) { return b.to == node; });
    if (at.right > 0)
      return is_first(graph_.columns[i], [&](const CurveBranch& b) { return b.from == node; });
    return false;  // isolated: it parts nothing, wherever it is put
  }

  /// The arc of a line u = const that begins in the node.
  std::optional<std::size_t> line_from(std::size_t node) const {
    for (std::size_t k = 0; k < graph_.arcs.size(); ++k)
      if (graph_.arcs[k].from == node && graph_.nodes[graph_.arcs[k].to].u == graph_.nodes[node].u) return k;
    return std::nullopt;
  }

  // Chains.

  OutlineArc directed(std::size_t arc) const {
    return {arc, is_vertical(graph_.arcs[arc]) ? sides_[arc].beyond : sides_[arc].before};
  }
  std::size_t start(const OutlineArc& at) const {
    return at.is_reversed ? graph_.arcs[at.arc].to : graph_.arcs[at.arc].from;
  }
  std::size_t end(const OutlineArc& at) const {
    return at.is_reversed ? graph_.arcs[at.arc].from : graph_.arcs[at.arc].to;
  }
  std::size_t group_of(std::size_t arc) const { return group(beside_[arc][sides_[arc].beyond ? 1 : 0]); }

  /// As many arcs of a part end in a node as begin there.
  void add_chain(std::size_t first) {
    std::vector<OutlineArc> chain = {directed(first)};
    is_used_[first] = true;
    while (end(chain.back()) != start(chain.front())) {
      std::size_t next = 0;
      while (next < sides_.size() &&
             (is_used_[next] || sides_[next].before == sides_[next].beyond ||
              start(directed(next)) != end(chain.back()) || group_of(next) != group_of(first)))
        ++next;
      if (next == sides_.size()) throw ProofFailure(whole_domain(), "the rim of a region does not close");
      is_used_[next] = true;
      chain.push_back(directed(next));
    }
    const auto known = std::ranges::find(part_groups_, group_of(first));
    if (known == part_groups_.end()) {
      part_groups_.push_back(group_of(first));
      result_.parts.push_back({{std::move(chain)}});
    } else {
      result_.parts[static_cast<std::size_t>(known - part_groups_.begin())].chains.push_back(
          std::move(chain));
    }
  }

  const CurveRegion& region_;
  PlacedRegion placed_;
  CurveGraph graph_;
  std::vector<BivariatePolynomial> bounds_;  // v first
  std::vector<ArcSides> sides_;
  std::vector<std::size_t> first_strip_;
  std::vector<std::size_t> group_;
  std::vector<std::array<std::size_t, 2>> beside_;  // strips before and beyond each arc
  std::vector<bool> is_used_;
  std::vector<std::size_t> part_groups_;
  RegionOutline result_;
};

}  // namespace

RegionOutline outline(const CurveRegion& region) { return Outline(region).run(); }

}  // namespace exsect
