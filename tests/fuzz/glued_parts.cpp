#include "glued_parts.h"

#include <exsect/solver/intersect_rational.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <vector>

namespace exsect::glued_parts {

namespace {

/// A node in the parameters of the whole. `cut` is where it lies on a cut: in u, in s. Of a node whose
/// parameter u or s is free in a part, `run_on` is where the node of the whole may go on in another part.
struct Place {
  ParameterBox box;
  std::array<bool, 2> cut = {};
  std::array<bool, 2> run_on = {};
  bool on_side = false;  // of the whole
};

bool meet(const ParameterBox& a, const ParameterBox& b) {
  return std::ranges::all_of(all_parameters, [&](Parameter p) {
    const std::size_t j = index(p);
    return a[j].lower <= b[j].upper && b[j].lower <= a[j].upper;
  });
}

/// Classes of numbers that are joined one by one.
class Classes {
 public:
  void add() { parent_.push_back(parent_.size()); }
  void join(std::size_t a, std::size_t b) { parent_[root(a)] = root(b); }
  std::size_t root(std::size_t a) const {
    while (parent_[a] != a) a = parent_[a];
    return a;
  }

 private:
  std::vector<std::size_t> parent_;
};

/// Nodes joined by arcs, and those that are one point, on a cut or with a free parameter.
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
      for (const Parameter parameter : node.free)
        if (parameter == Parameter::u || parameter == Parameter::s)
          place.run_on[parameter == Parameter::u ? 0 : 1] = true;
      places_.push_back(place);
      points_.add();
      curves_.add();
    }
    for (const Arc& arc : graph.arcs) {
      const std::size_t from = first + static_cast<std::size_t>(arc.from);
      const std::size_t to = first + static_cast<std::size_t>(arc.to);
      ends_of_arcs_.push_back(from);
      ends_of_arcs_.push_back(to);
      curves_.join(from, to);
    }
  }

  /// False if a point on a cut is in no other part.
  bool glue() {
    std::vector<bool> met(places_.size(), false);
    for (std::size_t a = 0; a < places_.size(); ++a)
      for (std::size_t b = a + 1; b < places_.size(); ++b) {
        const auto same = [&](const std::array<bool, 2> Place::*kind) {
          return ((places_[a].*kind)[0] && (places_[b].*kind)[0]) ||
                 ((places_[a].*kind)[1] && (places_[b].*kind)[1]);
        };
        if ((!same(&Place::cut) && !same(&Place::run_on)) || !meet(places_[a].box, places_[b].box)) continue;
        met[a] = met[b] = true;
        points_.join(a, b);
        curves_.join(a, b);
      }
    for (std::size_t a = 0; a < places_.size(); ++a)
      if ((places_[a].cut[0] || places_[a].cut[1]) && !met[a]) return false;
    return true;
  }

  std::size_t root(std::size_t a) const { return curves_.root(a); }

  /// Ends of curves: points on a side of the whole, with one arc.
  std::vector<std::size_t> ends() const {
    const std::vector<int> degree = degrees();
    std::vector<std::size_t> result;
    for (std::size_t a = 0; a < places_.size(); ++a)
      if (places_[a].on_side && degree[points_.root(a)] == 1 && points_.root(a) == a) result.push_back(a);
    return result;
  }
  const Place& place(std::size_t a) const { return places_[a]; }

  /// The numbers of open and closed curves, of branched ones, and of points without arcs.
  std::array<int, 4> counts() const {
    std::vector<int> number_of_ends(places_.size(), 0), arcs(places_.size(), 0), most(places_.size(), 0);
    for (const std::size_t end : ends()) ++number_of_ends[root(end)];
    const std::vector<int> degree = degrees();
    for (std::size_t a = 0; a < places_.size(); ++a) {
      arcs[root(a)] += degree[a];
      most[root(a)] = std::max(most[root(a)], degree[a]);
    }
    std::array<int, 4> result = {};
    for (std::size_t a = 0; a < places_.size(); ++a) {
      if (root(a) != a) continue;
      ++result[arcs[a] == 0 ? 3 : most[a] > 2 ? 2 : number_of_ends[a] == 0 ? 1 : 0];
    }
    return result;
  }

 private:
  /// How many arcs end in a point, for the one that stands for it; 0 for the others.
  std::vector<int> degrees() const {
    std::vector<int> result(places_.size(), 0);
    for (const std::size_t end : ends_of_arcs_) ++result[points_.root(end)];
    return result;
  }

  std::vector<Place> places_;
  std::vector<std::size_t> ends_of_arcs_;
  Classes points_;
  Classes curves_;
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
  // The parts of an arc along which the parameter is free, side by side, are no arcs of the whole.
  const auto side_by_side = [](const Arc& arc) { return !arc.free.empty(); };
  if (std::ranges::any_of(whole.arcs, side_by_side)) return std::nullopt;
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
