// Pairs of surfaces in binary64, as every program of the comparison reads them, and what such a program
// answers.
#pragma once

#include <array>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <variant>
#include <vector>

namespace peers {

using Point = std::array<double, 3>;

/// A Bézier curve or a row of a Bézier patch: its control points, and weights or none.
struct Row {
  std::vector<Point> points;
  std::vector<double> weights;
};

/// Control points by rows, and weights in the same order or none: the row belongs to the first parameter, the
/// column to the second.
struct Patch {
  std::size_t rows;
  std::size_t columns;
  std::vector<Point> points;
  std::vector<double> weights;

  std::size_t index(std::size_t row, std::size_t column) const { return row * columns + column; }
};

/// A whole plane, cylinder, cone of one nappe, sphere or torus.
struct RoundSurface {
  std::string type;  // as in patch files
  Point point;       // on the plane or axis; the apex, the centre
  Point axis;        // of a plane its normal; (0,0,1) for a sphere
  double radius;     // of a cone its slope, of a torus the major one; 0 for a plane
  double minor;      // 0 unless it is a torus
};

using Surface = std::variant<Patch, RoundSurface>;

/// The name is FAMILY/NUMBER.
struct SurfacePair {
  std::string name;
  Surface x;
  Surface y;

  std::string family() const { return name.substr(0, name.find('/')); }
  /// The largest extent of the box around all control points; 4 of two round surfaces, which the families
  /// (round_families.h) make about as large.
  double size() const;
  /// The patch that the surface is; throws std::runtime_error where it is none.
  const Patch& first_patch() const;
  const Patch& second_patch() const;
};

/// A file with one patch file (docs/formats.md) of two entries a line; the title is the name of the pair. A
/// fraction is rounded to the nearest double. Throws std::runtime_error naming file and line.
std::vector<SurfacePair> read_pairs(const std::string& path);

/// x(u,v).
Point evaluate(const Patch& patch, double first, double second);

/// The curve x(u,.) for a fixed first parameter.
Row parameter_line(const Patch& patch, double first);

/// A point of space and its parameters (u,v,r,s).
struct Vertex {
  Point point;
  std::array<double, 4> parameters;
};
using Curve = std::vector<Vertex>;

/// What a program found: curves as polylines, and isolated points, whose parameters may be no numbers: not
/// known.
struct Answer {
  std::vector<Curve> curves;
  std::vector<Vertex> points;
};

/// The members "curves" and "points" of the form candidate/1 (docs/formats.md), and "length", that of all
/// curves.
nlohmann::ordered_json to_json(const Answer& answer);

/// A curve over [from,to] as a polyline: bisected until the middle of every chord is within `flat` of the
/// curve, at least into 64 pieces and at most into 2^14.
Curve sampled(const std::function<Vertex(double)>& at, double from, double to, double flat);

}  // namespace peers
