#include "output/drawing/svg_square.h"

#include <fmt/format.h>

#include <algorithm>

namespace exsect::cli {

SvgSquare::SvgSquare(SvgPicture& picture, double left, double top, const std::string& across,
                     const std::string& upwards)
    : picture_(picture), left_(left), top_(top) {
  const Stroke grid = {"#e4e4e4", 1};
  const Stroke tick = {"#404040", 1};
  for (int i = 0; i <= 5; ++i) {
    const double at = i / 5.0;
    const std::string number = i == 0 ? "0" : i == 5 ? "1" : fmt::format("{:.1f}", at);
    if (0 < i && i < 5) {
      picture_.line(x(at), y(0), x(at), y(1), grid);
      picture_.line(x(0), y(at), x(1), y(at), grid);
    }
    picture_.line(x(at), y(0), x(at), y(0) + 5, tick);
    picture_.line(x(0), y(at), x(0) - 5, y(at), tick);
    picture_.element("<g fill=\"#202020\">");
    picture_.text(x(at), y(0) + 19, number, 12, TextAnchor::middle);
    picture_.text(x(0) - 9, y(at) + 4, number, 12, TextAnchor::end);
    picture_.element("</g>");
  }
  picture_.element("<g fill=\"#000000\">");
  picture_.text(x(0.5), y(0) + 37, across, 16, TextAnchor::middle, true);
  picture_.text(x(0) - 36, y(0.5) + 5, upwards, 16, TextAnchor::middle, true);
  picture_.element("</g>");
  picture_.element(fmt::format(R"(<rect x="{}" y="{}" width="{}" height="{}" stroke="#404040"/>)", left_,
                               top_, size, size));
}

std::string SvgSquare::path(const PlanePolyline& polyline) const {
  std::string text;
  for (const PlanePoint& p : simplified(polyline, drawing_tolerance)) {
    text += fmt::format("{}{:.2f},{:.2f}", text.empty() ? 'M' : 'L', x(p[0]), y(p[1]));
  }
  return text;
}

void SvgSquare::polyline(const PlanePolyline& polyline, const Stroke& stroke) {
  if (polyline.empty()) return;
  picture_.element(fmt::format(R"(<path d="{}" {}/>)", path(polyline), attributes(stroke)));
}

void SvgSquare::region(const std::vector<PlanePolyline>& rings, const std::string& colour) {
  std::string text;
  for (const PlanePolyline& ring : rings) text += path(ring) + "Z";
  picture_.element(
      fmt::format(R"(<path d="{}" fill="{}" fill-opacity="0.2" fill-rule="evenodd"/>)", text, colour));
}

void SvgSquare::box(PlanePoint lower, PlanePoint upper) {
  constexpr double least = 9;
  const double width = std::max(least, size * (upper[0] - lower[0]));
  const double height = std::max(least, size * (upper[1] - lower[1]));
  picture_.element(fmt::format(
      R"(<rect x="{:.2f}" y="{:.2f}" width="{:.2f}" height="{:.2f}" fill="#808080" fill-opacity="0.35" stroke="#404040" stroke-width="0.8"/>)",
      (x(lower[0]) + x(upper[0]) - width) / 2, (y(lower[1]) + y(upper[1]) - height) / 2, width, height));
}

void SvgSquare::mark(Mark mark, PlanePoint at, const std::string& colour) {
  picture_.mark(mark, x(at[0]), y(at[1]), colour);
}

}  // namespace exsect::cli
