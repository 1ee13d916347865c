// The curve of an equation in the square of a patch: against the solver's polynomial, and values in space.
#include <exsect/checker/section.h>
#include <exsect/geometry/implicit_surface.h>
#include <exsect/geometry/surface_pull_back.h>

#include "support/catch.h"
#include "support/random_nets.h"

namespace exsect::section_test {
namespace {

using checker::Section;
using checker::WeightedNet;
using Generator = random_pairs::Generator;

WeightedNet<Rational> coefficients(const RationalPatch& patch) {
  const auto m = static_cast<std::size_t>(patch.degree_u());
  const auto n = static_cast<std::size_t>(patch.degree_v());
  WeightedNet<Rational> net = {checker::Net<Rational>(m, n), checker::Grid<Rational, 1>(m, n)};
  net.points.each([&](std::size_t i, std::size_t j) {
    const HomogeneousPoint& p = patch.homogeneous(static_cast<int>(i), static_cast<int>(j));
    net.points[i][j] = {p[0], p[1], p[2]};
    net.weights[i][j][0] = p[3];
  });
  net.to_powers();
  return net;
}

Rational small(Generator& generator) { return Rational(random_pairs::integer(generator, -9, 9), 4); }

/// Some of all monomials up to the degree, the pure power of x among them.
SpacePolynomial polynomial(Generator& generator, int degree) {
  SpacePolynomial::Terms terms = {{{degree, 0, 0}, 1}};
  for (const Exponents& e : exponents_up_to(degree))
    if (random_pairs::integer(generator, 0, 2) == 0) terms[e] += small(generator);
  return SpacePolynomial(terms);
}

}  // namespace

TEST_CASE("sections of patches of every kind are those of the solver") {
  Generator generator(51);
  INFO("seed 51");
  for (int i = 0; i < 36; ++i) {
    const int m = 1 + i % 3, n = 1 + i / 3 % 3, degree = 1 + i / 9;
    INFO(m << "," << n << ", degree " << degree);
    const auto nets = random_nets::scattered(generator, {m, n, 1, 1});
    const RationalPatch x = i % 2 == 0 ? nets.first() : random_nets::weighted(generator, nets.x);
    const SpacePolynomial f = polynomial(generator, degree);
    const checker::Polynomial section = Section(f.terms(), coefficients(x)).polynomial();
    const BivariatePolynomial other = pull_back(f, x);
    for (int k = 0; k <= degree * m; ++k)
      for (int l = 0; l <= degree * n; ++l) {
        const auto found = section.find({k, l, 0, 0});
        CHECK((found == section.end() ? Rational(0) : found->second) == other.coefficient(k, l));
      }
    // Bernstein coefficients: values at corners, and of both halves at the middle.
    const auto at = [&](const Rational& u, const Rational& v) { return other.at_r(u)(v); };
    auto net = checker::section_net(section, static_cast<std::size_t>(degree * m),
                                    static_cast<std::size_t>(degree * n));
    const std::size_t last[] = {net.degree(0), net.degree(1)};
    CHECK(net[0][0][0] == at(0, 0));
    CHECK(net[last[0]][last[1]][0] == at(1, 1));
    net = net.split(0);
    net.split(1);
    CHECK(net[last[0]][0][0] == at(Rational(1, 2), Rational(1, 2)));
    CHECK(net[0][last[1]][0] == at(0, 1));
  }
}

TEST_CASE("equations without terms, and of degree 0, have sections as well") {
  const WeightedNet<Rational> x =
      coefficients(RationalPatch({{{0, 0, 0}, {0, 1, 0}}, {{1, 0, 0}, {1, 1, 1}}}));
  CHECK(checker::is_zero(Section({}, x).polynomial()));
  const checker::SurfaceEquation constant = {{{0, 0, 0}, 3}, {{4, 0, 0}, 0}};
  CHECK(checker::degree(constant) == 0);
  const checker::Polynomial section = Section(constant, x).polynomial();
  CHECK((section.size() == 1 && section.at({}) == 3));
}

TEST_CASE("F of a section is the section and the middle of r and s") {
  const checker::Map<Rational> map = checker::section_map({{{2, 1, 0, 0}, 5}, {{0, 0, 0, 0}, -1}});
  const auto f = map.value({2, 3, 1, Rational(1, 4)});
  CHECK((f[0] == 59 && f[1] == Rational(1, 2) && f[2] == Rational(-1, 4)));
}

}  // namespace exsect::section_test
