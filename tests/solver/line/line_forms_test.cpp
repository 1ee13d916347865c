#include "line/line_forms.h"

#include <exsect/algebra/resultant.h>
#include <exsect/geometry/pull_back.h>

#include <random>

#include "line_shapes.h"
#include "support/catch.h"

namespace exsect::line_forms_test {

namespace {

/// c with f = c g, both not zero; fails the test if there is none.
Rational constant_ratio(const Polynomial& f, const Polynomial& g) {
  REQUIRE(!g.is_zero());
  const Rational c = f.leading_coefficient() / g.leading_coefficient();
  CHECK(f == Polynomial(c) * g);
  return c;
}

/// a modulo f, f = A r^2 + B r + C: A^k a = alpha + beta r with k = deg_r a - 1.
BivariatePolynomial pseudo_remainder(BivariatePolynomial a, const BivariatePolynomial& f) {
  for (int n = a.degree_r(); n >= 2; --n) {
    const Polynomial lead = a.coefficient(n);
    BivariatePolynomial shifted = f * lead;
    for (int i = 2; i < n; ++i) shifted = shifted * BivariatePolynomial::r();
    a = a * f.coefficient(2) - shifted;
  }
  return a;
}

void check_against_pull_back(const PatchPair& pair, const LineQuery& query) {
  const ConicForms forms = conic_forms(integer_line_and_patch(pair.x, pair.y, query));
  const LineAndPatch problem = line_and_patch(pair.x, pair.y, query);
  const LineForms axis = axis_forms(problem.line);
  const PullBack p = pull_back(axis, problem.patch);
  const BivariatePolynomial z = p.cylinder();
  const Rational nk = axis.e0.constant;

  INFO("R = Res_r(P,Z) / n_k^4 up to the scaling to integers: det^4 of plane and cylinder");
  const Rational plane_scale = constant_ratio(forms.a, p.plane.coefficient(2));
  CHECK(plane_scale > 0);
  CHECK(constant_ratio(forms.b, p.plane.coefficient(1)) == plane_scale);
  CHECK(constant_ratio(forms.c, p.plane.coefficient(0)) == plane_scale);
  const Rational ratio = constant_ratio(forms.eliminant, resultant_r(p.plane, z));
  CHECK(ratio == plane_scale * plane_scale * plane_scale * plane_scale / (nk * nk * nk * nk));

  INFO("A^3 Z = s1 r + s0 modulo P");
  const BivariatePolynomial remainder = pseudo_remainder(z, p.plane);
  const Rational scale = constant_ratio(forms.s1, remainder.coefficient(1));
  CHECK(scale > 0);
  CHECK(constant_ratio(forms.s0, remainder.coefficient(0)) == scale);

  INFO("t = -t_numerator/s1 at a common point: s1 L + U t_numerator vanishes modulo R at r = -s0/s1");
  const Polynomial l0 = p.l.coefficient(0) * forms.s1 * forms.s1 - p.l.coefficient(1) * forms.s0 * forms.s1 +
                        p.l.coefficient(2) * forms.s0 * forms.s0;
  const Polynomial u_t = Polynomial(nk) * forms.t_numerator * forms.s1;
  CHECK(divide(l0 + u_t, squarefree_part(forms.eliminant)).remainder.is_zero());
  CHECK(divide(forms.a * forms.s0 * forms.s0 - forms.b * forms.s0 * forms.s1 + forms.c * forms.s1 * forms.s1,
               squarefree_part(forms.eliminant))
            .remainder.is_zero());
}

}  // namespace

TEST_CASE("the closed formula is the resultant of plane and cylinder") {
  const PatchPair pair = example("chapter9-first.json");
  for (const Rational& u : {Rational(0), Rational(1, 20), Rational(1, 2), Rational(1)}) {
    const LineQuery query{Parameter::u, u};
    CHECK(conic_forms(integer_line_and_patch(pair.x, pair.y, query)).eliminant.degree() == 16);
    check_against_pull_back(pair, query);
  }
}

TEST_CASE("the closed formula on random lines and patches") {
  const unsigned seed = 20241;
  INFO("seed " << seed);
  std::mt19937 random(seed);
  for (int i = 0; i < 10; ++i) {
    const PatchPair pair = random_pair(random, 9);
    for (const Parameter fixed : all_parameters) check_against_pull_back(pair, {fixed, Rational(i, 9)});
  }
}

}  // namespace exsect::line_forms_test
