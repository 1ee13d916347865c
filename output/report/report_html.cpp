#include "output/report/report_html.h"

#include "output/drawing/intersection_svg.h"
#include "output/drawing/line_svg.h"
#include "output/drawing/surfaces_svg.h"
#include "output/report/report_data.h"
#include "output/text/chart_json.h"
#include "output/text/line_json.h"

namespace exsect::cli {
namespace {

constexpr int fibre_steps = 40;

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
  data["equations"] = Json::array({equation_data(names.second, surface, points_of(x))});
  return page_of(data, intersection_svg(result, names, origin.title));
}

std::string surfaces_report_html(const DrawnSurfaces& drawn, const ReportOrigin& origin) {
  Json tree = surfaces_json(drawn.result, drawn.names);
  add_charts(tree, drawn.result, drawn.first, drawn.second);
  Json data = report_data("intersect", origin, std::move(tree));
  data["parameters"] = Json::array();
  data["patches"] = Json::array();
  data["equations"] = equations_data(drawn);
  return page_of(data, surfaces_svg(drawn, origin.title));
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
