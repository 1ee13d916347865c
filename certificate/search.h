// The search for the claims of a certificate, in doubles: nothing here proves anything. What is found is only
// worth something once checker/ has replayed it.
#pragma once

#include <exsect/checker/certificate.h>
#include <exsect/checker/pairs_of_points.h>
#include <exsect/checker/walls.h>
#include <exsect/solver/intersection_graph.h>
#include <exsect/solver/line_patch.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "certificate/near_pair.h"

namespace exsect::cli {

using Tube = checker::Tube<double>;
using Parameters = std::array<double, 4>;
using Vector = checker::Vector3<double>;

using checker::Chart;

/// How far apart they are in the parameter in which they are furthest.
double apart(const Parameters& a, const Parameters& b);
/// T, the kernel of the map's derivative at w (method (5.1)).
Parameters tangent(const Map& map, const Parameters& w);
/// The parameter along which the curve runs fastest.
std::size_t best_axis(const Map& map, const Parameters& w);
/// Newton's method for F = 0 with the variable `fixed` held.
Parameters on_curve(const Map& map, Parameters w, std::size_t fixed);
/// The zero of dw_i/dw_axis near w on the curve.
Parameters turning_point(const Map& map, Parameters w, std::size_t axis, std::size_t i);

/// The inverse of the columns of DF other than k, at the map's point; nothing if they are dependent.
std::optional<checker::Matrix3<double>> inverse(const Map& local, std::size_t k);
/// A factor of F, exactly and near it.
struct NearFactor {
  checker::Factor exact;
  Map map;
  std::array<Map, 3> columns;
  std::optional<checker::Walls> walls = {};
};

/// What vanishes on a curve: F, H of a chart, or the map of the factor with this number.
struct Equation {
  const Map& map;
  Chart chart = Chart::pair;
  int number = -1;
  const NearFactor* factor = nullptr;
  std::array<bool, 4> constant = {};  // parameters that are known to be constant where it vanishes
};

/// Bounds that the check finds may be greater by this factor.
inline constexpr double rounding_margin = 1 + 1e-3;
/// Surely not zero in the check.
bool definite(const checker::Ball<double>& b);
/// The parameters that are constant in the tube; nothing if something else than the equation vanishes there.
std::optional<std::array<bool, 4>> factored(const Equation& equation, const Tube& tube);

/// How often a parameter that is not constant may turn in a tube inside the domain.
enum class Turns { once, often };
/// A large tube around w that should satisfy everything the check asks of tubes, narrower than `limit`, a
/// power of two. Throws NoCertificate.
Tube tube_at(const Equation& equation, const Parameters& w, std::size_t axis, Turns turns = Turns::often,
             double limit = 1);
checker::CurveBounds<double> bounds_in(const Map& map, const Tube& tube);
/// The map with the errors that the check has in doubles.
checker::Map<checker::Enclosure> in_enclosures(const Map& map);
/// T of all places within `near` of w, with the errors of the check in doubles.
checker::Box<double> tangent_near(const Map& map, const Parameters& w, double near);
/// A bound for the distance from w to the curve.
double distance(const Map& map, const Tube& tube, const Parameters& w);

/// The pair of parameters that a point of a chart stands for; `side`: the sign of its half difference.
Parameters pair_of(Chart chart, const Parameters& z, int side);
/// The point of the chart.
Parameters in_chart(Chart chart, const Parameters& w);

/// What cells may lie in.
struct Places {
  const std::vector<Tube>& tubes;
  std::vector<checker::Star> stars = {};
  std::vector<const NearFactor*> planes = {};  // of the overlaps
  bool self = false;
};
}  // namespace exsect::cli
