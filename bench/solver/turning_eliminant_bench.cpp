#include <benchmark/benchmark.h>
#include <exsect/solver/turning_eliminant.h>

#include <random>
#include <vector>

namespace {

using namespace exsect;

template <class Coordinate>
BezierPatch patch_of(const Coordinate& coordinate) {
  ControlNet net;
  for (auto& row : net)
    for (auto& point : row)
      for (auto& c : point) c = coordinate();
  return BezierPatch(net);
}

struct Pair {
  BezierPatch x;
  BezierPatch y;
};

constexpr int pairs = 20;

/// Coordinates in [0,1] with denominators up to 16.
std::vector<Pair> small_rational_pairs() {
  std::mt19937_64 random(1);
  const auto coordinate = [&] {
    const int denominator = std::uniform_int_distribution<int>(1, 16)(random);
    return Rational(std::uniform_int_distribution<int>(0, denominator)(random), denominator);
  };
  std::vector<Pair> result;
  for (int i = 0; i < pairs; ++i) result.push_back({patch_of(coordinate), patch_of(coordinate)});
  return result;
}

/// Coordinates that are arbitrary doubles in [0,1).
std::vector<Pair> double_pairs() {
  std::mt19937_64 random(2);
  const auto coordinate = [&] { return from_double(std::uniform_real_distribution<double>(0, 1)(random)); };
  std::vector<Pair> result;
  for (int i = 0; i < pairs; ++i) result.push_back({patch_of(coordinate), patch_of(coordinate)});
  return result;
}

void run(benchmark::State& state, const std::vector<Pair>& inputs) {
  std::size_t i = 0;
  for (auto _ : state) {
    const auto& [x, y] = inputs[i++ % inputs.size()];
    benchmark::DoNotOptimize(turning_eliminant(x, y));
  }
}

void turning_eliminant_small_rationals(benchmark::State& state) { run(state, small_rational_pairs()); }
void turning_eliminant_doubles(benchmark::State& state) { run(state, double_pairs()); }

BENCHMARK(turning_eliminant_small_rationals)->Unit(benchmark::kMillisecond)->Iterations(pairs);
BENCHMARK(turning_eliminant_doubles)->Unit(benchmark::kMillisecond)->Iterations(pairs);

}  // namespace
