#include "certificate/line.h"

// The certificate of a parameter line against the other patch.
#include <exsect/geometry/number.h>

#include <algorithm>
#include <cmath>

#include "certificate/claims.h"
#include "certificate/cover.h"

namespace exsect::cli {
namespace {

/// Throws NoCertificate for what a certificate cannot say.
void refuse_points(const LinePoints& solution) {
  if (solution.incomplete) throw NoCertificate("the result is incomplete");
  if (!solution.on_patch.empty()) throw NoCertificate("a part of the line on the other patch");
  for (const CertifiedPoint& point : solution.points)
    if (point.multiplicity() != 1) throw NoCertificate("a point where the line touches the other patch");
}

/// The point in doubles, exact where it is on sides.
Parameters near_point(const NearPair& pair, const CertifiedPoint& point, std::size_t fixed) {
  Parameters w;
  for (const Parameter p : all_parameters) w[index(p)] = to_double(point.box()[index(p)].midpoint());
  w = on_curve(pair.power, w, fixed);
  for (const Side& side : point.sides()) w[index(side.parameter)] = side.value;
  return w;
}

}  // namespace

std::string certificate_text(const RationalPatch& x, const RationalPatch& y, const PatchNames& names,
                             const LineIntersection& line) {
  refuse_points(line.solution);
  const Patches patches = {certified_form(x), certified_form(y)};
  const NearPair pair = near_pair(patches);
  const std::size_t fixed = index(line.query.fixed);
  const std::string value = to_string(line.query.value);
  std::vector<Tube> tubes;
  Json points = Json::array();
  for (const CertifiedPoint& point : line.solution.points) {
    const Parameters w = near_point(pair, point, fixed);
    tubes.push_back(tube_at({pair.power}, w, fixed));
    const double near = distance(pair.power, tubes.back(), w);
    const double radius = std::exp2(std::ceil(std::log2(std::max(4 * near, 0x1p-44))));
    Json at = exact(w);
    at[fixed] = value;
    points.push_back(sealed(in_list("points", points.size()),
                            {{"tube", points.size()}, {"at", at}, {"radius", exact_number(radius)}}));
  }
  Json document = {{"exsect", "certificate/1"}, {"command", "line"}};
  document["fixed"] = sealed("$.fixed", {{"parameter", letter(fixed)}, {"value", value}});
  document["first"] = patch_claim("$.first", names.first, patches[0]);
  document["second"] = patch_claim("$.second", names.second, patches[1]);
  document["tubes"] = tube_claims(pair, tubes);
  document["points"] = points;
  const std::vector<std::string> cells = cover(pair, {tubes}, line.query);
  document["cover"] = cover_claims(cells);
  const Json claims = {0, 0, tubes.size(), points.size(), 0, cells.size(), 0};
  document["summary"] = sealed("$.summary", {{"claims", claims}});
  return confirmed(claims_text(document));
}

}  // namespace exsect::cli
