#include "certificate.h"

#include <exsect/geometry/number.h>

#include "json_value.h"

namespace exsect::checker {
namespace {

BezierPatch patch(const Value& value) {
  value.require_claim({"name", "points"});
  const auto row = [](const Value& v) {
    return v.array<3>([](const Value& p) { return p.numbers<Rational, 3>(); });
  };
  return BezierPatch(value["points"].array<3>(row));
}

Relation relation(const Value& value) {
  value.require_claim({"direction", "first", "second"});
  return {value["direction"].numbers<Rational, 3>(), value["first"].parameter(), value["second"].parameter()};
}

Line line(const Value& value) {
  value.require_claim({"axis", "at"});
  return {value["axis"].parameter(),
          value["at"].array<4>([](const Value& v) { return v.numbers<Rational, 3>(); })};
}

/// "star0u+", which is taken off the text.
MapName chart_of_star(const Value& value, std::string_view& text) {
  const std::size_t end = std::min(text.find_first_of(parameter_letters, 4), text.size() - 1);
  const std::size_t k = parameter_letters.find(text[end]);
  const std::string_view sign = text.substr(end + 1, 1);
  value.require(k != std::string_view::npos && (sign == "+" || sign == "-"),
                "must be a chart such as star0u+");
  const auto star = static_cast<std::size_t>(value.integer(text.substr(4, end - 4)));
  text.remove_prefix(end + 2);
  return {Chart::star, star, 2 * k + (sign == "-" ? 1 : 0)};
}

/// "pair" or "star0u+".
MapName map_name(const Value& value) {
  std::string_view text = value.text();
  if (text == "pair") return {};
  value.require(text.substr(0, 4) == "star", "must be pair or a chart of a star");
  const MapName result = chart_of_star(value, text);
  value.require(text.empty(), "must be pair or a chart of a star");
  return result;
}

/// "pair", "first", "second", "line3", "line3seam2", "star0u+", "star0u+line3" or "star0u+line3seam2".
template <class N>
void read_curve(const Value& value, Tube<N>& tube) {
  std::string_view curve = value.text();
  if (curve == "pair") return;
  if (curve == "first" || curve == "second") {
    tube.chart = curve == "first" ? Chart::first : Chart::second;
    return;
  }
  if (curve.substr(0, 4) == "star") {
    static_cast<MapName&>(tube) = chart_of_star(value, curve);
    if (curve.empty()) return;
  }
  if (const std::size_t seam = curve.find("seam"); seam != std::string_view::npos) {
    tube.seam = value.integer(curve.substr(seam + 4));
    curve = curve.substr(0, seam);
  }
  tube.line = value.integer(curve.substr(0, 4) == "line" ? curve.substr(4) : "");
}

template <class N>
Tube<N> tube(const Value& value) {
  value.require_claim({"centre", "axis", "slope", "reach", "width", "inverse", "curve"});
  Tube<N> result = {{},
                    value["centre"].numbers<N, 4>(),
                    value["axis"].parameter(),
                    value["slope"].numbers<N, 4>(),
                    value["reach"].number<N>(),
                    value["width"].number<N>(),
                    value["inverse"].array<3>([](const Value& v) { return v.numbers<N, 3>(); })};
  read_curve(value["curve"], result);
  return result;
}

Side side(const Value& value) {
  const std::string& text = value.text();
  const std::size_t i = text.empty() ? std::string_view::npos : parameter_letters.find(text[0]);
  value.require(i != std::string_view::npos && (text.substr(1) == "=0" || text.substr(1) == "=1"),
                "must be a side such as u=0");
  return {i, text.back() - '0'};
}

template <class N>
Node<N> node(const Value& value) {
  value.require_claim({"tube", "at", "radius", "on", "wrt"});
  return {value["tube"].count(),
          value["at"].numbers<N, 4>(),
          value["radius"].number<N>(),
          value["on"].list(side),
          value["wrt"].list([](const Value& v) { return v.parameter(); }),
          value["at"].numbers<Rational, 4>()};
}

template <class N>
ArcPoint<N> arc_point(const Value& value) {
  value.require(value.size() == 4 || value.size() == 7, "must be a list of 4 or 7 numbers");
  ArcPoint<N> result;
  for (std::size_t i = 0; i < 4; ++i) result.at[i] = value[i].number<N>();
  if (value.size() == 7) result.vertex = {value[4].number<N>(), value[5].number<N>(), value[6].number<N>()};
  return result;
}

template <class N>
Arc<N> arc(const Value& value) {
  value.require_claim({"component", "from", "to", "points", "pieces", "error_bound"});
  const auto piece = [](const Value& v) {
    v.require_size(2);
    return Piece{v[std::size_t{0}].count(), v[std::size_t{1}].count()};
  };
  return {value["component"].count(),         value["from"].count(),       value["to"].count(),
          value["points"].list(arc_point<N>), value["pieces"].list(piece), value["error_bound"].number<N>()};
}

Component component(const Value& value) {
  value.require_claim({"shape", "arcs"});
  const std::string& shape = value["shape"].text();
  value.require(shape == "open" || shape == "closed" || shape == "branched",
                "must be open, closed or branched");
  return {shape == "open"     ? Shape::open
          : shape == "closed" ? Shape::closed
                              : Shape::branched,
          value["arcs"].list([](const Value& v) { return v.count(); })};
}

template <class N>
Overlap<N> overlap(const Value& value) {
  value.require_claim({"seam", "edges"});
  const auto edge = [](const Value& v) {
    v.require_keys({"points"}, "error_bound");
    v["points"].require(v["points"].size() >= 2, "must be two points or more");
    return Arc<N>{0, 0, 0, v["points"].list(arc_point<N>), {}, v["error_bound"].number<N>()};
  };
  const auto corner = [](const Value& v) {
    const Value points = v["points"];
    const Value first = points[std::size_t{0}];
    Vector4<Rational> at;
    for (std::size_t i = 0; i < 4; ++i) at[i] = first[i].template number<Rational>();
    return at;
  };
  Overlap<N> result = {value["seam"].count(), {}, value["edges"].list(edge)};
  result.corners = value["edges"].list(corner);
  return result;
}

/// "u", "t5", "p0", "s1", "m5", "lower", "3,-1,2" or "i3,-1,2".
Cell cell(const Value& value, std::string_view claim) {
  using Kind = Cell::Kind;
  value.require(!claim.empty(), "must have one blank between entries");
  if (claim == "lower") return {Kind::lower, 0, {}};
  const std::size_t parameter = parameter_letters.find(claim);
  if (claim.size() == 1 && parameter != std::string_view::npos) return {Kind::split, parameter, {}};
  for (const auto& [letter, kind] :
       {std::pair{'t', Kind::tube}, {'p', Kind::star}, {'s', Kind::sheet}, {'m', Kind::mirrored}})
    if (claim[0] == letter) return {kind, static_cast<std::size_t>(value.integer(claim.substr(1))), {}};
  Cell result = {claim[0] == 'i' ? Kind::injective : Kind::excluded, 0, {}};
  if (result.kind == Kind::injective) claim.remove_prefix(1);
  for (std::size_t d = 0; d < 3; ++d) {
    const std::size_t end = d < 2 ? std::min(claim.find(','), claim.size()) : claim.size();
    result.direction[d] = value.integer(claim.substr(0, end), true);
    claim.remove_prefix(std::min(end + 1, claim.size()));
  }
  return result;
}

/// Entries with blanks between them.
std::vector<Cell> cells(const Value& value, std::string_view text, std::size_t row) {
  std::vector<Cell> result;
  for (std::size_t begin = 0; !text.empty() && begin <= text.size();) {
    const std::size_t end = std::min(text.find(' ', begin), text.size());
    result.push_back(cell(value, text.substr(begin, end - begin)));
    result.back().row = row;
    begin = end + 1;
  }
  return result;
}

/// Entries, and their seal after a blank and "#".
void append_row(const Value& value, std::size_t i, std::vector<Cell>& list) {
  const std::string& text = value.text();
  const std::size_t mark = text.find(" #");
  value.require(mark != std::string::npos, "must end with a seal");
  value.require(text.substr(mark + 2) == seal("$.cover[" + std::to_string(i) + "]" + text.substr(0, mark)),
                "the seal does not fit the claim");
  const std::vector<Cell> row = cells(value, std::string_view(text).substr(0, mark), i);
  list.insert(list.end(), row.begin(), row.end());
}

Star star(const Value& value, const MapName& of) {
  const auto row = [](const Value& v) { return v.numbers<Rational, 4>(); };
  const auto count = [](const Value& v) { return v.count(); };
  return {of,
          row(value["at"]),
          value["axes"].array<4>(row),
          value["coordinates"].array<4>(row),
          value["weights"].array<4>(count),
          value["rows"].array<3>([](const Value& v) { return v.numbers<Rational, 3>(); }),
          value["orders"].array<3>(count),
          value["charts"].array<8>([](const Value& v) { return cells(v, v.text(), 0); })};
}

Star star_at_point(const Value& value) {
  value.require_claim({"at", "axes", "coordinates", "weights", "rows", "orders", "charts"});
  return star(value, {});
}
Star seam(const Value& value) {
  value.require_claim({"of", "at", "axes", "coordinates", "weights", "rows", "orders", "charts"});
  return star(value, map_name(value["of"]));
}

Summary summary(const Value& value) {
  value.require_claim({"claims", "components", "closed", "open", "branched", "isolated", "boundary",
                       "tangential", "turning"});
  const auto count = [](const Value& v) { return v.count(); };
  return {value["claims"].array<9>(count), value["components"].count(), value["closed"].count(),
          value["open"].count(),           value["branched"].count(),   value["isolated"].count(),
          value["boundary"].count(),       value["tangential"].count(), value["turning"].array<4>(count)};
}

Fixed fixed(const Value& value) {
  value.require_claim({"parameter", "value"});
  const Fixed result = {value["parameter"].parameter(), value["value"].number<Rational>()};
  value.require(result.value >= 0 && result.value <= 1, "must be in [0,1]");
  return result;
}

/// A point of a line: `at` has the line's value, exactly.
template <class N>
Node<N> point(const Value& value, const Fixed& fixed) {
  value.require_claim({"tube", "at", "radius"});
  const Value at = value["at"];
  const Node<N> result = {value["tube"].count(),    at.numbers<N, 4>(), value["radius"].number<N>(), {}, {},
                          at.numbers<Rational, 4>()};
  value.require(at[fixed.parameter].number<Rational>() == fixed.value, "must be on the line");
  return result;
}

/// Each arc begins and ends at the places of its nodes, exactly.
template <class N>
void require_ends(const Value& root, const std::vector<Arc<N>>& arcs) {
  const auto place = [](const Value& v) { return v["at"].numbers<Rational, 4>(); };
  std::vector<Vector4<Rational>> places = root["nodes"].list(place);
  const std::vector<Vector4<Rational>> stars = root["stars"].list(place);
  places.insert(places.end(), stars.begin(), stars.end());
  const Value list = root["arcs"];
  for (std::size_t a = 0; a < arcs.size(); ++a) {
    const Value arc = list[a];
    const Value points = arc["points"];
    points.require(points.size() >= 2, "must be two points or more");
    for (const auto& [node, i] : {std::pair{arcs[a].from, std::size_t{0}}, {arcs[a].to, points.size() - 1}}) {
      const Value point = points[i];
      arc.require(node < places.size(), "names no node");
      for (std::size_t j = 0; j < 4; ++j)
        point.require(point[j].template number<Rational>() == places[node][j], "must be where the node is");
    }
  }
}

/// Each edge of an overlap ends exactly where the next one begins.
template <class N>
void require_chains(const Value& root, const std::vector<Overlap<N>>& overlaps) {
  const Value list = root["overlaps"];
  for (std::size_t o = 0; o < overlaps.size(); ++o) {
    const Value overlap = list[o];
    const Value edges = overlap["edges"];
    for (std::size_t i = 0; i < edges.size(); ++i) {
      const Value edge = edges[i];
      const Value points = edge["points"];
      const Value last = points[points.size() - 1];
      for (std::size_t j = 0; j < 4; ++j)
        last.require(last[j].template number<Rational>() == overlaps[o].corners[(i + 1) % edges.size()][j],
                     "must be where the next edge begins");
    }
  }
}

/// Of a pair, or of one patch.
template <class N>
Certificate<N> curves(const Value& root, bool self) {
  if (self)
    root.require_keys({"exsect", "command", "first", "relations", "lines", "stars", "seams", "tubes", "nodes",
                       "arcs", "components", "overlaps", "cover"},
                      "summary");
  else
    root.require_keys({"exsect", "command", "first", "second", "relations", "lines", "stars", "seams",
                       "tubes", "nodes", "arcs", "components", "overlaps", "cover"},
                      "summary");
  Certificate<N> result = {{patch(root["first"]), patch(root[self ? "first" : "second"])},
                           self,
                           std::nullopt,
                           root["relations"].list(relation),
                           root["lines"].list(line),
                           root["stars"].list(star_at_point),
                           root["seams"].list(seam),
                           root["tubes"].list(tube<N>),
                           root["nodes"].list(node<N>),
                           root["arcs"].list(arc<N>),
                           root["components"].list(component),
                           root["overlaps"].list(overlap<N>),
                           {},
                           summary(root["summary"])};
  require_ends(root, result.arcs);
  require_chains(root, result.overlaps);
  for (std::size_t i = 0; i < result.stars.size(); ++i) {
    const Vector4<Rational>& at = result.stars[i].at;
    result.nodes.push_back(
        {0, {N(at[0]), N(at[1]), N(at[2]), N(at[3])}, N(0), {}, {}, at, static_cast<int>(i)});
  }
  return result;
}

template <class N>
Certificate<N> points(const Value& root) {
  root.require_keys({"exsect", "command", "fixed", "first", "second", "tubes", "points", "cover"}, "summary");
  const Fixed only = fixed(root["fixed"]);
  root["summary"].require_claim({"claims"});
  Certificate<N> result = {{patch(root["first"]), patch(root["second"])}, false, only};
  result.tubes = root["tubes"].list(tube<N>);
  result.nodes = root["points"].list([&](const Value& v) { return point<N>(v, only); });
  result.summary = {root["summary"]["claims"].array<9>([](const Value& v) { return v.count(); })};
  return result;
}

}  // namespace

std::string seal(const std::string& text) {
  std::uint64_t hash = 0xcbf29ce484222325U;
  for (const char c : text) {
    hash ^= static_cast<unsigned char>(c);
    hash *= 0x100000001b3U;
  }
  std::string result(16, '0');
  for (std::size_t i = 16; i-- > 0; hash >>= 4) result[i] = "0123456789abcdef"[hash & 15];
  return result;
}

Rational number_of(const std::string& text) {
  const std::size_t mark = std::min(text.find("/2^"), text.size());
  Rational q = parse_number(text.substr(0, mark));
  std::string canonical = to_string(q);
  if (mark < text.size()) {
    int n = 0;
    std::from_chars(text.data() + mark + 3, text.data() + text.size(), n);
    if (n < 1 || n > 2000 || denominator(q) != 1 || numerator(q) % 2 == 0) canonical = "";
    canonical += "/2^" + std::to_string(n);
    q *= power_of_two(-n);
  }
  if (text != canonical) throw std::invalid_argument("must be p/q in lowest terms, p/2^n with p odd, or p");
  return q;
}

template <class N>
Certificate<N> read_certificate(const std::string& text) {
  const Json json = parse(text);
  if (!json.is_object() || json.value("exsect", Json()) != "certificate/1")
    throw Unreadable("not of the form certificate/1");
  const Value root(json);
  const Json command = json.value("command", Json());
  if (command != "intersect" && command != "line" && command != "self")
    throw Rejected("$.command", "must be intersect, line or self");
  Certificate<N> result = command == "line" ? points<N>(root) : curves<N>(root, command == "self");
  const Value cover = root["cover"];
  for (std::size_t i = 0; i < cover.size(); ++i) append_row(cover[i], i, result.cover);
  return result;
}
template Certificate<Rational> read_certificate(const std::string&);
template Certificate<Enclosure> read_certificate(const std::string&);

}  // namespace exsect::checker
