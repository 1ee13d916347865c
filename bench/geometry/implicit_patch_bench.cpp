#include <benchmark/benchmark.h>
#include <exsect/geometry/approximate_implicit_patch.h>
#include <exsect/geometry/implicit_patch.h>

#include "geometry/example_pairs.h"

namespace {

using namespace exsect;

void implicit_equation_degree_8(benchmark::State& state) {
  const BezierPatch x = first_example().x;
  for (auto _ : state) benchmark::DoNotOptimize(implicit_equation(x));
}
void approximate_quartic_dokken(benchmark::State& state) {
  const BezierPatch x = first_example().x;
  for (auto _ : state) benchmark::DoNotOptimize(approximate_equation(x, 4, PatchFit::dokken));
}
void approximate_quartic_conics(benchmark::State& state) {
  const BezierPatch x = first_example().x;
  for (auto _ : state) benchmark::DoNotOptimize(approximate_equation(x, 4, PatchFit::conics));
}

BENCHMARK(implicit_equation_degree_8)->Unit(benchmark::kMillisecond);
BENCHMARK(approximate_quartic_dokken)->Unit(benchmark::kMillisecond);
BENCHMARK(approximate_quartic_conics)->Unit(benchmark::kMillisecond);

}  // namespace
