#include "certificate.h"

#include <nlohmann/json.hpp>

#include "read_surfaces.h"

namespace exsect::checker {

std::string hexadecimal(std::uint64_t hash) {
  std::string result(16, '0');
  for (std::size_t i = 16; i-- > 0; hash >>= 4) result[i] = "0123456789abcdef"[hash & 15];
  return result;
}
bool is_json(const std::string& text) { return nlohmann::json::accept(text); }
std::string seal(std::string_view text) { return hexadecimal(hash(text)); }

const char* name(Violation kind) {
  constexpr std::array<const char*, 7> names = {"form",  "seal",  "claim",  "error-bound",
                                                "cover", "graph", "summary"};
  return names[static_cast<std::size_t>(kind)];
}

static void read(Reader& in, Parameter& parameter) {
  Word word(in.string());
  parameter = word.parameter();
  word.end();
}
/// Three polynomials, lists of their terms.
static void read(Reader& in, Map<Rational>& map) {
  const std::size_t size = in.list([&](std::size_t d) {
    require(d < 3, "must be three polynomials");
    in.list([&](std::size_t) {
      const auto [power, c] = read_term<4>(in, max_factor_degree);
      map.coefficient(power)[d] += c;
    });
  });
  require(size == 3, "must be three polynomials");
}
static void read(Reader& in, Factor& factor) {
  in.claim({"map", "powers", "columns"}, factor.map, factor.powers, factor.columns);
}

/// "u+", after "star0".
static MapName chart_of_star(Word& word) {
  MapName result = {Chart::star, static_cast<std::size_t>(word.count()), 0};
  result.direction = 2 * word.parameter();
  if (!word.skip("+")) {
    require(word.skip("-"), "must be a chart such as star0u+");
    ++result.direction;
  }
  return result;
}

/// "u", "t5", "p0", "s1", "m5", "lower", "3,-1,2" or "i3,-1,2".
static Cell cell(std::string_view text, std::size_t row) {
  using Kind = Cell::Kind;
  Word word(text);
  Cell result = {Kind::lower, 0, {}, row};
  const auto in_set = [&] {
    for (const auto& [letter, kind] :
         {std::pair{"t", Kind::tube}, {"p", Kind::star}, {"s", Kind::sheet}, {"m", Kind::mirrored}}) {
      result.kind = kind;
      if (word.skip(letter)) return true;
    }
    return false;
  };
  if (text.size() == 1 && text.find_first_of("uvrs") == 0) {
    result.kind = Kind::split;
    result.index = word.parameter();
  } else if (word.skip("lower")) {
    result.kind = Kind::lower;
  } else if (in_set()) {
    result.index = static_cast<std::size_t>(word.count());
  } else {
    result.kind = word.skip("i") ? Kind::injective : Kind::excluded;
    for (std::size_t d = 0; d < 3; ++d) {
      require(d == 0 || word.skip(","), "must be one of the documented words");
      result.direction[d] = word.integer();
    }
  }
  word.end();
  return result;
}

/// Entries with one blank between them, or none.
static void read_cells(Reader& in, std::string_view text, std::size_t row, std::vector<Cell>& cells) {
  while (!text.empty()) {
    in.count_entry();
    const std::size_t end = std::min(text.find(' '), text.size());
    cells.push_back(cell(text.substr(0, end), row));
    require(end + 1 != text.size(), "must have no blank at its end");
    text.remove_prefix(std::min(end + 1, text.size()));
  }
}
static void read(Reader& in, std::vector<Cell>& cells) { read_cells(in, in.string(), 0, cells); }

/// Entries, and their seal after a blank and "#".
static void read_row(Reader& in, std::size_t row, std::vector<Cell>& cells) {
  const std::string_view text = in.string();
  const std::size_t mark = text.find(" #");
  require(mark != std::string_view::npos, "must end with a seal");
  const std::string_view entries = text.substr(0, mark);
  require(text.substr(mark + 2) == seal(in.place() + std::string(entries)), "the seal does not fit the claim",
          Violation::seal);
  require(!entries.empty(), "must be one of the documented words");
  read_cells(in, entries, row, cells);
}

/// One rational, or those of a polynomial.
static void read(Reader& in, Algebraic& number) {
  std::vector<Rational> c;
  if (in.at_list())
    in.list([&](std::size_t i) {
      require(i < max_modulus_degree, "a number of a degree above 64");
      read(in, c.emplace_back());
    });
  else
    read(in, c.emplace_back());
  number = Algebraic(std::move(c), nullptr);
}
static void read(Reader& in, Star& star) {
  auto root = std::make_shared<Root>();
  in.claim({"modulus", "between", "at", "axes", "coordinates", "weights", "rows", "orders", "charts"},
           root->modulus, root->between, star.at, star.axes, star.coordinates, star.weights, star.rows,
           star.orders, star.charts);
  require(root->modulus.size() <= max_modulus_degree + 1, "its modulus has a degree above 64");
  root->check();
  star.root = root;
  const auto belongs = [&](Algebraic& number) { number = Algebraic(number.coefficients(), root); };
  for (Algebraic& number : star.at) belongs(number);
  for (Matrix4* matrix : {&star.axes, &star.coordinates})
    for (auto& row : *matrix) std::for_each(row.begin(), row.end(), belongs);
  for (auto& row : star.rows) std::for_each(row.begin(), row.end(), belongs);
}

/// "pair", "first", "second", "star0u+", "factor3" or "star0u+factor3".
template <class N>
void read_curve(std::string_view text, Tube<N>& tube) {
  Word word(text);
  if (word.skip("first") || word.skip("second")) {
    tube.chart = text == "first" ? Chart::first : Chart::second;
  } else if (!word.skip("pair")) {
    const bool star = word.skip("star");
    if (star) static_cast<MapName&>(tube) = chart_of_star(word);
    if (word.skip("factor"))
      tube.factor = word.count();
    else
      require(star, "must be one of the documented words");
  }
  word.end();
}
template <class N>
void read(Reader& in, Tube<N>& tube) {
  const auto curve = [&] { read_curve(in.string(), tube); };
  in.claim({"centre", "axis", "slope", "reach", "width", "inverse", "curve"}, tube.centre, tube.axis,
           tube.slope, tube.reach, tube.width, tube.inverse, curve);
}

static void read(Reader& in, Side& side) {
  Word word(in.string());
  side.parameter = word.parameter();
  side.value = word.skip("=1") ? 1 : 0;
  require(side.value == 1 || word.skip("=0"), "must be a side such as u=0");
  word.end();
}
/// `at`, as numbers of the check and exactly.
template <class N>
void read_place(Reader& in, Node<N>& node) {
  Reader again = in.again(in.position());
  read(in, node.at);
  read(again, node.place);
}
template <class N>
void read(Reader& in, Node<N>& node) {
  const auto at = [&] { read_place(in, node); };
  in.claim({"tube", "at", "radius", "on", "wrt"}, node.tube, at, node.radius, node.on, node.wrt);
}

template <class N>
void read(Reader& in, ArcPoint<N>& point) {
  Vector3<N> vertex;
  const std::size_t size = in.list([&](std::size_t i) {
    require(i < 7, "must be a list of 4 or 7 numbers");
    read(in, i < 4 ? point.at[i] : vertex[i - 4]);
  });
  require(size == 4 || size == 7, "must be a list of 4 or 7 numbers");
  if (size == 7) point.vertex = vertex;
}
/// The points, and the first and the last place exactly.
template <class N>
void read_points(Reader& in, Arc<N>& arc) {
  std::array<std::size_t, 2> ends = {};
  in.list([&](std::size_t i) {
    ends[i == 0 ? 0 : 1] = in.position();
    read(in, arc.points.emplace_back());
  });
  require(arc.points.size() >= 2, "must be two points or more");
  for (std::size_t e = 0; e < 2; ++e) {
    Reader again = in.again(ends[e]);
    again.list([&](std::size_t i) {
      Rational rest;
      read(again, i < 4 ? arc.ends[e][i] : rest);
    });
  }
}
static void read(Reader& in, Piece& piece) {
  std::array<std::size_t, 2> numbers;
  read(in, numbers);
  piece = {numbers[0], numbers[1]};
}
template <class N>
void read(Reader& in, Arc<N>& arc) {
  const auto points = [&] { read_points(in, arc); };
  in.claim({"component", "from", "to", "points", "pieces", "error_bound"}, arc.component, arc.from, arc.to,
           points, arc.pieces, arc.error_bound);
}
template <class N>
void read(Reader& in, Overlap<N>& overlap) {
  const auto edge = [&](std::size_t) {
    Arc<N>& arc = overlap.edges.emplace_back();
    in.begin();
    in.members(
        {"points", "error_bound"}, [&] { read_points(in, arc); }, arc.error_bound);
    in.end();
  };
  in.claim({"factor", "edges"}, overlap.factor, [&] { in.list(edge); });
}
static void read(Reader& in, Component& component) {
  in.claim({"shape", "arcs"}, component.shape, component.arcs);
}
static void read(Reader& in, Summary& s) {
  in.claim(
      {"claims", "components", "closed", "open", "branched", "isolated", "boundary", "tangential", "turning"},
      s.claims, s.components, s.closed, s.open, s.branched, s.isolated, s.boundary, s.tangential, s.turning);
}
/// The node is at the place: exactly, but for the irrational point of a star.
template <class N>
bool is_at(const Certificate<N>& certificate, const Node<N>& node, const Vector4<Rational>& place) {
  if (node.star < 0) return place == node.place;
  const Star& star = certificate.stars[static_cast<std::size_t>(node.star)];
  for (std::size_t i = 0; i < 4; ++i) {
    const Ball<Rational> away = (star.at[i] - place[i]).ball();
    if (away.magnitude() > (star.at[i].is_rational() ? Rational(0) : power_of_two(-40))) return false;
  }
  return true;
}
/// Each arc begins and ends at the places of its nodes.
template <class N>
void require_ends(const Certificate<N>& certificate) {
  for (std::size_t a = 0; a < certificate.arcs.size(); ++a) {
    const Arc<N>& arc = certificate.arcs[a];
    for (const auto& [node, e, i] :
         {std::tuple{arc.from, std::size_t{0}, std::size_t{0}}, {arc.to, 1, arc.points.size() - 1}}) {
      const std::string place = "$.arcs[" + std::to_string(a) + "]";
      if (node >= certificate.nodes.size()) throw Rejected(place, "names no node", Violation::graph);
      if (!is_at(certificate, certificate.nodes[node], arc.ends[e]))
        throw Rejected(place + ".points[" + std::to_string(i) + "]", "must be where the node is",
                       Violation::graph);
    }
  }
}

template <class N>
void read_patches(Reader& in, Certificate<N>& c) {
  const auto patch = [&](std::size_t n) {
    WeightedNet<Rational>& net = c.nets[n];
    const auto name = [&] { in.text(); };
    const auto equation = [&] { read_equation(in, c.equation); };
    const auto points = [&] { read(in, net.points); };
    const auto weights = [&] { read_weights(in, net); };
    in.claim({"name", "equation", "points", "weights"}, name, Optional{equation}, Optional{points},
             Optional{weights});
    const bool is_patch = net.points.degree(0) > 0;
    require(c.equation && n == 1 ? !is_patch && !c.fixed : is_patch, "must have the documented keys");
  };
  in.members({"first"}, [&] { patch(0); });
  require(!c.equation, "must be a patch");
  if (c.self)
    c.nets[1] = c.nets[0];
  else
    in.members({"second"}, [&] { patch(1); });
}
template <class N>
void read_cover(Reader& in, Certificate<N>& c) {
  in.members({"cover"}, [&] { in.list([&](std::size_t i) { read_row(in, i, c.cover); }); });
}

/// Of a line: what comes after the command.
template <class N>
void read_line(Reader& in, Certificate<N>& c) {
  const auto fixed = [&] {
    c.fixed.emplace();
    in.claim({"parameter", "value"}, c.fixed->parameter, c.fixed->value);
    require(c.fixed->value >= 0 && c.fixed->value <= 1, "must be in [0,1]");
  };
  const auto point = [&](std::size_t) {
    Node<N>& node = c.nodes.emplace_back();
    const auto at = [&] { read_place(in, node); };
    in.claim({"tube", "at", "radius"}, node.tube, at, node.radius);
    require(node.place[c.fixed->parameter] == c.fixed->value, "must be on the line");
  };
  in.members({"fixed"}, fixed);
  read_patches(in, c);
  in.members({"tubes", "points"}, c.tubes, [&] { in.list(point); });
  read_cover(in, c);
  in.members({"summary"}, [&] { in.claim({"claims"}, c.summary.claims); });
}

/// Of two patches, or of one: what comes after the command.
template <class N>
void read_curves(Reader& in, Certificate<N>& c) {
  read_patches(in, c);
  in.members({"factors", "stars", "tubes", "nodes", "arcs", "components", "overlaps"}, c.factors, c.stars,
             c.tubes, c.nodes, c.arcs, c.components, c.overlaps);
  read_cover(in, c);
  in.members({"summary"}, c.summary);
  for (std::size_t i = 0; i < c.stars.size(); ++i) {
    Node<N> node = {0, {}, N(0), {}, {}, {}, static_cast<int>(i)};
    for (std::size_t j = 0; j < 4; ++j) node.at[j] = number<N>(c.stars[i].at[j]);
    c.nodes.push_back(node);
  }
}

template <class N>
Certificate<N> read_certificate(const std::string& text) {
  Reader in(text);
  Certificate<N> result = {};
  std::string form;
  std::string command;
  try {
    in.begin();
    in.members({"exsect", "command"}, form, command);
    result.self = command == "self";
    command == "line" ? read_line(in, result) : read_curves(in, result);
    require(result.self || command == "line" || command == "intersect", "must be of intersect, line or self");
    in.end();
    in.finish();
  } catch (const Failed& failed) {
    if (!is_json(text)) throw Unreadable("not valid JSON");
    if (form != "certificate/1") throw Unreadable("not of the form certificate/1");
    throw Rejected(in.place(), failed.what(),
                   failed.kind == Violation::seal ? Violation::seal : Violation::form);
  }
  if (form != "certificate/1") throw Unreadable("not of the form certificate/1");
  require_ends(result);
  return result;
}
template Certificate<Rational> read_certificate(const std::string&);
template Certificate<Enclosure> read_certificate(const std::string&);

}  // namespace exsect::checker
