#include "output/drawing/revolution_svg.h"

// The picture of a surface of revolution.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "output/drawing/drawn_arcs.h"
#include "output/drawing/revolution_curves.h"
#include "output/drawing/svg_legend.h"
#include "output/drawing/svg_plane.h"
#include "output/drawing/svg_square.h"
#include "output/text/terminal_text.h"

namespace exsect::cli {
namespace {

constexpr double plane_margin = 76;
constexpr double plane_top = 62;

const Stroke profile_stroke = {"#56b4e9", 6};
const Stroke own_stroke = {"#000000", 1.6};
const Stroke unwanted_stroke = {"#d55e00", 1.6, "6 3"};
const Stroke mirrored_stroke = {"#009e73", 1.6, "2 4"};
constexpr const char* ring_colour = "#cc79a7";

void draw_half_plane(const ShownRevolution& shown, const HalfPlaneCurves& drawn, SvgPlane& plane) {
  plane.polyline(drawn.profile, profile_stroke);
  for (const PlanePolyline& curve : drawn.mirrored) plane.polyline(curve, mirrored_stroke);
  for (const PlanePolyline& curve : drawn.own.further) plane.polyline(curve, unwanted_stroke);
  for (const PlanePolyline& curve : drawn.own.following) plane.polyline(curve, own_stroke);
  if (shown.revolution.rings)
    for (const SingularRing& ring : shown.revolution.rings->rings)
      plane.mark(Mark::ring, {to_double(ring.r.midpoint()), to_double(ring.z.midpoint())}, ring_colour);
}

void draw_patch(const ShownRevolutionPatch& patch, SvgSquare& square) {
  if (patch.curve.equation.is_zero()) return;
  const std::vector<PlanePolyline> arcs = drawn_arcs(patch.curve.inner, patch.curve.arcs);
  for (std::size_t i = 0; i < arcs.size(); ++i)
    square.polyline(arcs[i], patch.curve.sheets[i] == Sheet::own ? Stroke{palette(0)} : mirrored_stroke);
  for (const ShownRevolutionLine& line : patch.lines)
    for (const RevolutionPatchPoint& p : line.line.points)
      square.mark(Mark::dot, {to_double(line.u), p.v.to_double()}, "#000000");
}

SvgLegend revolution_legend(const ShownRevolution& shown, const HalfPlaneCurves& drawn) {
  SvgLegend legend;
  legend.add(profile_stroke, "profile");
  legend.add(own_stroke, "zero set along it");
  if (!drawn.own.further.empty()) legend.add(unwanted_stroke, "further branches of its own");
  if (!drawn.mirrored.empty()) legend.add(mirrored_stroke, "mirrored branches");
  if (shown.revolution.rings && !shown.revolution.rings->rings.empty())
    legend.add(Mark::ring, ring_colour, "singular ring");
  if (shown.patch) legend.add(Stroke{palette(0)}, "on the patch");
  return legend;
}

}  // namespace

std::string revolution_svg(const ShownRevolution& shown, const std::string& title) {
  const PlaneView view = view_of(shown.revolution.region);
  const HalfPlaneCurves drawn = half_plane_curves(shown);
  const SvgLegend entries = revolution_legend(shown, drawn);
  const double plane_right = plane_margin + SvgPlane::width(view);
  const double width = plane_right + (shown.patch ? 90 + SvgSquare::size : 0) + 40;
  const double height = std::max(SvgPlane::height(view), shown.patch ? SvgSquare::size : 0.0);
  const double legend_top = plane_top + height + 54;
  SvgPicture picture(width, legend_top + entries.height(width - 60) + 14);
  picture.element("<g fill=\"#000000\">");
  picture.text(width / 2, 26, fitted(title, 15, width - 30), 15, TextAnchor::middle);
  const auto& bound = shown.revolution.bounds.one_sided.distance;
  const std::string subtitle = fmt::format(
      "{}: {}", name(shown.method),
      bound ? "one-sided distance at most " + rounded_up(to_double(*bound)) : "no distance proved");
  picture.text(width / 2, 48, fitted(subtitle, 13, width - 30), 13, TextAnchor::middle);
  picture.element("</g>");
  SvgPlane plane(picture, plane_margin, plane_top, view, "r", "z");
  draw_half_plane(shown, drawn, plane);
  if (shown.patch) {
    SvgSquare square(picture, plane_right + 90, plane_top, "u", "v");
    draw_patch(*shown.patch, square);
  }
  entries.draw(picture, 30, legend_top, width - 60);
  return picture.document();
}

}  // namespace exsect::cli
