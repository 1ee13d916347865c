#include "trace/sheet_graph.h"

#include "trace/sheet_contraction.h"

namespace exsect {

std::optional<SheetGraph> graph_over(const PairSystem<DoubleBall>& system, const SearchRegion& region) {
  SheetContraction attempt(region);
  if (!attempt.find_centre(system) || !attempt.contracts()) return std::nullopt;
  return attempt.graph();
}

}  // namespace exsect
