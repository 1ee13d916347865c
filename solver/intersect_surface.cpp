#include "intersect_surface.h"

#include <exsect/algebra/nearest_rounding.h>
#include <exsect/geometry/bounding_box.h>

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "answer/coarse_drawing.h"
#include "answer/finished_result.h"
#include "answer/graph_builder.h"
#include "answer/placed_result.h"
#include "answer/proof.h"
#include "answer/run.h"
#include "curve/outline_graph.h"
#include "curve/surface_curve.h"
#include "curve/surface_graph.h"
#include "curve/turning_in_v.h"
#include "filter/section_intersection.h"

namespace exsect {
namespace {

/// The curve of a surface and a patch.
struct KnownCurve {
  SurfaceCurve curve;
  RationalPatch patch;
  std::vector<Parameter> turning;
};

IntersectResult drawn(const KnownCurve& known, const Run& run) {
  const DrawnPatch patch(known.patch);
  const double tolerance = run.drawn_tolerance(patch.extent());
  GraphBuilder builder;
  if (known.curve.contains_patch)
    builder = outline_graph(known.curve, outline(known.curve.region), patch, tolerance);
  else
    builder = surface_graph(known.curve, patch, tolerance);
  IntersectResult result = finished(std::move(builder), {known.turning}, {});
  result.coarse = coarse_drawing(result.graph, run.tolerance(patch.extent()));
  return result;
}

IntersectResult solved_exactly(const ImplicitSurface& surface, const RationalPatch& x, const Run& run) {
  KnownCurve known{{}, x.reduced(), {Parameter::u}};
  run.timed("curve", [&] { known.curve = surface_curve(surface, x); });
  if (std::ranges::find(run.turning(), Parameter::v) != run.turning().end()) {
    known.turning.push_back(Parameter::v);
    run.timed("turning", [&] { known.curve.graph = with_turning_in_v(std::move(known.curve.graph)); });
  }
  const auto kept = std::make_shared<const KnownCurve>(std::move(known));
  std::optional<IntersectResult> result;
  run.timed("drawing", [&] {
    result = first_drawn([kept](const Run& given) { return std::optional(drawn(*kept, given)); }, run);
  });
  return *std::move(result);
}

/// In doubles where they decide.
IntersectResult solved(const ImplicitSurface& surface, const RationalPatch& x, const Run& run) {
  if (!run.exact())
    if (auto result = section_intersection(surface, x, run)) return *std::move(result);
  return solved_exactly(surface, x, run);
}

}  // namespace

IntersectResult intersect(const ImplicitSurface& surface, const RationalPatch& x,
                          const IntersectOptions& options) {
  return in_nearest_rounding([&] {
    const Run run(options);
    const BoundingBox box = bounding_box(x);
    const std::array<Point, 2> corners = {box.lower, box.upper};
    const auto place = Placement::of(corners);
    IntersectResult result = run.finished(answered(run, [&] {
      return !place ? solved(surface, x, run)
                    : solved_in_place(place, to_double(model_extent(corners)), run, [&](const Run& about) {
                        return solved(place->placed(surface), place->placed(x), about);
                      });
    }));
    return answer_to(options, std::move(result),
                     [surface, x](const IntersectOptions& other) { return intersect(surface, x, other); });
  });
}

}  // namespace exsect
