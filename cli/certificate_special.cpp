// The special places of a certificate: lines, overlaps, stars and seams.
#include <exsect/geometry/number.h>

#include <algorithm>
#include <cmath>

#include "certificate_claims.h"
#include "certificate_draft.h"
#include "certificate_overlap.h"

namespace exsect::cli {
namespace {

/// The order of the nodes among the claims.
void number_nodes(Draft& d) {
  d.line_of.assign(d.graph.nodes.size(), {});
  d.line_along.assign(d.graph.arcs.size(), {});
  d.claim_of.assign(d.graph.nodes.size(), 0);
  d.on_curve.assign(d.graph.nodes.size(), false);
  for (const int n : d.graph.isolated_points) d.on_curve[static_cast<std::size_t>(n)] = true;
  for (const Arc& arc : d.graph.arcs)
    for (const int n : {arc.from, arc.to}) d.on_curve[static_cast<std::size_t>(n)] = true;
  std::size_t next = 0;
  for (const bool star : {false, true}) {
    if (star) d.first_star = next;
    for (const Node& n : d.graph.nodes)
      if (d.on_curve[static_cast<std::size_t>(n.id)] && is_star(d.graph, n, d.self) == star)
        d.claim_of[static_cast<std::size_t>(n.id)] = next++;
  }
}

/// The line's number among the claims.
std::size_t add_line(Draft& d, const checker::Line& line, bool touching) {
  const auto known = std::find_if(d.lines.begin(), d.lines.end(), [&](const checker::Line& other) {
    return line.axis == other.axis && line.at == other.at;
  });
  if (known != d.lines.end()) return static_cast<std::size_t>(known - d.lines.begin());
  d.lines.push_back(line);
  d.touching.push_back(touching);
  return d.lines.size() - 1;
}

/// Lines that arcs run along.
void find_lines(Draft& d) {
  for (const Arc& arc : d.graph.arcs) {
    const auto from = static_cast<std::size_t>(arc.from);
    const auto to = static_cast<std::size_t>(arc.to);
    const auto line = line_between(d.patches, d.graph.nodes[from], d.graph.nodes[to]);
    const bool inside = arc.place == ArcPlace::interior;
    if (!line && !inside)
      throw NoCertificate("an arc on a side that is no line of parameters of both patches");
    if (!line && touches(arc))
      throw NoCertificate("an arc along which the patches touch and that is no line of parameters");
    if (!line || (inside && d.self && !touches(arc))) continue;
    OnLine on = {static_cast<int>(add_line(d, *line, touches(arc))), line->axis, {}};
    for (std::size_t i = 0; i < 4; ++i) on.constant[i] = line->at[i][1] == 0 && line->at[i][2] == 0;
    if (inside && !touches(arc) && on.constant == std::array{false, false, false, false}) continue;
    d.line_of[from] = d.line_of[to] = d.line_along[static_cast<std::size_t>(arc.id)] = on;
  }
}

Json overlap_claim(Draft& d, const Overlap& overlap, std::size_t index) {
  if (d.self) throw NoCertificate("an overlap of a patch with itself");
  FoundOverlap found = overlap_at(d.patches, d.graph, overlap);
  d.seams.push_back(found.seam);
  return sealed(in_list("overlaps", index), {{"seam", index}, {"edges", found.edges}});
}

/// The seam along the arc, or the part of it that is in no star.
void add_seam(Draft& d, const Arc& arc) {
  const checker::Line& line =
      d.lines[static_cast<std::size_t>(d.line_along[static_cast<std::size_t>(arc.id)].claim)];
  std::array<Rational, 2> t;
  for (std::size_t end = 0; end < 2; ++end)
    t[end] = short_place(d.graph.nodes[static_cast<std::size_t>(end == 0 ? arc.from : arc.to)])[line.axis];
  const std::array<Rational, 2> all = t;
  for (std::size_t end = 0; end < 2; ++end) {
    const std::size_t node = d.claim_of[static_cast<std::size_t>(end == 0 ? arc.from : arc.to)];
    if (node < d.first_star) continue;
    Rational most = 0;  // along the line, in the star's coordinates
    for (const auto& row : d.stars[node - d.first_star].claim.coordinates) {
      Rational e = 0;
      for (std::size_t i = 0; i < 4; ++i) e += row[i].rational() * line.at[i][1];
      most = std::max<Rational>(most, abs(e));
    }
    t[end] += (all[1 - end] > all[end] ? 1 : -1) * Rational(2, 5) / most;
  }
  try {
    d.seams.push_back(seam_along(checker::pair_map(d.patches[0].power_basis(), d.patches[1].power_basis()),
                                 {}, line.at, line.axis, (t[0] + t[1]) / 2, abs(Rational(t[1] - t[0])) / 2,
                                 d.seams.size(), d.line_along[static_cast<std::size_t>(arc.id)].claim));
  } catch (const NotAlone&) {
    throw NoCertificate("an arc along which the patches touch, next to other solutions");
  }
  d.seam_tube[arc.from] = d.seam_tube[arc.to] = d.tubes.size();
  d.along_seam[arc.id] = d.tubes.size();
  d.tubes.push_back(d.seams.back().tube);
}

/// Smaller than the way to any other node.
void add_star(Draft& d, const Node& n) {
  double size = 0.5;
  for (const Node& other : d.graph.nodes) {
    double away = 0;
    for (std::size_t i = 0; i < 4; ++i) away = std::max(away, std::abs(n.approx[i] - other.approx[i]));
    if (other.id != n.id) size = std::min(size, 0.4 * away);
  }
  d.stars.push_back(
      star_at(d.patches, n, {d.stars.size(), d.tubes.size(), d.seams.size()}, size, d.lines, d.touching));
  d.tubes.insert(d.tubes.end(), d.stars.back().tubes.begin(), d.stars.back().tubes.end());
  d.seams.insert(d.seams.end(), d.stars.back().seams.begin(), d.stars.back().seams.end());
}

}  // namespace

bool touches(const Arc& arc) { return arc.contact == Contact::tangential; }

void find_special_places(Draft& d) {
  number_nodes(d);
  find_lines(d);
  for (const Overlap& overlap : d.graph.overlaps)
    d.overlaps.push_back(overlap_claim(d, overlap, d.overlaps.size()));
  for (const Node& n : d.graph.nodes)
    if (is_star(d.graph, n, d.self)) add_star(d, n);
  for (const Arc& a : d.graph.arcs)
    if (touches(a)) add_seam(d, a);
}

}  // namespace exsect::cli
