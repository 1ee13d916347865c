#include "output/drawing/comparison_svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "output/drawing/drawn_arcs.h"
#include "output/drawing/svg_legend.h"
#include "output/drawing/svg_square.h"
#include "output/text/terminal_text.h"

namespace exsect::cli {
namespace {

constexpr double rows_top = 92;
constexpr double row_height = SvgSquare::size + 96;

const Stroke phantom = {"#a0a0a0", 1.4};

/// A polynomial in (u,v) in doubles.
class Shade {
 public:
  explicit Shade(const BivariatePolynomial& f) {
    for (int i = 0; i <= f.degree_r(); ++i) {
      rows_.emplace_back();
      for (const Rational& c : f.coefficient(i).coefficients()) rows_.back().push_back(to_double(c));
    }
  }
  double operator()(PlanePoint p) const {
    double value = 0;
    for (auto row = rows_.rbegin(); row != rows_.rend(); ++row) {
      double inner = 0;
      for (auto c = row->rbegin(); c != row->rend(); ++c) inner = inner * p[1] + *c;
      value = value * p[0] + inner;
    }
    return value;
  }

 private:
  std::vector<std::vector<double>> rows_;
};

void draw_lines(const IntersectResult& result, SvgSquare& square) {
  for (const Arc& arc : result.graph.arcs) {
    PlanePolyline polyline;
    for (const PolylineVertex& vertex : arc.polyline)
      polyline.push_back({vertex.parameters[0], vertex.parameters[1]});
    square.polyline(polyline, Stroke{palette(static_cast<std::size_t>(std::max(arc.component, 0)))});
  }
  for (const Node& node : result.graph.nodes)
    square.mark(Mark::point, {node.approx[0], node.approx[1]}, "#000000");
}

void draw_resultant(const ResultantMethod& result, SvgSquare& square) {
  if (result.curve.is_zero()) return;
  const std::vector<PlanePolyline> arcs = drawn_arcs(result.curve, result.arcs);
  for (const CurveComponent& component : result.phantoms)
    for (const std::size_t arc : component.arcs) square.polyline(arcs[arc], phantom);
  for (std::size_t i = 0; i < result.components.size(); ++i)
    for (const std::size_t arc : result.components[i].arcs) square.polyline(arcs[arc], Stroke{palette(i)});
}

/// Boxes of the regions; the pieces' curves where they run through their boxes, grey in phantom regions and
/// further than a box from the curve found by parameter lines.
class QuarticDrawing {
 public:
  QuarticDrawing(const QuarticMethod& method, int boxes, const IntersectResult& exact)
      : method_(method), boxes_(1 << boxes) {
    for (const Arc& arc : exact.graph.arcs)
      for (const PolylineVertex& vertex : arc.polyline)
        exact_.push_back({vertex.parameters[0], vertex.parameters[1]});
  }

  void draw(SvgSquare& square) {
    for (const QuarticRegion& region : method_.regions) {
      // boxes on top of each other in one
      std::vector<PlanePolyline> rings;
      const double size = 1.0 / boxes_;
      for (std::size_t k = 0; k < region.boxes.size();) {
        const auto [i, from] = region.boxes[k];
        int to = from;
        while (k < region.boxes.size() && region.boxes[k] == std::array<int, 2>{i, to}) ++k, ++to;
        rings.push_back({{i * size, from * size},
                         {(i + 1) * size, from * size},
                         {(i + 1) * size, to * size},
                         {i * size, to * size}});
      }
      square.region(rings, region.is_phantom ? "#a0a0a0" : "#56b4e9");
    }
    for (const QuarticPiece& piece : method_.pieces) {
      covered_.assign(static_cast<std::size_t>(boxes_) * static_cast<std::size_t>(boxes_), false);
      for (const auto& [i, j] : piece.boxes) covered_[position(i, j)] = true;
      if (piece.boxes.empty()) continue;
      for (const PlanePolyline& curve : zero_set(Shade(piece.composed), 160)) draw(square, curve);
    }
  }

 private:
  std::size_t position(int i, int j) const { return static_cast<std::size_t>(i * boxes_ + j); }

  bool is_covered(PlanePoint p) const {
    const auto box = [&](double t) { return std::clamp(static_cast<int>(t * boxes_), 0, boxes_ - 1); };
    return covered_[position(box(p[0]), box(p[1]))];
  }

  bool is_near(PlanePoint p) const {
    return std::any_of(exact_.begin(), exact_.end(), [&](const PlanePoint& q) {
      return std::hypot(p[0] - q[0], p[1] - q[1]) < 1.5 / boxes_;
    });
  }

  void draw(SvgSquare& square, const PlanePolyline& curve) const {
    PlanePolyline part;
    int state = 0;  // 0 outside the regions, 1 near the curve, 2 phantom
    const auto flush = [&] {
      if (state != 0 && part.size() > 1) square.polyline(part, state == 1 ? Stroke{palette(0)} : phantom);
      part.clear();
    };
    for (const PlanePoint& p : curve) {
      const int next = !is_covered(p) ? 0 : is_near(p) ? 1 : 2;
      if (next != state) {
        const PlanePoint joint = part.empty() ? p : part.back();
        flush();
        if (state != 0 && next != 0) part.push_back(joint);
        state = next;
      }
      part.push_back(p);
    }
    flush();
  }

  const QuarticMethod& method_;
  int boxes_;
  std::vector<PlanePoint> exact_;
  std::vector<bool> covered_;  // by the piece that is drawn
};

}  // namespace

std::string comparison_svg(const Comparison& comparison, const std::string& title) {
  SvgLegend legend;
  legend.add(Stroke{palette(0)}, "intersection, one colour for each component found");
  legend.add(phantom, "phantom branches");
  legend.add(Stroke{"#56b4e9", 6}, "regions outside of which the quartics prove that there is nothing");
  legend.add(Stroke{"#a0a0a0", 6}, "such a region without a point of the intersection on a check line");
  const double legend_width = pair_width - 2 * 30;
  const std::size_t rows = (2 + comparison.quartics.size() + 1) / 2;
  const double legend_top = rows_top + static_cast<double>(rows) * row_height - 20;
  SvgPicture picture(pair_width, legend_top + legend.height(legend_width) + 14);
  picture.element("<g fill=\"#000000\">");
  picture.text(pair_width / 2, 26, fitted(title, 15, pair_width - 30), 15, TextAnchor::middle);
  picture.element("</g>");
  for (std::size_t i = 0; i < comparison.rows.size(); ++i) {
    const MethodRow& row = comparison.rows[i];
    const double left = pair_left + static_cast<double>(i % 2) * (SvgSquare::size + pair_between);
    const double top = rows_top + static_cast<double>(i / 2) * row_height;
    const std::string heading = fmt::format(
        "{} ({}): {}{}", row.method, row.detail, counted(row.components, i < 2 ? "component" : "region"),
        row.phantom_branches.value_or(0) > 0 ? fmt::format(", {} phantom", *row.phantom_branches) : "");
    picture.element("<g fill=\"#000000\">");
    picture.text(left + SvgSquare::size / 2, top - 12, fitted(heading, 13, SvgSquare::size + 40), 13,
                 TextAnchor::middle);
    picture.element("</g>");
    const bool in_vs = i == 1 && comparison.plane == ResultantPlane::v_s;
    SvgSquare square(picture, left, top, in_vs ? "v" : "u", in_vs ? "s" : i == 1 ? "r" : "v");
    if (i == 0) draw_lines(comparison.parameter_lines, square);
    if (i == 1) draw_resultant(comparison.resultant, square);
    if (i >= 2)
      QuarticDrawing(comparison.quartics[i - 2], comparison.quartic_options[i - 2].boxes,
                     comparison.parameter_lines)
          .draw(square);
  }
  legend.draw(picture, 30, legend_top, legend_width);
  return picture.document();
}

}  // namespace exsect::cli
