#include "output/report/report_html.h"

#include "output/drawing/intersection_svg.h"
#include "output/drawing/line_svg.h"
#include "output/drawing/sampled_equation.h"
#include "output/report/report_data.h"
#include "output/text/chart_json.h"
#include "output/text/implicit_json.h"
#include "output/text/line_json.h"

namespace exsect::cli {
namespace {

constexpr int fibre_steps = 40;

constexpr int sampled_cells = 48;

/// Points of the patch, in doubles.
SpacePoints points_of(const RationalPatch& x) {
  constexpr int n = 8;
  SpacePoints points;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j) {
      const Point p = x(Rational(i, n), Rational(j, n));
      points.push_back({to_double(p[0]), to_double(p[1]), to_double(p[2])});
    }
  return points;
}

/// The surface's terms, and, where it can be sampled, a mesh beside the patch.
Json equation_data(const std::string& name, const ImplicitSurface& surface, const RationalPatch& x) {
  Json data = {{"name", name},
               {"kind", exsect::name(surface.kind())},
               {"terms", equation_json(name, terms_of(surface.equation()))["terms"]}};
  const std::optional<SceneMesh> mesh = sampled(surface, name, points_of(x), sampled_cells);
  if (!mesh) return data;
  Json points = Json::array();
  for (const PolylineVertex& vertex : mesh->vertices) points.push_back(vertex.point);
  data["mesh"] = {{"points", std::move(points)}, {"faces", mesh->faces}};
  return data;
}

/// The lines u = 0, 1/40, ..., 1 of x against y.
Json fibres(const BezierPatch& x, const BezierPatch& y) {
  Json list = Json::array();
  for (int i = 0; i <= fibre_steps; ++i)
    list.push_back(fibre_data(intersect_line(x, y, {Parameter::u, Rational(i) / fibre_steps}), x));
  return list;
}

}  // namespace

std::string report_html(const IntersectResult& result, const RationalPatch& x, const RationalPatch& y,
                        const PatchNames& names, const ReportOrigin& origin) {
  Json data = report_data("intersect", origin, intersection_json(result, names));
  data["parameters"] = pair_names;
  data["patches"] = {patch_data(names.first, x), patch_data(names.second, y)};
  const std::optional<BezierPatch> first = x.biquadratic(), second = y.biquadratic();
  if (first && second) data["fibres"] = fibres(*first, *second);
  return page_of(data, intersection_svg(result, names, origin.title));
}

std::string equation_report_html(const IntersectResult& result, const RationalPatch& x,
                                 const ImplicitSurface& surface, const PatchNames& names,
                                 const ReportOrigin& origin) {
  Json tree = intersection_json(result, names);
  add_charts(tree, result.graph, x, surface);
  Json data = report_data("intersect", origin, std::move(tree));
  data["parameters"] = {"u", "v"};
  data["patches"] = Json::array({patch_data(names.first, x)});
  data["equation"] = equation_data(names.second, surface, x);
  return page_of(data, intersection_svg(result, names, origin.title));
}

std::string self_report_html(const IntersectResult& result, const RationalPatch& x, const std::string& name,
                             const ReportOrigin& origin) {
  Json data = report_data("self", origin, self_json(result, name));
  data["parameters"] = self_names;
  data["patches"] = Json::array({patch_data(name, x)});
  return page_of(data, intersection_svg(result, {name, name, self_names}, origin.title));
}

std::string line_report_html(const LineIntersection& line, const RationalPatch& x, const RationalPatch& y,
                             const PatchNames& names, const ReportOrigin& origin) {
  Json data = report_data("line", origin, line_json(line, x));
  data["parameters"] = pair_names;
  data["patches"] = {patch_data(names.first, x), patch_data(names.second, y)};
  data["fibres"] = Json::array({fibre_data(line, x)});
  return page_of(data, line_svg(line, x, origin.title));
}

}  // namespace exsect::cli
