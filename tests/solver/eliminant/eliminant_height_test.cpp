#include "eliminant/eliminant_height.h"

#include <exsect/algebra/modular.h>

#include <cmath>

#include "curve/mahler_measure.h"
#include "eliminant/fibre_projection.h"
#include "eliminant/turning_eliminant_modular.h"
#include "eliminant_pairs.h"
#include "support/catch.h"

namespace exsect::eliminant_height_test {
using namespace exsect::eliminant_pairs;

namespace {

/// E with its content, by the slow route and with 200 bits more than the bound asks for.
std::vector<Integer> eliminant(const IntegerPair& pair) {
  return interpolate_integer_polynomial(
      128, eliminant_height_bound(pair) + 200, [&](const PrimeField& field, Residue u, std::size_t count) {
        const ModularEliminant e(field, pair);
        std::vector<ResidueFraction> values;
        for (std::size_t i = 0; i < count; ++i, u = field.add(u, field.one())) values.push_back(e.value(u));
        return values;
      });
}

std::size_t bits(const std::vector<Integer>& coefficients) {
  Integer largest = 1;
  for (const Integer& c : coefficients) largest = std::max(largest, Integer(abs(c)));
  return msb(largest) + 1;
}

}  // namespace

TEST_CASE("the height bound holds and is not wasteful", "[eliminant_height]") {
  const unsigned seed = 31;
  INFO("seed " << seed);
  Random random(seed);
  const auto any_double = [&] { return from_double(std::uniform_real_distribution<double>(0, 1)(random)); };
  const auto tiny = [&] { return Rational(std::uniform_int_distribution<int>(-2, 2)(random)); };
  const auto mixed = [&] {
    return from_double(std::ldexp(std::uniform_real_distribution<double>(-1, 1)(random),
                                  std::uniform_int_distribution<int>(-40, 0)(random)));
  };
  const auto check = [](const BezierPatch& x, const BezierPatch& y, std::size_t slack) {
    const IntegerPair pair = integer_pair(x, y);
    const std::size_t bound = eliminant_height_bound(pair);
    const std::size_t actual = bits(eliminant(pair));
    INFO("bound " << bound << ", actual " << actual);
    CHECK(actual <= bound);
    CHECK(bound <= actual + slack);
  };
  for (int repeat = 0; repeat < 2; ++repeat) {
    check(random_patch(random), random_patch(random), 500);
    check(BezierPatch(net_of(tiny)), BezierPatch(net_of(tiny)), 600);
  }
  check(BezierPatch(net_of(any_double)), BezierPatch(net_of(any_double)), 500);
  check(BezierPatch(net_of(mixed)), BezierPatch(net_of(mixed)), 1500);
}

TEST_CASE("the height bound is made of the right norms", "[eliminant_height]") {
  const unsigned seed = 34;
  INFO("seed " << seed);
  Random random(seed);
  for (int repeat = 0; repeat < 3; ++repeat) {
    const IntegerPair pair = integer_pair(random_patch(random), random_patch(random));
    const HeightTerms terms = height_terms(pair);
    const auto norm = [](const std::vector<Polynomial>& f) {
      return log2_norm_upper(integer_coefficients({f}));
    };
    const FibreCoefficients<Polynomial> fibre = symbolic_fibre(pair);
    CHECK(std::abs(terms.r_s - norm(project_fibre(fibre).r.coefficients)) < 0.1);
    CHECK(std::abs(terms.r_r - norm(project_fibre(fibre.exchanged()).r.coefficients)) < 0.1);
    double jacobian = 1e9;
    const FibreForms<Polynomial> forms(fibre);
    for (std::size_t k = 0; k < 3; ++k)
      jacobian = std::min(jacobian, std::log2(6) + norm(turning_forms(fibre)[k]) -
                                        *measure_lower(integer_coefficients({{forms.n[k]}})));
    CHECK(std::abs(terms.jacobian - jacobian) < 0.2);
    CHECK(project_fibre(fibre).r.coefficients[16].degree() == 8);
    CHECK(2 * terms.g_s < norm({project_fibre(fibre).r.coefficients[16]}));  // g_s^2
    CHECK(2 * terms.g_s > norm({project_fibre(fibre).r.coefficients[16]}) - 8);

    // A linear map of space with determinant 2^30 multiplies E by 2^(40 * 30).
    IntegerPair scaled = pair;
    for (auto* net : {&scaled.x, &scaled.y})
      for (auto& row : *net)
        for (auto& point : row) {
          point[0] <<= 7;
          point[1] <<= 23;
        }
    const auto difference =
        static_cast<double>(eliminant_height_bound(scaled) - eliminant_height_bound(pair));
    CHECK(std::abs(difference - 1200) <= 1);
  }
}

TEST_CASE("the height bound refuses pairs without leading forms", "[eliminant_height]") {
  Random random(32);
  const BezierPatch any = random_patch(random);
  const BezierPatch ruled = BezierPatch::from_power_basis(random_coefficients(random, 2, 1));
  CHECK_THROWS_AS(eliminant_height_bound(integer_pair(ruled, any)), std::domain_error);
  CHECK_THROWS_AS(eliminant_height_bound(integer_pair(any, ruled)), std::domain_error);
}

TEST_CASE("the fast and the slow value of E agree, also modulo a prime that was not used",
          "[eliminant_height]") {
  const unsigned seed = 33;
  INFO("seed " << seed);
  Random random(seed);
  const IntegerPair pair = integer_pair(random_patch(random), random_patch(random));
  const std::vector<Integer> e = eliminant(pair);
  for (const std::uint64_t p : {prime_below(std::uint64_t{1} << 50), prime_below(std::uint64_t{1} << 20)}) {
    const PrimeField field(p);
    std::vector<Residue> coefficients;
    for (const Integer& c : e) coefficients.push_back(field.residue(c));
    const ModularEliminant modular(field, pair);
    for (std::int64_t u = -20; u < 20; ++u) {
      const Residue expected = evaluate(field, coefficients, field.residue(u));
      for (const ResidueFraction& value :
           {modular.fast_values(field.residue(u), 1).front(), modular.value(field.residue(u))})
        CHECK((value.denominator == 0 || field.multiply(expected, value.denominator) == value.numerator));
    }
  }
}

}  // namespace exsect::eliminant_height_test
