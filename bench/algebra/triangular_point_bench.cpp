// Fibres over real algebraic s: the shapes of the line problem.
#include <benchmark/benchmark.h>
#include <exsect/algebra/resultant.h>
#include <exsect/algebra/triangular_point.h>

#include <vector>

#include "algebra/random_numbers.h"

using namespace exsect;

namespace {

BivariatePolynomial random_bivariate(test::Random& random, int degree, int bits) {
  std::vector<Polynomial> coefficients;
  for (int i = 0; i <= degree; ++i) coefficients.push_back(random.big_polynomial(degree, bits));
  return BivariatePolynomial(coefficients);
}

struct Problem {
  BivariatePolynomial f;
  BivariatePolynomial g;
  RealAlgebraic s;
};

/// f of bidegree (2,2), g of bidegree (n,n), s over their common points.
std::vector<Problem> problems(int n) {
  test::Random random(5);
  std::vector<Problem> result;
  for (int k = 0; k < 10; ++k) {
    const BivariatePolynomial f = random_bivariate(random, 2, 30), g = random_bivariate(random, n, 30);
    for (const RealAlgebraic& s : real_roots(resultant_r(f, g), -4, 4)) result.push_back({f, g, s});
  }
  return result;
}

template <class Operation>
void run(benchmark::State& state, Operation operation) {
  const std::vector<Problem> all = problems(static_cast<int>(state.range(0)));
  std::size_t next = 0;
  for (auto _ : state) benchmark::DoNotOptimize(operation(all[next++ % all.size()]));
}

void common_factor(benchmark::State& state) {
  run(state, [](const Problem& p) { return gcd_at(p.f, p.g, p.s); });
}
BENCHMARK(common_factor)->ArgName("n")->Arg(2)->Arg(4)->Unit(benchmark::kMicrosecond);

void coprime(benchmark::State& state) {
  run(state, [](const Problem& p) { return gcd_at(p.f, p.g + BivariatePolynomial::constant(1), p.s); });
}
BENCHMARK(coprime)->ArgName("n")->Arg(2)->Arg(4)->Unit(benchmark::kMicrosecond);

void roots(benchmark::State& state) {
  run(state, [](const Problem& p) { return roots_at(p.g, p.s, -8, 8).size(); });
}
BENCHMARK(roots)->ArgName("n")->Arg(2)->Arg(4)->Unit(benchmark::kMicrosecond);

void refine_roots(benchmark::State& state) {
  run(state, [](const Problem& p) {
    const std::vector<TriangularPoint> points = roots_at(p.g, p.s, -8, 8);
    for (const TriangularPoint& point : points) benchmark::DoNotOptimize(point.refined_to(power_of_two(-60)));
    return points.size();
  });
}
BENCHMARK(refine_roots)->ArgName("n")->Arg(2)->Arg(4)->Unit(benchmark::kMicrosecond);

/// Which of the points of g lie on f: exact zeros among them.
void signs(benchmark::State& state) {
  run(state, [](const Problem& p) {
    int zeros = 0;
    for (const TriangularPoint& point : roots_at(p.g, p.s, -8, 8)) zeros += sign_at(p.f, point) == 0;
    return zeros;
  });
}
BENCHMARK(signs)->ArgName("n")->Arg(2)->Arg(4)->Unit(benchmark::kMicrosecond);

}  // namespace
