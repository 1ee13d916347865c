#include "support/graph_isomorphism.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

namespace exsect {
namespace {

using Labels = std::vector<int>;  // sorted
using Vector4 = std::array<double, 4>;

template <typename Items, typename Number>
Labels labels(const Items& items, Number number) {
  Labels result;
  for (const auto& item : items) result.push_back(number(item));
  std::sort(result.begin(), result.end());
  return result;
}

Labels kinds(const Node& node) {
  return labels(node.kinds, [](NodeKind kind) { return static_cast<int>(kind); });
}

Labels renamed(const std::vector<Parameter>& parameters, const Renaming& renaming) {
  return labels(parameters, [&](Parameter p) { return static_cast<int>(renaming.to[index(p)]); });
}

Labels sides(const Node& node, const Renaming& renaming) {
  return labels(node.on, [&](const Side& side) {
    const std::size_t i = index(side.parameter);
    return static_cast<int>(2 * renaming.to[i]) + (renaming.reversed[i] ? 1 - side.value : side.value);
  });
}

Vector4 renamed(const Vector4& z, const Renaming& renaming) {
  Vector4 result{};
  for (std::size_t i = 0; i < 4; ++i) result[renaming.to[i]] = renaming.reversed[i] ? 1 - z[i] : z[i];
  return result;
}

bool overlap(const ParameterBox& a, const ParameterBox& b, const Renaming& renaming) {
  for (std::size_t i = 0; i < 4; ++i) {
    const RationalInterval& other = b[renaming.to[i]];
    const Rational lower = renaming.reversed[i] ? 1 - a[i].upper : a[i].lower;
    const Rational upper = renaming.reversed[i] ? 1 - a[i].lower : a[i].upper;
    if (upper < other.lower || other.upper < lower) return false;
  }
  return true;
}

double distance(const Vector4& a, const Vector4& b) {
  double result = 0;
  for (std::size_t i = 0; i < 4; ++i) result = std::max(result, std::abs(a[i] - b[i]));
  return result;
}

/// From z to the segment from a to b, as the largest difference of a parameter at the Euclidean foot.
double distance_to_segment(const Vector4& z, const Vector4& a, const Vector4& b) {
  double along = 0;
  double length = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    along += (z[i] - a[i]) * (b[i] - a[i]);
    length += (b[i] - a[i]) * (b[i] - a[i]);
  }
  const double t = length > 0 ? std::clamp(along / length, 0.0, 1.0) : 0;
  Vector4 foot{};
  for (std::size_t i = 0; i < 4; ++i) foot[i] = a[i] + t * (b[i] - a[i]);
  return distance(z, foot);
}

double distance_to_polyline(const Vector4& z, const std::vector<PolylineVertex>& line) {
  double result = distance(z, line.front().parameters);
  for (std::size_t k = 1; k < line.size(); ++k) {
    result = std::min(result, distance_to_segment(z, line[k - 1].parameters, line[k].parameters));
  }
  return result;
}

struct Different : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Finds the correspondence step by step; `Different` where there is none.
class Matching {
 public:
  Matching(const IntersectionGraph& a, const IntersectionGraph& b, const Renaming& renaming, double tolerance)
      : a_(a), b_(b), renaming_(renaming), tolerance_(tolerance) {}

  void run() {
    require(a_.nodes.size() == b_.nodes.size(), "numbers of nodes");
    require(a_.arcs.size() == b_.arcs.size(), "numbers of arcs");
    require(a_.components.size() == b_.components.size(), "numbers of components");
    require(a_.overlaps.size() == b_.overlaps.size(), "numbers of overlaps");
    for (const Node& node : a_.nodes) match(node);
    for (const Arc& arc : a_.arcs) match(arc);
    for (const Component& component : a_.components) match(component);
    const auto other = [&](int node) { return nodes_.at(node); };
    for (const Overlap& overlap : a_.overlaps) match(overlap);
    require(labels(a_.isolated_points, other) == labels(b_.isolated_points, [](int node) { return node; }),
            "isolated points");
  }

 private:
  static void require(bool equal, const std::string& what) {
    if (!equal) throw Different("different " + what);
  }

  /// Enters the best of the candidates that `error` does not exclude and that no other item has.
  template <typename Item, typename Error>
  static void choose(const Item& item, const std::vector<Item>& candidates, std::map<int, int>& taken,
                     const Error& error, const std::string& what) {
    const Item* best = nullptr;
    double least = 0;
    for (const Item& candidate : candidates) {
      const std::optional<double> e = error(candidate);
      if (e && (!best || *e < least)) {
        best = &candidate;
        least = *e;
      }
    }
    const std::string name = what + " " + std::to_string(item.id);
    if (!best) throw Different(name + " of the first graph has no counterpart");
    for (const auto& entry : taken) {
      if (entry.second == best->id) throw Different(name + " of the first graph shares its counterpart");
    }
    taken[item.id] = best->id;
  }

  void match(const Node& node) {
    const auto error = [&](const Node& other) -> std::optional<double> {
      const bool same = kinds(node) == kinds(other) &&
                        renamed(node.wrt, renaming_) == renamed(other.wrt, {}) &&
                        renamed(node.free, renaming_) == renamed(other.free, {}) &&
                        sides(node, renaming_) == sides(other, {}) && overlap(node.box, other.box, renaming_);
      if (!same) return std::nullopt;
      return distance(renamed(node.approx, renaming_), other.approx);
    };
    choose(node, b_.nodes, nodes_, error, "node");
  }

  void match(const Arc& arc) {
    choose(
        arc, b_.arcs, arcs_, [&](const Arc& other) { return error(arc, other); }, "arc");
  }

  /// How far the arcs run apart; empty if they do not correspond.
  std::optional<double> error(const Arc& arc, const Arc& other) const {
    const auto ends = std::minmax(nodes_.at(arc.from), nodes_.at(arc.to));
    const bool same = ends == std::minmax(other.from, other.to) && arc.place == other.place &&
                      arc.contact == other.contact && renamed(arc.free, renaming_) == renamed(other.free, {});
    if (!same) return std::nullopt;
    double largest = 0;
    for (std::size_t k = 0; k < arc.polyline.size(); k += 1 + arc.polyline.size() / 16) {
      const Vector4 z = renamed(arc.polyline[k].parameters, renaming_);
      largest = std::max(largest, distance_to_polyline(z, other.polyline));
    }
    return largest < tolerance_ ? std::optional(largest) : std::nullopt;
  }

  /// The same chains up to order, direction and first arc.
  void match(const Overlap& overlap) {
    const auto corresponds = [&](const Overlap& other) {
      return overlap.chains.size() == other.chains.size() &&
             std::all_of(overlap.chains.begin(), overlap.chains.end(), [&](const std::vector<Arc>& chain) {
               return std::any_of(other.chains.begin(), other.chains.end(),
                                  [&](const std::vector<Arc>& candidate) { return same(chain, candidate); });
             });
    };
    require(std::count_if(b_.overlaps.begin(), b_.overlaps.end(), corresponds) == 1, "overlaps");
  }

  bool same(const std::vector<Arc>& chain, const std::vector<Arc>& other) const {
    return chain.size() == other.size() && std::all_of(chain.begin(), chain.end(), [&](const Arc& arc) {
             return std::any_of(other.begin(), other.end(),
                                [&](const Arc& candidate) { return error(arc, candidate).has_value(); });
           });
  }

  void match(const Component& component) {
    const auto other_component = [&](int arc) {
      return b_.arcs.at(static_cast<std::size_t>(arcs_.at(arc))).component;
    };
    const Component& other =
        b_.components.at(static_cast<std::size_t>(other_component(component.arcs.at(0))));
    require(component.shape == other.shape, "shapes of components");
    require(component.arcs.size() == other.arcs.size(), "sizes of components");
    for (const int arc : component.arcs) require(other_component(arc) == other.id, "components");
  }

  const IntersectionGraph& a_;
  const IntersectionGraph& b_;
  const Renaming& renaming_;
  double tolerance_;
  std::map<int, int> nodes_;  // ids in a to ids in b
  std::map<int, int> arcs_;
};

}  // namespace

std::string difference(const IntersectionGraph& a, const IntersectionGraph& b, const Renaming& renaming,
                       double tolerance) {
  try {
    Matching(a, b, renaming, tolerance).run();
    return "";
  } catch (const Different& different) {
    return different.what();
  }
}

}  // namespace exsect
