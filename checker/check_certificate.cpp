#include "check_certificate.h"

#include <set>

#include "check_arcs.h"
#include "check_cover.h"
#include "check_nodes.h"
#include "check_overlaps.h"
#include "floating_point.h"
#include "positive.h"

namespace exsect::checker {
namespace {

/// The ends of arcs at each node.
using Ends = std::vector<std::vector<ArcEnd>>;

/// check(i) for each node, those of stars last.
template <class N, class Check>
void each_node(const Certificate<N>& certificate, const Check& check, Violation kind = Violation::claim) {
  const std::size_t listed = certificate.nodes.size() - certificate.stars.size();
  for (std::size_t i = 0; i < listed; ++i)
    replayed(
        "$.nodes", i, [&] { check(i); }, kind);
  each(
      "$.stars", certificate.stars, [&](std::size_t i) { check(listed + i); }, kind);
}

/// Turning points are the ends of an arc on either side, each half branch of a star inside is the end of one,
/// and each other node.
template <class N>
void check_ends(const Node<N>& node, const std::vector<ArcEnd>& ends) {
  if (node.star < 0 && node.wrt.empty()) return require(ends.size() == 1, "not the end of exactly one arc");
  if (node.star < 0)
    return require(ends.size() == 2 && ends[0].direction == -ends[1].direction,
                   "not the end of one arc on either side");
  std::set<std::size_t> tubes;
  for (const ArcEnd& end : ends) require(tubes.insert(end.tube).second, "two arcs on one half branch");
}

/// The component's arcs are connected, and no others have a node in common with them.
template <class N>
void check_component(const Certificate<N>& certificate, std::size_t c, const Ends& ends,
                     std::vector<bool>& listed) {
  const Component& component = certificate.components[c];
  require(!component.arcs.empty(), "without arcs");
  std::set<std::size_t> nodes;
  for (const std::size_t a : component.arcs) {
    const Arc<N>& arc = element(certificate.arcs, a, "names no arc");
    require(!listed[a] && arc.component == c, "an arc does not belong to this component alone");
    listed[a] = true;
    require(nodes.empty() || nodes.count(arc.from) + nodes.count(arc.to) > 0, "not connected");
    nodes.insert({arc.from, arc.to});
  }
  for (const Arc<N>& arc : certificate.arcs)
    require(arc.component == c || nodes.count(arc.from) + nodes.count(arc.to) == 0,
            "connected with another component");
  bool branched = false;
  bool open = false;
  for (const std::size_t n : nodes) {
    branched = branched || ends[n].size() > 2;
    open = open || ends[n].size() == 1;
  }
  require(component.shape == (branched ? "branched"
                              : open   ? "open"
                                       : "closed"),
          "open, closed and branched confused");
}

/// The patches touch all along the arc; in tubes without such a factor they do so nowhere.
template <class N>
bool is_tangential(const Replay<N>& all, const Arc<N>& arc) {
  return std::all_of(arc.pieces.begin(), arc.pieces.end(), [&](const Piece& piece) {
    const int factor = all.tubes[piece.tube].claim.factor;
    return factor >= 0 && all.touching[static_cast<std::size_t>(factor)];
  });
}

/// What the claims and their graph say together.
template <class N>
Summary counted(const Replay<N>& all, const Ends& ends) {
  const Certificate<N>& c = all.certificate;
  Summary count = {{c.factors.size(), c.stars.size(), c.tubes.size(), c.nodes.size() - c.stars.size(),
                    c.arcs.size(), c.cover.size(), c.overlaps.size()}};
  count.components = c.components.size();
  for (const Component& component : c.components)
    ++(component.shape == "open" ? count.open : component.shape == "closed" ? count.closed : count.branched);
  for (const Arc<N>& arc : c.arcs)
    if (is_tangential(all, arc)) ++count.tangential;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    if (!c.nodes[i].on.empty()) ++count.boundary;
    if (ends[i].empty()) ++count.isolated;
    for (const std::size_t p : c.nodes[i].wrt) ++count.turning[p];
  }
  return count;
}

template <class N>
void check_graph(const Replay<N>& all, const Ends& ends) {
  const Certificate<N>& certificate = all.certificate;
  each_node(
      certificate, [&](std::size_t i) { check_ends(certificate.nodes[i], ends[i]); }, Violation::graph);
  std::vector<bool> listed(certificate.arcs.size());
  each(
      "$.components", certificate.components,
      [&](std::size_t c) { check_component(certificate, c, ends, listed); }, Violation::graph);
  each(
      "$.arcs", listed, [&](std::size_t i) { require(listed[i], "in no component"); }, Violation::graph);
}

/// The claims about curves, tubes apart.
template <class N>
Ends check_curves(const Replay<N>& all) {
  const Certificate<N>& c = all.certificate;
  for (std::size_t i = 0; i < c.stars.size(); ++i) check_charts(all, i);
  each("$.stars", c.stars, [&](std::size_t i) { check_no_arc_inside(all, i); });
  each_node(c, [&](std::size_t i) { NodeCheck<N>(all).check(i); });
  each("$.overlaps", c.overlaps, [&](std::size_t i) { OverlapCheck<N>(all, i).check(); });
  Ends ends(c.nodes.size());
  std::vector<bool> used(all.tubes.size());
  each("$.arcs", c.arcs, [&](std::size_t i) {
    const Arc<N>& arc = c.arcs[i];
    const std::array<ArcEnd, 2> both = ArcCheck<N>(all, i).check();
    ends[arc.from].push_back(both[0]);
    ends[arc.to].push_back(both[1]);
    for (const Piece& piece : arc.pieces) used[piece.tube] = true;
  });
  each(
      "$.tubes", used,
      [&](std::size_t i) { require(used[i] || leaves_domain(all, all.tubes[i]), "no arc runs through it"); },
      Violation::graph);
  return ends;
}

/// Those about the points of a line.
template <class N>
Summary check_points(const Replay<N>& all) {
  const Certificate<N>& c = all.certificate;
  std::vector<bool> used(c.tubes.size());
  each("$.points", c.nodes, [&](std::size_t i) {
    check_point(all, i);
    used[c.nodes[i].tube] = true;
  });
  each(
      "$.tubes", used, [&](std::size_t i) { require(used[i], "no point is in it"); }, Violation::graph);
  return {{0, 0, c.tubes.size(), c.nodes.size(), 0, c.cover.size(), 0}};
}

/// Both denominators are positive in the square: so F vanishes where the patches meet, and nowhere else.
template <class N>
void check_denominators(const Certificate<N>& certificate) {
  for (std::size_t n = 0; n < 2; ++n) {
    try {
      require_positive(certificate.nets[n].weights);
    } catch (const Failed& failed) {
      throw Rejected(n == 0 ? "$.first" : "$.second", failed.what(), failed.kind);
    }
  }
}

/// Error bounds that are too small are listed, or rejected where there is no list.
template <class N>
Report check(const Certificate<N>& certificate, std::vector<Shortfall>* shortfalls) {
  check_denominators(certificate);
  Replay<N> all = start(certificate);
  all.shortfalls = shortfalls;
  each("$.factors", certificate.factors, [&](std::size_t i) {
    check_factor(all.exact, certificate.factors[i]);
    all.touching.push_back(touches(certificate.factors[i]));
  });
  each("$.stars", certificate.stars, [&](std::size_t i) { all.stars.push_back(check_star(all, i)); });
  each("$.tubes", certificate.tubes, [&](std::size_t i) { check_tube(all, certificate.tubes[i]); });
  Summary count;
  if (certificate.fixed) {
    count = check_points(all);
  } else {
    const Ends ends = check_curves(all);
    check_graph(all, ends);
    count = counted(all, ends);
  }
  if (count != certificate.summary)
    throw Rejected("$.summary", "does not agree with the claims and their graph", Violation::summary);
  Report report = {certificate.summary, certificate.fixed, certificate.self};
  Cover<N>(all).check(report.covered, report.exclusions);
  return report;
}

/// First in doubles, then exactly.
Report check(const std::string& text, std::vector<Shortfall>* shortfalls) {
  const FloatingPoint arithmetic;
  const Certificate<Enclosure> in_doubles = read_certificate<Enclosure>(text);
  try {
    return check(in_doubles, shortfalls);
  } catch (const Rejected&) {
    const auto irrational = [](const Star& star) { return !star.is_rational(); };
    if (std::any_of(in_doubles.stars.begin(), in_doubles.stars.end(), irrational)) throw;
    if (shortfalls) shortfalls->clear();
    return check(read_certificate<Rational>(text), shortfalls);
  }
}

}  // namespace

Report check_certificate(const std::string& text) { return check(text, nullptr); }

std::vector<Shortfall> too_small_error_bounds(const std::string& text) {
  std::vector<Shortfall> result;
  check(text, &result);
  return result;
}

}  // namespace exsect::checker
