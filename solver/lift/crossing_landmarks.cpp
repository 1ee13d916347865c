#include "lift/crossing_landmarks.h"

#include <exsect/algebra/interruption.h>
#include <exsect/algebra/real_algebraic.h>
#include <exsect/geometry/beyond_doubles.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "lift/root_interval.h"

namespace exsect {
namespace {

Point middle_of(const CrossingBox& box) { return {box[0].midpoint(), box[1].midpoint(), box[2].midpoint()}; }

/// A landmark that is still to be enclosed in a cube.
struct Guess {
  CrossingBox box;  // which an end is in; about the place of a turning point
  LandmarkKind kind;
  RationalInterval heights;  // of u: no other turning point is over it, and no other number for ends
  std::size_t branch;
  std::optional<std::size_t> star = {};
};

bool is_end(LandmarkKind kind) { return kind == LandmarkKind::entry || kind == LandmarkKind::exit; }

/// A real root of E, and a closed interval around it without another one.
struct TurningValue {
  RealAlgebraic u;
  bool is_simple;
  RationalInterval free;
};

/// The real roots of E in an open interval, ascending.
std::vector<TurningValue> turning_values(const Polynomial& norm, const RationalInterval& range) {
  std::vector<TurningValue> values;
  if (norm.degree() < 1) return values;
  for (const PolynomialPower& power : squarefree_factors(norm))
    for (const PolynomialPower& part :
         power.multiplicity > 1 ? irreducible_factors(power.factor) : std::vector<PolynomialPower>{power})
      for (RealAlgebraic& u : real_roots(part.factor, range.lower, range.upper))
        values.push_back({std::move(u), power.multiplicity == 1, range});
  std::ranges::sort(values, {}, &TurningValue::u);
  for (std::size_t i = 0; i + 1 < values.size(); ++i) {
    RealAlgebraic &u = values[i].u, &next = values[i + 1].u;
    for (Rational width = range.width() / 1024; !(u.interval().upper < next.interval().lower);
         width /= 1024) {
      interruption_point();
      u = u.refined_to(width);
      next = next.refined_to(width);
    }
  }
  for (std::size_t i = 0; i + 1 < values.size(); ++i)
    values[i].free.upper = values[i + 1].free.lower =
        (values[i].u.interval().upper + values[i + 1].u.interval().lower) / 2;
  return values;
}

/// Over u every zero of the shadow is simple, with one common point, by (17.15).
bool is_general_over(const SpaceProjection& projection, const Rational& u) {
  const Polynomial over = projection.shadow.at_r(u);
  return is_squarefree(over) && gcd(over, projection.slope.at_r(u)).degree() == 0;
}

class LandmarkSearch {
 public:
  explicit LandmarkSearch(const CrossingBranches& branches)
      : branches_(branches), projection_(branches.projection), range_(fitted_interval({branches.norm})) {
    while (!is_general_over(projection_, range_.lower)) range_.lower -= range_.width() / 64;
    while (!is_general_over(projection_, range_.upper)) range_.upper += range_.width() / 64;
    values_ = turning_values(branches.norm, range_);
  }

  CrossingLandmarks run(const std::function<double(double)>& tolerance) {
    if (!add_ends(range_.lower, LandmarkKind::entry) || !add_ends(range_.upper, LandmarkKind::exit))
      return with_obstacle("where the curve goes on to infinity is not proved");
    for (const TurningValue& value : values_) {
      if (value.is_simple && !add_turning_point(value))
        return with_obstacle("turning points of the curve are not proved");
      if (!value.is_simple && !add_centres(value))
        return with_obstacle("both surfaces are singular in a common point, it seems");
    }
    if (guesses_.empty() && result_.stars.empty()) return std::move(result_);
    result_.extent = extent_of_guesses();
    result_.tolerance = tolerance(result_.extent);
    for (std::size_t i = 0; i < centres_.size(); ++i)
      if (!add_star(i)) return with_obstacle("arcs at a singular point are not proved");
    const double radius = std::ldexp(1.0, std::ilogb(result_.extent) - 90);
    for (const Guess& guess : guesses_)
      if (!add_landmark(guess, radius)) return with_obstacle("ends of arcs are not proved");
    return std::move(result_);
  }

 private:
  static CrossingLandmarks with_obstacle(std::string why) { return {.obstacle = std::move(why)}; }

  /// The point over (u,v), about.
  std::optional<Point> lifted(const Rational& u, const Rational& v) const {
    const Rational slope = projection_.slope(u, v);
    if (slope == 0) return std::nullopt;
    return projection_.frame.point(u, v, -projection_.offset(u, v) / slope);  // (17.15)
  }

  /// Intervals around the zeros of a polynomial, of those in a strip if one is given.
  static std::vector<RationalInterval> enclosed_roots(const Polynomial& in_v,
                                                      const RationalInterval* strip = nullptr) {
    std::vector<RationalInterval> result;
    if (in_v.degree() < 1) return result;
    const Rational beyond = above_all_roots(in_v);
    const RationalInterval range = strip ? *strip : RationalInterval{-beyond, beyond};
    for (const RealAlgebraic& v : real_roots(in_v, range.lower, range.upper))
      result.push_back(v.refined_to(beyond * fine_).interval());
    return result;
  }

  /// All points over u, or those in the strip of a star whose window ends there; false if one is not found.
  bool add_ends(const Rational& u, LandmarkKind kind, std::optional<std::size_t> star = {}) {
    const RationalInterval* strip = star ? &result_.stars[*star].star.strip : nullptr;
    for (std::size_t branch = 0; branch < branches_.all.size(); ++branch)
      for (const RationalInterval& v : enclosed_roots(branches_.all[branch].shadow.at_r(u), strip)) {
        const std::optional<CrossingBox> box = box_over(projection_, {u, u}, v);
        if (!box) return false;
        guesses_.push_back({*box, kind, {u, u}, branch, star});
      }
    return true;
  }

  bool add_centres(const TurningValue& value) {
    const auto centres = centres_over(projection_, value.u);
    if (!centres) return false;
    for (const CrossingCentre& centre : *centres) {
      centres_.emplace_back(centre, value.free);
      result_.stars.push_back({{}, fine_box(centre), centre.is_singular});
    }
    return true;
  }

  /// Of the point alone.
  CrossingBox fine_box(const CrossingCentre& centre) const {
    for (Rational width = range_.width() * power_of_two(-100);; width *= width) {
      interruption_point();
      const TriangularPoint below = centre.below.refined_to(width);
      if (const auto box = box_over(projection_, below.s().refined_to(width).interval(), below.r_interval()))
        return *box;
    }
  }

  bool add_star(std::size_t i) {
    const auto& [centre, free] = centres_[i];
    result_.stars[i].star = crossing_star(projection_, centre, free, from_double(result_.tolerance) / 4);
    const RationalInterval& window = result_.stars[i].star.window;
    return add_ends(window.lower, LandmarkKind::exit, i) && add_ends(window.upper, LandmarkKind::entry, i);
  }

  /// False if it is not proved.
  bool add_landmark(const Guess& guess, double radius) {
    const std::optional<SpaceZero> zero = proved(guess, radius);
    if (!zero) return false;
    const int upward = is_end(guess.kind) ? sign_on(branches_.all[guess.branch].rate, *zero) : 0;
    if (is_end(guess.kind) && upward == 0) return false;
    const std::optional<std::size_t> branch = is_end(guess.kind) ? guess.branch : branch_at(*zero);
    if (!branch) return false;
    result_.landmarks.push_back({*zero, guess.kind, guess.star, *branch, upward});
    return true;
  }

  /// The only one along which the surfaces cross that may pass through the point.
  std::optional<std::size_t> branch_at(const SpaceZero& zero) const {
    std::optional<std::size_t> only;
    const RationalInterval u = range_on(zero, projection_.frame.height), v = range_on(zero, along_v());
    for (std::size_t i = 0; i < branches_.all.size(); ++i) {
      const CrossingBranch& branch = branches_.all[i];
      if (branch.multiplicity > 1) continue;
      if (branches_.all.size() > 1 && has_no_zero_on(branch.shadow, u, v)) continue;
      if (only) return std::nullopt;
      only = i;
    }
    return only;
  }

  /// The point over a simple root of E: next to it a zero of the shadow's derivative by v, and nearly one of
  /// the shadow.
  bool add_turning_point(const TurningValue& value) {
    const auto crossing = std::ranges::find(branches_.all, 1, &CrossingBranch::multiplicity);
    if (crossing == branches_.all.end()) return false;
    const auto branch = static_cast<std::size_t>(crossing - branches_.all.begin());
    const Rational u = value.u.refined_to(range_.width() * fine_).interval().midpoint();
    const Polynomial over = projection_.shadow.at_r(u);
    std::vector<RationalInterval> places = enclosed_roots(over.derivative());
    std::ranges::sort(places, {},
                      [&](const RationalInterval& v) -> Rational { return abs(over(v.midpoint())); });
    for (std::size_t k = 0; k < std::min<std::size_t>(places.size(), 3); ++k) {
      const std::optional<Point> place = lifted(u, places[k].midpoint());
      if (!place) continue;
      Guess landmark{{RationalInterval{(*place)[0], (*place)[0]},
                      {(*place)[1], (*place)[1]},
                      {(*place)[2], (*place)[2]}},
                     LandmarkKind::lowest,
                     value.free,
                     branch};
      const std::optional<SpaceZero> zero = proved(landmark, to_double(value.free.width()) * 0x1p-40);
      if (!zero) continue;
      const int bend = orientation_on(system_of(landmark), *zero);
      if (bend == 0) continue;
      if (bend < 0) landmark.kind = LandmarkKind::highest;
      guesses_.push_back(std::move(landmark));
      return true;
    }
    return false;
  }

  SpaceSystem system_of(const Guess& guess) const {
    const CrossingBranch& branch = branches_.all[guess.branch];
    if (!is_end(guess.kind)) return {branch.f, branch.g, branch.rate};
    SpacePolynomial plane = SpacePolynomial::constant(-guess.heights.lower);
    for (std::size_t k = 0; k < 3; ++k) plane += projection_.frame.height[k] * SpacePolynomial::variable(k);
    return {branch.f, branch.g, plane};
  }

  /// A turning point with its u in the interval; an end with its box in the cube.
  std::optional<SpaceZero> proved(const Guess& guess, double radius) const {
    if (!(radius > 0x1p-900 && radius < 0x1p900)) return std::nullopt;
    std::optional<SpaceZero> zero = space_zero(system_of(guess), middle_of(guess.box), radius);
    if (!zero) return zero;
    if (!is_end(guess.kind)) {
      const RationalInterval u = range_on(*zero, projection_.frame.height);
      return guess.heights.lower < u.lower && u.upper < guess.heights.upper ? zero : std::nullopt;
    }
    for (std::size_t k = 0; k < 3; ++k)
      if (guess.box[k].lower < zero->centre[k] - from_double(radius) ||
          zero->centre[k] + from_double(radius) < guess.box[k].upper)
        return std::nullopt;
    return zero;
  }

  /// v = along_v . P.
  Point along_v() const { return cross(projection_.frame.columns[2], projection_.frame.columns[0]); }

  /// Of a linear form on a cube.
  static RationalInterval range_on(const SpaceZero& zero, const Point& form) {
    const Rational spread = (abs(form[0]) + abs(form[1]) + abs(form[2])) * from_double(zero.radius);
    const Rational at = dot(form, zero.centre);
    return {at - spread, at + spread};
  }

  /// About the size of all; of a single point that of the interval of u.
  double extent_of_guesses() const {
    std::vector<Point> points;
    for (const Guess& guess : guesses_) points.push_back(middle_of(guess.box));
    for (const LandmarkStar& star : result_.stars) points.push_back(middle_of(star.point));
    double extent = 0;
    for (const Point& point : points)
      for (std::size_t k = 0; k < 3; ++k)
        extent = std::max(extent, std::fabs(to_double(point[k] - points[0][k])));
    if (points.size() == 1) extent = to_double(range_.width());
    if (!(extent > 0x1p-800 && extent < 0x1p800))
      throw BeyondDoubles("the common points must lie in the range of doubles");
    return extent;
  }

  static inline const Rational fine_ = power_of_two(-240);

  const CrossingBranches& branches_;
  const SpaceProjection& projection_;
  RationalInterval range_;
  std::vector<TurningValue> values_;
  std::vector<std::pair<CrossingCentre, RationalInterval>> centres_;  // and their u's free intervals
  std::vector<Guess> guesses_;
  CrossingLandmarks result_;
};

}  // namespace

CrossingLandmarks crossing_landmarks(const CrossingBranches& branches,
                                     const std::function<double(double)>& tolerance) {
  return LandmarkSearch(branches).run(tolerance);
}

}  // namespace exsect
