// Descartes and Sturm on polynomials with random Bernstein coefficients: about sqrt(2n) roots in (0,1).
#include <benchmark/benchmark.h>
#include <exsect/algebra/bernstein.h>
#include <exsect/algebra/descartes.h>
#include <exsect/algebra/sturm.h>

#include <vector>

#include "algebra/random_numbers.h"

using namespace exsect;

namespace {

std::vector<Polynomial> random_bernstein(int degree, int bits) {
  test::Random random(7);
  std::vector<Polynomial> result;
  for (int k = 0; k < 20; ++k)
    result.push_back(from_bernstein(random.big_polynomial(degree, bits).coefficients()).primitive());
  return result;
}

void isolate(benchmark::State& state) {
  const std::vector<Polynomial> family =
      random_bernstein(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
  std::size_t next = 0;
  std::size_t roots = 0;
  for (auto _ : state) roots += isolate_roots(family[next++ % family.size()], 0, 1).size();
  state.counters["roots"] =
      benchmark::Counter(static_cast<double>(roots), benchmark::Counter::kAvgIterations);
}
BENCHMARK(isolate)
    ->ArgNames({"degree", "bits"})
    ->Args({4, 60})
    ->Args({8, 100})
    ->Args({16, 100})
    ->Args({16, 500})
    ->Args({128, 1000})
    ->Args({128, 7000})
    ->Unit(benchmark::kMicrosecond);

/// Three roots 2^-gap apart: the fixed-point form runs out and is renewed.
void isolate_cluster(benchmark::State& state) {
  const Rational gap = power_of_two(-state.range(1));
  const Polynomial f = random_bernstein(static_cast<int>(state.range(0)) - 3, 200).front() *
                       test::with_roots({Rational(1, 3), Rational(1, 3) + gap, Rational(1, 3) + 2 * gap});
  for (auto _ : state) benchmark::DoNotOptimize(isolate_roots(f, 0, 1));
}
BENCHMARK(isolate_cluster)
    ->ArgNames({"degree", "gap"})
    ->Args({16, 50})
    ->Args({16, 200})
    ->Args({128, 50})
    ->Args({128, 200})
    ->Unit(benchmark::kMicrosecond);

void sturm_count(benchmark::State& state) {
  const std::vector<Polynomial> family =
      random_bernstein(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
  std::size_t next = 0;
  for (auto _ : state)
    benchmark::DoNotOptimize(SturmSequence(family[next++ % family.size()]).count_closed(0, 1));
}
BENCHMARK(sturm_count)
    ->ArgNames({"degree", "bits"})
    ->Args({8, 100})
    ->Args({16, 100})
    ->Args({16, 500})
    ->Unit(benchmark::kMicrosecond);

void bernstein_form(benchmark::State& state) {
  const Polynomial f =
      random_bernstein(static_cast<int>(state.range(0)), static_cast<int>(state.range(1))).front();
  for (auto _ : state) benchmark::DoNotOptimize(bernstein_coefficients(f, f.degree()));
}
BENCHMARK(bernstein_form)
    ->ArgNames({"degree", "bits"})
    ->Args({4, 60})
    ->Args({16, 300})
    ->Args({128, 7000})
    ->Unit(benchmark::kMicrosecond);

}  // namespace
