// From a parameter line to the pulled-back plane and cylinder, at a rational u0 and with u as a variable.
#include <benchmark/benchmark.h>
#include <exsect/geometry/symbolic_line.h>

#include "geometry/example_pairs.h"

using namespace exsect;

namespace {

void pull_back_of_axis_forms(benchmark::State& state, Pair (*make)()) {
  const Pair pair = make();
  const ParameterLine line = line_at_first(pair.x, Rational(5, 17));
  for (auto _ : state) benchmark::DoNotOptimize(pull_back(axis_forms(line), pair.y));
}
BENCHMARK_CAPTURE(pull_back_of_axis_forms, small_rationals, first_example);
BENCHMARK_CAPTURE(pull_back_of_axis_forms, doubles, first_example_in_doubles);

void symbolic_cylinder(benchmark::State& state) {
  const Pair pair = first_example();
  for (auto _ : state)
    benchmark::DoNotOptimize(pull_back(orthogonal_forms(symbolic_line(pair.x)), pair.y).cylinder());
}
BENCHMARK(symbolic_cylinder);

}  // namespace
