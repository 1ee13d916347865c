// Pairs of patches in binary64, as every program of the comparison reads them, and what such a program
// answers.
#pragma once

#include <array>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace peers {

using Point = std::array<double, 3>;
/// Control points: row index = first parameter, column index = second.
using Net = std::array<std::array<Point, 3>, 3>;

/// The name is FAMILY/NUMBER.
struct PatchPair {
  std::string name;
  Net x;
  Net y;

  std::string family() const { return name.substr(0, name.find('/')); }
  /// The largest extent of the box around all control points.
  double size() const;
};

/// A file with one patch file (docs/formats.md) of two patches of degree [2,2] a line; the title is the name
/// of the pair. A fraction is rounded to the nearest double. Throws std::runtime_error naming file and line.
std::vector<PatchPair> read_pairs(const std::string& path);

/// x(u,v).
Point evaluate(const Net& net, double first, double second);

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

/// The members "curves" and "points" of the form candidate/1 (docs/formats.md).
nlohmann::ordered_json to_json(const Answer& answer);

/// A curve over [from,to] as a polyline: bisected until the middle of every chord is within `flat` of the
/// curve, at least into 64 pieces and at most into 2^14.
Curve sampled(const std::function<Vertex(double)>& at, double from, double to, double flat);

}  // namespace peers
