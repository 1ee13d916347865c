#include "lift/crossing_landmarks.h"

#include <exsect/algebra/bivariate_factors.h>
#include <exsect/algebra/interruption.h>
#include <exsect/algebra/real_algebraic.h>
#include <exsect/geometry/beyond_doubles.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "lift/root_interval.h"

namespace exsect {
namespace {

/// About where a landmark is.
struct Guess {
  Point place;
  LandmarkKind kind;
  RationalInterval heights;  // of u: no other landmark of its system is over it
  std::optional<std::size_t> star;
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

class LandmarkSearch {
 public:
  LandmarkSearch(const SpacePolynomial& f, const SpacePolynomial& g, const SpaceProjection& projection,
                 const Polynomial& norm)
      : f_(f), g_(g), projection_(projection), range_(fitted_interval({norm})) {
    const Point& height = projection_.frame.height;
    turning_ = turning_form(f, g, height);
    for (std::size_t k = 0; k < 3; ++k) height_ += height[k] * SpacePolynomial::variable(k);
    for (BivariatePower& power : irreducible_factors(projection_.shadow))
      factors_.push_back(std::move(power.factor));
    while (!is_squarefree(projection_.shadow.at_r(range_.lower))) range_.lower -= range_.width() / 64;
    while (!is_squarefree(projection_.shadow.at_r(range_.upper))) range_.upper += range_.width() / 64;
    values_ = turning_values(norm, range_);
  }

  CrossingLandmarks run(const std::function<double(double)>& tolerance) {
    add_ends(range_.lower, LandmarkKind::entry);
    add_ends(range_.upper, LandmarkKind::exit);
    for (const TurningValue& value : values_) {
      if (value.is_simple && !add_turning_point(value))
        return with_obstacle("turning points of the curve are not proved");
      if (!value.is_simple && !add_centres(value))
        return with_obstacle("both surfaces are singular in a common point, it seems");
    }
    if (guesses_.empty() && result_.stars.empty()) return std::move(result_);
    result_.extent = extent_of_guesses();
    result_.tolerance = tolerance(result_.extent);
    for (std::size_t i = 0; i < centres_.size(); ++i) add_star(i);
    const double radius = std::ldexp(1.0, std::ilogb(result_.extent) - 90);
    for (const Guess& guess : guesses_)
      if (!add_landmark(guess, radius)) return with_obstacle("ends of arcs are not proved");
    if (!ends_are_apart()) return with_obstacle("ends of arcs are not apart");
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

  std::vector<Rational> roots_near(const Polynomial& in_v) const {
    std::vector<Rational> result;
    if (in_v.degree() < 1) return result;
    const Rational beyond = above_all_roots(in_v);
    for (const RealAlgebraic& v : real_roots(in_v, -beyond, beyond))
      result.push_back(v.refined_to(beyond * fine_).interval().midpoint());
    return result;
  }

  /// All points over u, where the shadow's are simple.
  void add_ends(const Rational& u, LandmarkKind kind) {
    for (const Rational& v : roots_near(projection_.shadow.at_r(u)))
      guesses_.push_back({lifted(u, v).value_or(Point{}), kind, {u, u}, {}});
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

  void add_star(std::size_t i) {
    const auto& [centre, free] = centres_[i];
    const CrossingStar star = crossing_star(projection_, centre, free, from_double(result_.tolerance) / 4);
    for (const bool on_right : {false, true}) {
      const Rational& u = on_right ? star.window.upper : star.window.lower;
      for (const Rational& v : on_right ? star.right : star.left)
        guesses_.push_back(
            {lifted(u, v).value_or(Point{}), on_right ? LandmarkKind::entry : LandmarkKind::exit, {u, u}, i});
    }
    result_.stars[i].star = star;
  }

  /// False if it is not proved.
  bool add_landmark(const Guess& guess, double radius) {
    const std::optional<SpaceZero> zero = proved(guess, radius);
    if (!zero) return false;
    const std::optional<std::size_t> factor = factor_at(*zero);
    const int upward = is_end(guess.kind) ? sign_on(turning_, *zero) : 0;
    if (!factor || (is_end(guess.kind) && upward == 0)) return false;
    result_.landmarks.push_back({*zero, guess.kind, guess.star, *factor, upward});
    return true;
  }

  /// The only factor of the shadow that may vanish below the point.
  std::optional<std::size_t> factor_at(const SpaceZero& zero) const {
    std::optional<std::size_t> only;
    const RationalInterval u = range_on(zero, projection_.frame.height), v = range_on(zero, along_v());
    for (std::size_t i = 0; i < factors_.size(); ++i) {
      if (factors_.size() > 1 && has_no_zero_on(factors_[i], u, v)) continue;
      if (only) return std::nullopt;
      only = i;
    }
    return only;
  }

  /// The point over a simple root of E: next to it a zero of the shadow's derivative by v, and nearly one of
  /// the shadow.
  bool add_turning_point(const TurningValue& value) {
    const Rational u = value.u.refined_to(range_.width() * fine_).interval().midpoint();
    const Polynomial over = projection_.shadow.at_r(u);
    std::vector<Rational> places = roots_near(over.derivative());
    std::ranges::sort(places, {}, [&](const Rational& v) -> Rational { return abs(over(v)); });
    for (std::size_t k = 0; k < std::min<std::size_t>(places.size(), 3); ++k) {
      const std::optional<Point> guess = lifted(u, places[k]);
      if (!guess) continue;
      Guess landmark{*guess, LandmarkKind::lowest, value.free, {}};
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
    if (!is_end(guess.kind)) return {f_, g_, turning_};
    return {f_, g_, height_ - SpacePolynomial::constant(guess.heights.lower)};
  }

  /// Whose u is in its interval, or v in the strip of its star.
  std::optional<SpaceZero> proved(const Guess& guess, double radius) const {
    if (!(radius > 0x1p-900 && radius < 0x1p900)) return std::nullopt;
    std::optional<SpaceZero> zero = space_zero(system_of(guess), guess.place, radius);
    if (!zero || (is_end(guess.kind) && !guess.star)) return zero;
    const RationalInterval range = range_on(*zero, guess.star ? along_v() : projection_.frame.height);
    const RationalInterval& known = guess.star ? result_.stars[*guess.star].star.strip : guess.heights;
    return known.lower < range.lower && range.upper < known.upper ? zero : std::nullopt;
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
    for (const Guess& guess : guesses_) points.push_back(guess.place);
    for (const LandmarkStar& star : result_.stars)
      points.push_back({star.point[0].midpoint(), star.point[1].midpoint(), star.point[2].midpoint()});
    double extent = 0;
    for (const Point& point : points)
      for (std::size_t k = 0; k < 3; ++k)
        extent = std::max(extent, std::fabs(to_double(point[k] - points[0][k])));
    if (points.size() == 1) extent = to_double(range_.width());
    if (!(extent > 0x1p-800 && extent < 0x1p800))
      throw BeyondDoubles("the common points must lie in the range of doubles");
    return extent;
  }

  /// As many as there are, therefore all.
  bool ends_are_apart() const {
    const std::vector<CrossingLandmark>& all = result_.landmarks;
    for (std::size_t i = 0; i < all.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) {
        if (all[i].kind != all[j].kind || !is_end(all[i].kind)) continue;
        Rational distance = 0;
        for (std::size_t k = 0; k < 3; ++k)
          distance = std::max<Rational>(distance, abs(all[i].zero.centre[k] - all[j].zero.centre[k]));
        if (distance <= from_double(all[i].zero.radius) + from_double(all[j].zero.radius)) return false;
      }
    return true;
  }

  static inline const Rational fine_ = power_of_two(-240);

  const SpacePolynomial& f_;
  const SpacePolynomial& g_;
  const SpaceProjection& projection_;
  RationalInterval range_;
  SpacePolynomial turning_;  // J
  SpacePolynomial height_;   // u
  std::vector<BivariatePolynomial> factors_;
  std::vector<TurningValue> values_;
  std::vector<std::pair<CrossingCentre, RationalInterval>> centres_;  // and their u's free intervals
  std::vector<Guess> guesses_;
  CrossingLandmarks result_;
};

}  // namespace

CrossingLandmarks crossing_landmarks(const SpacePolynomial& f, const SpacePolynomial& g,
                                     const SpaceProjection& projection, const Polynomial& norm,
                                     const std::function<double(double)>& tolerance) {
  if (norm.is_zero()) throw std::domain_error("crossing_landmarks: the shadow has a multiple factor");
  return LandmarkSearch(f, g, projection, norm).run(tolerance);
}

}  // namespace exsect
