// Approximate implicit equations of planar curves, and what is proved of them.
#include <benchmark/benchmark.h>
#include <exsect/implicit/implicitize_curve.h>
#include <exsect/implicit/implicitize_space_curve.h>

#include "geometry/curve_specimens.h"

using namespace exsect;

namespace {

const PlanarBox region = {{Rational(0), Rational(2)}, {Rational(0), Rational(2)}};

void least_squares(benchmark::State& state, Arithmetic arithmetic) {
  const PlanarSpace space = PlanarSpace::monomials(static_cast<int>(state.range(0)), region);
  const std::vector<FitSample> samples = fit_samples(profile_cubic(), 21);
  for (auto _ : state) benchmark::DoNotOptimize(fit_points_and_normals(space, samples, {}, arithmetic));
}
BENCHMARK_CAPTURE(least_squares, exact, Arithmetic::exact)->Arg(2)->Arg(3);
BENCHMARK_CAPTURE(least_squares, floating, Arithmetic::floating)->Arg(2)->Arg(3);

/// The bounds of the cubic fit, and of the bi-quartic one.
void bounds(benchmark::State& state, SpaceKind kind, int degree) {
  const PlanarSpace space = kind == SpaceKind::monomial ? PlanarSpace::monomials(degree, region)
                                                        : PlanarSpace::bernstein(degree, degree, region);
  const std::vector<FitSample> samples = fit_samples(profile_cubic(), 61);
  const PlanarFit fit =
      fit_points_and_normals(space, samples, {1, Rational(1, 100000)}, Arithmetic::floating);
  const PlanarFunction f = space.combination(rounded_coefficients(fit.coefficients, 9));
  for (auto _ : state) benchmark::DoNotOptimize(distance_bounds(f, profile_cubic()));
}
BENCHMARK_CAPTURE(bounds, cubic, SpaceKind::monomial, 3)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(bounds, biquartic, SpaceKind::bernstein, 4)->Unit(benchmark::kMillisecond);

void space_curve(benchmark::State& state, SpaceMethod method) {
  SpaceOptions options;
  options.method = method;
  for (auto _ : state) benchmark::DoNotOptimize(implicitize_space(space_cubic(), options));
}
BENCHMARK_CAPTURE(space_curve, cylinders, SpaceMethod::cylinders)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(space_curve, orthogonal, SpaceMethod::orthogonal)->Unit(benchmark::kMillisecond);

}  // namespace
