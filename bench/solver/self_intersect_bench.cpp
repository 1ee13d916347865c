#include <benchmark/benchmark.h>
#include <exsect/geometry/patch_file.h>
#include <exsect/solver/self_intersect.h>

#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "support/random_pairs.h"

namespace {

using namespace exsect;

BezierPatch example(const char* file, std::size_t i) {
  return read_patches(std::string(EXSECT_EXAMPLES) + "/" + file).patches.at(i).patch;
}

BezierPatch integers(random_pairs::Generator& generator, long largest) {
  ControlNet net;
  for (auto& row : net)
    for (Point& p : row)
      for (Rational& c : p) c = random_pairs::integer(generator, -largest, largest);
  return BezierPatch(net);
}

/// The counters are means of what each step reports.
void run(benchmark::State& state, const std::vector<BezierPatch>& inputs) {
  std::size_t i = 0;
  std::map<std::string, double> total;
  for (auto _ : state) {
    const IntersectResult result = self_intersect(inputs[i++ % inputs.size()]);
    if (result.status != Status::complete) throw std::logic_error("an incomplete result in a benchmark");
    for (const auto& [step, value] : result.work.steps) total[step] += value;
  }
  for (const auto& [step, value] : total) {
    state.counters[step] = benchmark::Counter(value, benchmark::Counter::kAvgIterations);
  }
}

void self_intersect_injective(benchmark::State& state) {
  run(state, {example("chapter9-first.json", 0), example("chapter9-first.json", 1)});
}
void self_intersect_second_x(benchmark::State& state) { run(state, {example("chapter9-second.json", 0)}); }
void self_intersect_second_y(benchmark::State& state) { run(state, {example("chapter9-second.json", 1)}); }

/// Control points anywhere in a cube: one to five curves.
void self_intersect_scattered(benchmark::State& state) {
  random_pairs::Generator generator(1);
  std::vector<BezierPatch> inputs;
  for (int i = 0; i < 20; ++i) inputs.push_back(integers(generator, 1000));
  run(state, inputs);
}

/// Nine times as much of such surfaces.
void self_intersect_extended(benchmark::State& state) {
  random_pairs::Generator generator(1);
  std::vector<BezierPatch> inputs;
  for (int i = 0; i < 10; ++i) inputs.push_back(integers(generator, 50).restricted_to(-1, 2, -1, 2));
  run(state, inputs);
}

BENCHMARK(self_intersect_injective)->Unit(benchmark::kMillisecond);
BENCHMARK(self_intersect_second_x)->Unit(benchmark::kMillisecond);
BENCHMARK(self_intersect_second_y)->Unit(benchmark::kMillisecond);
BENCHMARK(self_intersect_scattered)->Unit(benchmark::kMillisecond);
BENCHMARK(self_intersect_extended)->Unit(benchmark::kMillisecond);

}  // namespace
