#include <benchmark/benchmark.h>
#include <exsect/solver/intersect_all.h>

#include <utility>
#include <vector>

#include "support/random_pairs.h"

namespace {

using namespace exsect;

constexpr int pairs = 1000;

std::vector<PatchPair> generic_pairs() {
  random_pairs::Generator generator(1);
  std::vector<PatchPair> result;
  for (int i = 0; i < pairs; ++i) {
    random_pairs::Pair pair = random_pairs::doubles(generator);
    result.push_back({std::move(pair.x), std::move(pair.y)});
  }
  return result;
}

/// A thousand random pairs in doubles on so many threads: elapsed time without that of destroying the
/// results.
void intersect_all_doubles(benchmark::State& state) {
  static const std::vector<PatchPair> list = generic_pairs();
  for (auto _ : state) {
    std::vector<IntersectResult> results = intersect_all(list, {}, static_cast<int>(state.range(0)));
    state.PauseTiming();
    results.clear();
    state.ResumeTiming();
  }
  state.SetItemsProcessed(state.iterations() * pairs);
}

BENCHMARK(intersect_all_doubles)->Arg(1)->Arg(2)->UseRealTime()->Unit(benchmark::kMillisecond);

}  // namespace
