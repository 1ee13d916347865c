#include <benchmark/benchmark.h>
#include <exsect/geometry/implicit_surface.h>
#include <exsect/geometry/rational_patch.h>
#include <exsect/solver/intersect_surface.h>

#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "support/random_pairs.h"

namespace {

using namespace exsect;

constexpr int kScenes = 20;

struct Scene {
  ImplicitSurface surface;
  RationalPatch patch;
};

/// A random patch with small rational control points, of degree (2,2), or of (3,3) by those of two.
RationalPatch random_patch(random_pairs::Generator& generator, bool cubic) {
  const auto [x, y] = random_pairs::small_rationals(generator);
  if (!cubic) return x;
  std::vector<std::vector<Point>> points(4, std::vector<Point>(4));
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) {
      const Point p = RationalPatch(i < 3 && j < 3 ? x : y).point(i % 3, j % 3);
      points[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] = {p[0] + Rational(i, 8),
                                                                          p[1] + Rational(j, 8), p[2]};
    }
  return RationalPatch(points);
}

using Maker = ImplicitSurface (*)(const Point&);

ImplicitSurface a_plane(const Point& p) { return ImplicitSurface::plane(p, {1, 2, 3}); }
ImplicitSurface a_sphere(const Point& p) { return ImplicitSurface::sphere(p, Rational(3, 10)); }
ImplicitSurface a_cylinder(const Point& p) { return ImplicitSurface::cylinder(p, {1, 1, 1}, Rational(1, 4)); }
ImplicitSurface a_torus(const Point& p) {
  return ImplicitSurface::torus(p, {1, 2, 2}, Rational(2, 5), Rational(1, 7));
}

std::vector<Scene> scenes(Maker maker, bool cubic) {
  random_pairs::Generator generator(1);
  std::vector<Scene> result;
  for (int i = 0; i < kScenes; ++i) {
    RationalPatch patch = random_patch(generator, cubic);
    const Point middle = patch(Rational(1, 2), Rational(1, 2));
    result.push_back({maker(middle), std::move(patch)});
  }
  return result;
}

/// Complete intersections, turning points of both parameters and polylines to 1e-6; the counters are means.
void run(benchmark::State& state, Maker maker, bool cubic) {
  const std::vector<Scene> inputs = scenes(maker, cubic);
  std::size_t i = 0;
  std::map<std::string, double> total;
  for (auto _ : state) {
    const auto& [surface, patch] = inputs[i++ % inputs.size()];
    const IntersectResult result = intersect(surface, patch);
    if (result.status != Status::complete) throw std::logic_error("an incomplete result in a benchmark");
    for (const auto& [step, value] : result.work.steps) total[step] += value;
  }
  for (const auto& [step, value] : total)
    state.counters[step] = benchmark::Counter(value, benchmark::Counter::kAvgIterations);
}

void plane_biquadratic(benchmark::State& state) { run(state, a_plane, false); }
void sphere_biquadratic(benchmark::State& state) { run(state, a_sphere, false); }
void cylinder_biquadratic(benchmark::State& state) { run(state, a_cylinder, false); }
void torus_biquadratic(benchmark::State& state) { run(state, a_torus, false); }
void sphere_bicubic(benchmark::State& state) { run(state, a_sphere, true); }

BENCHMARK(plane_biquadratic)->Unit(benchmark::kMillisecond)->Iterations(2 * kScenes);
BENCHMARK(sphere_biquadratic)->Unit(benchmark::kMillisecond)->Iterations(2 * kScenes);
BENCHMARK(cylinder_biquadratic)->Unit(benchmark::kMillisecond)->Iterations(2 * kScenes);
BENCHMARK(torus_biquadratic)->Unit(benchmark::kMillisecond)->Iterations(kScenes);
BENCHMARK(sphere_bicubic)->Unit(benchmark::kMillisecond)->Iterations(kScenes);

}  // namespace
