#include "output/text/ray_output.h"

#include <exsect/geometry/number.h>
#include <exsect/geometry/point.h>
#include <fmt/format.h>

#include <algorithm>

#include "output/text/proved_decimal.h"
#include "output/text/terminal_text.h"

namespace exsect::cli {
namespace {

/// The numbers of t and of the parameters that are shown: exact where they are rational.
RationalInterval shown_value(const RealAlgebraic& t) {
  if (t.is_rational()) return {t.rational(), t.rational()};
  return t.refined_to(shown_width()).interval();
}

/// Coordinate k of the points of the ray with t in the interval.
RationalInterval coordinate_on(const ShownRay& ray, std::size_t k, const RationalInterval& t) {
  const Rational a = ray.origin[k] + t.lower * ray.direction[k];
  const Rational b = ray.origin[k] + t.upper * ray.direction[k];
  return {std::min(a, b), std::max(a, b)};
}

Json vector_json(const Point& p) {
  return Json::array({json_number(p[0]), json_number(p[1]), json_number(p[2])});
}

Json value_json(const RealAlgebraic& t) {
  return {{"box", json_interval(shown_value(t))}, {"approx", t.to_double()}};
}

Json hit_json(const ShownRay& ray, const HitOnRay& at) {
  const RationalInterval t = shown_value(at.hit.t);
  Json json = {{"surface", at.surface},
               {"place", at.place},
               {"t", value_json(at.hit.t)},
               {"multiplicity", at.hit.multiplicity},
               {"contact", name(at.hit.contact)}};
  if (at.hit.parameters) {
    const TriangularPoint p = at.hit.parameters->refined_to(shown_width());
    json["parameters"] = {{"u", json_interval(p.r_interval())}, {"v", json_interval(p.s().interval())}};
  }
  json["point"] = Json::array();
  for (std::size_t k = 0; k < 3; ++k) json["point"].push_back(to_double(coordinate_on(ray, k, t).midpoint()));
  return json;
}

std::string shown_decimal(const RationalInterval& value, bool verbose) {
  return proved_decimal(value, verbose ? -15 : -6);
}

std::string ray_headline(const ShownRay& ray, const std::vector<HitOnRay>& hits) {
  std::size_t parts = 0;
  for (const SurfaceOnRay& on : ray.surfaces) parts += on.common.overlaps.size();
  std::string text =
      fmt::format("ray: {}, proved: {}", ray.is_complete() ? "complete" : "incomplete",
                  counted(hits.empty() ? 0 : static_cast<std::size_t>(hits.back().place), "point"));
  if (parts > 0) text += ", " + counted(parts, "part") + " of the ray on a surface";
  return text + "\n";
}

std::string hit_table(const ShownRay& ray, const std::vector<HitOnRay>& hits, bool verbose) {
  std::vector<std::vector<std::string>> rows;
  for (const HitOnRay& at : hits) {
    const RationalInterval t = shown_value(at.hit.t);
    rows.push_back({std::to_string(at.place), shown_decimal(t, verbose)});
    for (std::size_t k = 0; k < 3; ++k)
      rows.back().push_back(shown_decimal(coordinate_on(ray, k, t), verbose));
    rows.back().push_back(printable(at.surface));
    std::string u = "-", v = "-";
    if (at.hit.parameters) {
      const TriangularPoint p = at.hit.parameters->refined_to(shown_width());
      u = shown_decimal(p.r_interval(), verbose);
      v = shown_decimal(p.s().interval(), verbose);
    }
    rows.back().insert(rows.back().end(), {u, v, std::to_string(at.hit.multiplicity), name(at.hit.contact)});
  }
  const std::string text =
      table({"place", "t", "x", "y", "z", "surface", "u", "v", "multiplicity", "contact"}, rows);
  return text.empty() ? "" : "\n" + text;
}

}  // namespace

bool ShownRay::is_complete() const {
  return std::none_of(surfaces.begin(), surfaces.end(),
                      [](const SurfaceOnRay& on) { return on.common.incomplete.has_value(); });
}

std::vector<HitOnRay> hits_in_order(const ShownRay& ray) {
  std::vector<HitOnRay> hits;
  for (const SurfaceOnRay& on : ray.surfaces)
    for (const RayHit& hit : on.common.hits) hits.push_back({on.surface, hit, 1});
  std::stable_sort(hits.begin(), hits.end(),
                   [](const HitOnRay& a, const HitOnRay& b) { return a.hit.t < b.hit.t; });
  for (std::size_t i = 1; i < hits.size(); ++i)
    hits[i].place = hits[i - 1].place + (hits[i].hit.t == hits[i - 1].hit.t ? 0 : 1);
  return hits;
}

Json ray_json(const ShownRay& ray) {
  Json surfaces = Json::array(), hits = Json::array(), overlaps = Json::array(), incomplete = Json::array();
  for (const HitOnRay& at : hits_in_order(ray)) hits.push_back(hit_json(ray, at));
  for (const SurfaceOnRay& on : ray.surfaces) {
    surfaces.push_back(on.surface);
    for (const RayOverlap& overlap : on.common.overlaps)
      overlaps.push_back({{"surface", on.surface},
                          {"from", value_json(overlap.from)},
                          {"to", overlap.to ? value_json(*overlap.to) : Json()}});
    if (on.common.incomplete) incomplete.push_back({{"surface", on.surface}, {"why", *on.common.incomplete}});
  }
  return {{"exsect", "ray/1"},
          {"status", ray.is_complete() ? "complete" : "incomplete"},
          {"origin", vector_json(ray.origin)},
          {"direction", vector_json(ray.direction)},
          {"surfaces", std::move(surfaces)},
          {"hits", std::move(hits)},
          {"overlaps", std::move(overlaps)},
          {"incomplete", std::move(incomplete)}};
}

std::string ray_summary(const ShownRay& ray, bool verbose) {
  const std::vector<HitOnRay> hits = hits_in_order(ray);
  std::string text = ray_headline(ray, hits) + hit_table(ray, hits, verbose);
  for (const SurfaceOnRay& on : ray.surfaces)
    for (const RayOverlap& overlap : on.common.overlaps)
      text += fmt::format("\n  on {} for t {}\n", printable(on.surface),
                          overlap.to
                              ? fmt::format("in [{}, {}]", shown_decimal(shown_value(overlap.from), verbose),
                                            shown_decimal(shown_value(*overlap.to), verbose))
                              : "from " + shown_decimal(shown_value(overlap.from), verbose) + " on");
  for (const SurfaceOnRay& on : ray.surfaces)
    if (on.common.incomplete)
      text += fmt::format("\nNot decided: {}: {}\n", printable(on.surface), *on.common.incomplete);
  return text;
}

}  // namespace exsect::cli
