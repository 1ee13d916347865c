// Pairs of conics that are conjugate over a quadratic field: products of known ones, and what is none.
#include "lift/conjugate_conics.h"

#include <exsect/algebra/bivariate_factors.h>

#include <random>

#include "support/catch.h"

namespace exsect::conjugate_conics_test {
namespace {

BivariatePolynomial number(const Rational& q) { return BivariatePolynomial::constant(q); }
const BivariatePolynomial r = BivariatePolynomial::r(), s = BivariatePolynomial::s();

/// u, v and y along the axes.
SurfaceChart plain() { return {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {}}; }

bool is_irreducible(const BivariatePolynomial& f) {
  const std::vector<BivariatePower> powers = irreducible_factors(f);
  return powers.size() == 1 && powers[0].multiplicity == 1;
}

}  // namespace

TEST_CASE("conjugate conics: products are taken apart") {
  const unsigned seed = 26;
  INFO("seed " << seed);
  std::mt19937 random(seed);
  const auto small = [&] { return Rational(std::uniform_int_distribution<int>(-4, 4)(random)) / 3; };
  int found = 0;
  for (int k = 0; k < 60; ++k) {
    const Rational delta = std::array{2, 3, 7, 12}[static_cast<std::size_t>(k % 4)];
    const auto form = [&](int degree) {
      BivariatePolynomial sum = number(small());
      if (degree > 0) sum += number(small()) * r + number(small()) * s;
      if (degree > 1) sum += number(small()) * r * r + number(small()) * r * s + number(small()) * s * s;
      return sum;
    };
    // Conics with irrational numbers in all terms, in those of the first degree, or in the constant alone.
    const BivariatePolynomial n = form(2) + number(5) * s * s, m = form(k % 3);
    const BivariatePolynomial g = n * n - number(delta) * m * m;
    if (m.is_zero() || !is_irreducible(g)) continue;
    const auto pair = conjugate_conics(number(Rational(-3, 7)) * g);
    REQUIRE(pair);
    const BivariatePolynomial product = pair->n * pair->n - number(pair->delta) * pair->m * pair->m;
    CHECK(number(g.coefficient(0, 4)) * product == g);
    ++found;
  }
  CHECK(found > 50);
}

TEST_CASE("conjugate conics: what is no pair, or has no real points") {
  const BivariatePolynomial one = number(1);
  CHECK(!conjugate_conics(r * r * r * r + s * s * s * s - one));        // smooth
  CHECK(!conjugate_conics(s * s - number(2)));                          // of degree 2
  CHECK(!conjugate_conics((s * s - r) * (s * s - r) + one));            // conjugate complex
  CHECK(!conjugate_conics((s * s - r) * (s * s - r) - number(2) * r));  // the root of delta is no number
  CHECK(!conjugate_conics(r * r * r * r - number(2) * r * r - s * s));  // without s^4
}

TEST_CASE("conjugate conics: kinds, circles of tilted planes, and no plane") {
  const SheetFunction level = {{}, number(1)};
  const auto kinds = [&](const ConjugateConics& pair, const SheetFunction& f) {
    std::array<std::string, 2> names;
    for (const int side : {1, -1}) {
      const auto conic = conic_above(plain(), pair, side, f);
      names[side > 0 ? 0 : 1] = conic ? name(conic->kind) : "none";
    }
    return names;
  };
  using Names = std::array<std::string, 2>;
  CHECK(kinds({r * r + s * s - number(3), number(1), 2}, level) == Names{"circle", "circle"});
  CHECK(kinds({s * s - number(1), r * r, 2}, level) == Names{"hyperbola", "ellipse"});
  CHECK(kinds({s * s - r, number(1), 2}, level) == Names{"parabola", "parabola"});
  CHECK(kinds({s * s, r * r, 2}, level) == Names{"none", "none"});  // lines
  // In the planes y = +- sqrt(2) r, r is sqrt(3) times as long.
  const ConjugateConics pair = {number(3) * r * r + s * s - number(4), r, 2};
  // y = n / 1 on the pair, as n = +- sqrt(2) r there.
  CHECK(kinds(pair, {number(-1) * pair.n, number(1)}) == Names{"circle", "circle"});
  CHECK(kinds(pair, level) == Names{"ellipse", "ellipse"});
  CHECK(conic_above(plain(), pair, 1, level)->direction == Point{0, 0, 1});
  CHECK(!conic_above(plain(), pair, 1, {number(-1) * pair.n, number(1)})->direction);
  CHECK(kinds(pair, {r * s, number(1)}) == Names{"none", "none"});
}

}  // namespace exsect::conjugate_conics_test
