#include <benchmark/benchmark.h>
#include <exsect/algebra/real_algebraic.h>
#include <exsect/geometry/patch_file.h>
#include <exsect/solver/intersect.h>
#include <exsect/solver/turning_eliminant.h>

#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "support/random_pairs.h"

namespace {

using namespace exsect;
using random_pairs::Pair;

constexpr int pairs = 20;
/// Every member several times: an intersection in doubles takes less than a millisecond.
constexpr int filtered_rounds = 50;

Pair first_example() {
  const PatchFile file = read_patches(EXSECT_EXAMPLES "/chapter9-first.json");
  return {file.patches.at(0).patch, file.patches.at(1).patch};
}

std::vector<Pair> family(Pair (*member)(random_pairs::Generator&)) {
  random_pairs::Generator generator(1);
  std::vector<Pair> result;
  for (int i = 0; i < pairs; ++i) result.push_back(member(generator));
  return result;
}

/// Complete intersections, turning points of all parameters and polylines to 1e-6; the counters are means of
/// what each step reports. Not `exact`: in doubles first.
void run(benchmark::State& state, const std::vector<Pair>& inputs, bool exact) {
  IntersectOptions options;
  options.exact = exact;
  std::size_t i = 0;
  std::map<std::string, double> total;
  for (auto _ : state) {
    const auto& [x, y] = inputs[i++ % inputs.size()];
    const IntersectResult result = intersect(x, y, options);
    if (result.status != Status::complete) throw std::logic_error("an incomplete result in a benchmark");
    for (const auto& [step, value] : result.work.steps) total[step] += value;
  }
  for (const auto& [step, value] : total) {
    state.counters[step] = benchmark::Counter(value, benchmark::Counter::kAvgIterations);
  }
}

void intersect_first_example(benchmark::State& state) { run(state, {first_example()}, false); }
void intersect_small_rationals(benchmark::State& state) {
  run(state, family(random_pairs::small_rationals), false);
}
void intersect_doubles(benchmark::State& state) { run(state, family(random_pairs::doubles), false); }
void intersect_loops(benchmark::State& state) { run(state, family(random_pairs::loop), false); }

void intersect_exactly_first_example(benchmark::State& state) { run(state, {first_example()}, true); }
void intersect_exactly_small_rationals(benchmark::State& state) {
  run(state, family(random_pairs::small_rationals), true);
}
void intersect_exactly_doubles(benchmark::State& state) { run(state, family(random_pairs::doubles), true); }
void intersect_exactly_loops(benchmark::State& state) { run(state, family(random_pairs::loop), true); }

void roots_of_turning_eliminant(benchmark::State& state) {
  const Pair pair = first_example();
  const Polynomial e = turning_eliminant(pair.x, pair.y).polynomial.value();
  for (auto _ : state) benchmark::DoNotOptimize(real_roots(e, 0, 1));
}

BENCHMARK(intersect_first_example)->Unit(benchmark::kMicrosecond);
BENCHMARK(intersect_small_rationals)->Unit(benchmark::kMicrosecond)->Iterations(filtered_rounds* pairs);
BENCHMARK(intersect_doubles)->Unit(benchmark::kMicrosecond)->Iterations(filtered_rounds* pairs);
BENCHMARK(intersect_loops)->Unit(benchmark::kMicrosecond)->Iterations(filtered_rounds* pairs);
BENCHMARK(intersect_exactly_first_example)->Unit(benchmark::kMillisecond);
BENCHMARK(intersect_exactly_small_rationals)->Unit(benchmark::kMillisecond)->Iterations(pairs);
BENCHMARK(intersect_exactly_doubles)->Unit(benchmark::kMillisecond)->Iterations(pairs);
BENCHMARK(intersect_exactly_loops)->Unit(benchmark::kMillisecond)->Iterations(pairs);
BENCHMARK(roots_of_turning_eliminant)->Unit(benchmark::kMillisecond);

}  // namespace
