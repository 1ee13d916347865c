// Neighbourhoods of single points of the intersection, singular ones included, in which the intersection is a
// star of arcs. Internal to solver/.
#pragma once

#include <exsect/geometry/bezier_patch.h>
#include <exsect/solver/certified_point.h>

#include <optional>
#include <vector>

#include "answer/stop_request.h"
#include "eliminant/algebraic_fibre.h"
#include "eliminant/exact_pair.h"

namespace exsect {

/// Where an arc of a star leaves its neighbourhood: a fibre point of the sweep, or a point of the line on
/// which the sweep parameter has the centre's value.
struct Port {
  CertifiedPoint point;
  Parameter across;  // the arc leaves the box across this parameter
  int side;          // -1: at the lower end of the box in that parameter, +1: at the upper end
};

/// Invariant, by (6.3) (docs/method.md, Lemmas 6.2, 6.2a): inside the closed box the intersection consists of
/// `centre` and of one arc for every port, that runs from the port to the centre; the arcs meet in the centre
/// only. Each is strictly monotone in the parameter it leaves across, and strictly monotone or constant in
/// each other parameter, unless all lie on sides of the squares. No port: the centre is an isolated point.
struct StarNeighbourhood {
  CertifiedPoint centre;
  Parameter sweep;
  ParameterBox box;
  std::vector<Port> ports;
  /// Further fibre points of the arcs, from the ports' fibre inwards, for the lower (0) and upper (1) side.
  std::array<std::vector<std::vector<CertifiedPoint>>, 2> layers;
  /// A larger closed box in which the invariant holds with other ports, if one was proved on the way: all
  /// solutions in it are on the arcs that end in the centre, so on these arcs and their continuations.
  std::optional<ParameterBox> outer = {};
};

/// True only if the centre is a singular point: three arcs or more end in it.
inline bool is_singular(const StarNeighbourhood& star) { return star.ports.size() >= 3; }

/// What the stars of a pair must keep away from.
struct StarPlaces {
  const std::vector<CertifiedPoint>& boundary;  // all isolated points on sides
  Parameter sampled;                            // no star contains a point over these of its values
  const std::vector<Rational>& samples;
};

/// Where a star is asked for. After ExactPair::stop() nothing is proved.
struct StarQuery {
  ExactPair& pair;
  const StarPlaces& places;
  const TurningValues& turning;  // of the sweep
  double largest_halfwidth = 0;
  /// The centre's value of the parameter along the line over `at`, if it is given by that.
  std::optional<RealAlgebraic> along = {};
  /// The centre, where the value of the sweep parameter is irrational.
  const SingularFibrePoint* singular = nullptr;
};

/// The star around `centre`, a point of the intersection over the value `at` of the sweep parameter, rational
/// unless StarQuery::singular is given; empty if it cannot be proved. If the line over `at` lies on the
/// other patch around the centre, StarQuery::along must be given, or the centre must lie over no turning
/// value of the parameter along it.
std::optional<StarNeighbourhood> star_neighbourhood(const StarQuery& query, const CertifiedPoint& centre,
                                                    const RealAlgebraic& at);

/// Fills in layers, `count` on each side that has ports; false if `stop` came in between, or if a fibre has
/// another number of points in the star than there are ports, as it must not.
bool add_layers(StarNeighbourhood& star, const BezierPatch& x, const BezierPatch& y, const RealAlgebraic& at,
                int count, const StopRequest& stop = {});

/// An arc of a star from its port to the centre: between neighbouring fibres it lies in a box. vertices: a
/// point near the arc, or on it, in every layer; hulls: one more.
struct StarArc {
  std::vector<CertifiedPoint> vertices;
  std::vector<ParameterBox> hulls;
};
}  // namespace exsect
