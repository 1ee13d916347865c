#include "lift/crossing_curve.h"

#include <exsect/algebra/bivariate_factors.h>
#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <string>
#include <utility>

#include "answer/parameter_box.h"
#include "answer/proof_failure.h"
#include "lift/common_factor.h"
#include "lift/crossing_landmarks.h"
#include "lift/space_projection.h"
#include "lift/space_trace.h"

namespace exsect {
namespace {

int expected_arrivals(LandmarkKind kind) {
  if (kind == LandmarkKind::highest) return 2;
  return kind == LandmarkKind::exit || kind == LandmarkKind::passage ? 1 : 0;
}

/// Along grad F x grad G, or against it, u grows from the landmark on.
std::vector<int> upward_senses(const CrossingLandmark& landmark) {
  if (landmark.kind == LandmarkKind::lowest) return {1, -1};
  const bool goes_up = landmark.kind == LandmarkKind::entry || landmark.kind == LandmarkKind::passage;
  return goes_up ? std::vector<int>{landmark.upward} : std::vector<int>{};
}

CrossingNode node_at(const CrossingLandmark& landmark) {
  const bool goes_on = landmark.kind == LandmarkKind::entry || landmark.kind == LandmarkKind::exit;
  return {cube_of(landmark.zero), goes_on, false, 0};
}

/// An arc that ends on the window of a star goes on to its centre: by a chord, within the diameter of the
/// star's box and of the landmark's cube.
void add_chord(SpaceTrace& trace, const LandmarkStar& star, const SpaceZero& end, bool at_front) {
  std::array<double, 3> centre{}, size{}, rounding{};
  for (std::size_t k = 0; k < 3; ++k) {
    const RationalInterval& side = star.star.box[k];
    centre[k] = to_double(star.point[k].midpoint());
    size[k] = to_double(side.width()) + 4 * end.radius;
    rounding[k] = to_double(abs(side.lower) + abs(side.upper)) * 0x1p-50;
  }
  trace.points.insert(at_front ? trace.points.begin() : trace.points.end(), centre);
  const double error =
      length_bound(size[0], size[1], size[2]) + length_bound(rounding[0], rounding[1], rounding[2]);
  trace.error_bound = larger_bound(trace.error_bound, error * kSlack);
}

/// One curve F = G = 0 with all landmarks on it: that of the branches along which the surfaces cross, or one
/// of a multiple branch.
struct TracedPart {
  TraceProblem problem;
  std::vector<std::size_t> landmarks;  // positions in the list of all
};

std::vector<TracedPart> traced_parts(const CrossingBranches& branches, const CrossingLandmarks& known) {
  std::vector<TracedPart> parts;
  std::vector<std::size_t> part_of;
  std::optional<std::size_t> crossing;
  for (const CrossingBranch& branch : branches.all) {
    const bool is_known = branch.multiplicity == 1 && crossing;
    part_of.push_back(is_known ? *crossing : parts.size());
    if (branch.multiplicity == 1) crossing = part_of.back();
    if (!is_known) parts.push_back({{branch.f, branch.g, {}, known.extent, known.tolerance}, {}});
  }
  for (std::size_t i = 0; i < known.landmarks.size(); ++i) {
    TracedPart& part = parts[part_of[known.landmarks[i].branch]];
    part.problem.landmarks.push_back(known.landmarks[i].zero);
    part.landmarks.push_back(i);
  }
  return parts;
}

struct TracedCurve {
  const CrossingBranches& branches;
  const std::vector<CrossingBound>& bounds;
  const SurfaceRegion& region;
  const CrossingLandmarks& known;
};

std::vector<std::size_t> bounds_at(const TracedCurve& of, const LandmarkStar& star) {
  std::vector<std::size_t> at;
  for (std::size_t i = 0; i < star.signs.size(); ++i)
    if (star.signs[i] == 0 && star.where_signs[i] >= 0 && !of.region.bounds[i].name.empty()) at.push_back(i);
  return at;
}

/// Whether the bound is 0 in the landmark, as its branch lies on the bound or passes it there.
bool is_on_bound(const TracedCurve& of, const CrossingLandmark& landmark, std::size_t bound) {
  const bool passes = landmark.kind == LandmarkKind::passage && landmark.bound == bound;
  return passes || of.bounds[bound].norms[landmark.branch].is_zero();
}

/// Of a bound, or of its `where`.
int certain(int sign) {
  if (sign == 0) throw ProofFailure(whole_domain(), "a point is too near to a bound, or to its end");
  return sign;
}

std::vector<std::size_t> bounds_at(const TracedCurve& of, const CrossingLandmark& landmark) {
  std::vector<std::size_t> at;
  for (std::size_t i = 0; i < of.bounds.size(); ++i)
    if (!of.region.bounds[i].name.empty() && is_on_bound(of, landmark, i) &&
        certain(sign_on(of.bounds[i].where, landmark.zero)) > 0)
      at.push_back(i);
  return at;
}

/// The nodes of all stars, then those of other landmarks, without degrees; `node_of` of every landmark.
std::vector<CrossingNode> nodes_of(const TracedCurve& of, std::vector<std::size_t>& node_of) {
  std::vector<CrossingNode> nodes;
  for (const LandmarkStar& star : of.known.stars)
    nodes.push_back({star.point, false, star.is_singular, 0, bounds_at(of, star)});
  for (const CrossingLandmark& landmark : of.known.landmarks) {
    node_of.push_back(landmark.star.value_or(nodes.size()));
    if (landmark.star) continue;
    nodes.push_back(node_at(landmark));
    nodes.back().bounds = bounds_at(of, landmark);
  }
  return nodes;
}

/// Of the bounds along the arc that leaves a landmark in a sense; 0 for those that it lies on.
std::vector<int> signs_along(const TracedCurve& of, const CrossingLandmark& from, int sense) {
  const CrossingBranch& branch = of.branches.all[from.branch];
  std::vector<int> signs;
  for (std::size_t i = 0; i < of.bounds.size(); ++i) {
    const SpacePolynomial& form = of.bounds[i].form;
    if (of.bounds[i].norms[from.branch].is_zero())
      signs.push_back(0);
    else if (is_on_bound(of, from, i))
      signs.push_back(certain(orientation_on({branch.f, branch.g, form}, from.zero) * sense));
    else
      signs.push_back(certain(sign_on(form, from.zero)));
  }
  return signs;
}

/// Leaves the nodes that end arcs, and centres of stars in the region.
void drop_other_nodes(CrossingCurve& curve, const TracedCurve& of) {
  for (const CrossingArc& arc : curve.arcs)
    for (const std::size_t end : {arc.from, arc.to}) ++curve.nodes[end].degree;
  std::vector<CrossingNode> nodes;
  std::vector<std::size_t> position;
  for (std::size_t i = 0; i < curve.nodes.size(); ++i) {
    position.push_back(nodes.size());
    const bool is_alone = i < of.known.stars.size() && is_in_region(of.region, of.known.stars[i].signs);
    if (is_alone || curve.nodes[i].degree > 0) nodes.push_back(std::move(curve.nodes[i]));
  }
  curve.nodes = std::move(nodes);
  for (CrossingArc& arc : curve.arcs) arc.from = position[arc.from], arc.to = position[arc.to];
}

CrossingCurve traced(const TracedCurve& of) {
  const CrossingLandmarks& known = of.known;
  CrossingCurve result;
  result.projection = of.branches.projection;
  for (const CrossingBranch& branch : of.branches.all) {
    result.factors.push_back(branch.shadow);
    result.forms.push_back({branch.f, branch.g});
  }
  std::vector<std::size_t> node_of;
  result.nodes = nodes_of(of, node_of);
  std::vector<int> arrivals(known.landmarks.size(), 0);
  for (const TracedPart& part : traced_parts(of.branches, known))
    for (std::size_t k = 0; k < part.landmarks.size(); ++k) {
      const std::size_t start = part.landmarks[k];
      const CrossingLandmark& from = known.landmarks[start];
      for (const int sense : upward_senses(from)) {
        SpaceTrace trace = space_trace(part.problem, k, sense);
        const std::size_t end = part.landmarks[trace.end];
        ++arrivals[end];
        if (!is_in_region(of.region, signs_along(of, from, sense))) continue;
        const CrossingLandmark& to = known.landmarks[end];
        if (from.star) add_chord(trace, known.stars[*from.star], from.zero, true);
        if (to.star) add_chord(trace, known.stars[*to.star], to.zero, false);
        result.arcs.push_back({node_of[start], node_of[end], from.branch,
                               of.branches.all[from.branch].multiplicity, std::move(trace.points),
                               trace.error_bound, from.zero, sense});
      }
    }
  for (std::size_t i = 0; i < known.landmarks.size(); ++i)
    if (arrivals[i] != expected_arrivals(known.landmarks[i].kind))
      throw ProofFailure(whole_domain(), "the arcs of a curve in space do not fit together");
  drop_other_nodes(result, of);
  return result;
}

CrossingCurve left_open(std::string why) {
  CrossingCurve result;
  result.open = OpenQuestion{std::move(why), Reason::not_decided};
  return result;
}

/// The same for both orders of the surfaces.
bool is_first(const SpacePolynomial& f, const SpacePolynomial& g) {
  if (f.degree() != g.degree()) return f.degree() > g.degree();
  return f.terms() < g.terms();
}

/// Those of the branches in the resultant of two polynomials with the same zeros.
void set_multiplicities(CrossingCurve& curve, const CrossingBranches& branches,
                        const SpaceProjection& projection) {
  const std::vector<BivariatePower> powers = irreducible_factors(projection.shadow);
  for (CrossingArc& arc : curve.arcs) {
    const auto power = std::ranges::find(powers, branches.all[arc.factor].shadow, &BivariatePower::factor);
    if (power == powers.end()) throw ProofFailure(whole_domain(), "a curve is not in a resultant");
    arc.multiplicity = power->multiplicity;
  }
}

/// Of polynomials without a common factor.
CrossingCurve curve_of_coprime(const SpacePolynomial& whole_f, const SpacePolynomial& whole_g,
                               const SurfaceRegion& region, const std::function<double(double)>& tolerance) {
  const SpacePolynomial f = squarefree_part(whole_f).primitive(), g = squarefree_part(whole_g).primitive();
  std::string why = "no frame in general position";
  int tried = 0;
  for (int attempt = 0; attempt < general_frames && tried < 3; ++attempt) {
    const std::optional<SpaceProjection> projection = space_projection(f, g, general_frame(attempt));
    if (!projection) continue;
    if (projection->shadow.degree_s() < 1) return {};
    ++tried;
    std::optional<CrossingBranches> branches = crossing_branches(f, g, *projection);
    if (!branches) {
      why = "both surfaces are singular along a common curve, it seems";
      continue;
    }
    const std::vector<CrossingBound> bounds = crossing_bounds(*branches, region);
    CrossingLandmarks landmarks = crossing_landmarks(*branches, bounds, tolerance);
    if (landmarks.asks_for_quadratic && g.degree() > 1) {
      branches->projection.quadratic = space_quadratic(f, g, projection->frame);
      landmarks = crossing_landmarks(*branches, bounds, tolerance);
    }
    if (landmarks.obstacle.empty()) {
      CrossingCurve curve = traced({*branches, bounds, region, landmarks});
      if (!(f == whole_f && g == whole_g))
        set_multiplicities(curve, *branches,
                           space_projection(whole_f, whole_g, general_frame(attempt)).value());
      return curve;
    }
    why = landmarks.obstacle;
  }
  return left_open(why);
}

}  // namespace

CrossingCurve crossing_curve(const SpacePolynomial& first, const SpacePolynomial& second,
                             const SurfaceRegion& region, const std::function<double(double)>& tolerance) {
  const SpacePolynomial common = common_factor(first, second);
  SpacePolynomial f = exact_quotient(first, common).primitive(),
                  g = exact_quotient(second, common).primitive();
  if (!is_first(f, g)) std::swap(f, g);
  lower_degrees(f, g);
  CrossingCurve curve;
  if (g.degree() > 0) curve = curve_of_coprime(f, g.primitive(), region, tolerance);
  curve.is_same = common.degree() > 0;
  return curve;
}

}  // namespace exsect
