#include "output/drawing/svg_plane.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "output/drawing/svg_square.h"

namespace exsect::cli {
namespace {

double length(const std::array<double, 2>& side) { return side[1] - side[0]; }

double unit_of(const PlaneView& view) {
  return SvgPlane::longest / std::max(length(view.across), length(view.upwards));
}

/// A step of 1, 2 or 5 times a power of ten that divides the side into about five.
double tick_step(double side) {
  const double rough = side / 5;
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  const double quotient = rough / power;
  return power * (quotient < 1.5 ? 1 : quotient < 3.5 ? 2 : quotient < 7.5 ? 5 : 10);
}

std::vector<double> ticks(const std::array<double, 2>& side) {
  const double step = tick_step(length(side));
  std::vector<double> list;
  for (double k = std::ceil(side[0] / step); k * step <= side[1] && list.size() < 20; ++k)
    list.push_back(k == 0 ? 0 : k * step);
  return list;
}

}  // namespace

double SvgPlane::width(const PlaneView& view) { return unit_of(view) * length(view.across); }
double SvgPlane::height(const PlaneView& view) { return unit_of(view) * length(view.upwards); }

double SvgPlane::x(double across) const { return left_ + unit_ * (across - view_.across[0]); }
double SvgPlane::y(double upwards) const { return top_ + unit_ * (view_.upwards[1] - upwards); }

SvgPlane::SvgPlane(SvgPicture& picture, double left, double top, const PlaneView& view,
                   const std::string& across, const std::string& upwards)
    : picture_(picture), left_(left), top_(top), view_(view), unit_(unit_of(view)) {
  const Stroke grid = {"#e4e4e4", 1};
  const double bottom = top_ + height(view_);
  const double right = left_ + width(view_);
  for (double at : ticks(view_.across)) picture_.line(x(at), top_, x(at), bottom, grid);
  for (double at : ticks(view_.upwards)) picture_.line(left_, y(at), right, y(at), grid);
  picture_.element("<g fill=\"#202020\">");
  for (double at : ticks(view_.across))
    picture_.text(x(at), bottom + 19, fmt::format("{:.4g}", at), 12, TextAnchor::middle);
  for (double at : ticks(view_.upwards))
    picture_.text(left_ - 9, y(at) + 4, fmt::format("{:.4g}", at), 12, TextAnchor::end);
  picture_.text((left_ + right) / 2, bottom + 37, across, 16, TextAnchor::middle, true);
  picture_.text(left_ - 46, (top_ + bottom) / 2 + 5, upwards, 16, TextAnchor::middle, true);
  picture_.element("</g>");
  picture_.element(
      fmt::format(R"(<rect x="{:.2f}" y="{:.2f}" width="{:.2f}" height="{:.2f}" stroke="#404040"/>)", left_,
                  top_, width(view_), height(view_)));
}

bool SvgPlane::shows(PlanePoint p) const {
  const double slack = 1e-9 * std::max(length(view_.across), length(view_.upwards));
  return p[0] >= view_.across[0] - slack && p[0] <= view_.across[1] + slack &&
         p[1] >= view_.upwards[0] - slack && p[1] <= view_.upwards[1] + slack;
}

void SvgPlane::polyline(const PlanePolyline& polyline, const Stroke& stroke) {
  std::vector<PlanePolyline> parts(1);
  for (const PlanePoint& p : polyline) {
    if (shows(p))
      parts.back().push_back(p);
    else if (!parts.back().empty())
      parts.emplace_back();
  }
  for (const PlanePolyline& part : parts) {
    if (part.size() < 2) continue;
    std::string path;
    for (const PlanePoint& p : simplified(part, drawing_tolerance * longest / unit_))
      path += fmt::format("{}{:.2f},{:.2f}", path.empty() ? "M" : "L", x(p[0]), y(p[1]));
    picture_.element(fmt::format(R"(<path d="{}" {}/>)", path, attributes(stroke)));
  }
}

void SvgPlane::box(PlanePoint lower, PlanePoint upper, const std::string& colour) {
  picture_.element(fmt::format(
      R"(<rect x="{:.2f}" y="{:.2f}" width="{:.2f}" height="{:.2f}" fill="{}" fill-opacity="0.35" stroke="{}" stroke-width="0.8"/>)",
      x(lower[0]), y(upper[1]), unit_ * (upper[0] - lower[0]), unit_ * (upper[1] - lower[1]), colour,
      colour));
}

void SvgPlane::mark(Mark mark, PlanePoint at, const std::string& colour) {
  if (shows(at)) picture_.mark(mark, x(at[0]), y(at[1]), colour);
}

std::vector<PlanePolyline> zero_set_in(const std::function<double(PlanePoint)>& f, const PlaneView& view,
                                       int cells) {
  const auto in_view = [&](PlanePoint p) {
    return PlanePoint{view.across[0] + p[0] * length(view.across),
                      view.upwards[0] + p[1] * length(view.upwards)};
  };
  const double step = 1.5 / cells;
  const auto is_defined_near = [&](PlanePoint p) {
    for (const PlanePoint& q : {PlanePoint{p[0] - step, p[1]}, PlanePoint{p[0] + step, p[1]},
                                PlanePoint{p[0], p[1] - step}, PlanePoint{p[0], p[1] + step}})
      if (!std::isfinite(f(in_view(q)))) return false;
    return true;
  };
  std::vector<PlanePolyline> result;
  for (const PlanePolyline& polyline : zero_set([&](PlanePoint p) { return f(in_view(p)); }, cells)) {
    result.emplace_back();
    for (const PlanePoint& p : polyline) {
      if (is_defined_near(p))
        result.back().push_back(in_view(p));
      else if (!result.back().empty())
        result.emplace_back();
    }
  }
  std::erase_if(result, [](const PlanePolyline& polyline) { return polyline.size() < 2; });
  return result;
}

}  // namespace exsect::cli
