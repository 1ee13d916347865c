// The families G[h] with P: everything happens in the plane, where the curve is h(u,v) = 0.
#include <cmath>
#include <stdexcept>

#include "support/families.h"
#include "support/graph_patches.h"

namespace exsect::families {
namespace {

using testing::graph_patch;
using testing::HeightCoefficients;
using Vector2 = std::array<double, 2>;

constexpr auto interior = ArcPlace::interior;
constexpr auto transversal = Contact::transversal;
constexpr auto tangential = Contact::tangential;

const Rational half(1, 2);

/// centre + sign sqrt(d), d > 0.
RealAlgebraic surd(const Rational& centre, const Rational& d, int sign) {
  const Polynomial f{centre * centre - d, -2 * centre, 1};
  const Rational reach = 1 + d;
  return sign > 0 ? real_roots(f, centre, centre + reach).at(0) : real_roots(f, centre - reach, centre).at(0);
}

/// The w in [lower, upper] with f(w) = t; f is monotone there.
RealAlgebraic preimage(const RealAlgebraic& t, const Polynomial& f, const Rational& lower,
                       const Rational& upper) {
  const RationalInterval around = t.interval();
  for (const RealAlgebraic& w : real_roots(t.polynomial().compose(f), lower, upper)) {
    if (sign_at(f - around.lower, w) >= 0 && sign_at(f - around.upper, w) <= 0) return w;
  }
  throw std::logic_error("no preimage");
}

/// 1/t for t > 0.
RealAlgebraic reciprocal(const RealAlgebraic& t) {
  if (t.is_rational()) return {1 / t.rational()};
  const RationalInterval i = t.refined_to(Rational(1, 4) * t.interval().width()).interval();
  return RealAlgebraic::root_of(t.polynomial().reversed(t.polynomial().degree()), {1 / i.upper, 1 / i.lower});
}

/// v / (1 + u) for u = 1/sqrt(2) and v = 1/sqrt(3).
RealAlgebraic quotient(const RealAlgebraic& u, const RealAlgebraic& v) {
  if (u != surd(0, half, 1) || v != surd(0, Rational(1, 3), 1)) throw std::logic_error("another quotient");
  return real_roots(Polynomial{4, 0, -36, 0, 9}, 0, 1).at(0);
}

BezierPatch patch_of(Plane plane) {
  ControlNet c{};
  switch (plane) {
    case Plane::square:
      c[1][0][0] = 1;
      c[0][1][1] = 1;
      break;
    case Plane::larger:
      c[0][0] = {Rational(-1, 4), Rational(-1, 4), 0};
      c[1][0][0] = Rational(3, 2);
      c[0][1][1] = Rational(3, 2);
      break;
    case Plane::bilinear:
      c[1][0][0] = 1;
      c[0][1][1] = 1;
      c[1][1][1] = 1;
      break;
    case Plane::quadratic:
      c[1][0][0] = half;
      c[2][0][0] = half;
      c[0][1][1] = Rational(3, 2);
      c[0][2][1] = -half;
      break;
    case Plane::squares:
      c[2][0][0] = 1;
      c[0][2][1] = 1;
      break;
  }
  return BezierPatch::from_power_basis(c);
}

/// The (r,s) of the plane patch at the point (u,v).
std::array<RealAlgebraic, 2> lifted(Plane plane, const RealAlgebraic& u, const RealAlgebraic& v) {
  const Polynomial larger{Rational(-1, 4), Rational(3, 2)};
  switch (plane) {
    case Plane::square:
      return {u, v};
    case Plane::larger:
      return {preimage(u, larger, 0, 1), preimage(v, larger, 0, 1)};
    case Plane::bilinear:
      if (u.is_rational()) return {u, preimage(v, Polynomial{0, 1 + u.rational()}, 0, 1)};
      if (v.compare(0) == 0) return {u, v};
      if (!v.is_rational()) return {u, quotient(u, v)};
      return {u, reciprocal(preimage(u, Polynomial{-1, v.rational()}, 1, 4 / v.rational()))};
    case Plane::quadratic:
      return {preimage(u, Polynomial{0, half, half}, 0, 1),
              preimage(v, Polynomial{0, Rational(3, 2), -half}, 0, 1)};
    case Plane::squares:
      break;
  }
  return {preimage(u, Polynomial{0, 0, 1}, 0, 1), preimage(v, Polynomial{0, 0, 1}, 0, 1)};
}

std::array<double, 4> lifted(Plane plane, const Vector2& p) {
  const auto [u, v] = p;
  switch (plane) {
    case Plane::square:
      return {u, v, u, v};
    case Plane::larger:
      return {u, v, (4 * u + 1) / 6, (4 * v + 1) / 6};
    case Plane::bilinear:
      return {u, v, u, v / (1 + u)};
    case Plane::quadratic:
      return {u, v, 2 * (2 * u) / (1 + std::sqrt(1 + 8 * u)), 4 * v / (3 + std::sqrt(9 - 8 * v))};
    case Plane::squares:
      break;
  }
  return {u, v, std::sqrt(u), std::sqrt(v)};
}

/// One of the names of a case.
std::string with_plane(const std::string& name, Plane plane) {
  constexpr std::array<const char*, 5> names = {"", " on a larger plane", " on a bilinear plane",
                                                " on a quadratic plane", " on a plane in squares"};
  return name + names[static_cast<std::size_t>(plane)];
}

/// A case in the making: nodes and arcs in the (u,v) plane.
class Planar {
 public:
  Planar(const std::string& name, const HeightCoefficients& h, Plane plane)
      : plane_(plane), case_{with_plane(name, plane), graph_patch(h), patch_of(plane), {}} {
    // The bilinear plane's s turns at other points, which the families do not state.
    if (plane == Plane::bilinear) case_.turning = {Parameter::u, Parameter::v, Parameter::r};
  }

  Planar& node(const RealAlgebraic& u, const RealAlgebraic& v, std::optional<NodeKind> kind = std::nullopt) {
    const auto [r, s] = lifted(plane_, u, v);
    case_.graph.nodes.push_back({{u, v, r, s}, kind});
    const bool singular = plane_ == Plane::squares && u.compare(0) == 0 && v.compare(0) == 0;
    if (singular) case_.graph.nodes.back().kind = NodeKind::crossing;
    return *this;
  }
  /// A node where u turns.
  Planar& turning_u(const RealAlgebraic& u, const RealAlgebraic& v) {
    node(u, v);
    case_.graph.nodes.back().wrt = {Parameter::u, Parameter::r};
    return *this;
  }
  Planar& turning_v(const RealAlgebraic& u, const RealAlgebraic& v) {
    node(u, v);
    case_.graph.nodes.back().wrt = {Parameter::v};
    if (plane_ != Plane::bilinear) case_.graph.nodes.back().wrt.push_back(Parameter::s);
    return *this;
  }
  Planar& arc(std::size_t from, std::size_t to, const std::function<Vector2(double)>& point,
              Contact contact = transversal, ArcPlace place = interior) {
    const auto lift = [&](double t) { return lifted(plane_, point(t)); };
    case_.graph.arcs.push_back(arc_along(from, to, contact, place, lift));
    return *this;
  }
  /// The straight arc between two nodes.
  Planar& segment(std::size_t from, std::size_t to, Contact contact = transversal,
                  ArcPlace place = interior) {
    const auto corner = [&](std::size_t k) {
      const ExactPoint& p = case_.graph.nodes[k].at;
      return Vector2{p[0].to_double(), p[1].to_double()};
    };
    const Vector2 a = corner(from);
    const Vector2 b = corner(to);
    const auto point = [=](double t) { return Vector2{a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])}; };
    return arc(from, to, point, contact, place);
  }
  ExactCase done() const { return case_; }

 private:
  Plane plane_;
  ExactCase case_;
};

const double pi = std::acos(-1.0);

}  // namespace

ExactCase cap(const Rational& e, Plane plane) {
  Planar c("cap", {{{e - half, 1, -1}, {1, 0, 0}, {-1, 0, 0}}}, plane);
  if (e == 0) c.node(half, half, NodeKind::touch);
  if (e <= 0) return c.done();
  c.turning_u(surd(half, e, 1), half).turning_v(half, surd(half, e, 1));
  c.turning_u(surd(half, e, -1), half).turning_v(half, surd(half, e, -1));
  const double radius = std::sqrt(to_double(e));
  for (std::size_t k = 0; k < 4; ++k) {
    c.arc(k, (k + 1) % 4, [=](double t) {
      const double angle = (static_cast<double>(k) + t) * pi / 2;
      return Vector2{0.5 + radius * std::cos(angle), 0.5 + radius * std::sin(angle)};
    });
  }
  return c.done();
}

ExactCase crossing(Plane plane) {
  Planar c("crossing", {{{0, 1, -1}, {-1, 0, 0}, {1, 0, 0}}}, plane);
  c.node(half, half, NodeKind::crossing).node(0, 0).node(1, 0).node(1, 1).node(0, 1);
  return c.segment(0, 1).segment(0, 2).segment(0, 3).segment(0, 4).done();
}

ExactCase irrational_lines(Plane plane) {
  Planar c("two irrational lines", {{{Rational(1, 6), 0, -half}, {0, 0, 0}, {-Rational(1, 3), 0, 1}}}, plane);
  const RealAlgebraic u = surd(0, half, 1);
  const RealAlgebraic v = surd(0, Rational(1, 3), 1);
  c.node(u, v, NodeKind::crossing).node(0, v).node(1, v).node(u, 0).node(u, 1);
  return c.segment(0, 1).segment(0, 2).segment(0, 3).segment(0, 4).done();
}

ExactCase three_irrational_lines() {
  Planar c("three irrational lines", {{{-1, 6, -6}, {0, 0, 0}, {2, -12, 12}}}, Plane::square);
  const RealAlgebraic u = surd(0, half, 1);
  const RealAlgebraic lower = surd(half, Rational(1, 12), -1);
  const RealAlgebraic upper = surd(half, Rational(1, 12), 1);
  c.node(u, lower, NodeKind::crossing).node(u, upper, NodeKind::crossing).node(u, 0).node(u, 1);
  c.node(0, lower).node(1, lower).node(0, upper).node(1, upper);
  c.segment(0, 1).segment(0, 2).segment(1, 3);
  return c.segment(0, 4).segment(0, 5).segment(1, 6).segment(1, 7).done();
}

ExactCase near_crossing(const Rational& e, Plane plane) {
  Planar c("nearly crossing", {{{-e, 1, -1}, {-1, 0, 0}, {1, 0, 0}}}, plane);
  const double root = std::sqrt(to_double(e));
  const double reach = std::sqrt(0.25 - to_double(e));
  for (const int side : {0, 1}) {
    const int sign = 2 * side - 1;
    const std::size_t first = side == 0 ? 0 : 3;
    c.node(side, surd(half, Rational(1, 4) - e, -1)).turning_u(surd(half, e, sign), half);
    c.node(side, surd(half, Rational(1, 4) - e, 1));
    // a = sign sqrt(e) cosh w, b = sqrt(e) sinh w.
    const double end = std::asinh(reach / root);
    const auto point = [=](double w) {
      return Vector2{0.5 + sign * root * std::cosh(w), 0.5 + root * std::sinh(w)};
    };
    c.arc(first, first + 1, [=](double t) { return point((t - 1) * end); });
    c.arc(first + 1, first + 2, [=](double t) { return point(t * end); });
  }
  return c.done();
}

ExactCase quarter_circle(Plane plane) {
  Planar c("quarter of a circle", {{{-half, 0, 1}, {0, 0, 0}, {1, 0, 0}}}, plane);
  c.node(0, surd(0, half, 1)).node(surd(0, half, 1), 0);
  return c
      .arc(0, 1,
           [](double t) {
             return Vector2{std::sqrt(0.5) * std::sin(t * pi / 2), std::sqrt(0.5) * std::cos(t * pi / 2)};
           })
      .done();
}

ExactCase tangent_curve(const Rational& c, Plane plane) {
  const Rational q(1, 4);
  Planar result("tangent curve", {{{q * q, 2 * q * c, c * c}, {-2 * q, -2 * c, 0}, {1, 0, 0}}}, plane);
  return result.node(q, 0).node(q + c, 1).segment(0, 1, tangential).done();
}

ExactCase near_sheets(const Rational& e, Plane plane) {
  Planar c("two near sheets", {{{Rational(1, 4) - e * e, 0, 0}, {-1, 0, 0}, {1, 0, 0}}}, plane);
  c.node(half - e, 0).node(half - e, 1).node(half + e, 0).node(half + e, 1);
  return c.segment(0, 1).segment(2, 3).done();
}

ExactCase parted_sheets(const Rational& e, Plane plane) {
  return Planar("parted sheets", {{{Rational(1, 4) + e, 0, 0}, {-1, 0, 0}, {1, 0, 0}}}, plane).done();
}

ExactCase tangent_and_transversal(Plane plane) {
  const Rational q(1, 4);
  Planar c("tangent and transversal", {{{-q * half, q, 0}, {half, -1, 0}, {-half, 1, 0}}}, plane);
  c.node(half, half, NodeKind::crossing).node(half, 0).node(half, 1).node(0, half).node(1, half);
  return c.segment(0, 1, tangential).segment(0, 2, tangential).segment(0, 3).segment(0, 4).done();
}

ExactCase tangent_lines(Plane plane) {
  const Rational quarter = half * half;
  Planar c("two tangent lines",
           {{{quarter * quarter, -quarter, quarter}, {-quarter, 1, -1}, {quarter, -1, 1}}}, plane);
  c.node(half, half, NodeKind::crossing).node(half, 0).node(half, 1).node(0, half).node(1, half);
  for (const std::size_t end : {1, 2, 3, 4}) c.segment(0, end, tangential);
  return c.done();
}

ExactCase curve_cusp(Plane plane) {
  // (u - v)² - (u - 1/2)² (v - 1/2)
  Planar c("cusp of the curve",
           {{{Rational(1, 8), Rational(-1, 4), 1}, {-half, -1, 0}, {Rational(3, 2), -1, 0}}}, plane);
  c.node(half, half, NodeKind::cusp);
  c.node(surd(Rational(3, 2), half, -1), 1).node(1, Rational(3, 4));
  const auto branch = [](double a, int sign) {
    return Vector2{0.5 + a, 0.5 + (2 * a + a * a + sign * a * std::sqrt(a * a + 4 * a)) / 2};
  };
  c.arc(0, 1, [=](double t) { return branch(t * t * (1 - std::sqrt(0.5)), 1); });
  c.arc(0, 2, [=](double t) { return branch(t * t / 2, -1); });
  return c.done();
}

ExactCase tangent_branches(Plane plane) {
  // a² - a b², b² = v² - v + 1/4
  const Rational q(1, 4);
  Planar c("two branches tangent to each other", {{{q + q * half, -half, half}, {-1 - q, 1, -1}, {1, 0, 0}}},
           plane);
  c.node(half, half, NodeKind::crossing).node(half, 0).node(half, 1);
  c.node(Rational(3, 4), 0).node(Rational(3, 4), 1);
  const auto parabola = [](double b) { return Vector2{0.5 + b * b, 0.5 + b}; };
  c.segment(0, 1).segment(0, 2);
  c.arc(0, 3, [=](double t) { return parabola(-t / 2); });
  c.arc(0, 4, [=](double t) { return parabola(t / 2); });
  return c.done();
}

ExactCase side_and_arc() {
  const Rational third(1, 3);
  Planar c("side and arc", {{{0, 0, 0}, {-third, 1, 0}, {-half, 0, 0}}}, Plane::square);
  c.node(0, third, NodeKind::crossing).node(0, 0).node(0, 1).node(1, Rational(5, 6));
  const auto boundary = ArcPlace::patch_boundary;
  return c.segment(0, 1, transversal, boundary).segment(0, 2, transversal, boundary).segment(0, 3).done();
}

ExactCase side_and_arc_from_its_end() {
  Planar c("side and arc from its end", {{{0, 0, 0}, {0, 1, 0}, {-half, 0, 0}}}, Plane::square);
  c.node(0, 0, NodeKind::crossing).node(0, 1).node(1, half);
  return c.segment(0, 1, transversal, ArcPlace::patch_boundary).segment(0, 2).done();
}

ExactCase line_and_arc() {
  // a (v - 1/3 - u/2)
  Planar c("line and arc",
           {{{Rational(1, 6), -half, 0}, {Rational(1, 4) - Rational(1, 3), 1, 0}, {-half, 0, 0}}},
           Plane::square);
  c.node(half, Rational(7, 12), NodeKind::crossing).node(half, 0).node(half, 1);
  c.node(0, Rational(1, 3)).node(1, Rational(5, 6));
  return c.segment(0, 1).segment(0, 2).segment(0, 3).segment(0, 4).done();
}

}  // namespace exsect::families
