#include "trace/tube_line.h"

#include <cmath>
#include <random>

#include "support/ball_checks.h"
#include "support/catch.h"
#include "support/graph_patches.h"
#include "trace/tube.h"

namespace exsect::tube_line_test {
namespace {

using Polynomial = std::vector<double>;

double value(const Polynomial& f, double t) {
  double sum = 0;
  for (std::size_t k = f.size(); k-- > 0;) sum = f[k] + t * sum;
  return sum;
}
Polynomial derived(const Polynomial& f) {
  Polynomial d;
  for (std::size_t k = 1; k < f.size(); ++k) d.push_back(static_cast<double>(k) * f[k]);
  return d;
}
Polynomial product(const Polynomial& f, const Polynomial& g) {
  Polynomial h(f.size() + g.size() - 1);
  for (std::size_t i = 0; i < f.size(); ++i)
    for (std::size_t j = 0; j < g.size(); ++j) h[i + j] += f[i] * g[j];
  return h;
}

/// Bounds of a polynomial in sigma = tau / scale, |tau| <= ratio scale.
SeriesBound bound_of(const Polynomial& f, double ratio, double scale) {
  SeriesBound bound;
  for (std::size_t k = 0; k < f.size(); ++k)
    bound.add_multiple(std::fabs(f[k]), SeriesBound::of_power(k, ratio, scale));
  return bound;
}

void check_bounds(const SeriesBound& bound, const Polynomial& f, double ratio, double scale) {
  for (int i = -8; i <= 8; ++i) {
    const double sigma = ratio * i / 8;
    CHECK(std::fabs(value(f, sigma)) <= bound.value * (1 + 1e-12));
    CHECK(std::fabs(value(derived(f), sigma)) / scale <= bound.first * (1 + 1e-12));
    CHECK(std::fabs(value(derived(derived(f)), sigma)) / (scale * scale) <= bound.second * (1 + 1e-12));
  }
}

}  // namespace

TEST_CASE("tube line: bounds of polynomials and their products with two derivatives", "[trace]") {
  std::mt19937_64 generator(20272);
  std::uniform_real_distribution<double> any(-1, 1);
  for (int round = 0; round < 100; ++round) {
    const double scale = std::exp2(-(round % 20));
    const double ratio = 0.5 + 0.5 * std::fabs(any(generator));
    Polynomial f(4), g(3);
    for (double& c : f) c = any(generator);
    for (double& c : g) c = any(generator);
    const SeriesBound of_f = bound_of(f, ratio, scale);
    check_bounds(of_f, f, ratio, scale);
    SeriesBound of_product;
    of_product.add_product(of_f, bound_of(g, ratio, scale));
    check_bounds(of_product, product(f, g), ratio, scale);
  }
  // Sharp for powers, at the end of the range.
  const SeriesBound cube = SeriesBound::of_power(3, 0.5, 0.25);
  CHECK(cube.value == Approx(0.125));
  CHECK(cube.first == Approx(3 * 0.25 / 0.25));
  CHECK(cube.second == Approx(6 * 0.5 / 0.0625));
}

TEST_CASE("tube line: the Taylor polynomial of the hyperbola", "[trace]") {
  // u v = 1/4 over u: v = 1/(4 u), at u = 1/2: v = 1/2 - t + 2 t^2 - 4 t^3 + ...
  const Rational q(-1, 4);
  testing::HeightCoefficients h{};
  h[0][0] = q;
  h[1][1] = 1;
  using Ball = ArbBall<256>;
  const PairSystem<Ball> system(testing::graph_patch(h), testing::plane_patch(), {0, 0, 0}, 0);
  const Rational half(1, 2);
  const auto tube = certify_tube(system, testing::ball_point<Ball>({half, half, half, half}), 0, 0.0625, 0);
  REQUIRE(tube);
  for (std::size_t k = 1; k <= kLineDegree<Ball>; ++k) {
    const double v = 0.5 * std::pow(-2.0 * tube->scale, static_cast<double>(k));
    CHECK(tube->line[k - 1][1].approximation() == Approx(v).epsilon(1e-12));
    CHECK(tube->line[k - 1][3].approximation() == Approx(v).epsilon(1e-12));
    CHECK(tube->line[k - 1][2].approximation() == Approx(k == 1 ? tube->scale : 0).margin(1e-40));
  }
}

}  // namespace exsect::tube_line_test
