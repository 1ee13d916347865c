// From patches to parameter lines: rational and on integers.
#include <benchmark/benchmark.h>
#include <exsect/geometry/integer_pair.h>
#include <exsect/geometry/parameter_line.h>

#include "geometry/example_pairs.h"

using namespace exsect;

namespace {

const Rational u0(5, 17);

void evaluate(benchmark::State& state, Pair (*make)()) {
  const Pair pair = make();
  for (auto _ : state) benchmark::DoNotOptimize(pair.x(u0, u0));
}
BENCHMARK_CAPTURE(evaluate, small_rationals, first_example);
BENCHMARK_CAPTURE(evaluate, doubles, first_example_in_doubles);

void power_basis(benchmark::State& state, Pair (*make)()) {
  const Pair pair = make();
  for (auto _ : state) benchmark::DoNotOptimize(pair.x.power_basis());
}
BENCHMARK_CAPTURE(power_basis, small_rationals, first_example);
BENCHMARK_CAPTURE(power_basis, doubles, first_example_in_doubles);

void rational_line(benchmark::State& state, Pair (*make)()) {
  const Pair pair = make();
  for (auto _ : state) benchmark::DoNotOptimize(line_at_first(pair.x, u0));
}
BENCHMARK_CAPTURE(rational_line, small_rationals, first_example);
BENCHMARK_CAPTURE(rational_line, doubles, first_example_in_doubles);

void integers_of_pair(benchmark::State& state, Pair (*make)()) {
  const Pair pair = make();
  for (auto _ : state) benchmark::DoNotOptimize(integer_pair(pair.x, pair.y));
}
BENCHMARK_CAPTURE(integers_of_pair, small_rationals, first_example);
BENCHMARK_CAPTURE(integers_of_pair, doubles, first_example_in_doubles);

void integer_line(benchmark::State& state, Pair (*make)()) {
  const Pair pair = make();
  const IntegerPair integers = integer_pair(pair.x, pair.y);
  for (auto _ : state) benchmark::DoNotOptimize(line_at_first(integers.x, u0));
}
BENCHMARK_CAPTURE(integer_line, small_rationals, first_example);
BENCHMARK_CAPTURE(integer_line, doubles, first_example_in_doubles);

}  // namespace
