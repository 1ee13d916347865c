// What another program computed for a pair of patches: curves and isolated points, in doubles.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace exsect {

/// Larger numbers are refused: differences of such ones have squares that are doubles.
inline constexpr double max_candidate_number = 0x1p500;

/// A polynomial or rational B-spline curve of the plane (third coordinate 0) or of space.
/// Invariant: degree >= 1, at least degree+1 points; knots.size() == points.size() + degree + 1, ascending,
/// interior ones at most `degree` times, knots[degree] < knots[points.size()]; weights empty (all 1) or one
/// for each point, all > 0 and finite; no knot and no coordinate beyond max_candidate_number in magnitude.
struct SplineCurve {
  int degree;
  std::vector<double> knots;
  std::vector<std::array<double, 3>> points;
  std::vector<double> weights;

  /// The curve is defined on [from, to].
  double from() const { return knots[static_cast<std::size_t>(degree)]; }
  double to() const { return knots[points.size()]; }
  friend bool operator==(const SplineCurve&, const SplineCurve&) = default;
};

/// The polyline through at least two points as a spline of degree 1: the parameter is the number of the
/// vertex, from 0. Throws std::invalid_argument for fewer points.
SplineCurve polyline(std::vector<std::array<double, 3>> vertices);

/// The point at t in [from, to], in floating point.
std::array<double, 3> point_of(const SplineCurve& curve, double t);

/// The violated part of the invariant, or an empty text.
std::string violation(const SplineCurve& curve);

/// One curve as the program returned it, given in space, in the parameter square of either patch, or in
/// several of these: at least one is there, and all have the same parameter interval.
struct CandidateCurve {
  std::optional<SplineCurve> space;
  std::optional<SplineCurve> first;   // (u,v), within [-1,2]^2
  std::optional<SplineCurve> second;  // (r,s), within [-1,2]^2
  bool closed = false;                // polylines: the last vertex is joined to the first
  std::optional<bool> tangential;     // whether the patches touch along it, where the program says so
};

/// An isolated point; at least one member is there.
struct CandidatePoint {
  std::optional<std::array<double, 3>> point;
  std::optional<std::array<double, 2>> first;
  std::optional<std::array<double, 2>> second;
};

struct Candidate {
  std::array<std::string, 2> patches;  // names of the two patches, empty where the file does not tell
  std::string source;                  // free text
  std::vector<CandidateCurve> curves;
  std::vector<CandidatePoint> points;
};

/// The same for the pair in the other order: what was `first` is `second`. The names stay.
Candidate exchanged(Candidate candidate);

}  // namespace exsect
