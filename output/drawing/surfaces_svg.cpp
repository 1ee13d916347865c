#include "output/drawing/surfaces_svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "output/drawing/svg_legend.h"
#include "output/text/terminal_text.h"

namespace exsect::cli {
namespace {

constexpr double picture_size = 560;
constexpr double picture_margin = 30;
constexpr double drawing_top = 66;
constexpr int wires = 24;               // cells of the surfaces in each direction
constexpr std::size_t most_curves = 8;  // in the legend

const std::array<Stroke, 2> wire_strokes = {{{"#9fb4c9", 0.7}, {"#d2b48c", 0.7}}};

using Flat = std::array<double, 2>;

/// Seen from the direction (2, -3, 2), z upwards.
Flat projected(const std::array<double, 3>& p) {
  const double side = std::sqrt(13.0), up = std::sqrt(13.0 * 17.0);
  return {(3 * p[0] + 2 * p[1]) / side, (-4 * p[0] + 6 * p[1] + 13 * p[2]) / up};
}

/// Where the scene is on the picture.
class View {
 public:
  View(const Scene& scene, const SpaceAdditions& additions) {
    for (const SceneMesh& mesh : scene.meshes) cover(mesh.vertices);
    for (const SceneCurve& curve : scene.curves) cover(curve.vertices);
    for (const SceneNode& node : scene.nodes) cover({node.vertex});
    for (const auto* lines : {&additions.below, &additions.above})
      for (const auto& line : *lines) std::ranges::for_each(line.first, [&](const auto& p) { cover(p); });
    for (const auto& p : additions.marks) cover(p);
    const double extent = std::max(upper_[0] - lower_[0], upper_[1] - lower_[1]);
    scale_ = extent > 0 && std::isfinite(extent) ? (picture_size - 2 * picture_margin) / extent : 1;
  }

  Flat operator()(const PolylineVertex& vertex) const { return (*this)(vertex.point); }
  Flat operator()(const std::array<double, 3>& p) const {
    const Flat at = projected(p);
    return {picture_margin + scale_ * (at[0] - lower_[0]), drawing_top + scale_ * (upper_[1] - at[1])};
  }
  double bottom() const {
    return drawing_top + (upper_[1] > lower_[1] ? scale_ * (upper_[1] - lower_[1]) : 0);
  }

 private:
  void cover(const std::vector<PolylineVertex>& vertices) {
    for (const PolylineVertex& vertex : vertices) cover(vertex.point);
  }
  void cover(const std::array<double, 3>& p) {
    const Flat at = projected(p);
    for (std::size_t k = 0; k < 2; ++k) {
      lower_[k] = std::min(lower_[k], at[k]);
      upper_[k] = std::max(upper_[k], at[k]);
    }
  }

  static constexpr double far = std::numeric_limits<double>::infinity();
  Flat lower_ = {far, far};
  Flat upper_ = {-far, -far};
  double scale_ = 1;
};

template <class Vertex>
void draw_path(SvgPicture& picture, const View& view, const std::vector<Vertex>& vertices,
               const Stroke& stroke) {
  std::string path;
  for (const Vertex& vertex : vertices) {
    const Flat at = view(vertex);
    path += fmt::format("{}{:.2f},{:.2f}", path.empty() ? "M" : "L", at[0], at[1]);
  }
  picture.element(fmt::format(R"(<path d="{}" fill="none" {}/>)", path, attributes(stroke)));
}

/// Every second line of the grid, in both directions.
void draw_wires(SvgPicture& picture, const View& view, const SceneMesh& mesh, const Stroke& stroke) {
  constexpr std::size_t n = wires;
  for (std::size_t i = 0; i <= n; i += 2) {
    std::vector<PolylineVertex> one, other;
    for (std::size_t j = 0; j <= n; ++j) {
      one.push_back(mesh.vertices[i * (n + 1) + j]);
      other.push_back(mesh.vertices[j * (n + 1) + i]);
    }
    draw_path(picture, view, one, stroke);
    draw_path(picture, view, other, stroke);
  }
}

Stroke space_curve_stroke(int curve, bool is_tangential) {
  return {palette(static_cast<std::size_t>(curve)), 2.4, is_tangential ? "7 5" : ""};
}

std::optional<Mark> mark_of(SpaceNodeKind kind) {
  switch (kind) {
    case SpaceNodeKind::touch:
      return Mark::plus;
    case SpaceNodeKind::crossing:
      return Mark::cross;
    case SpaceNodeKind::singular:
      return Mark::triangle;
    case SpaceNodeKind::end:
      return Mark::square;
    default:
      return std::nullopt;  // a joint or a cut is nothing that the curve has there
  }
}

SvgLegend legend_of(const DrawnSurfaces& drawn, const Scene& scene) {
  SvgLegend legend;
  const auto& curves = drawn.result.curves;
  for (std::size_t i = 0; i < std::min(most_curves, curves.size()); ++i)
    legend.add(space_curve_stroke(curves[i].id, curves[i].multiplicity != 1),
               fmt::format("{}{}", curves[i].kind == SpaceCurveKind::general ? "curve" : name(curves[i].kind),
                           curves[i].multiplicity != 1 ? ", touching" : ""));
  for (const SpaceNodeKind kind :
       {SpaceNodeKind::touch, SpaceNodeKind::crossing, SpaceNodeKind::singular, SpaceNodeKind::end})
    if (drawn.result.count(kind) > 0) legend.add(*mark_of(kind), "#000000", name(kind));
  for (std::size_t i = 0; i < scene.meshes.size(); ++i)
    legend.add(Stroke{wire_strokes[i].colour, 1.6}, printable(scene.meshes[i].name));
  return legend;
}

}  // namespace

std::string surfaces_svg(const DrawnSurfaces& drawn, const std::string& title) {
  return surfaces_svg(drawn, title, {});
}

std::string surfaces_svg(const DrawnSurfaces& drawn, const std::string& title,
                         const SpaceAdditions& additions) {
  const Scene scene = surfaces_scene(drawn, title, wires);
  const View view(scene, additions);
  SvgLegend legend = legend_of(drawn, scene);
  for (const auto& [stroke, text] : additions.legend) legend.add(stroke, text);
  const double legend_width = picture_size - 2 * picture_margin, legend_top = view.bottom() + 24;
  SvgPicture picture(picture_size, legend_top + legend.height(legend_width) + 14);
  picture.element("<g fill=\"#000000\">");
  picture.text(picture_size / 2, 26, fitted(title, 15, picture_size - 30), 15, TextAnchor::middle);
  picture.text(picture_size / 2, 48,
               fitted(fmt::format("{}{}", what_is_common(drawn.result),
                                  drawn.result.status == Status::complete ? "" : " (incomplete)"),
                      13, picture_size - 30),
               13, TextAnchor::middle);
  picture.element("</g>");
  for (std::size_t i = 0; i < scene.meshes.size(); ++i)
    draw_wires(picture, view, scene.meshes[i], wire_strokes[i]);
  for (const auto& [points, stroke] : additions.below) draw_path(picture, view, points, stroke);
  for (const SceneCurve& curve : scene.curves)
    draw_path(picture, view, curve.vertices,
              space_curve_stroke(curve.component, curve.contact == Contact::tangential));
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    const Flat at = view(scene.nodes[i].vertex);
    if (const auto mark = mark_of(drawn.result.nodes[i].kind)) picture.mark(*mark, at[0], at[1], "#000000");
  }
  for (const auto& [points, stroke] : additions.above) draw_path(picture, view, points, stroke);
  for (const auto& p : additions.marks) picture.mark(Mark::cross, view(p)[0], view(p)[1], "#d00000");
  legend.draw(picture, picture_margin, legend_top, legend_width);
  return picture.document();
}

}  // namespace exsect::cli
