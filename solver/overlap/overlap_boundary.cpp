#include "overlap/overlap_boundary.h"

#include <algorithm>
#include <optional>
#include <string>

#include "answer/left_open.h"
#include "answer/parameter_box.h"
#include "side/boundary_lines.h"
#include "trace/enclose.h"

namespace exsect {

namespace {

/// A small region around a point, 2^-bits wide on both sides of it.
SearchRegion region_around(const CertifiedPoint& point, int bits) {
  SearchRegion region{};
  for (std::size_t j = 0; j < 4; ++j) {
    const double middle = to_double(point.box()[j].midpoint());
    region.lower[j] = middle - std::ldexp(1, -bits);
    region.upper[j] = middle + std::ldexp(1, -bits);
  }
  return region;
}

std::optional<CommonSheet> sheet_through(const CommonSheets& sheets, const CertifiedPoint& point) {
  for (const int bits : {6, 9, 13, 18})
    if (auto sheet = sheets.certify(region_around(point, bits))) return sheet;
  return std::nullopt;
}

constexpr const char* kPole = "a side of each patch is the same point of space";
constexpr const char* kWorkCap = "the work cap was reached while boundary lines were compared";
constexpr const char* kAcross = "a boundary line lies on the other patch here, across the common surface";

/// On a sheet w, an arc on one side only has solutions on the inner side of it. On a side of both squares w
/// takes the one to the other; the inner sides correspond or not.
BoundaryArcKind kind_of(const CertifiedPoint& inside, const CommonSheets& sheets) {
  const auto sheet = sheet_through(sheets, inside);
  if (!sheet) return BoundaryArcKind::unknown;
  const std::vector<Side>& sides = inside.sides();
  if (sides.size() == 1) return BoundaryArcKind::rim;
  const Side& first = sides.front();
  const Side& second = sides.back();
  if (sides.size() != 2 || index(first.parameter) > 1 || index(second.parameter) < 2)
    return BoundaryArcKind::unknown;
  const int sign = sheet->derivative[index(second.parameter) - 2][index(first.parameter)].certain_sign();
  if (sign == 0) return BoundaryArcKind::unknown;
  const bool same_end = first.value == second.value;
  return (sign > 0) == same_end ? BoundaryArcKind::rim : BoundaryArcKind::edge;
}

/// The tangent planes differ at the point: it is on no common sheet.
bool crosses(const CertifiedPoint& inside, const PairSystem<ArbBall<256>>& system) {
  const auto tangent =
      Expansion<ArbBall<256>>(system, enclose<ArbBall<256>>(inside, power_of_two(-200))).tangent();
  return std::any_of(tangent.begin(), tangent.end(), [](const auto& t) { return t.certain_sign() != 0; });
}

void report(OverlapBoundary& result, const ParameterBox& where, const std::string& why) {
  result.incomplete.push_back({where, why});
}

}  // namespace

OverlapBoundary overlap_boundary(const BezierPatch& x, const BezierPatch& y, const CommonSheets& sheets,
                                 const ModelScale& scale, double tolerance, const StopRequest& stop) {
  const PairSystem<ArbBall<256>> system(x, y, scale.origin, scale.frame.exponent);
  BoundaryLines lines = boundary_lines(x, y, scale, tolerance, stop);
  OverlapBoundary result;
  result.incomplete = std::move(lines.incomplete);
  for (const CommonPole& pole : lines.poles) {
    ParameterBox where = whole_domain();
    for (const Side& side : {pole.of_x, pole.of_y}) where[index(side.parameter)] = {side.value, side.value};
    report(result, where, kPole);
  }
  for (const CertifiedPoint& point : lines.points) result.points.push_back({point, BoundaryPointKind::other});
  for (SideArc& arc : lines.arcs) {
    if (is_stopped(stop)) {
      result.incomplete.push_back(out_of_time(arc.inside.box(), kWorkCap));
      return result;
    }
    for (const std::size_t end : {arc.from, arc.to}) result.points[end].kind = BoundaryPointKind::on_arc;
    BoundaryArcKind kind = kind_of(arc.inside, sheets);
    if (kind == BoundaryArcKind::unknown && crosses(arc.inside, system)) kind = BoundaryArcKind::branch;
    if (kind == BoundaryArcKind::unknown) report(result, arc.inside.box(), kAcross);
    result.arcs.push_back({arc.from, arc.to, arc.inside, std::move(arc.polyline), arc.error_bound, kind});
  }
  for (BoundaryPoint& point : result.points)
    if (point.kind == BoundaryPointKind::other && !is_stopped(stop) && sheet_through(sheets, point.at))
      point.kind = BoundaryPointKind::touch;
  return result;
}

}  // namespace exsect
