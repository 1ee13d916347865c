#include "glued_parts.h"

#include <exsect/solver/intersect_rational.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <vector>

namespace exsect::glued_parts {

namespace {

/// A node in the parameters of the whole. Inside, `cut` is where it lies on a cut: in u, in s.
struct Place {
  ParameterBox box;
  std::array<bool, 2> cut = {};
  bool on_side = false;  // of the whole
  int degree = 0;
};

bool meet(const ParameterBox& a, const ParameterBox& b) {
  return std::ranges::all_of(all_parameters, [&](Parameter p) {
    const std::size_t j = index(p);
    return a[j].lower <= b[j].upper && b[j].lower <= a[j].upper;
  });
}

/// Nodes joined by arcs, and those that are one point on a cut.
class Curves {
 public:
  void add(const IntersectionGraph& graph, const std::array<RationalInterval, 4>& part) {
    const std::size_t first = places_.size();
    for (const Node& node : graph.nodes) {
      Place place;
      for (std::size_t j = 0; j < 4; ++j) {
        const Rational width = part[j].width();
        place.box[j] = {part[j].lower + width * node.box[j].lower, part[j].lower + width * node.box[j].upper};
      }
      for (const Side& side : node.on) {
        const std::size_t j = index(side.parameter);
        const Rational value = side.value == 0 ? part[j].lower : part[j].upper;
        place.box[j] = {value, value};
        if (value == 0 || value == 1) {
          place.on_side = true;
        } else {
          place.cut[j == 0 ? 0 : 1] = true;
        }
      }
      places_.push_back(place);
      parent_.push_back(parent_.size());
    }
    for (const Arc& arc : graph.arcs) {
      const std::size_t from = first + static_cast<std::size_t>(arc.from);
      const std::size_t to = first + static_cast<std::size_t>(arc.to);
      ++places_[from].degree;
      ++places_[to].degree;
      join(from, to);
    }
  }

  /// False if a point on a cut is not in two parts.
  bool glue() {
    std::vector<int> met(places_.size(), 0);
    for (std::size_t a = 0; a < places_.size(); ++a)
      for (std::size_t b = a + 1; b < places_.size(); ++b) {
        const bool same_cut =
            (places_[a].cut[0] && places_[b].cut[0]) || (places_[a].cut[1] && places_[b].cut[1]);
        if (!same_cut || !meet(places_[a].box, places_[b].box)) continue;
        ++met[a];
        ++met[b];
        join(a, b);
      }
    for (std::size_t a = 0; a < places_.size(); ++a)
      if ((places_[a].cut[0] || places_[a].cut[1]) && met[a] != 1) return false;
    return true;
  }

  std::size_t root(std::size_t a) const {
    while (parent_[a] != a) a = parent_[a];
    return a;
  }
  /// Ends of curves: on a side of the whole, with one arc.
  std::vector<std::size_t> ends() const {
    std::vector<std::size_t> result;
    for (std::size_t a = 0; a < places_.size(); ++a)
      if (places_[a].on_side && places_[a].degree == 1) result.push_back(a);
    return result;
  }
  const Place& place(std::size_t a) const { return places_[a]; }

  /// The numbers of open and closed curves, of branched ones, and of points without arcs.
  std::array<int, 4> counts() const {
    std::vector<int> number_of_ends(places_.size(), 0), arcs(places_.size(), 0), most(places_.size(), 0);
    for (const std::size_t end : ends()) ++number_of_ends[root(end)];
    for (std::size_t a = 0; a < places_.size(); ++a) {
      arcs[root(a)] += places_[a].degree;
      most[root(a)] = std::max(most[root(a)], places_[a].degree);
    }
    std::array<int, 4> result = {};
    for (std::size_t a = 0; a < places_.size(); ++a) {
      if (root(a) != a) continue;
      ++result[arcs[a] == 0 ? 3 : most[a] > 2 ? 2 : number_of_ends[a] == 0 ? 1 : 0];
    }
    return result;
  }

 private:
  void join(std::size_t a, std::size_t b) { parent_[root(a)] = root(b); }

  std::vector<Place> places_;
  std::vector<std::size_t> parent_;
};

/// Ends of a and b in bijection by their boxes, in the same pairs.
std::string difference_of_ends(const Curves& a, const Curves& b) {
  const std::vector<std::size_t> of_a = a.ends(), of_b = b.ends();
  if (of_a.size() != of_b.size()) return "another number of ends";
  std::vector<std::size_t> partner;
  for (const std::size_t end : of_a) {
    std::vector<std::size_t> found;
    for (const std::size_t other : of_b)
      if (meet(a.place(end).box, b.place(other).box)) found.push_back(other);
    if (found.size() != 1) return "an end that is not the end of one curve";
    partner.push_back(found.front());
  }
  for (std::size_t i = 0; i < of_a.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      if ((a.root(of_a[i]) == a.root(of_a[k])) != (b.root(partner[i]) == b.root(partner[k])))
        return "ends in other pairs";
  return "";
}

}  // namespace

std::optional<std::string> difference(const RationalPatch& x, const RationalPatch& y,
                                      const IntersectionGraph& whole, const Cuts& cuts) {
  const RationalInterval all = {0, 1};
  Curves expected, glued;
  expected.add(whole, {all, all, all, all});
  for (const RationalInterval& u : {RationalInterval{0, cuts.u}, RationalInterval{cuts.u, 1}})
    for (const RationalInterval& s : {RationalInterval{0, cuts.s}, RationalInterval{cuts.s, 1}}) {
      const IntersectResult part =
          intersect(x.restricted_to(u.lower, u.upper, 0, 1), y.restricted_to(0, 1, s.lower, s.upper));
      if (part.status != Status::complete || !part.graph.overlaps.empty()) return std::nullopt;
      glued.add(part.graph, {u, all, all, s});
    }
  if (!glued.glue()) return "a point on a cut that is not in two parts";
  if (expected.counts() != glued.counts()) return "other numbers of curves";
  return difference_of_ends(expected, glued);
}

}  // namespace exsect::glued_parts
