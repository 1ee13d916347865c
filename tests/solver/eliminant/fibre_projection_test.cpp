#include "eliminant/fibre_projection.h"

#include <exsect/algebra/resultant.h>
#include <exsect/geometry/integer_pair.h>
#include <exsect/geometry/parameter_line.h>
#include <exsect/geometry/pull_back.h>

#include "eliminant_pairs.h"
#include "support/catch.h"

namespace exsect::fibre_projection_test {
using namespace exsect::eliminant_pairs;

namespace {

FibreProjection project(const BezierPatch& x, const BezierPatch& y) {
  return project_fibre(symbolic_fibre(integer_pair(x, y)));
}

int degree_s(const FibrePolynomial& f) { return static_cast<int>(f.coefficients.size()) - 1; }

int degree_u(const FibrePolynomial& f) {
  int degree = -1;
  for (const Polynomial& c : f.coefficients) degree = std::max(degree, c.degree());
  return degree;
}

/// The polynomial in s at a rational u.
Polynomial at(const FibrePolynomial& f, const Rational& u) {
  std::vector<Rational> coefficients;
  for (const Polynomial& c : f.coefficients) coefficients.push_back(c(u));
  return Polynomial(coefficients);
}

Polynomial monic(const Polynomial& f) { return f * Polynomial(1 / f.leading_coefficient()); }

}  // namespace

TEST_CASE("R and S1 have the degrees of the method", "[fibre_projection]") {
  const unsigned seed = 41;
  INFO("seed " << seed);
  Random random(seed);
  const FibreProjection p = project(random_patch(random), random_patch(random));
  CHECK(degree_s(p.r) == 16);
  CHECK(degree_u(p.r) == 16);
  CHECK(degree_s(p.s1) == 10);
  CHECK(degree_u(p.s1) == 10);
  CHECK(p.complete);
  CHECK(p.content.degree() == 0);
  CHECK(degree_s(p.finite) == 16);
  CHECK(coprime(p.finite, derivative(p.finite)));
  CHECK(coprime(p.finite, p.s1));
}

TEST_CASE("R at a rational u is the resultant of plane and cylinder", "[fibre_projection]") {
  const unsigned seed = 42;
  INFO("seed " << seed);
  Random random(seed);
  const BezierPatch conic = random_patch(random);
  const BezierPatch bent = random_patch(random);
  const BezierPatch ruled = BezierPatch::from_power_basis(random_coefficients(random, 1, 2));
  for (const BezierPatch& y : {bent, ruled}) {
    const FibreProjection p = project(conic, y);
    for (const Rational& u : {Rational(0), Rational(1, 3), Rational(-7, 2)}) {
      const PullBack forms = pull_back(orthogonal_forms(line_at_first(conic, u)), y);
      CHECK(monic(at(p.r, u)) == monic(resultant_r(forms.plane, forms.cylinder())));
    }
  }
}

TEST_CASE("R and S1 give the Jacobian at a known point", "[fibre_projection]") {
  const unsigned seed = 43;
  INFO("seed " << seed);
  Random random(seed);
  const Rational u(1, 2);
  const Rational v(2, 3);
  const Rational r(-1, 4);
  const Rational s(3, 5);
  struct Degrees {
    std::size_t x_v;
    std::size_t y_r;
  };
  for (const auto& [x_v, y_r] : {Degrees{2, 2}, Degrees{2, 1}, Degrees{1, 2}, Degrees{1, 1}}) {
    INFO("degrees " << x_v << ' ' << y_r);
    // y is moved so that x(u,v) = y(r,s).
    ControlNet x = random_coefficients(random, 2, x_v);
    ControlNet y = random_coefficients(random, y_r, 2);
    x[0][0] = Point{};
    y[0][0] = y[0][0] + (BezierPatch::from_power_basis(x)(u, v) - BezierPatch::from_power_basis(y)(r, s));
    FibreCoefficients<Polynomial> fibre;
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t k = 0; k < 3; ++k) {
        fibre.a[j][k] = Polynomial({x[0][j][k], x[1][j][k], x[2][j][k]});
        for (std::size_t i = 0; i < 3; ++i) fibre.y[i][j][k] = y[i][j][k];
      }
    const FibreProjection p = project_fibre(fibre);
    CHECK(at(p.r, u)(s) == 0);
    const Rational jacobian = determinant(BezierPatch::from_power_basis(x).derivative_second(u, v),
                                          BezierPatch::from_power_basis(y).derivative_first(r, s),
                                          BezierPatch::from_power_basis(y).derivative_second(r, s));
    const Rational quotient = at(p.r, u).derivative()(s) / (at(p.s1, u)(s) * jacobian);
    CHECK(quotient * quotient == 1);
  }
}

TEST_CASE("points at infinity are taken out of the fibre", "[fibre_projection]") {
  const unsigned seed = 44;
  INFO("seed " << seed);
  Random random(seed);
  const BezierPatch x = random_patch(random);
  const BezierPatch field = BezierPatch::from_power_basis(height_field_coefficients(random));
  const FibreProjection to_s = project(x, field);
  CHECK(degree_s(to_s.r) == 12);
  CHECK(to_s.complete);
  CHECK(degree_s(to_s.finite) == 8);
  const FibreProjection to_r = project(x, field.exchanged());
  CHECK(degree_s(to_r.finite) == 8);
}

}  // namespace exsect::fibre_projection_test
