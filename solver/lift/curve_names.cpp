#include "lift/curve_names.h"

#include <algorithm>
#include <map>
#include <utility>

#include "lift/connected_parts.h"
#include "lift/plane_section.h"

namespace exsect {
namespace {

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
