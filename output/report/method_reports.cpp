#include "output/report/method_reports.h"

#include <exsect/geometry/number.h>

#include "output/drawing/comparison_svg.h"
#include "output/drawing/drawn_arcs.h"
#include "output/drawing/revolution_curves.h"
#include "output/drawing/revolution_svg.h"
#include "output/report/report_data.h"
#include "output/text/comparison_json.h"

namespace exsect::cli {
namespace {

/// Points of the curve for t = 0, 1/96, ..., 1.
Json curve_data(const BezierCurve& curve) {
  constexpr int chords = 96;
  Json points = Json::array();
  for (int i = 0; i <= chords; ++i) {
    Json point = Json::array();
    for (const Rational& coordinate : curve(Rational(i) / chords)) point.push_back(to_double(coordinate));
    points.push_back(std::move(point));
  }
  return points;
}

Json polylines_data(const std::vector<PlanePolyline>& polylines) {
  Json list = Json::array();
  for (const PlanePolyline& polyline : polylines) list.push_back(simplified(polyline, 1e-4));
  return list;
}

/// Names of sheets, and polylines in (u,v).
Json patch_curve_data(const ShownRevolutionPatch& patch) {
  Json list = Json::array();
  if (patch.curve.equation.is_zero()) return list;
  const std::vector<PlanePolyline> arcs = drawn_arcs(patch.curve.inner, patch.curve.arcs);
  for (std::size_t i = 0; i < arcs.size(); ++i)
    list.push_back({{"sheet", name(patch.curve.sheets[i])}, {"polyline", simplified(arcs[i], 1e-4)}});
  return list;
}

}  // namespace

std::string implicit_report_html(const Json& result, const ImplicitSubject& subject,
                                 const ReportOrigin& origin) {
  Json data = report_data("implicitize", origin, result);
  if (subject.curve) data["curve"] = curve_data(*subject.curve);
  if (subject.patch) data["patches"] = Json::array({patch_data(subject.patch->name, subject.patch->patch)});
  return page_of(data, subject.svg);
}

std::string revolution_report_html(const ShownRevolution& shown, const ReportOrigin& origin) {
  Json data = report_data("revolve", origin, revolution_json(shown));
  const HalfPlaneCurves curves = half_plane_curves(shown);
  data["profile"] = curves.profile;
  data["own"] = polylines_data(curves.own.following);
  data["further"] = polylines_data(curves.own.further);
  data["mirrored"] = polylines_data(curves.mirrored);
  if (shown.patch) {
    data["patches"] = Json::array({patch_data(shown.patch->name, shown.patch->patch)});
    data["patch_curve"] = patch_curve_data(*shown.patch);
  }
  return page_of(data, revolution_svg(shown, origin.title));
}

std::string comparison_report_html(const Comparison& comparison, const BezierPatch& x, const BezierPatch& y,
                                   const PatchNames& names, const ReportOrigin& origin) {
  Json data = report_data("compare", origin, comparison_json(comparison, names));
  data["parameters"] = pair_names;
  data["patches"] = {patch_data(names.first, x), patch_data(names.second, y)};
  data["graph"] = intersection_json(comparison.parameter_lines, names);
  return page_of(data, comparison_svg(comparison, origin.title));
}

}  // namespace exsect::cli
