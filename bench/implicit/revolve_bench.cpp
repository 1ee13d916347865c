// Surfaces of revolution: elimination and product of a bi-quartic profile, and the certified distance.
#include <benchmark/benchmark.h>
#include <exsect/geometry/curve_file.h>
#include <exsect/geometry/patch_file.h>
#include <exsect/implicit/revolution_patch.h>
#include <exsect/implicit/revolve.h>
#include <exsect/solver/curve_arcs.h>

#include <random>

namespace {

using namespace exsect;

BezierCurve profile() { return read_curve(EXSECT_EXAMPLES "/profile.json").curve; }

RevolveOptions cubic() {
  RevolveOptions options;
  options.method = RevolutionMethod::product;
  options.degree = 3;
  return options;
}

/// Coefficients with denominators up to 16.
BivariatePolynomial biquartic() {
  std::mt19937_64 random(1);
  std::uniform_int_distribution<int> numerator(-50, 50), denominator(1, 16);
  std::vector<Polynomial> rows;
  for (int i = 0; i <= 4; ++i) {
    std::vector<Rational> row;
    for (int j = 0; j <= 4; ++j) row.emplace_back(numerator(random), denominator(random));
    rows.emplace_back(row);
  }
  return BivariatePolynomial(rows);
}

void elimination_of_a_biquartic(benchmark::State& state) {
  const BivariatePolynomial f = biquartic();
  for (auto _ : state) benchmark::DoNotOptimize(surface_of_revolution(revolved_by_elimination(f)));
}
void product_of_a_biquartic(benchmark::State& state) {
  const BivariatePolynomial f = biquartic();
  for (auto _ : state) benchmark::DoNotOptimize(surface_of_revolution(revolved_by_product(f)));
}
void certified_distances_of_the_cubic_profile(benchmark::State& state) {
  const BezierCurve curve = profile();
  const PlanarFunction f = revolve(curve, cubic()).profile;
  for (auto _ : state) benchmark::DoNotOptimize(distance_bounds(f, curve));
}
void revolution_of_the_cubic_profile(benchmark::State& state) {
  const BezierCurve curve = profile();
  for (auto _ : state) benchmark::DoNotOptimize(revolve(curve, cubic()));
}
void revolution_against_a_patch(benchmark::State& state) {
  const BivariatePolynomial f = revolve(profile(), cubic()).profile.polynomial();
  const BezierPatch patch = read_patches(EXSECT_EXAMPLES "/chapter9-first.json").patches[0].patch;
  for (auto _ : state) benchmark::DoNotOptimize(intersect_revolution(f, patch));
}

BENCHMARK(elimination_of_a_biquartic)->Unit(benchmark::kMillisecond);
BENCHMARK(product_of_a_biquartic)->Unit(benchmark::kMillisecond);
BENCHMARK(certified_distances_of_the_cubic_profile)->Unit(benchmark::kMillisecond);
BENCHMARK(revolution_of_the_cubic_profile)->Unit(benchmark::kMillisecond);
BENCHMARK(revolution_against_a_patch)->Unit(benchmark::kMillisecond);

}  // namespace
