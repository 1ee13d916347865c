#include "lift/curve_names.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

#include "lift/plane_section.h"

namespace exsect {
namespace {

/// Arcs without a name of one factor: connected parts, a number for each of them.
class ConnectedParts {
 public:
  ConnectedParts(const LiftedCurve& curve, std::size_t factor) : parent_(curve.nodes.size()) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
    for (const LiftedArc& arc : curve.arcs)
      if (arc.factor == factor) parent_[root(arc.from)] = root(arc.to);
  }

  int operator()(const LiftedArc& arc) const { return static_cast<int>(root(arc.from)); }

 private:
  std::size_t root(std::size_t node) const {
    while (parent_[node] != node) node = parent_[node];
    return node;
  }

  std::vector<std::size_t> parent_;
};

/// The arcs of one factor, by their curves.
void add_curves(const LiftedCurve& curve, std::size_t factor, std::vector<SpaceCurve>& curves) {
  const auto general = [](int) { return SpaceCurve{0, SpaceCurveKind::general, {}, false, 1}; };
  const NamedParts named =
      named_parts(curve, curve.factors[factor]).value_or(NamedParts{ConnectedParts(curve, factor), general});
  std::map<std::pair<int, int>, std::size_t> position;  // arcs of one order of contact
  for (std::size_t i = 0; i < curve.arcs.size(); ++i) {
    const LiftedArc& arc = curve.arcs[i];
    if (arc.factor != factor) continue;
    const int part = named.part(arc);
    const auto [at, is_new] = position.emplace(std::pair(part, arc.multiplicity), curves.size());
    if (is_new) {
      curves.push_back(named.curve(part));
      curves.back().id = static_cast<int>(at->second);
      curves.back().multiplicity = arc.multiplicity;
      if (std::optional<Point>& direction = curves.back().direction) direction = shortened(*direction);
    }
    curves[at->second].arcs.push_back(static_cast<int>(i));
  }
}

}  // namespace

std::vector<SpaceCurve> named_curves(const LiftedCurve& curve) {
  std::vector<SpaceCurve> curves;
  for (std::size_t factor = 0; factor < curve.factors.size(); ++factor) add_curves(curve, factor, curves);
  return curves;
}

}  // namespace exsect
