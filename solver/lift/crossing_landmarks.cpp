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
  RationalInterval
      heights;  // of u: no other turning point or passage is over it, and no other number for ends
  std::size_t branch;
  std::optional<std::size_t> star = {};
  std::size_t bound = 0;
};

bool is_end(LandmarkKind kind) { return kind == LandmarkKind::entry || kind == LandmarkKind::exit; }

/// A norm, and what is over its simple roots: turning points, or passages of one bound on one branch.
struct LandmarkSource {
  Polynomial norm;
  LandmarkKind kind;
  std::size_t branch = 0;
  std::size_t bound = 0;
};

std::vector<LandmarkSource> landmark_sources(const CrossingBranches& branches,
                                             const std::vector<CrossingBound>& bounds) {
  std::vector<LandmarkSource> sources = {{branches.norm, LandmarkKind::lowest}};
  for (std::size_t bound = 0; bound < bounds.size(); ++bound)
    for (std::size_t branch = 0; branch < branches.all.size(); ++branch) {
      const Polynomial& norm = bounds[bound].norms[branch];
      if (norm.is_zero()) continue;
      sources.push_back({branches.all[branch].multiplicity == 1 ? norm : norm * norm, LandmarkKind::passage,
                         branch, bound});
    }
  return sources;
}

/// A real root of the product of the norms, and a closed interval around it without another one.
struct TurningValue {
  RealAlgebraic u;
  std::optional<std::size_t> source;  // of a simple one
  RationalInterval free;
};

/// The real roots of the product in an open interval, ascending.
std::vector<TurningValue> turning_values(const std::vector<LandmarkSource>& sources,
                                         const Polynomial& product, const RationalInterval& range) {
  std::vector<TurningValue> values;
  if (product.degree() < 1) return values;
  const auto add_roots = [&](const Polynomial& f, std::optional<std::size_t> source) {
    for (RealAlgebraic& u : real_roots(f, range.lower, range.upper))
      values.push_back({std::move(u), source, range});
  };
  for (const PolynomialPower& power : squarefree_factors(product)) {
    if (power.multiplicity > 1)
      for (const PolynomialPower& part : irreducible_factors(power.factor)) add_roots(part.factor, {});
    else
      for (std::size_t i = 0; i < sources.size(); ++i)
        if (const Polynomial part = gcd(power.factor, sources[i].norm); part.degree() > 0) add_roots(part, i);
  }
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
  LandmarkSearch(const CrossingBranches& branches, const std::vector<CrossingBound>& bounds)
      : branches_(branches),
        bounds_(bounds),
        projection_(branches.projection),
        sources_(landmark_sources(branches, bounds)) {
    Polynomial product = 1;
    for (const LandmarkSource& source : sources_) product *= source.norm;
    range_ = fitted_interval({product});
    while (!is_general_over(projection_, range_.lower)) range_.lower -= range_.width() / 64;
    while (!is_general_over(projection_, range_.upper)) range_.upper += range_.width() / 64;
    values_ = turning_values(sources_, product, range_);
  }

  CrossingLandmarks run(const std::function<double(double)>& tolerance) {
    if (!add_ends(range_.lower, LandmarkKind::entry) || !add_ends(range_.upper, LandmarkKind::exit))
      return with_obstacle("where the curve goes on to infinity is not proved");
    for (const TurningValue& value : values_) {
      if (value.source && !add_simple(value))
        return with_obstacle("turning points of the curve are not proved");
      if (!value.source && !add_centres(value)) {
        CrossingLandmarks unknown = with_obstacle("both surfaces are singular in a common point, it seems");
        unknown.asks_for_quadratic = !projection_.quadratic;
        return unknown;
      }
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
    std::vector<BivariatePolynomial> forms;
    for (const CrossingBound& bound : bounds_) forms.push_back(bound.below);
    const auto centres = centres_over(projection_, value.u, forms);
    if (!centres) return false;
    for (const CrossingCentre& centre : *centres) {
      centres_.emplace_back(centre, value.free);
      LandmarkStar star{{}, fine_box(centre), centre.is_singular};
      for (const CrossingBound& bound : bounds_) {
        star.signs.push_back(sign_over(bound.below, centre.below));
        star.where_signs.push_back(sign_over(bound.where_below, centre.below));
      }
      result_.stars.push_back(std::move(star));
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
    const bool turns = guess.kind == LandmarkKind::lowest || guess.kind == LandmarkKind::highest;
    const int upward = turns ? 0 : sign_on(branches_.all[guess.branch].rate, *zero);
    if (!turns && upward == 0) return false;
    const std::optional<std::size_t> branch = turns ? branch_at(*zero) : guess.branch;
    if (!branch) return false;
    result_.landmarks.push_back({*zero, guess.kind, guess.star, *branch, upward, guess.bound});
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

  /// The point over a simple root.
  bool add_simple(const TurningValue& value) {
    const LandmarkSource& source = sources_[*value.source];
    const Rational u = value.u.refined_to(range_.width() * fine_).interval().midpoint();
    const bool is_passage = source.kind == LandmarkKind::passage;
    for (const Point& place : is_passage ? places_on_bound(source, u) : turning_places(u)) {
      Guess landmark{point_box(place), source.kind, value.free, source.branch, {}, source.bound};
      if (!is_passage) landmark.branch = crossing_branch();
      const int bend = bend_at(landmark, to_double(value.free.width()));
      if (bend == 0) continue;
      if (!is_passage && bend < 0) landmark.kind = LandmarkKind::highest;
      guesses_.push_back(std::move(landmark));
      return true;
    }
    return false;
  }

  /// The sign of the gradients' determinant in a turning point or passage; 0 if it is not proved. Where
  /// surfaces nearly touch it is that of a small number, on a small cube alone.
  int bend_at(const Guess& guess, double width) const {
    for (const double part : {0x1p-40, 0x1p-80, 0x1p-160}) {
      const std::optional<SpaceZero> zero = proved(guess, width * part);
      if (!zero) return 0;
      if (const int bend = orientation_on(system_of(guess), *zero); bend != 0) return bend;
    }
    return 0;
  }

  /// One along which the surfaces cross; a turning point over a simple root is on such a branch.
  std::size_t crossing_branch() const {
    const auto branch = std::ranges::find(branches_.all, 1, &CrossingBranch::multiplicity);
    return static_cast<std::size_t>(branch - branches_.all.begin());
  }

  /// Points over numbers v near u, those with the least values first, three at most.
  template <class Value>
  std::vector<Point> places_over(const Rational& u, const std::vector<RationalInterval>& numbers,
                                 Value value) const {
    std::vector<std::pair<Rational, Point>> places;
    for (const RationalInterval& v : numbers)
      if (const std::optional<Point> place = lifted(u, v.midpoint()))
        places.emplace_back(abs(value(v.midpoint(), *place)), *place);
    std::ranges::sort(places, {}, &std::pair<Rational, Point>::first);
    std::vector<Point> result;
    for (std::size_t k = 0; k < std::min<std::size_t>(places.size(), 3); ++k)
      result.push_back(places[k].second);
    return result;
  }

  /// Near zeros of the shadow's derivative by v, and of the shadow.
  std::vector<Point> turning_places(const Rational& u) const {
    const Polynomial over = projection_.shadow.at_r(u);
    return places_over(u, enclosed_roots(over.derivative()),
                       [&](const Rational& v, const Point&) { return over(v); });
  }

  std::vector<Point> places_on_bound(const LandmarkSource& source, const Rational& u) const {
    return places_over(u, enclosed_roots(branches_.all[source.branch].shadow.at_r(u)),
                       [&](const Rational&, const Point& p) { return bounds_[source.bound].form(p); });
  }

  static CrossingBox point_box(const Point& p) {
    return {RationalInterval{p[0], p[0]}, RationalInterval{p[1], p[1]}, RationalInterval{p[2], p[2]}};
  }

  SpaceSystem system_of(const Guess& guess) const {
    const CrossingBranch& branch = branches_.all[guess.branch];
    if (guess.kind == LandmarkKind::passage)
      return {branch.f, branch.g, bounds_[guess.bound].form};  // (17.20)
    if (!is_end(guess.kind)) return {branch.f, branch.g, branch.rate};
    SpacePolynomial plane = SpacePolynomial::constant(-guess.heights.lower);
    for (std::size_t k = 0; k < 3; ++k) plane += projection_.frame.height[k] * SpacePolynomial::variable(k);
    return {branch.f, branch.g, plane};
  }

  /// A turning point or passage with its u in the interval; an end with its box in the cube.
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
  const std::vector<CrossingBound>& bounds_;
  const SpaceProjection& projection_;
  std::vector<LandmarkSource> sources_;
  RationalInterval range_;
  std::vector<TurningValue> values_;
  std::vector<std::pair<CrossingCentre, RationalInterval>> centres_;  // and their u's free intervals
  std::vector<Guess> guesses_;
  CrossingLandmarks result_;
};

}  // namespace

CrossingLandmarks crossing_landmarks(const CrossingBranches& branches,
                                     const std::vector<CrossingBound>& bounds,
                                     const std::function<double(double)>& tolerance) {
  return LandmarkSearch(branches, bounds).run(tolerance);
}

}  // namespace exsect
