#include <benchmark/benchmark.h>
#include <exsect/algebra/polynomial.h>

#include "algebra/random_numbers.h"

using namespace exsect;

namespace {

void multiply(benchmark::State& state) {
  test::Random random(1);
  const Polynomial f =
      random.big_polynomial(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
  const Polynomial g =
      random.big_polynomial(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
  for (auto _ : state) benchmark::DoNotOptimize(f * g);
}
BENCHMARK(multiply)
    ->ArgNames({"degree", "bits"})
    ->Args({4, 50})
    ->Args({4, 200})
    ->Args({8, 100})
    ->Args({8, 300});

void add(benchmark::State& state) {
  test::Random random(1);
  Polynomial f = random.big_polynomial(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
  const Polynomial g =
      random.big_polynomial(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
  for (auto _ : state) {
    f += g;
    f -= g;
  }
}
BENCHMARK(add)->ArgNames({"degree", "bits"})->Args({8, 200})->Args({16, 400});

/// At a dyadic (odd / 2^precision) or, with third argument 1, at a rational of that size.
void sign_at(benchmark::State& state) {
  test::Random random(1);
  const Polynomial f =
      random.big_polynomial(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
  const int precision = static_cast<int>(state.range(2));
  const Rational numerator(abs(random.big_integer(precision)) | 1);
  const Rational t = numerator / (power_of_two(precision) + static_cast<int>(state.range(3)));
  for (auto _ : state) benchmark::DoNotOptimize(f.sign_at(t));
}
BENCHMARK(sign_at)
    ->ArgNames({"degree", "bits", "precision", "rational"})
    ->Args({16, 300, 10, 0})
    ->Args({16, 300, 60, 0})
    ->Args({16, 300, 60, 1})
    ->Args({16, 300, 200, 0})
    ->Args({128, 1000, 20, 0})
    ->Args({128, 1000, 200, 0})
    ->Args({128, 7000, 20, 0})
    ->Args({128, 7000, 200, 0})
    ->Args({128, 7000, 200, 1});

void evaluate(benchmark::State& state) {
  test::Random random(1);
  const Polynomial f =
      random.big_polynomial(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
  const Rational t(355, 678);
  for (auto _ : state) benchmark::DoNotOptimize(f(t));
}
BENCHMARK(evaluate)->ArgNames({"degree", "bits"})->Args({4, 100})->Args({16, 300})->Args({128, 1000});

void squarefree(benchmark::State& state) {
  test::Random random(1);
  const Polynomial f =
      random.big_polynomial(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
  for (auto _ : state) benchmark::DoNotOptimize(is_squarefree(f));
}
BENCHMARK(squarefree)->ArgNames({"degree", "bits"})->Args({16, 300})->Args({128, 1000})->Args({128, 7000});

}  // namespace
