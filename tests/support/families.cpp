// The families of curved and of degenerate patches.
#include "support/families.h"

#include <algorithm>
#include <utility>

namespace exsect::families {
namespace {

using Vector4 = std::array<double, 4>;

constexpr auto transversal = Contact::transversal;
constexpr auto tangential = Contact::tangential;
constexpr auto interior = ArcPlace::interior;
constexpr auto boundary = ArcPlace::patch_boundary;

const Rational half(1, 2);
const Point upwards = {0, 0, 1};

/// x of the chapter's first example; seen along `upwards` it is one to one: the Jacobian of its first two
/// coordinates has Bernstein coefficients of one sign, and its four sides form a simple closed curve.
BezierPatch first_example() {
  const auto q = [](long a, long b) { return Rational(a, b); };
  return BezierPatch(ControlNet{
      {{Point{q(1, 7), 0, q(3, 5)}, Point{q(3, 5), q(1, 5), q(3, 4)}, Point{1, 0, q(7, 10)}},
       {Point{q(3, 8), q(4, 9), q(2, 3)}, Point{q(2, 3), q(3, 4), q(1, 3)}, Point{q(6, 7), q(3, 8), q(5, 7)}},
       {Point{q(1, 5), q(6, 7), q(4, 7)}, Point{q(3, 4), q(7, 8), q(3, 4)},
        Point{q(7, 8), q(7, 9), q(5, 8)}}}});
}

BezierPatch from_power(const std::vector<std::pair<std::array<std::size_t, 2>, Point>>& terms) {
  ControlNet c{};
  for (const auto& [power, coefficient] : terms) c[power[0]][power[1]] = coefficient;
  return BezierPatch::from_power_basis(c);
}

Vector4 in_doubles(const ExactPoint& p) {
  return {p[0].to_double(), p[1].to_double(), p[2].to_double(), p[3].to_double()};
}

/// The arc between two nodes that is straight in the parameters.
ExactArc segment(const ExactGraph& graph, std::size_t from, std::size_t to, Contact contact, ArcPlace place) {
  const Vector4 a = in_doubles(graph.nodes[from].at);
  const Vector4 b = in_doubles(graph.nodes[to].at);
  return arc_along(from, to, contact, place, [=](double t) {
    Vector4 z{};
    for (std::size_t i = 0; i < 4; ++i) z[i] = a[i] + t * (b[i] - a[i]);
    return z;
  });
}

/// The arc between these two points that is straight in the parameters, and nothing else.
ExactCase one_segment(const std::string& name, const BezierPatch& x, const BezierPatch& y,
                      const ExactPoint& from, const ExactPoint& to, Contact contact, ArcPlace place) {
  ExactCase c = {name, x, y, {}};
  c.graph.nodes = {{from}, {to}};
  c.graph.arcs = {segment(c.graph, 0, 1, contact, place)};
  return c;
}

/// Row i of the result: the points of `curve` (three control points) moved by offset[i] d.
BezierPatch moved_along(const std::array<Point, 3>& curve, const std::array<Rational, 3>& offset,
                        const Point& d) {
  ControlNet net;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) net[i][j] = curve[j] + offset[i] * d;
  }
  return BezierPatch(net);
}

/// An overlap whose one chain runs through the nodes in order.
ExactCase overlapping(const std::string& name, const BezierPatch& x, const BezierPatch& y,
                      const std::vector<ExactPoint>& corners) {
  ExactCase c = {name, x, y, {}};
  for (const ExactPoint& p : corners) c.graph.nodes.push_back({p});
  std::vector<ExactArc> chain;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    chain.push_back(segment(c.graph, k, (k + 1) % corners.size(), tangential, boundary));
  }
  c.graph.overlaps = {{chain}};
  return c;
}

}  // namespace

ExactCase shared_side(const Neighbour& neighbour) {
  const BezierPatch x = first_example();
  const Rational& from = neighbour.from;
  const Rational& to = neighbour.to;
  const Rational& at = neighbour.at;
  const BezierPatch piece = x.restricted_to(0, 1, from, to);
  const BezierPatch y = moved_along(piece.net()[0], {-at, half - at, 1 - at}, upwards);
  const Rational lower = std::max<Rational>(0, std::min(from, to));
  const Rational upper = std::min<Rational>(1, std::max(from, to));
  const auto s = [&](const Rational& v) { return Rational((v - from) / (to - from)); };
  const char* name = lower == 0 && upper == 1 ? "shared side" : "part of a side";
  return one_segment(name, x, y, {0, lower, at, s(lower)}, {0, upper, at, s(upper)}, transversal, boundary);
}

ExactCase smooth_neighbour(const Rational& k) {
  const BezierPatch x = first_example();
  ControlNet net = x.restricted_to(0, Rational(-1, 4), 0, 1).net();
  for (Point& p : net[2]) p = p + k * upwards;
  return one_segment("smooth neighbour", x, BezierPatch(net), {0, 0, 0, 0}, {0, 1, 0, 1}, tangential,
                     boundary);
}

ExactCase side_on_interior_line() {
  const BezierPatch x = first_example();
  const BezierPatch y = moved_along(x.restricted_to(half, 1, 0, 1).net()[0], {0, half, 1}, upwards);
  return one_segment("side on an interior line", x, y, {half, 0, 0, 0}, {half, 1, 0, 1}, transversal,
                     boundary);
}

ExactCase side_at_two_speeds() {
  const BezierPatch x = from_power({{{1, 0}, {1, 0, 0}}, {{0, 1}, {0, 1, 0}}, {{1, 1}, {0, 0, 1}}});
  const BezierPatch y = from_power({{{1, 0}, {0, 0, 1}}, {{0, 1}, {0, half, 0}}, {{0, 2}, {0, half, 0}}});
  ExactCase c = {"side at two speeds", x, y, {}};
  c.graph.nodes = {{{0, 0, 0, 0}}, {{0, 1, 0, 1}}};
  c.graph.arcs = {arc_along(0, 1, transversal, boundary, [](double t) {
    return Vector4{0, (t + t * t) / 2, 0, t};
  })};
  return c;
}

ExactCase turned_side(const Rational& e) {
  const BezierPatch x = from_power({{{1, 0}, {1, 0, 0}}, {{0, 1}, {0, 1, 0}}, {{1, 1}, {0, 0, 1}}});
  const BezierPatch y = from_power({{{0, 0}, {-e, 0, 0}}, {{1, 0}, {0, 0, 1}}, {{0, 1}, {2 * e, 1, 0}}});
  ExactCase c = {"turned side", x, y, {}};
  c.graph.nodes = {{{0, half, 0, half}}, {{e, 1, e, 1}}};
  c.graph.arcs = {arc_along(0, 1, transversal, interior, [width = to_double(e)](double t) {
    const double s = (1 + t) / 2;
    return Vector4{width * t, s, width * t * s, s};
  })};
  return c;
}

ExactCase shifted_copy() {
  const BezierPatch x = first_example();
  const Rational third(1, 3);
  const Rational quarter(1, 4);
  const BezierPatch y = x.restricted_to(third, 4 * third, -quarter, 3 * quarter);
  const auto at = [&](const Rational& u, const Rational& v) {
    return ExactPoint{u, v, u - third, v + quarter};
  };
  return overlapping("overlap", x, y, {at(third, 0), at(1, 0), at(1, 3 * quarter), at(third, 3 * quarter)});
}

ExactCase same_patch() {
  const BezierPatch x = first_example();
  return overlapping("the same patch", x, x, {{0, 0, 0, 0}, {1, 0, 1, 0}, {1, 1, 1, 1}, {0, 1, 0, 1}});
}

ExactCase lifted_copy(const Rational& e) {
  const BezierPatch x = first_example();
  ControlNet net = x.net();
  for (auto& row : net) {
    for (Point& p : row) p = p + e * upwards;
  }
  return {"lifted copy", x, BezierPatch(net), {}};
}

ExactCase tilted_copy(const Rational& e) {
  const BezierPatch x = first_example();
  ControlNet net = x.net();
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      net[i][j] = net[i][j] + e * Rational(static_cast<long>(i + j) - 2, 2) * upwards;
    }
  }
  return one_segment("tilted copy", x, BezierPatch(net), {0, 1, 0, 1}, {1, 0, 1, 0}, transversal, interior);
}

ExactCase coplanar_squares() {
  const Rational third(1, 3);
  const BezierPatch x = from_power({{{1, 0}, {1, 0, 0}}, {{0, 1}, {0, 1, 0}}});
  const BezierPatch y = from_power({{{0, 0}, {half, third, 0}}, {{1, 0}, {1, 0, 0}}, {{0, 1}, {0, 1, 0}}});
  return overlapping(
      "coplanar squares", x, y,
      {{half, third, 0, 0}, {1, third, half, 0}, {1, 1, half, 2 * third}, {half, 1, 0, 2 * third}});
}

ExactCase touching_curve(const BezierPatch& x, const BezierPatch& y) {
  const auto q = [](long a, long b) { return Rational(a, b); };
  return one_segment("touching curve", x, y, {q(1, 4), 1, q(7, 24), q(11, 12)},
                     {q(3, 4), 0, q(17, 24), q(1, 12)}, tangential, interior);
}

ExactCase double_cover() {
  const BezierPatch x =
      from_power({{{0, 0}, {1, 0, 0}}, {{1, 0}, {-4, 0, 0}}, {{2, 0}, {4, 0, 0}}, {{0, 1}, {0, 1, 0}}});
  const BezierPatch y =
      from_power({{{0, 0}, {Rational(1, 4), 0, -half}}, {{1, 0}, {0, 1, 0}}, {{0, 1}, {0, 0, 1}}});
  ExactCase c = {"double cover", x, y, {}};
  for (const Rational& u : {Rational(1, 4), Rational(3, 4)}) {
    c.graph.nodes.push_back({{u, 0, 0, half}});
    c.graph.nodes.push_back({{u, 1, 1, half}});
  }
  c.graph.arcs = {segment(c.graph, 0, 1, transversal, interior),
                  segment(c.graph, 2, 3, transversal, interior)};
  return c;
}

namespace {

BezierPatch cone() { return from_power({{{1, 0}, {1, -1, 0}}, {{1, 1}, {0, 2, 0}}, {{2, 0}, {0, 0, 1}}}); }

}  // namespace

ExactCase collapsed_side() {
  const BezierPatch y = from_power({{{0, 0}, {0, -half, -half}}, {{1, 0}, {0, 1, 0}}, {{0, 1}, {0, 0, 1}}});
  ExactCase c = {"collapsed side", cone(), y, {}};
  c.graph.nodes = {{{0, half, half, half}, std::nullopt, {}, {Parameter::v}}};
  return c;
}

ExactCase arc_from_collapsed_side() {
  const BezierPatch y = from_power({{{1, 0}, {1, 0, 0}}, {{0, 1}, {0, 0, 1}}});
  ExactCase c = {"arc from a collapsed side", cone(), y, {}};
  c.graph.nodes = {{{0, half, 0, 0}, std::nullopt, {}, {Parameter::v}}, {{1, half, 1, 1}}};
  c.graph.arcs = {arc_along(0, 1, transversal, interior, [](double t) { return Vector4{t, 0.5, t, t * t}; })};
  return c;
}

ExactCase pinch_point() {
  // u' = 2u - 1, v' = 2v - 1: (u'², u' v', v').
  const BezierPatch x = from_power({{{0, 0}, {1, 1, -1}},
                                    {{1, 0}, {-4, -2, 0}},
                                    {{2, 0}, {4, 0, 0}},
                                    {{0, 1}, {0, -2, 2}},
                                    {{1, 1}, {0, 4, 0}}});
  const BezierPatch y = from_power({{{0, 0}, {-1, -half, 0}}, {{1, 0}, {3, 0, 0}}, {{0, 1}, {0, 1, 0}}});
  ExactCase c = {"pinch point", x, y, {}};
  const Rational third(1, 3);
  c.graph.nodes = {{{0, half, 2 * third, half}},
                   {{half, half, third, half}, std::nullopt, {Parameter::r}},
                   {{1, half, 2 * third, half}}};
  const auto point = [](double u) { return Vector4{u, 0.5, (1 + (2 * u - 1) * (2 * u - 1)) / 3, 0.5}; };
  c.graph.arcs = {arc_along(0, 1, transversal, interior, [=](double t) { return point(t / 2); }),
                  arc_along(1, 2, transversal, interior, [=](double t) { return point((1 + t) / 2); })};
  return c;
}

ExactCase pinch_point_passed(bool on_side) {
  // a = 2u - 1, v' = 2v - 1: (a², a v', v').
  const BezierPatch x = from_power({{{0, 0}, {1, 1, -1}},
                                    {{1, 0}, {-4, -2, 0}},
                                    {{2, 0}, {4, 0, 0}},
                                    {{0, 1}, {0, -2, 2}},
                                    {{1, 1}, {0, 4, 0}}});
  // (r', s - 1/2, r'/4), r' = r or 2r - 1.
  const Rational quarter(1, 4);
  const BezierPatch y =
      on_side ? from_power({{{0, 0}, {0, -half, 0}}, {{1, 0}, {1, 0, quarter}}, {{0, 1}, {0, 1, 0}}})
              : from_power({{{0, 0}, {-1, -half, -quarter}}, {{1, 0}, {2, 0, half}}, {{0, 1}, {0, 1, 0}}});
  ExactCase c = {on_side ? "pinch point on a side" : "pinch point passed", x, y, {}};
  const Rational r = on_side ? Rational(0) : half;
  c.graph.nodes = {
      {{0, Rational(5, 8), 1, quarter}}, {{half, half, r, half}}, {{1, Rational(5, 8), 1, Rational(3, 4)}}};
  if (!on_side) c.graph.nodes[1].wrt = {Parameter::v, Parameter::r};
  const auto point = [=](double a) {
    return Vector4{(1 + a) / 2, (1 + a * a / 4) / 2, on_side ? a * a : (1 + a * a) / 2, 0.5 + a * a * a / 4};
  };
  c.graph.arcs = {arc_along(0, 1, transversal, interior, [=](double t) { return point(t - 1); }),
                  arc_along(1, 2, transversal, interior, [=](double t) { return point(t); })};
  return c;
}

std::vector<ExactCase> specimens() {
  const Plane p = Plane::square;
  return {cap(Rational(1, 50), p),
          crossing(p),
          near_crossing(Rational(1, 100), p),
          tangent_curve(Rational(1, 3), p),
          near_sheets(Rational(1, 100), p),
          tangent_and_transversal(p),
          curve_cusp(p),
          tangent_branches(p),
          shared_side({}),
          shared_side({Rational(3, 4), Rational(1, 4), 0}),
          side_and_arc(),
          shifted_copy(),
          double_cover(),
          collapsed_side()};
}

}  // namespace exsect::families
