// The formulas of round charts over Q, where points are exactly on the surface and values those of the other
// equation.
#include "filter/round_formula.h"

#include "filter/rounded_number.h"
#include "support/catch.h"

namespace exsect::round_formula_test {
namespace {

using S = ImplicitSurface;

/// Of a surface about the origin and the axis z, and another one about the point (1,2,3), with the axis
/// (2/3, 1/3, 2/3) unless it is a sphere.
RoundFormula<Rational> formula_of(SurfaceKind kind) {
  RoundFormula<Rational> f;
  f.kind = kind;
  f.major = 3;
  f.minor = kind == SurfaceKind::torus ? 1 : 0;
  f.unit = 1;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) f.axes[i][k] = i == k ? 1 : 0;
  f.offset = {1, 2, 3};
  f.direction = {Rational(2, 3), Rational(1, 3), Rational(2, 3)};
  f.offset_squared = 14;
  f.offset_along = Rational(2 + 2 + 6, 3);
  f.linear = 1;
  return f;
}

S chart_surface(SurfaceKind kind) {
  if (kind == SurfaceKind::torus) return S::torus({0, 0, 0}, {0, 0, 1}, 3, 1);
  return kind == SurfaceKind::cylinder ? S::cylinder({0, 0, 0}, {0, 0, 1}, 3)
                                       : S::cone({0, 0, 0}, {0, 0, 1}, 3);
}

/// Places of rational directions, or of numbers.
std::vector<RoundAngles<Rational>> places(SurfaceKind kind) {
  std::vector<RoundAngles<Rational>> result;
  for (const Rational& t : {Rational(0), Rational(1, 2), Rational(-3), Rational(7, 5)}) {
    const Rational n = 1 + t * t;
    const std::array<Rational, 2> a = {(1 - t * t) / n, 2 * t / n}, b = {Rational(-4, 5), Rational(3, 5)};
    result.push_back({a, kind == SurfaceKind::torus ? b : std::array<Rational, 2>{t - 2, Rational(0)}});
  }
  return result;
}

/// One equation is a multiple of the other one at all places.
void check(const RoundFormula<Rational>& f, const S& other) {
  Rational ratio = 0;
  for (const auto& at : places(f.kind)) {
    const auto [x, y, z] = f.position(at);
    CHECK(chart_surface(f.kind).equation()({x, y, z}) == 0);
    const Rational value = f.value(at), expected = other.equation()({x, y, z});
    CHECK(f.derivatives(at).value == value);
    if (ratio == 0 && value != 0) ratio = expected / value;
    CHECK(expected == ratio * value);
  }
  CHECK(ratio > 0);
}

}  // namespace

TEST_CASE("round formula: points are on the surface, and values are those of the other equation") {
  const Point centre = {1, 2, 3}, axis = {2, 1, 2};
  for (const SurfaceKind kind : {SurfaceKind::torus, SurfaceKind::cylinder, SurfaceKind::cone}) {
    RoundFormula<Rational> f = formula_of(kind);
    f.constant = -4;
    check(f, S::sphere(centre, 2));
    f.quadratic = -1;
    check(f, S::cylinder(centre, axis, 2));
    f.quadratic = -5;
    f.constant = 0;
    check(f, S::cone(centre, axis, 2));
    f.has_square = true;
    f.shift = 4 - 1;
    f.quadratic = 16;
    f.linear = -16;
    check(f, S::torus(centre, axis, 2, 1));
    RoundFormula<Rational> plane = formula_of(kind);
    plane.linear = 0;
    plane.along = 1;
    check(plane, S::plane(centre, axis));
  }
}

TEST_CASE("round formula: with other numbers it is the same") {
  for (const SurfaceKind kind : {SurfaceKind::torus, SurfaceKind::cylinder, SurfaceKind::cone}) {
    RoundFormula<Rational> f = formula_of(kind);
    f.has_square = true;
    f.shift = Rational(1, 3);
    f.quadratic = 2, f.along = Rational(1, 7), f.constant = Rational(-1, 11);
    f.centre = {Rational(1, 3), 7, 1};
    const auto rounded = f.mapped<double>([](const Rational& x) { return to_double(x); });
    const auto balls = f.mapped<DoubleBall>([](const Rational& x) { return DoubleBall::enclosing(x); });
    const auto bounds = balls.mapped<RoundedNumber>(RoundedNumber::of);
    for (const auto& at : places(kind)) {
      RoundAngles<double> x;
      RoundAngles<RoundedNumber> most;
      for (std::size_t i = 0; i < 2; ++i) {
        x.around[i] = to_double(at.around[i]), x.along[i] = to_double(at.along[i]);
        most.around[i] = {1, 0x1p-53};
        most.along[i] = {5, 0x1p-51};
      }
      const auto error = [](double a, const Rational& b) { return abs(Rational(from_double(a) - b)); };
      CHECK(error(rounded.value(x), f.value(at)) <= from_double(bounds.value(most).error()));
      for (std::size_t k = 0; k < 3; ++k) {
        CHECK(error(rounded.position(x)[k], f.position(at)[k]) <=
              from_double(bounds.position(most)[k].error()));
        CHECK(error(rounded.derivatives(x).second[k], f.derivatives(at).second[k]) <=
              from_double(bounds.derivatives(most).second[k].error()));
      }
    }
  }
}

}  // namespace exsect::round_formula_test
