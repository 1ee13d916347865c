#include "filter/magnified_box.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>
#include <utility>

#include "answer/coarse_drawing.h"
#include "answer/finished_result.h"
#include "answer/graph_builder.h"
#include "answer/parameter_names.h"
#include "answer/proof.h"
#include "answer/whitened_pieces.h"

namespace exsect::filter {

namespace {

/// A quarter of the box's width. The search ends at 2^-20 of the squares.
constexpr double kMagnifiedStep = 0x1p-14;
/// Of the extent of whitened pieces, or less, which is 8 or more; and the share of the tolerance that the map
/// back leaves.
constexpr double kCoarsestMagnified = 0x1p-10;
constexpr double kMagnifiedExtent = 8;
constexpr double kMagnifiedShare = 0.9;

using Vectors = std::vector<HomogeneousPoint>;

/// The control vectors of a curve over the interval: blossoms of those over [0,1].
Vectors continued(const Vectors& curve, const RationalInterval& to) {
  Vectors result;
  for (std::size_t k = 0; k < curve.size(); ++k) {
    Vectors b = curve;
    for (std::size_t level = 1; level < curve.size(); ++level) {
      const Rational& t = level <= k ? to.upper : to.lower;
      for (std::size_t i = 0; i + level < curve.size(); ++i)
        for (std::size_t c = 0; c < 4; ++c) b[i][c] = (1 - t) * b[i][c] + t * b[i + 1][c];
    }
    result.push_back(b[0]);
  }
  return result;
}

std::vector<Vectors> transposed(const std::vector<Vectors>& net) {
  std::vector<Vectors> result(net[0].size());
  for (const Vectors& row : net)
    for (std::size_t j = 0; j < row.size(); ++j) result[j].push_back(row[j]);
  return result;
}

/// The patch's polynomials over a rectangle that may reach beyond the unit square.
RationalPatch piece(const RationalPatch& of, const RationalInterval& u, const RationalInterval& v) {
  if (u.lower >= 0 && u.upper <= 1 && v.lower >= 0 && v.upper <= 1)
    return of.restricted_to(u.lower, u.upper, v.lower, v.upper);
  std::vector<Vectors> net;
  for (int i = 0; i <= of.degree_u(); ++i) {
    Vectors row;
    for (int j = 0; j <= of.degree_v(); ++j) row.push_back(of.homogeneous(i, j));
    net.push_back(continued(row, v));
  }
  net = transposed(net);
  for (Vectors& row : net) row = continued(row, u);
  return RationalPatch::from_homogeneous(transposed(net));
}

void append(GraphBuilder& graph, IntersectionGraph part) {
  const int first = static_cast<int>(graph.nodes().size());
  for (Node& node : part.nodes) graph.add_node(std::move(node));
  for (Arc& arc : part.arcs) {
    arc.from += first;
    arc.to += first;
    graph.add_arc(std::move(arc));
  }
  for (const int id : part.isolated_points) graph.add_isolated(first + id);
}

IntersectResult joined_parts(std::vector<IntersectResult> parts, double extent, const Run& run) {
  GraphBuilder graph;
  std::vector<Incomplete> incomplete;
  for (IntersectResult& part : parts) {
    append(graph, std::move(part.graph));
    std::ranges::move(part.incomplete, std::back_inserter(incomplete));
  }
  IntersectResult result = finished(std::move(graph), {run.turning()}, std::move(incomplete));
  result.coarse = coarse_drawing(result.graph, run.tolerance(extent));
  return result;
}

}  // namespace

ParameterBox box_to_magnify(const Vec4& place) {
  ParameterBox box;
  for (std::size_t j = 0; j < 4; ++j) {
    const double middle = kMagnifiedStep * std::round((place[j] + 0.5) / kMagnifiedStep);
    box[j] = {from_double(std::max(0.0, middle - 2 * kMagnifiedStep)),
              from_double(std::min(1.0, middle + 2 * kMagnifiedStep))};
  }
  return box;
}

ParameterBox widened(const ParameterBox& box) {
  ParameterBox wide;
  for (std::size_t j = 0; j < 4; ++j) {
    const Rational middle = box[j].midpoint(), half = 16 * box[j].width();
    wide[j] = {std::max(Rational(0), Rational(middle - half)),
               std::min(Rational(1), Rational(middle + half))};
  }
  return wide;
}

std::optional<IntersectResult> intersect_over(
    const RationalPatch& x, const RationalPatch& y, const ParameterBox& where, double extent, const Run& run,
    const SolvePieces& solve, const std::function<bool(const IntersectionGraph& of_pieces)>& takes) {
  const RationalPatch first = piece(x, where[0], where[1]), second = piece(y, where[2], where[3]);
  const auto whitening = Whitening::of(first, second);
  if (!whitening) return std::nullopt;
  const OtherRun of_pieces = [extent, stretch = whitening->stretch()](const Run& given) {
    const double tolerance = kMagnifiedShare * given.drawn_tolerance(extent) / (stretch * kMagnifiedExtent);
    return given.with_tolerance(tolerance < kCoarsestMagnified ? tolerance : kCoarsestMagnified);
  };
  IntersectResult inside = solve((*whitening)(first), (*whitening)(second), of_pieces(run));
  if (inside.status != Status::complete || !takes(inside.graph)) return std::nullopt;
  const ResultChange change = [map = *whitening, where](IntersectResult& result, const Run&) {
    map.restore(result.graph);
    place_parameters(result, where);
  };
  return changed(std::move(inside), run, change, of_pieces);
}

std::optional<MagnifiedBox> magnified(const RationalPatch& x, const RationalPatch& y,
                                      const ParameterBox& where, double extent, const Run& run,
                                      const SolvePieces& solve) {
  bool meets_side = false;
  const auto stays_inside = [&meets_side](const IntersectionGraph& graph) {  // (14.95)
    meets_side = std::ranges::any_of(graph.nodes, [](const Node& node) { return !node.on.empty(); });
    return graph.overlaps.empty() && !meets_side;
  };
  auto inside = intersect_over(x, y, where, extent, run, solve, stays_inside);
  if (meets_side) return MagnifiedBox{where, {}, true};
  if (!inside) return std::nullopt;
  return MagnifiedBox{where, *std::move(inside)};
}

IntersectResult joined(IntersectResult outside, std::vector<MagnifiedBox> boxes, double extent,
                       const Run& run) {
  std::vector<IntersectResult> parts = {std::move(outside)};
  for (MagnifiedBox& box : boxes) parts.push_back(std::move(box.inside));
  std::vector<std::shared_ptr<const Proof>> proofs;
  for (const IntersectResult& part : parts) proofs.push_back(part.proof);
  IntersectResult result = joined_parts(std::move(parts), extent, run);
  if (std::ranges::any_of(proofs, [](const auto& proof) { return !proof || !proof->draw; })) return result;
  Draw draw = [proofs, extent](const Run& again) -> std::optional<IntersectResult> {
    std::vector<IntersectResult> drawn;
    for (const auto& proof : proofs) {
      auto part = proof->draw(again);
      if (!part) return std::nullopt;
      drawn.push_back(*std::move(part));
    }
    return joined_parts(std::move(drawn), extent, again);
  };
  result.proof = std::make_shared<const Proof>(Proof{std::move(draw), {}, {}});
  return result;
}

}  // namespace exsect::filter
