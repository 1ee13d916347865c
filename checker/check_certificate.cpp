#include "check_certificate.h"

#include "check_arcs.h"
#include "check_cover.h"
#include "check_nodes.h"
#include "check_overlaps.h"

namespace exsect::checker {
namespace {

/// Turning points are the ends of an arc on either side, each half branch of a star inside is the end of one,
/// and each other node. Returns the number of ends at each node.
template <class N>
std::vector<std::size_t> check_ends(const Certificate<N>& certificate,
                                    const std::vector<std::array<ArcEnd, 2>>& ends) {
  std::vector<std::size_t> degrees;
  for (std::size_t i = 0; i < certificate.nodes.size(); ++i) {
    std::vector<int> directions;
    std::vector<std::size_t> tubes;
    for (const auto& pair : ends) {
      for (const ArcEnd& end : pair) {
        if (end.node != i) continue;
        directions.push_back(end.direction);
        tubes.push_back(end.tube);
      }
    }
    std::sort(directions.begin(), directions.end());
    std::sort(tubes.begin(), tubes.end());
    degrees.push_back(tubes.size());
    const Node<N>& node = certificate.nodes[i];
    if (node.star >= 0)
      require(std::adjacent_find(tubes.begin(), tubes.end()) == tubes.end(),
              place("stars", static_cast<std::size_t>(node.star)), "two arcs on one half branch");
    else if (!node.wrt.empty())
      require(directions == std::vector<int>{-1, 1}, place("nodes", i),
              "not the end of one arc on either side");
    else
      require(directions.size() == 1, place("nodes", i), "not the end of exactly one arc");
  }
  return degrees;
}

/// The component's arcs are connected, and no others have a node in common with them.
template <class N>
void check_component(const Certificate<N>& certificate, std::size_t c,
                     const std::vector<std::size_t>& degrees, std::vector<bool>& listed) {
  const Component& component = certificate.components[c];
  const std::string where = place("components", c);
  require(!component.arcs.empty(), where, "without arcs");
  std::vector<std::size_t> nodes;
  const auto known = [&](std::size_t n) { return std::find(nodes.begin(), nodes.end(), n) != nodes.end(); };
  for (const std::size_t a : component.arcs) {
    const Arc<N>& arc = element(certificate.arcs, a, where, "names no arc");
    require(!listed[a] && arc.component == c, where, "an arc does not belong to this component alone");
    listed[a] = true;
    require(nodes.empty() || known(arc.from) || known(arc.to), where, "not connected");
    nodes.insert(nodes.end(), {arc.from, arc.to});
  }
  for (const Arc<N>& arc : certificate.arcs)
    require(arc.component == c || (!known(arc.from) && !known(arc.to)), where,
            "connected with another component");
  const auto any = [&](auto is) {
    return std::any_of(nodes.begin(), nodes.end(), [&](std::size_t n) { return is(degrees[n]); });
  };
  const Shape shape = any([](std::size_t n) { return n > 2; })    ? Shape::branched
                      : any([](std::size_t n) { return n == 1; }) ? Shape::open
                                                                  : Shape::closed;
  require(component.shape == shape, where, "open, closed and branched confused");
}

/// The patches touch all along the arc. In tubes that no seam proves they do so nowhere.
template <class N>
bool is_tangential(const Replay<N>& all, const Arc<N>& arc) {
  return std::all_of(arc.pieces.begin(), arc.pieces.end(), [&](const Piece& piece) {
    const Tube<N>& tube = all.tubes[piece.tube].claim;
    return tube.seam >= 0 && touches(all.exact, all.certificate.lines[static_cast<std::size_t>(tube.line)]);
  });
}

template <class N>
void check_graph(const Replay<N>& all, const std::vector<std::array<ArcEnd, 2>>& ends) {
  const Certificate<N>& certificate = all.certificate;
  const std::vector<std::size_t> degrees = check_ends(certificate, ends);
  Summary count{};
  std::vector<bool> listed(certificate.arcs.size());
  for (std::size_t c = 0; c < certificate.components.size(); ++c) {
    check_component(certificate, c, degrees, listed);
    const Shape shape = certificate.components[c].shape;
    ++(shape == Shape::open ? count.open : shape == Shape::closed ? count.closed : count.branched);
  }
  require(std::find(listed.begin(), listed.end(), false) == listed.end(), "$.components",
          "an arc is missing");
  for (const Arc<N>& arc : certificate.arcs)
    if (is_tangential(all, arc)) ++count.tangential;
  for (std::size_t i = 0; i < certificate.nodes.size(); ++i) {
    const Node<N>& node = certificate.nodes[i];
    if (!node.on.empty()) ++count.boundary;
    if (degrees[i] == 0) ++count.isolated;
    for (const std::size_t p : node.wrt) ++count.turning[p];
  }
  const Summary& said = certificate.summary;
  count.claims = {certificate.relations.size(),
                  certificate.lines.size(),
                  certificate.stars.size(),
                  certificate.tubes.size(),
                  certificate.nodes.size() - certificate.stars.size(),
                  certificate.arcs.size(),
                  certificate.cover.size(),
                  certificate.seams.size(),
                  certificate.overlaps.size()};
  require(said.claims == count.claims && said.components == certificate.components.size() &&
              said.closed == count.closed && said.open == count.open && said.branched == count.branched &&
              said.isolated == count.isolated && said.boundary == count.boundary &&
              said.tangential == count.tangential && said.turning == count.turning,
          "$.summary", "does not agree with the claims and their graph");
}

template <class N>
void check_curves(const Replay<N>& all) {
  const Certificate<N>& certificate = all.certificate;
  for (std::size_t i = 0; i < certificate.stars.size(); ++i)
    for (std::size_t direction = 0; direction < 8; ++direction)
      ChartCover<N>(all, certificate.stars[i], all.stars[i], {Chart::star, i, direction}, place("stars", i));
  for (std::size_t i = 0; i < certificate.seams.size(); ++i)
    for (std::size_t direction = 0; direction < 8; ++direction)
      ChartCover<N>(all, certificate.seams[i], all.seams[i], {Chart::pair, 0, direction}, place("seams", i));
  for (std::size_t i = 0; i < certificate.nodes.size(); ++i) NodeCheck<N>(all).check(i);
  for (std::size_t i = 0; i < certificate.overlaps.size(); ++i) OverlapCheck<N>(all, i).check();
  std::vector<std::array<ArcEnd, 2>> ends;
  std::vector<bool> used(all.tubes.size());
  for (std::size_t i = 0; i < certificate.arcs.size(); ++i) {
    ends.push_back(ArcCheck<N>(all, i).check());
    for (const Piece& piece : certificate.arcs[i].pieces) used[piece.tube] = true;
  }
  for (std::size_t i = 0; i < used.size(); ++i)
    require(used[i] || leaves_domain(all, all.tubes[i]), place("tubes", i), "no arc runs through it");
  check_graph(all, ends);
}

template <class N>
Report check(const Certificate<N>& certificate) {
  Replay<N> all = start(certificate);
  for (std::size_t i = 0; i < certificate.relations.size(); ++i)
    check_relation(all.exact, certificate.relations[i], place("relations", i));
  for (std::size_t i = 0; i < certificate.lines.size(); ++i)
    check_line(all.exact, certificate.lines[i], place("lines", i));
  for (std::size_t i = 0; i < certificate.stars.size(); ++i)
    all.stars.push_back(check_star(all, certificate.stars[i], place("stars", i)));
  for (std::size_t i = 0; i < certificate.seams.size(); ++i)
    all.seams.push_back(check_seam(all, certificate.seams[i], place("seams", i)));
  for (const Tube<N>& tube : certificate.tubes) check_tube(all, tube);
  if (certificate.fixed)
    check_points(all);
  else
    check_curves(all);
  Cover<N>(all).check();
  Report report = {certificate.summary, certificate.fixed, certificate.self};
  for (const Cell& cell : certificate.cover) {
    using Kind = Cell::Kind;
    const bool covered = cell.kind == Kind::tube || cell.kind == Kind::mirrored || cell.kind == Kind::star ||
                         cell.kind == Kind::sheet;
    if (covered) ++report.covered;
    if (!covered && cell.kind != Kind::split) ++report.exclusions;
  }
  return report;
}

}  // namespace

Report check_in_doubles(const std::string& text) { return check(read_certificate<Enclosure>(text)); }

Report check_certificate(const std::string& text) {
  const Certificate<Enclosure> in_doubles = read_certificate<Enclosure>(text);
  try {
    return check(in_doubles);
  } catch (const Rejected&) {
    return check(read_certificate<Rational>(text));
  }
}

}  // namespace exsect::checker
