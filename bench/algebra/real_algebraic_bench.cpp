// Real algebraic numbers: roots in (0,1) of polynomials with random Bernstein coefficients.
#include <benchmark/benchmark.h>
#include <exsect/algebra/bernstein.h>
#include <exsect/algebra/real_algebraic.h>

#include <vector>

#include "algebra/random_numbers.h"

using namespace exsect;

namespace {

std::vector<RealAlgebraic> random_roots(int degree, int bits, std::uint64_t seed = 7) {
  test::Random random(seed);
  std::vector<RealAlgebraic> result;
  for (int k = 0; k < 10; ++k)
    for (const RealAlgebraic& root :
         real_roots(from_bernstein(random.big_polynomial(degree, bits).coefficients()), 0, 1))
      result.push_back(root);
  return result;
}

/// The mean over all roots of the family.
void refine(benchmark::State& state) {
  const std::vector<RealAlgebraic> roots =
      random_roots(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
  const Rational width = power_of_two(-state.range(2));
  std::size_t next = 0;
  for (auto _ : state) benchmark::DoNotOptimize(roots[next++ % roots.size()].refined_to(width));
}
BENCHMARK(refine)
    ->ArgNames({"degree", "bits", "to"})
    ->Args({4, 100, 60})
    ->Args({16, 300, 20})
    ->Args({16, 300, 60})
    ->Args({16, 300, 1000})
    ->Args({128, 2000, 60})
    ->Args({128, 7000, 60})
    ->Args({128, 7000, 1000})
    ->Unit(benchmark::kMicrosecond);

/// Signs of random polynomials of degree 8 at the roots.
void sign_nonzero(benchmark::State& state) {
  const std::vector<RealAlgebraic> roots = random_roots(static_cast<int>(state.range(0)), 300);
  test::Random random(8);
  const Polynomial f = random.big_polynomial(8, 100);
  std::size_t next = 0;
  for (auto _ : state) benchmark::DoNotOptimize(sign_at(f, roots[next++ % roots.size()]));
}
BENCHMARK(sign_nonzero)->ArgName("degree")->Arg(4)->Arg(16)->Arg(128)->Unit(benchmark::kMicrosecond);

/// Zero: a multiple of the polynomial of the number.
void sign_zero(benchmark::State& state) {
  const std::vector<RealAlgebraic> roots = random_roots(static_cast<int>(state.range(0)), 300);
  test::Random random(8);
  const Polynomial f = random.big_polynomial(4, 100);
  std::vector<Polynomial> multiples;
  for (const RealAlgebraic& root : roots) multiples.push_back(f * root.polynomial());
  std::size_t next = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(sign_at(multiples[next % roots.size()], roots[next % roots.size()]));
    ++next;
  }
}
BENCHMARK(sign_zero)->ArgName("degree")->Arg(4)->Arg(16)->Arg(128)->Unit(benchmark::kMicrosecond);

/// Neighbouring roots of two polynomials.
void compare(benchmark::State& state) {
  const std::vector<RealAlgebraic> a = random_roots(static_cast<int>(state.range(0)), 300, 7);
  const std::vector<RealAlgebraic> b = random_roots(static_cast<int>(state.range(0)), 300, 8);
  std::vector<std::pair<RealAlgebraic, RealAlgebraic>> pairs;
  for (const RealAlgebraic& x : a)
    for (const RealAlgebraic& y : b)
      if (x.interval().upper > y.interval().lower && y.interval().upper > x.interval().lower)
        pairs.emplace_back(x, y);
  std::size_t next = 0;
  for (auto _ : state) {
    const auto& [x, y] = pairs[next++ % pairs.size()];
    benchmark::DoNotOptimize(x < y);
  }
}
BENCHMARK(compare)->ArgName("degree")->Arg(4)->Arg(16)->Arg(128)->Unit(benchmark::kMicrosecond);

}  // namespace
