#include "self/pair_orders.h"

#include <algorithm>
#include <map>
#include <optional>

#include "answer/parameter_box.h"
#include "answer/parameter_names.h"
#include "self/chart.h"

namespace exsect {
namespace {

constexpr ParameterNames exchanged_names = {Parameter::r, Parameter::s, Parameter::u, Parameter::v};

/// Sets with a sign: of each member relative to the set's root.
class SignedSets {
 public:
  explicit SignedSets(std::size_t n) : parent_(n), exchanged_(n, false) {
    for (std::size_t i = 0; i < n; ++i) parent_[i] = i;
  }

  struct Place {
    std::size_t root;
    bool exchanged;
  };
  Place find(std::size_t i) const {
    Place place{i, false};
    while (parent_[place.root] != place.root) {
      place.exchanged = place.exchanged != exchanged_[place.root];
      place.root = parent_[place.root];
    }
    return place;
  }

  /// Unless they are in one set already.
  void unite(std::size_t a, std::size_t b, bool exchanged) {
    const Place p = find(a), q = find(b);
    if (p.root == q.root) return;
    parent_[q.root] = p.root;
    exchanged_[q.root] = exchanged != (p.exchanged != q.exchanged);
  }

 private:
  std::vector<std::size_t> parent_;
  std::vector<bool> exchanged_;  // relative to the parent
};

class Orders {
 public:
  Orders(GraphBuilder& graph, const std::vector<std::size_t>& mates) : graph_(graph), mates_(mates) {}

  void run() {
    const std::size_t n = graph_.nodes().size();
    SignedSets sets(n);
    std::vector<bool> used(n, false);
    for (const Arc& arc : graph_.arcs()) {
      const auto from = static_cast<std::size_t>(arc.from), to = static_cast<std::size_t>(arc.to);
      used[from] = used[to] = true;
      sets.unite(from, to, false);
    }
    bool any = false;
    for (std::size_t i = 0; i < n; ++i) {
      const auto mate = used[i] ? mate_of(i) : std::nullopt;
      if (!mate || *mate == i || !used[*mate]) continue;
      any = any || sets.find(i).root != sets.find(*mate).root;
      sets.unite(i, *mate, true);
    }
    if (!any) return;
    std::vector<Arc> arcs = graph_.take_arcs(0);
    for (Arc& arc : arcs) {
      if (sets.find(static_cast<std::size_t>(arc.from)).exchanged) exchange(arc);
      graph_.add_arc(std::move(arc));
    }
  }

 private:
  /// The other order's node, the same one for a pair of equal points.
  std::optional<std::size_t> mate_of(std::size_t id) const {
    if (id < mates_.size()) return mates_[id];
    const ParameterBox box = exchanged_pair(graph_.nodes()[id].box);
    for (std::size_t i = mates_.size(); i < graph_.nodes().size(); ++i)
      if (const ParameterBox& at = graph_.nodes()[i].box; lies_in(at, box) && lies_in(box, at)) return i;
    return std::nullopt;
  }

  void exchange(Arc& arc) {
    arc.from = other(arc.from);
    arc.to = other(arc.to);
    rename_parameters(arc, exchanged_names);
  }

  int other(int id) {
    const auto known = other_.find(id);
    if (known != other_.end()) return known->second;
    if (const auto mate = mate_of(static_cast<std::size_t>(id))) return other_[id] = static_cast<int>(*mate);
    Node node = graph_.node(id);
    rename_parameters(node, exchanged_names);
    return other_[id] = graph_.add_node(std::move(node));
  }

  GraphBuilder& graph_;
  const std::vector<std::size_t>& mates_;
  std::map<int, int> other_;
};

}  // namespace

void join_orders(GraphBuilder& graph, const std::vector<std::size_t>& mates) { Orders(graph, mates).run(); }

std::vector<Parameter> in_both_orders(const std::vector<Parameter>& wanted) {
  std::vector<Parameter> result;
  for (const Parameter p : all_parameters)
    if (std::ranges::any_of(wanted, [p](Parameter q) { return index(p) % 2 == index(q) % 2; }))
      result.push_back(p);
  return result;
}

}  // namespace exsect
