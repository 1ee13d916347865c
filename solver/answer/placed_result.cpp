#include "answer/placed_result.h"

#include "answer/coarse_drawing.h"
#include "answer/proof.h"

namespace exsect {

IntersectResult solved_in_place(const std::optional<Placement>& place, double extent, const Run& run,
                                const std::function<IntersectResult(const Run&)>& solve) {
  const auto about_origin = [place](const Run& given) {
    return place ? given.with_tolerance(place->left_of(given.tolerance(1))) : given;
  };
  const auto put_back = [place, extent](IntersectResult& result, const Run& given) {
    if (place) place->restore(result.graph);
    result.coarse = coarse_drawing(result.graph, given.tolerance(extent));
  };
  return changed(solve(about_origin(run)), run, put_back, about_origin);
}

}  // namespace exsect
