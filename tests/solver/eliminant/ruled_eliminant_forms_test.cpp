// The eliminant of patches of which one has straight lines x(u,.): against values of another program, against
// the formulas with the parameters of the other patch exchanged, and exact against enclosed.
#include "eliminant/ruled_eliminant_forms.h"

#include <exsect/algebra/modular.h>

#include <random>

#include "eliminant/weighted_eliminant.h"
#include "scalar_eliminant.h"
#include "support/catch.h"
#include "support/random_nets.h"
#include "weighted_pairs.h"

namespace exsect::ruled_eliminant_forms_test {
namespace {

using namespace exsect::weighted_pairs;

struct Degrees {
  std::size_t a, m, n;
};

/// The coefficient of u^i v^j in coordinate k is t^3 mod p - p/2, by formulas that another program has as
/// well; the weight is large.
template <class Formula>
RationalPatch patch_by(std::size_t m, std::size_t n, std::size_t p, const Formula& formula) {
  PowerBasis c(m + 1, std::vector<HomogeneousPoint>(n + 1));
  for (std::size_t i = 0; i <= m; ++i)
    for (std::size_t j = 0; j <= n; ++j)
      for (std::size_t k = 0; k < 4; ++k) {
        const std::size_t t = formula(i, j, k);
        c[i][j][k] = static_cast<long>(t * t * t % p) - static_cast<long>(p / 2);
      }
  c[0][0][3] += 200;
  return from_power_basis(c);
}
RationalPatch first_patch(const Degrees& d) {
  return patch_by(d.a, 1, 29, [](auto i, auto j, auto k) { return 3 + 5 * i + 7 * j + 11 * k; });
}
RationalPatch second_patch(const Degrees& d) {
  return patch_by(d.m, d.n, 31, [](auto i, auto j, auto k) { return 2 + 11 * i + 3 * j + 5 * k; });
}

struct Reference {
  Degrees degrees;
  int degree;
  std::int64_t at_2, at_3;  // E(2)/E(1) and E(3)/E(1) modulo 10^9 + 7
};

// By PARI/GP: the discriminant of Res_r([a0 a1 c Y], [a0 a1 d Y]) / [a0 a1 c d]^m in s modulo 10^9 + 7,
// interpolated from its values at u = 1, 2, ..., without its multiple factors.
constexpr std::array<Reference, 15> kReferences = {{{{1, 1, 1}, 4, 247803514, 460429305},
                                                    {{2, 1, 1}, 8, 698296271, 893318388},
                                                    {{3, 1, 1}, 12, 833311074, 468197155},
                                                    {{1, 1, 2}, 12, 61771888, 208633983},
                                                    {{2, 1, 2}, 24, 534939734, 736921401},
                                                    {{3, 1, 2}, 36, 948755611, 165040061},
                                                    {{3, 1, 3}, 60, 97518977, 708504879},
                                                    {{1, 2, 2}, 32, 63023377, 977208957},
                                                    {{2, 2, 2}, 64, 260693650, 904416089},
                                                    {{3, 2, 2}, 96, 340687646, 731479273},
                                                    {{2, 2, 3}, 104, 464759399, 266913214},
                                                    {{3, 2, 3}, 156, 664579970, 507252133},
                                                    {{1, 3, 3}, 84, 201334768, 66116469},
                                                    {{2, 3, 3}, 168, 646297281, 554849108},
                                                    {{3, 3, 3}, 252, 932477498, 269775283}}};

Residue at(const PrimeField& field, const Polynomial& e, std::int64_t u) {
  Residue sum = 0;
  for (int i = e.degree(); i >= 0; --i)
    sum = field.add(field.multiply(sum, field.residue(u)), field.residue(numerator(e.coefficient(i))));
  return sum;
}

RationalPatch random_ruled(random_nets::Generator& generator, int a) {
  return random_nets::weighted_by_doubles(generator, random_nets::doubles(generator, a, 1));
}

/// E(u) for y with its parameters exchanged, of the kind that these have then.
template <std::size_t m, std::size_t n>
Residue exchanged_value(const PrimeField& field, const WeightedPair& pair, Residue u) {
  using Forms = RuledEliminantForms<ScalarArithmetic, n, m>;
  typename Forms::FirstNet x = {};
  typename Forms::SecondNet y = {};
  typename Forms::SmallNumbers small;
  for (std::size_t i = 0; i < std::size(small); ++i) small[i] = field.residue(static_cast<std::int64_t>(i));
  for (std::size_t k = 0; k < 4; ++k) {
    for (std::size_t i = 0; i < pair.x.size(); ++i)
      for (std::size_t j = 0; j < 2; ++j) x.c[i][j].c[k] = field.residue(pair.x[i][j][k]);
    for (std::size_t i = 0; i <= m; ++i)
      for (std::size_t j = 0; j <= n; ++j) y.c[j][i].c[k] = field.residue(pair.y[i][j][k]);
  }
  const Forms forms(ScalarArithmetic(field), x, y, small);
  const auto value = forms.value(forms.fibre(u));
  return field.multiply(value.numerator, field.inverse(value.denominator));
}

template <std::size_t m, std::size_t n>
void check_exchanged(const PrimeField& field) {
  INFO(m << ", " << n);
  const WeightedPair pair = weighted_pair(first_patch({2, m, n}), second_patch({2, m, n}));
  const WeightedModularEliminant<RuledKind<m, n>> eliminant(field, pair);
  std::optional<Residue> ratio;
  for (const std::int64_t u : {1, 5, -7, 1234567}) {
    const ResidueFraction value = eliminant.value(field.residue(u));
    const Residue e = field.multiply(value.numerator, field.inverse(value.denominator));
    const Residue other = exchanged_value<m, n>(field, pair, field.residue(u));
    REQUIRE(e != 0);
    if (!ratio) ratio = field.multiply(other, field.inverse(e));
    CHECK(other == field.multiply(*ratio, e));
  }
  CHECK((*ratio == field.one() || *ratio == field.negate(field.one())));
}

}  // namespace

TEST_CASE("ruled eliminant: degrees, simple roots, and values of another program",
          "[ruled_eliminant_forms]") {
  const PrimeField field(1000000007);
  for (const Reference& reference : kReferences) {
    INFO(reference.degrees.a << " " << reference.degrees.m << " " << reference.degrees.n);
    const auto e =
        weighted_eliminant(first_patch(reference.degrees), second_patch(reference.degrees), Parameter::u);
    REQUIRE(e);
    CHECK(e->degree() == reference.degree);
    if (reference.degree < 160) CHECK(squarefree_part(*e).degree() == reference.degree);
    const Residue inverse = field.inverse(at(field, *e, 1));
    CHECK(field.representative(field.multiply(at(field, *e, 2), inverse)) ==
          static_cast<std::uint64_t>(reference.at_2));
    CHECK(field.representative(field.multiply(at(field, *e, 3), inverse)) ==
          static_cast<std::uint64_t>(reference.at_3));
  }
}

TEST_CASE("ruled eliminant: r and s exchanged", "[ruled_eliminant_forms]") {
  const PrimeField field(prime_below(prime_field_limit));
  check_exchanged<1, 1>(field);
  check_exchanged<1, 2>(field);
  check_exchanged<1, 3>(field);
  check_exchanged<2, 2>(field);
  check_exchanged<2, 3>(field);
  check_exchanged<3, 3>(field);
}

TEST_CASE("ruled eliminant: vectors and scalars, and the bound of the height", "[ruled_eliminant_forms]") {
  const auto seed = std::random_device{}();
  CAPTURE(seed);
  random_nets::Generator generator(seed);
  for (const auto& [a, m, n] : {std::array{3, 1, 1}, std::array{1, 1, 2}, std::array{3, 1, 3},
                                std::array{2, 2, 2}, std::array{3, 2, 3}, std::array{1, 3, 3}}) {
    INFO(a << " " << m << " " << n);
    const auto y = random_nets::weighted(generator, random_nets::doubles(generator, m, n));
    const WeightedPair pair = weighted_pair(random_ruled(generator, a), y);
    scalar_eliminant::check_vectors_and_bound(pair, 1500);
  }
}

TEST_CASE("ruled eliminant: enclosed roots are those of the exact one", "[ruled_eliminant_forms]") {
  const auto seed = std::random_device{}();
  CAPTURE(seed);
  random_nets::Generator generator(seed);
  std::size_t decided = 0, count = 0;
  for (const auto& [a, m, n] : {std::array{3, 1, 3}, std::array{2, 2, 2}, std::array{2, 1, 2},
                                std::array{3, 2, 2}, std::array{2, 3, 2}, std::array{1, 2, 1}}) {
    INFO(a << " " << m << " " << n);
    const auto nets = random_nets::crossing(generator, {a, 1, m, n}, true);
    const RationalPatch x(nets.x);  // without weights
    const RationalPatch y = random_nets::weighted_by_doubles(generator, nets.y);
    const auto roots = scalar_eliminant::checked_roots(x, y);
    decided += roots ? 1 : 0;
    count += roots.value_or(0);
  }
  CHECK(decided >= 5);
  CHECK(count >= 1);
}

TEST_CASE("ruled eliminant: the sweeps of lowest degree first", "[ruled_eliminant_forms]") {
  random_nets::Generator generator(3);
  const auto patch = [&](int m, int n) {
    return random_nets::weighted(generator, random_nets::doubles(generator, m, n));
  };
  using enum Parameter;
  const auto sweeps = [](const RationalPatch& x, const RationalPatch& y) { return eliminant_sweeps(x, y); };
  CHECK(sweeps(patch(2, 2), patch(2, 2)) == std::vector{u, v, r, s});
  CHECK(sweeps(patch(2, 2), patch(1, 3)) == std::vector{s});
  CHECK(sweeps(patch(3, 1), patch(1, 2)) == std::vector{u, s});
  CHECK(sweeps(patch(2, 1), patch(1, 3)) == std::vector{s, u});
  CHECK(sweeps(patch(1, 1), patch(3, 3)) == std::vector{u, v});
  CHECK(sweeps(patch(2, 1).elevated(3, 2), patch(3, 3)) == std::vector{u});
  CHECK(sweeps(patch(2, 3), patch(2, 2)).empty());
  CHECK(sweeps(patch(3, 3), patch(3, 3)).empty());
}

}  // namespace exsect::ruled_eliminant_forms_test
