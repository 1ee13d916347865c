// Exact implicit equations of planar curves.
#include <benchmark/benchmark.h>
#include <exsect/geometry/implicit_curve.h>

#include "geometry/curve_specimens.h"

using namespace exsect;

namespace {

void planar_cubic(benchmark::State& state) {
  const BezierCurve curve = profile_cubic();
  for (auto _ : state) benchmark::DoNotOptimize(implicit_curve(curve));
}
BENCHMARK(planar_cubic);

void random_rational_curve(benchmark::State& state) {
  Random random(1);
  const BezierCurve curve = random_curve(random, static_cast<int>(state.range(0)), 2, true);
  for (auto _ : state) benchmark::DoNotOptimize(implicit_curve(curve));
}
BENCHMARK(random_rational_curve)->Arg(2)->Arg(3)->Arg(4)->Arg(6)->Arg(8);

}  // namespace
