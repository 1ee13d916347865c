// One parameter line query, in doubles with proof and exact: small rationals and control points that are
// doubles.
#include <benchmark/benchmark.h>
#include <exsect/solver/line_patch.h>

#include <random>
#include <vector>

namespace {

using namespace exsect;

struct Pair {
  BezierPatch x;
  BezierPatch y;
};

/// Control points near a grid over the unit square; `coordinate` makes a number in [-1/2,1/2].
template <class Coordinate>
BezierPatch grid_patch(Coordinate coordinate) {
  ControlNet net;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      net[i][j] = {Rational(static_cast<int>(i), 2) + coordinate() / 2,
                   Rational(static_cast<int>(j), 2) + coordinate() / 2, coordinate()};
  return BezierPatch(net);
}

std::vector<Pair> small_rationals() {
  std::mt19937 random(1);
  const auto coordinate = [&] {
    const int denominator = std::uniform_int_distribution<int>(1, 16)(random);
    return Rational(std::uniform_int_distribution<int>(-denominator, denominator)(random), 2 * denominator);
  };
  std::vector<Pair> pairs;
  for (int i = 0; i < 20; ++i) {
    BezierPatch x = grid_patch(coordinate);
    pairs.push_back({x, grid_patch(coordinate)});
  }
  return pairs;
}

std::vector<Pair> doubles() {
  std::mt19937_64 random(2);
  const auto coordinate = [&] {
    return from_double(std::uniform_real_distribution<double>(-0.5, 0.5)(random));
  };
  std::vector<Pair> pairs;
  for (int i = 0; i < 20; ++i) {
    BezierPatch x = grid_patch(coordinate);
    pairs.push_back({x, grid_patch(coordinate)});
  }
  return pairs;
}

/// Lines u = k/16, one pair after the other.
template <class Query>
void run(benchmark::State& state, const std::vector<Pair>& pairs, Query query) {
  std::size_t i = 0;
  for (auto _ : state) {
    const Pair& pair = pairs[i % pairs.size()];
    benchmark::DoNotOptimize(
        query(pair.x, pair.y, LineQuery{Parameter::u, Rational(static_cast<int>(i % 15) + 1, 16)}));
    ++i;
  }
}

void filtered_small_rationals(benchmark::State& state) {
  run(state, small_rationals(), line_points_filtered);
}
void filtered_doubles(benchmark::State& state) { run(state, doubles(), line_points_filtered); }
void line_points_small_rationals(benchmark::State& state) { run(state, small_rationals(), line_points); }
void line_points_doubles(benchmark::State& state) { run(state, doubles(), line_points); }
void intersect_line_small_rationals(benchmark::State& state) {
  run(state, small_rationals(), [](const BezierPatch& x, const BezierPatch& y, const LineQuery& query) {
    return intersect_line(x, y, query);
  });
}

BENCHMARK(filtered_small_rationals)->Unit(benchmark::kMicrosecond);
BENCHMARK(filtered_doubles)->Unit(benchmark::kMicrosecond);
BENCHMARK(line_points_small_rationals)->Unit(benchmark::kMicrosecond);
BENCHMARK(line_points_doubles)->Unit(benchmark::kMicrosecond);
BENCHMARK(intersect_line_small_rationals)->Unit(benchmark::kMicrosecond);

}  // namespace
