// Joins that the truth does not have, splits where it has none, and stated contacts.
#include <algorithm>
#include <cmath>

#include "infinite.h"
#include "verifier.h"

namespace exsect {
namespace {}  // namespace

void Verifier::judge_connections() {
  for (std::size_t c = 0; c < curves_.size(); ++c)
    for (const Strand& strand : curves_[c].strands)
      for (std::size_t w = 0; w + 1 < strand.walks.size(); ++w)
        judge_join(c, strand, strand.walks[w], strand.walks[w + 1]);
  for (const ComponentFinding& component : verdict_.components)
    if (component.coverage == Coverage::partly) judge_split(component);
}

std::optional<int> Verifier::certain_component(const Strand& strand, const Walk& walk) const {
  const std::size_t steps = std::min<std::size_t>(walk.last - walk.first, 16);
  for (std::size_t k = 0; k <= steps; ++k) {
    const std::size_t vertex = walk.first + k * (walk.last - walk.first) / std::max<std::size_t>(steps, 1);
    std::set<int> components;
    const double radius =
        tolerance_ + strand.chain.bound[std::min(vertex, strand.chain.pieces() - 1)] + rounding_;
    truth_.tree().within(strand.chain.points[vertex], 2 * radius, [&](const ChainPlace& place) {
      components.insert(truth_.arcs()[place.chain].arc->component);
    });
    if (components.size() == 1) return *components.begin();
  }
  return std::nullopt;
}

void Verifier::judge_join(std::size_t c, const Strand& strand, const Walk& before, const Walk& after) {
  require_time(stop_);
  const auto from = certain_component(strand, before);
  const auto to = certain_component(strand, after);
  if (!from || !to || *from < 0 || *to < 0) return;
  if (*from == *to && !is_shortcut(strand.chain, before, after)) return;
  const CandidatePart part = {c, strand.representation, strand.chain.at[before.last],
                              strand.chain.at[after.first]};
  Difference& difference = differ(
      DifferenceKind::wrong_connection,
      "curve " + std::to_string(c) + " joins " +
          (*from == *to ? "two places of component " + std::to_string(*from) + " that are apart"
                        : "component " + std::to_string(*from) + " to component " + std::to_string(*to)) +
          " between " + decimal(part.from) + " and " + decimal(part.to));
  difference.curve = c;
  difference.part = part;
  difference.components = *from == *to ? std::vector<int>{*from} : std::vector<int>{*from, *to};
}

bool Verifier::is_shortcut(const Chain& chain, const Walk& before, const Walk& after) const {
  Chain bridge;
  double length = 0;
  for (std::size_t i = before.last; i <= after.first; ++i) {
    bridge.points.push_back(chain.points[i]);
    if (i == before.last) continue;
    bridge.bound.push_back(chain.bound[i - 1]);
    length += distance(chain.points[i - 1], chain.points[i]);
  }
  if (bridge.bound.empty()) return false;
  const std::vector<Chain> alone = {bridge};
  const PieceTree tree(alone);
  const Leg& from = before.legs.back();
  const Leg& to = after.legs.front();
  std::size_t found = 0;
  for (const int direction : {1, -1}) {
    const auto farthest = farthest_between(tree, from, to, direction);
    if (!farthest) continue;
    if (!(*farthest > length + rounding_)) return false;
    ++found;
  }
  return found > 0;
}

std::optional<double> Verifier::farthest_between(const PieceTree& tree, const Leg& from, const Leg& to,
                                                 int direction) const {
  double result = 0;
  std::size_t arc = from.arc;
  double position = from.to;
  for (std::size_t legs = 0; legs <= truth_.arcs().size(); ++legs) {
    const Chain& chain = truth_.chains()[arc];
    const double end = direction > 0 ? static_cast<double>(chain.pieces()) : 0;
    const bool here = arc == to.arc && (direction > 0 ? to.from >= position : to.from <= position);
    const auto [lower, upper] = std::minmax(position, here ? to.from : end);
    for (auto i = static_cast<std::size_t>(std::ceil(lower)); static_cast<double>(i) <= upper; ++i)
      result = std::max(result, tree.distance_from_below(chain.points[i]));
    if (here) return result;
    const auto ways = truth_.after(arc, direction);
    if (ways.size() != 1) return std::nullopt;
    arc = ways[0].first;
    direction = ways[0].second;
    position = direction > 0 ? 0 : static_cast<double>(truth_.chains()[arc].pieces());
  }
  return std::nullopt;
}

void Verifier::judge_split(const ComponentFinding& finding) {
  const Component& component = graph_.components[static_cast<std::size_t>(finding.component)];
  // the covered and the missing parts, in order along the component
  std::vector<bool> missing;
  for (const int id : component.arcs) {
    const auto a = static_cast<std::size_t>(id);
    std::vector<std::pair<double, bool>> parts;
    for (const ArcGap& gap : verdict_.arcs[a].gaps)
      parts.push_back({static_cast<double>(gap.vertices[0] + gap.vertices[1]) / 2, true});
    for (const auto& [c, interval] : kernel_[a])
      parts.push_back({(interval.first + interval.second) / 2, false});
    std::sort(parts.begin(), parts.end());
    if (component.shape != ComponentShape::branched && is_reversed(component, id))
      std::reverse(parts.begin(), parts.end());
    for (const auto& [position, is_gap] : parts)
      if (missing.empty() || missing.back() != is_gap) missing.push_back(is_gap);
  }
  std::size_t covered = static_cast<std::size_t>(std::count(missing.begin(), missing.end(), false));
  const bool closed = component.shape == ComponentShape::closed;
  if (closed && missing.size() > 1 && !missing.front() && !missing.back()) --covered;
  if (component.shape == ComponentShape::branched || covered + (closed ? 1 : 0) < 2) return;
  Difference& difference = differ(
      DifferenceKind::split,
      "component " + std::to_string(component.id) + " (" + name(component.shape) + ") comes " +
          (covered == 1 ? "as an open curve" : "in " + std::to_string(covered) + " parts that are apart"));
  difference.components = {component.id};
}

bool Verifier::is_reversed(const Component& component, int id) const {
  const auto& arcs = component.arcs;
  const auto at = static_cast<std::size_t>(std::find(arcs.begin(), arcs.end(), id) - arcs.begin());
  if (arcs.size() < 2) return false;
  const Arc& arc = graph_.arcs[static_cast<std::size_t>(id)];
  const Arc& other = graph_.arcs[static_cast<std::size_t>(arcs[at + 1 < arcs.size() ? at + 1 : at - 1])];
  const bool to_is_shared = arc.to == other.from || arc.to == other.to;
  const bool from_is_shared = arc.from == other.from || arc.from == other.to;
  if (to_is_shared && from_is_shared)
    return at == 0 ? false : arc.to == graph_.arcs[static_cast<std::size_t>(arcs[at - 1])].to;
  return at + 1 < arcs.size() ? !to_is_shared : to_is_shared;
}

void Verifier::judge_contacts() {
  for (std::size_t c = 0; c < curves_.size(); ++c) {
    const auto& stated = candidate_.curves[c].tangential;
    if (!stated) continue;
    for (const Strand& strand : curves_[c].strands) {
      for (const Walk& walk : strand.walks) {
        if (!certain_component(strand, walk)) continue;
        for (const Leg& leg : walk.legs) {
          const Arc& arc = *truth_.arcs()[leg.arc].arc;
          if (leg.from == leg.to || (arc.contact == Contact::tangential) == *stated) continue;
          Difference& difference = differ(DifferenceKind::wrong_contact,
                                          "curve " + std::to_string(c) + " is claimed to be " +
                                              (*stated ? "tangential" : "transversal") + " and is " +
                                              name(arc.contact) + " along arc " + arc_name(leg.arc));
          difference.curve = c;
          difference.components = components_of(leg.arc);
          return;
        }
      }
    }
  }
}

void Verifier::doubt_parameters() {
  constexpr double clearly = 1e-6;
  for (std::size_t c = 0; c < curves_.size(); ++c) {
    if (!candidate_.curves[c].first && !candidate_.curves[c].second) continue;
    const Strand& strand = curves_[c].strands.front();
    for (const Walk& walk : strand.walks) {
      const std::size_t vertex = (walk.first + walk.last) / 2;
      double own = infinite;
      double other = infinite;
      truth_.tree().within(strand.chain.points[vertex], tolerance_, [&](const ChainPlace& place) {
        const bool followed = std::any_of(walk.legs.begin(), walk.legs.end(),
                                          [&](const Leg& leg) { return leg.arc == place.chain; });
        double& nearest = followed ? own : other;
        nearest = std::min(nearest, parameters_apart(candidate_.curves[c], strand.chain.at[vertex],
                                                     place.chain, place.position));
      });
      if (2 * other + clearly < own)
        verdict_.undecided.push_back("whether curve " + std::to_string(c) +
                                     " belongs to the arc that its parameters are nearest to");
    }
  }
}

}  // namespace exsect
