// Equations on patches in doubles against the exact composition.
#include "filter/section_forms.h"

#include <exsect/geometry/implicit_surface.h>
#include <exsect/geometry/surface_pull_back.h>

#include <cmath>

#include "support/catch.h"
#include "support/random_nets.h"

namespace exsect::section_forms_test {
namespace {

using S = ImplicitSurface;
using random_nets::Generator;

/// The power of two that the equation is multiplied with.
Rational unit_of(const SpacePolynomial& f) {
  double largest = 0;
  for (const auto& [exponents, c] : f.terms()) largest = std::max(largest, std::fabs(to_double(c)));
  return from_double(std::ldexp(1, -std::ilogb(largest) - 1));
}

double largest_of(const FormTable& table) {
  double largest = 0;
  for (std::size_t i = 0; i <= table.m(); ++i)
    for (std::size_t j = 0; j <= table.n(); ++j) largest = std::max(largest, std::fabs(table(i, j)));
  return largest;
}

/// At places of the square, and by how much the bound exceeds rounding.
void check_forms(const SpacePolynomial& equation, const RationalPatch& patch, double slack) {
  const auto forms = section_forms(equation, patch);
  REQUIRE(forms);
  const BivariatePolynomial section = pull_back(equation, patch);
  const Rational unit = unit_of(equation);
  for (const double p : {-1.0, -0.75, 0.125, 1.0})
    for (const double q : {-1.0, 0.375, 1.0}) {
      const Rational u = (1 + from_double(p)) / 2, v = (1 + from_double(q)) / 2;
      const Rational value = unit * section(u, v);
      CHECK(abs(value - from_double(forms->section(p, q))) <= from_double(forms->section.error()));
      for (std::size_t k = 0; k < 4; ++k)
        CHECK(abs(patch.homogeneous_at(u, v)[k] - from_double(forms->patch[k](p, q))) <=
              from_double(forms->patch[k].error()));
    }
  CHECK(forms->section.error() <= slack * largest_of(forms->section.table()));
}

}  // namespace

TEST_CASE("section forms: of every kind and degree, with weights or without, hold the exact composition") {
  Generator generator(2203);
  const std::vector<S> surfaces = {
      S::plane({0, Rational(1, 3), 0}, {1, 2, 3}), S::cylinder({0, 0, 0}, {1, 1, 1}, Length::of_squared(2)),
      S::cone({0, 0, 1}, {1, 0, 2}, Rational(1, 2)), S::sphere({Rational(1, 7), 0, 0}, 1),
      S::torus({0, 0, 0}, {1, 1, 0}, 2, 1)};
  for (const S& surface : surfaces)
    for (const auto& [m, n] : {std::pair{1, 1}, {2, 2}, {3, 1}, {3, 3}}) {
      const random_nets::Net net = random_nets::doubles(generator, m, n);
      check_forms(surface.equation(), RationalPatch(net), 1e-9);
      check_forms(surface.equation(), random_nets::weighted_by_doubles(generator, net), 1e-9);
      check_forms(surface.equation(), random_nets::weighted_by_one_or_two(generator, net), 1e-9);
    }
}

TEST_CASE("section forms: weights that are all 7 are weights") {
  Generator generator(2204);
  const random_nets::Net net = random_nets::doubles(generator, 2, 2);
  const RationalPatch sevenfold(net, std::vector(3, std::vector<Rational>(3, 7)));
  CHECK(section_forms(S::sphere({0, 0, 0}, 1).equation(), RationalPatch(net))->has_no_weights);
  CHECK_FALSE(section_forms(S::sphere({0, 0, 0}, 1).equation(), sevenfold)->has_no_weights);
  check_forms(S::sphere({0, 0, 0}, 1).equation(), sevenfold, 1e-9);
}

TEST_CASE("section forms: what doubles do not hold is left to others") {
  const RationalPatch patch(std::vector<std::vector<Point>>{{{0, 0, 0}, {0, 1, 0}}, {{1, 0, 0}, {1, 1, 0}}});
  const SpacePolynomial z = SpacePolynomial::variable(2), x = SpacePolynomial::variable(0);
  CHECK_FALSE(section_forms(z, patch));                        // it is 0 on the patch
  CHECK_FALSE(section_forms(power_of_two(2000) * x, patch));   // too large
  CHECK_FALSE(section_forms(power_of_two(-2000) * x, patch));  // too small
  CHECK(section_forms(power_of_two(400) * x, patch));
  SpacePolynomial fifth = x * x * x * x * x;
  CHECK_FALSE(section_forms(fifth, patch));
}

}  // namespace exsect::section_forms_test
