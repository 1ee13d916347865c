// Patches with a parameter line inside the square that is one point of the other patch.
#include "intersect_divided.h"

#include <exsect/solver/intersect.h>

#include "special/divided_patches.h"
#include "support/catch.h"
#include "support/family_checks.h"
#include "support/graph_checks.h"
#include "support/graph_patches.h"
#include "support/random_nets.h"

namespace exsect::intersect_divided_test {
namespace {

using enum Parameter;
using random_pairs::Generator;

/// Around (2,3), symmetric about it.
const std::vector<std::array<int, 2>> hexagon = {{6, 3}, {5, 6}, {1, 5}, {-2, 3}, {-1, 0}, {3, 1}};

/// From the polygon at height 0 to the same one, turned by half a turn, at height 1.
BezierPatch face_of_loft(std::size_t i) {
  const auto vertex = [](std::size_t k, int height) {
    const auto& [a, b] = hexagon[k % hexagon.size()];
    return Point{a, b, height};
  };
  return BezierPatch::elevated({{vertex(i, 0), vertex(i + 3, 1)}, {vertex(i + 1, 0), vertex(i + 4, 1)}});
}

/// Q + (v - c) w(u), w(u) = (u - 1/2, u², 1).
BezierPatch double_cone(const Point& tip, const Rational& c) {
  ControlNet p{};
  p[0][0] = tip + Point{c / 2, 0, -c};
  p[0][1] = {Rational(-1, 2), 0, 1};
  p[1][0] = {-c, 0, 0};
  p[1][1] = {1, 0, 0};
  p[2][0] = {0, -c, 0};
  p[2][1] = {0, 1, 0};
  return BezierPatch::from_power_basis(p);
}

/// The arcs of a line through all points (parameters at v from `first` to `last`) that passes the tip at `c`.
std::vector<ExactArc> two_arcs(const std::function<std::array<double, 4>(double)>& at, double first, double c,
                               double last) {
  const auto arc = [&](std::size_t from, std::size_t to, double a, double b) {
    return arc_along(from, to, Contact::transversal, ArcPlace::interior,
                     [=](double t) { return at(a + t * (b - a)); });
  };
  return {arc(0, 1, first, c), arc(1, 2, c, last)};
}

}  // namespace

TEST_CASE("faces of a loft that is twisted by half a turn") {
  for (std::size_t i = 0; i < hexagon.size(); ++i) {
    for (std::size_t k = i + 1; k < hexagon.size(); ++k) {
      ExactCase c{
          "faces " + std::to_string(i) + " and " + std::to_string(k), face_of_loft(i), face_of_loft(k), {}};
      const Rational half(1, 2);
      c.graph.nodes = {{{0, half, 0, half}, std::nullopt, {}, {u, r}}};
      const bool next = k == i + 1;
      if (next || k == i + 5) {
        const int at = next ? 1 : 0;  // of the side of x
        c.graph.nodes.push_back({{at, 0, 1 - at, 0}});
        c.graph.nodes.push_back({{at, 1, 1 - at, 1}});
        for (const std::size_t end : {1, 2})
          c.graph.arcs.push_back(
              arc_along(0, end, Contact::transversal, ArcPlace::patch_boundary, [=](double t) {
                const double v = 0.5 + (end == 1 ? -t : t) / 2;
                return std::array<double, 4>{static_cast<double>(at), v, static_cast<double>(1 - at), v};
              }));
      }
      check(c);
      if (i == 0) check_images(c);
    }
  }
}

TEST_CASE("a double cone and a plane through its tip") {
  const Rational c(1, 3);
  const Rational half(1, 2);
  const BezierPatch plane = testing::plane({0, -2, -2}, {0, 4, 0}, {0, 0, 4});
  ExactCase example{"a plane through a tip", double_cone({0, 0, 0}, c), plane, {}};
  const auto at = [&](const Rational& v) {
    return ExactPoint{half, v, half + (v - c) / 16, half + (v - c) / 4};
  };
  example.graph.nodes = {{at(0)}, {at(c), std::nullopt, {}, {u}}, {at(1)}};
  example.graph.arcs = two_arcs(
      [](double v) {
        return std::array<double, 4>{0.5, v, 0.5 + (v - 1. / 3) / 16, 0.5 + (v - 1. / 3) / 4};
      },
      0, 1. / 3, 1);
  check_images(example);
}

TEST_CASE("double cones with one tip and a common ruling") {
  // w(1/2) = (0, 1/4, 1) is a ruling of both, and goes on beyond s = 1 on x.
  const Rational half(1, 2);
  ControlNet p{};
  p[0][0] = {half, Rational(-1, 8), -half};
  p[0][1] = {-1, Rational(1, 4), 1};
  p[1][0] = {-1, 0, 0};
  p[1][1] = {2, 0, 0};
  ExactCase example{
      "two double cones", double_cone({0, 0, 0}, Rational(1, 3)), BezierPatch::from_power_basis(p), {}};
  const auto at = [&](const Rational& v) { return ExactPoint{half, v, half, v + Rational(1, 6)}; };
  example.graph.nodes = {{at(0)}, {at(Rational(1, 3)), std::nullopt, {}, {u, r}}, {at(Rational(5, 6))}};
  example.graph.arcs = two_arcs(
      [](double v) {
        return std::array<double, 4>{0.5, v, 0.5, v + 1. / 6};
      },
      0, 1. / 3, 5. / 6);
  check_images(example);
}

TEST_CASE("random patches with a line that is one point of the other patch agree with the oracle") {
  const unsigned seed = 5;
  INFO("seed " << seed);
  Generator generator(seed);
  for (int i = 0; i < 40; ++i) {
    INFO("pair " << i);
    const auto coordinate = [&] { return Rational(random_pairs::integer(generator, -16, 16), 16); };
    const auto vector = [&] { return Point{coordinate(), coordinate(), coordinate()}; };
    ControlNet net{};
    for (auto& row : net)
      for (Point& point : row) point = vector();
    const BezierPatch y(net);
    const Rational c(random_pairs::integer(generator, 1, 6), 7);
    const Point tip = y(Rational(random_pairs::integer(generator, 0, 8), 8),
                        Rational(random_pairs::integer(generator, 1, 4), 5));
    ControlNet power{};
    for (auto& row : power) {  // (v - c) (a + b v)
      const Point a = vector();
      const Point b = vector();
      row = {-c * a, a - c * b, b};
    }
    power[0][0] = power[0][0] + tip;
    const BezierPatch x = BezierPatch::from_power_basis(power);
    const auto result = intersect(x, y);
    CHECK(unsound(x, y, result) == "");
    CHECK(result.status == Status::complete);
    for (const auto& part : result.incomplete) UNSCOPED_INFO(part.why);
    if (result.status == Status::complete) CHECK(compare_with_oracle(x, y, result.graph).difference == "");
  }
}

TEST_CASE("a line that is one point off the other patch divides nothing") {
  const BezierPatch plane = testing::plane({0, -2, -2}, {0, 4, 0}, {0, 0, 4});
  CHECK_FALSE(divided_pair(double_cone({Rational(1, 16), 0, 0}, Rational(1, 3)), plane));
  CHECK_FALSE(divided_pair(double_cone({0, 0, 0}, 0), plane));
  CHECK(divided_pair(double_cone({0, 0, 0}, Rational(1, 3)), plane)->size() == 2);
}

}  // namespace exsect::intersect_divided_test
