#include "intersect_all.h"

#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <stdexcept>

namespace exsect {

std::vector<IntersectResult> intersect_all(std::span<const PatchPair> pairs, const IntersectOptions& options,
                                           int threads) {
  if (threads < 1) throw std::invalid_argument("intersect_all: at least one thread is needed");
  std::vector<IntersectResult> results(pairs.size());
  const auto solve = [&](std::size_t i) { results[i] = intersect(pairs[i].x, pairs[i].y, options); };
  if (threads == 1) {
    for (std::size_t i = 0; i < pairs.size(); ++i) solve(i);
    return results;
  }
  tbb::task_arena arena(std::min(threads, tbb::info::default_concurrency()));
  arena.execute([&] { tbb::parallel_for(std::size_t{0}, pairs.size(), solve); });
  return results;
}

}  // namespace exsect
