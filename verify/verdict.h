// What a candidate curve is judged to be: its verdict and what the verdict rests on.
#pragma once

#include <exsect/geometry/candidate.h>
#include <exsect/solver/result.h>

#include <optional>
#include <string>
#include <vector>

namespace exsect {

/// agrees, disagrees: proved. undecided: neither could be proved with the numbers at hand.
enum class Agreement { agrees, disagrees, undecided };

enum class DifferenceKind {
  lost_curve,        // no part of a component is covered
  gap,               // a part of an arc is not covered
  spurious_curve,    // a part of a candidate curve that is no intersection
  wrong_connection,  // a candidate curve joins what the true curve does not join
  split,             // a component in parts that are apart from each other
  repeated,          // a part of an arc occurs twice
  curve_as_points,   // points instead of a component
  false_point,       // a claimed point that is no intersection
  point_on_curve,    // a claimed isolated point that lies on a curve
  lost_point,        // an isolated point that is not claimed
  repeated_point,    // an isolated point claimed twice
  wrong_contact,     // tangential stated as transversal or the other way round
};

/// How a candidate curve or point is given.
enum class Representation { space, first, second };

/// A part of a candidate curve: its own parameter, for polylines the number of the vertex, from 0.
struct CandidatePart {
  std::size_t curve;
  Representation representation;
  double from;
  double to;
};

/// Every point of the arc at which the parameter lies strictly between the two numbers is farther than the
/// tolerance from the candidate. from > to where the parameter falls along the arc. On two surfaces given by
/// their equations, which have no parameter, a part between the two vertices is.
struct ArcGap {
  int arc;
  int overlap;  // -1, or the overlap whose rim the arc belongs to
  std::optional<Parameter> parameter;
  Rational from;  // 0 without a parameter, like `to`
  Rational to;
  std::array<std::size_t, 2> vertices;  // of the arc's polyline, the first at or before, the last at or after
};

struct Difference {
  DifferenceKind kind;
  std::string text;                   // in words
  std::vector<int> components;        // ids
  std::optional<std::size_t> curve;   // index of the candidate's curve
  std::optional<std::size_t> point;   // index of the candidate's point
  std::optional<int> node;            // id of an isolated point
  std::optional<CandidatePart> part;  // of that curve
  std::optional<ArcGap> gap;
};

enum class Coverage { covered, partly, missed, undecided };

/// Largest distance of a point, over one curve, from another: proved to lie in [lower, upper].
struct DistanceEnclosure {
  double lower = 0;
  double upper = 0;
};

struct ArcFinding {
  int arc;
  int overlap;  // -1, or the overlap whose rim it belongs to
  int component;
  Coverage coverage;
  std::vector<ArcGap> gaps;
  DistanceEnclosure distance;  // of the arc from the candidate's curves; infinite where there is none
};

struct ComponentFinding {
  int component;
  Coverage coverage;
  std::vector<std::size_t> curves;  // candidate curves on it
};

struct CurveFinding {
  std::vector<int> components;  // that it follows, in this order
  std::vector<CandidatePart> spurious;
  DistanceEnclosure distance;       // of the curve from the true curve
  DistanceEnclosure true_distance;  // of the components that it follows from the candidate's curves
};

/// The verdict on a candidate; docs/method-verify.md, section 15.
struct Verdict {
  Agreement agreement;
  bool exact_is_complete;
  double tolerance;  // absolute
  std::vector<Difference> differences;
  std::vector<std::string> undecided;
  std::vector<ComponentFinding> components;
  std::vector<ArcFinding> arcs;
  std::vector<CurveFinding> curves;
};

const char* name(Agreement agreement);
const char* name(DifferenceKind kind);
const char* name(Representation representation);
const char* name(Coverage coverage);

}  // namespace exsect
