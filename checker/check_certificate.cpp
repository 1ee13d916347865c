#include "check_certificate.h"

#include "check_arcs.h"
#include "check_cover.h"
#include "check_nodes.h"

namespace exsect::checker {
namespace {

template <class N>
void check_graph(const Certificate<N>& certificate, const std::vector<std::array<ArcEnd, 2>>& ends) {
  for (std::size_t i = 0; i < certificate.nodes.size(); ++i) {
    std::vector<int> directions;
    for (const auto& pair : ends)
      for (const ArcEnd& end : pair)
        if (end.node == i) directions.push_back(end.direction);
    std::sort(directions.begin(), directions.end());
    if (!certificate.nodes[i].wrt.empty())
      require(directions == std::vector<int>{-1, 1}, place("nodes", i),
              "not the end of one arc on either side");
    else
      require(directions.size() == 1, place("nodes", i), "not the end of exactly one arc");
  }
  // Every node has degree 1 or 2: a component is a path or a loop.
  Summary count{};
  std::vector<bool> listed(certificate.arcs.size());
  for (std::size_t c = 0; c < certificate.components.size(); ++c) {
    const Component& component = certificate.components[c];
    const std::string where = place("components", c);
    require(!component.arcs.empty(), where, "without arcs");
    std::vector<std::size_t> nodes;
    for (const std::size_t a : component.arcs) {
      const Arc<N>& arc = element(certificate.arcs, a, where, "names no arc");
      require(!listed[a] && arc.component == c, where, "an arc does not belong to this component alone");
      listed[a] = true;
      // In order along the curve: each arc has a node in common with those before it.
      const auto known = [&](std::size_t n) {
        return std::find(nodes.begin(), nodes.end(), n) != nodes.end();
      };
      require(nodes.empty() || known(arc.from) || known(arc.to), where, "not connected");
      nodes.insert(nodes.end(), {arc.from, arc.to});
    }
    const bool open = std::any_of(nodes.begin(), nodes.end(),
                                  [&](std::size_t n) { return certificate.nodes[n].wrt.empty(); });
    require(component.closed != open, where, "open and closed confused");
    ++(open ? count.open : count.closed);
  }
  require(std::find(listed.begin(), listed.end(), false) == listed.end(), "$.components",
          "an arc is missing");
  for (std::size_t c = 0; c < certificate.components.size(); ++c) {
    for (const std::size_t a : certificate.components[c].arcs)
      for (const Arc<N>& arc : certificate.arcs)
        require(arc.component == c ||
                    (arc.from != certificate.arcs[a].from && arc.from != certificate.arcs[a].to &&
                     arc.to != certificate.arcs[a].from && arc.to != certificate.arcs[a].to),
                place("components", c), "connected with another component");
  }
  for (const Node<N>& node : certificate.nodes) {
    if (!node.on.empty()) ++count.boundary;
    for (const std::size_t i : node.wrt) ++count.turning[i];
  }
  const Summary& said = certificate.summary;
  count.claims = {certificate.relations.size(), certificate.lines.size(), certificate.touches.size(),
                  certificate.tubes.size(),     certificate.nodes.size(), certificate.arcs.size(),
                  certificate.cover.size()};
  require(said.claims == count.claims && said.components == certificate.components.size() &&
              said.closed == count.closed && said.open == count.open && said.boundary == count.boundary &&
              said.turning == count.turning,
          "$.summary", "does not agree with the claims and their graph");
}

template <class N>
void check_curves(const Replay<N>& all) {
  const Certificate<N>& certificate = all.certificate;
  for (std::size_t i = 0; i < certificate.touches.size(); ++i) {
    check_touch(all.exact, certificate.touches[i], place("touches", i));
    for (std::size_t k = 0; k < i; ++k)
      require(certificate.touches[k].at != certificate.touches[i].at, place("touches", i), "given twice");
  }
  for (std::size_t i = 0; i < certificate.nodes.size(); ++i) NodeCheck<N>(all).check(i);
  std::vector<std::array<ArcEnd, 2>> ends;
  std::vector<bool> used(all.tubes.size());
  for (std::size_t i = 0; i < certificate.arcs.size(); ++i) {
    ends.push_back(ArcCheck<N>(all, i).check());
    for (const Piece& piece : certificate.arcs[i].pieces) used[piece.tube] = true;
  }
  for (std::size_t i = 0; i < used.size(); ++i) require(used[i], place("tubes", i), "no arc runs through it");
  check_graph(certificate, ends);
}

template <class N>
Report check(const Certificate<N>& certificate) {
  Replay<N> all = start(certificate);
  for (std::size_t i = 0; i < certificate.relations.size(); ++i)
    check_relation(all.exact, certificate.relations[i], place("relations", i));
  for (std::size_t i = 0; i < certificate.lines.size(); ++i)
    check_line(all.exact, certificate.lines[i], place("lines", i));
  for (const Tube<N>& tube : certificate.tubes) check_tube(all, tube);
  if (certificate.fixed)
    check_points(all);
  else
    check_curves(all);
  Cover<N>(all).check();
  Report report = {certificate.summary, certificate.fixed, certificate.self};
  for (const Cell& cell : certificate.cover) {
    const bool tube = cell.kind == Cell::Kind::tube || cell.kind == Cell::Kind::mirrored;
    if (tube) ++report.covered;
    if (!tube && cell.kind != Cell::Kind::split) ++report.exclusions;
  }
  return report;
}

}  // namespace

bool is_proved(const std::array<BezierPatch, 2>& patches, const Touch& touch) {
  try {
    check_touch({patches[0].power_basis(), patches[1].power_basis()}, touch, "");
    return true;
  } catch (const Rejected&) {
    return false;
  }
}

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
