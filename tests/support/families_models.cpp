// How patches of closed models meet: around a common pole, at the corners of equal tubes, symmetrically.
#include <cmath>

#include "support/families.h"

namespace exsect::families {
namespace {

using Vector4 = std::array<double, 4>;

const Rational half(1, 2);

BezierPatch from_power(const std::vector<std::pair<std::array<std::size_t, 2>, Point>>& terms) {
  ControlNet c{};
  for (const auto& [exponents, coefficient] : terms) c[exponents[0]][exponents[1]] = coefficient;
  return BezierPatch::from_power_basis(c);
}

/// sqrt(square), 0 < square < 1.
RealAlgebraic root_of(const Rational& square) { return real_roots(Polynomial{-square, 0, 1}, 0, 1).at(0); }

/// (u c(v), 1 - u² + slope u v), c a parabola from `from` to `to` with these tangents' directions exchanged.
BezierPatch quarter_of_dome(const std::array<int, 2>& from, const std::array<int, 2>& to, int slope) {
  const auto at = [&](int a, int b) { return Point{a * from[0] + b * to[0], a * from[1] + b * to[1], 0}; };
  return from_power({{{0, 0}, {0, 0, 1}},
                     {{1, 0}, at(1, 0)},
                     {{1, 1}, at(0, 2) + Point{0, 0, slope}},
                     {{1, 2}, at(-1, -1)},
                     {{2, 0}, {0, 0, -1}}});
}

}  // namespace

ExactCase common_pole(PoleNeighbour which) {
  const BezierPatch x = quarter_of_dome({1, 0}, {0, 1}, 0);
  if (which == PoleNeighbour::opposite) {
    ExactCase c = {"opposite quarters around a pole", x, quarter_of_dome({-1, 0}, {0, -1}, 0), {}};
    c.graph.nodes = {{{0, half, 0, half}, std::nullopt, {}, {Parameter::v, Parameter::s}}};
    return c;
  }
  const bool smooth = which == PoleNeighbour::smooth;
  ExactCase c = {smooth ? "quarters of a dome" : "quarters of a dome with an edge",
                 x,
                 quarter_of_dome({0, 1}, {-1, 0}, smooth ? 0 : 1),
                 {}};
  c.graph.nodes = {{{0, 1, 0, 0}, std::nullopt, {}, {Parameter::v, Parameter::s}}, {{1, 1, 1, 0}}};
  c.graph.arcs = {arc_along(0, 1, smooth ? Contact::tangential : Contact::transversal,
                            ArcPlace::patch_boundary, [](double t) {
                              return Vector4{t, 1, t, 0};
                            })};
  return c;
}

ExactCase common_apex(bool touching) {
  // w = 2v - 1: (w, 1, w²).
  const BezierPatch x = from_power({{{1, 0}, {-1, 1, 1}}, {{1, 1}, {2, 0, -4}}, {{1, 2}, {0, 0, 4}}});
  const BezierPatch y = touching ? from_power({{{1, 0}, {-2, 1, 0}}, {{1, 1}, {4, 0, 0}}})
                                 : from_power({{{1, 0}, {-2, 2, 1}}, {{1, 1}, {4, 0, 0}}});
  ExactCase c = {touching ? "cones that touch" : "cones with a common apex", x, y, {}};
  c.graph.nodes = {{{0, half, 0, half}, std::nullopt, {}, {Parameter::v, Parameter::s}}};
  const std::vector<RealAlgebraic> rulings =
      touching ? std::vector<RealAlgebraic>{half} : real_roots(Polynomial{Rational(1, 8), -1, 1}, 0, 1);
  const Rational end = touching ? Rational(1) : half;
  for (std::size_t k = 0; k < rulings.size(); ++k) {
    const double w = touching ? 0.5 : 0.5 + (k == 0 ? -1 : 1) * std::sqrt(0.125);
    c.graph.nodes.push_back({{1, rulings[k], end, rulings[k]}});
    c.graph.arcs.push_back(arc_along(0, k + 1, touching ? Contact::tangential : Contact::transversal,
                                     ArcPlace::interior, [=](double t) {
                                       return Vector4{t, w, t * to_double(end), w};
                                     }));
  }
  return c;
}

ExactCase crossing_tubes() {
  // c(t) = (t² - 2t, 1 - t²), a quarter of a round profile.
  const BezierPatch x =
      from_power({{{0, 0}, {0, 1, -2}}, {{0, 1}, {-2, 0, 0}}, {{0, 2}, {1, -1, 0}}, {{1, 0}, {0, 0, 4}}});
  const BezierPatch y =
      from_power({{{0, 0}, {-2, 0, 1}}, {{0, 1}, {0, -2, 0}}, {{0, 2}, {0, 1, -1}}, {{1, 0}, {4, 0, 0}}});
  ExactCase c = {"crossing tubes", x, y, {}};
  c.graph.nodes = {{{Rational(3, 4), 1, Rational(1, 4), 0}}};
  return c;
}

ExactCase symmetric_turns() {
  // a = u - 1/2: (u, v (1 + a²), v² + a²/4) and (s, 2r, 1/2).
  const Rational quarter(1, 4);
  const BezierPatch x = from_power({{{0, 0}, {0, 0, quarter * quarter}},
                                    {{1, 0}, {1, 0, -quarter}},
                                    {{2, 0}, {0, 0, quarter}},
                                    {{0, 1}, {0, 1 + quarter, 0}},
                                    {{1, 1}, {0, -1, 0}},
                                    {{2, 1}, {0, 1, 0}},
                                    {{0, 2}, {0, 0, 1}}});
  const BezierPatch y = from_power({{{0, 0}, {0, 0, half}}, {{1, 0}, {0, 2, 0}}, {{0, 1}, {1, 0, 0}}});
  ExactCase c = {"symmetric turns", x, y, {}};
  const RealAlgebraic v = root_of(Rational(7, 16));
  const RealAlgebraic r = root_of(Rational(7, 16) * Rational(25, 64));
  c.graph.nodes = {
      {{0, v, r, 0}},
      {{half, root_of(half), root_of(Rational(1, 8)), half}, std::nullopt, {Parameter::v, Parameter::r}},
      {{1, v, r, 1}}};
  const auto point = [](double u) {
    const double a = (u - 0.5) * (u - 0.5);
    return Vector4{u, std::sqrt(0.5 - 0.25 * a), 0.5 * std::sqrt(0.5 - 0.25 * a) * (1 + a), u};
  };
  for (const std::size_t k : {0U, 1U})
    c.graph.arcs.push_back(arc_along(k, k + 1, Contact::transversal, ArcPlace::interior,
                                     [=](double t) { return point((static_cast<double>(k) + t) / 2); }));
  return c;
}

ExactCase mirror_images() {
  // a = u - 1/2, b = v - 1/2: (u + v²/4, v + u²/4, ±h), h = a² + ab + b² - 1/15.
  const Rational quarter(1, 4);
  const auto patch = [&](int sign) {
    return from_power({{{0, 0}, {0, 0, sign * (3 * quarter - Rational(1, 15))}},
                       {{1, 0}, {1, 0, sign * -3 * half}},
                       {{0, 1}, {0, 1, sign * -3 * half}},
                       {{1, 1}, {0, 0, sign}},
                       {{2, 0}, {0, quarter, sign}},
                       {{0, 2}, {quarter, 0, sign}}});
  };
  ExactCase c = {"mirror images", patch(1), patch(-1), {}};
  const std::vector<RealAlgebraic> near = real_roots(Polynomial{quarter - Rational(1, 45), -1, 1}, 0, 1);
  const std::vector<RealAlgebraic> far = real_roots(Polynomial{quarter - Rational(4, 45), -1, 1}, 0, 1);
  using enum Parameter;
  c.graph.nodes = {{{far[1], near[0], far[1], near[0]}, std::nullopt, {u, r}},
                   {{near[0], far[1], near[0], far[1]}, std::nullopt, {v, s}},
                   {{far[0], near[1], far[0], near[1]}, std::nullopt, {u, r}},
                   {{near[1], far[0], near[1], far[0]}, std::nullopt, {v, s}}};
  const double pi = std::acos(-1.0);
  const std::array<double, 5> angles = {-pi / 6, pi / 2, 5 * pi / 6, 3 * pi / 2, 11 * pi / 6};
  const auto point = [](double angle) {
    const double p = std::cos(angle) / std::sqrt(15.0);
    const double q = std::sin(angle) / std::sqrt(45.0);
    return Vector4{0.5 + p - q, 0.5 + 2 * q, 0.5 + p - q, 0.5 + 2 * q};
  };
  for (std::size_t k = 0; k < 4; ++k)
    c.graph.arcs.push_back(arc_along(k, (k + 1) % 4, Contact::transversal, ArcPlace::interior, [=](double t) {
      return point(angles[k] + t * (angles[k + 1] - angles[k]));
    }));
  return c;
}

}  // namespace exsect::families
