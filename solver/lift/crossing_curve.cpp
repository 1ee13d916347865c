#include "lift/crossing_curve.h"

#include <exsect/algebra/ball.h>
#include <exsect/algebra/interruption.h>
#include <exsect/algebra/real_algebraic.h>
#include <exsect/geometry/beyond_doubles.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "answer/parameter_box.h"
#include "answer/proof_failure.h"
#include "lift/connected_parts.h"
#include "lift/root_interval.h"
#include "lift/space_projection.h"
#include "lift/space_trace.h"

namespace exsect {
namespace {

enum class LandmarkKind { lowest, highest, entry, exit };

struct Landmark {
  Point guess;
  LandmarkKind kind;
  RationalInterval heights;  // of u: no other landmark of its system is over it
};

/// The real roots of E with closed intervals that are apart, each with half of the space to its neighbours.
std::vector<std::pair<RealAlgebraic, RationalInterval>> separated_roots(const Polynomial& norm,
                                                                        const RationalInterval& range) {
  std::vector<RealAlgebraic> roots =
      norm.degree() < 1 ? std::vector<RealAlgebraic>{} : real_roots(norm, range.lower, range.upper);
  for (std::size_t i = 0; i + 1 < roots.size(); ++i)
    for (Rational width = range.width() / 1024; !(roots[i].interval().upper < roots[i + 1].interval().lower);
         width /= 1024) {
      interruption_point();
      roots[i] = roots[i].refined_to(width);
      roots[i + 1] = roots[i + 1].refined_to(width);
    }
  std::vector<std::pair<RealAlgebraic, RationalInterval>> result;
  Rational lower = range.lower;
  for (std::size_t i = 0; i < roots.size(); ++i) {
    const Rational upper =
        i + 1 < roots.size() ? (roots[i].interval().upper + roots[i + 1].interval().lower) / 2 : range.upper;
    result.emplace_back(roots[i], RationalInterval{lower, upper});
    lower = upper;
  }
  return result;
}

/// Of a curve that is in general position to its frame.
class Crossing {
 public:
  Crossing(const SpacePolynomial& f, const SpacePolynomial& g, SpaceProjection projection,
           const Polynomial& norm)
      : projection_(std::move(projection)), problem_{f, g, {}, 0, 0} {
    const Point& height = projection_.frame.height;
    turning_ = turning_form(f, g, height);
    for (std::size_t k = 0; k < 3; ++k) height_ += height[k] * SpacePolynomial::variable(k);
    range_ = fitted_interval({norm});
    while (!is_simple_over(range_.lower)) range_.lower -= range_.width() / 64;
    while (!is_simple_over(range_.upper)) range_.upper += range_.width() / 64;
    roots_ = separated_roots(norm, range_);
  }

  /// False if a landmark is not found or not proved.
  bool find_landmarks() {
    add_ends(range_.lower, LandmarkKind::entry);
    add_ends(range_.upper, LandmarkKind::exit);
    for (std::size_t i = 0; i < roots_.size(); ++i)
      if (!add_turning_point(i)) return false;
    if (landmarks_.empty()) return true;
    problem_.extent = extent_of_guesses();
    const double radius = std::ldexp(1.0, std::ilogb(problem_.extent) - 90);
    for (Landmark& landmark : landmarks_) {
      const std::optional<SpaceZero> zero = proved(landmark, radius);
      if (!zero) return false;
      problem_.landmarks.push_back(*zero);
    }
    return ends_are_apart();
  }

  CrossingCurve traced(const std::function<double(double)>& tolerance) {
    CrossingCurve result;
    if (landmarks_.empty()) return result;
    problem_.tolerance = tolerance(problem_.extent);
    for (std::size_t i = 0; i < landmarks_.size(); ++i) {
      CrossingNode node{{}, is_end(landmarks_[i].kind)};
      const Rational radius = from_double(problem_.landmarks[i].radius);
      for (std::size_t k = 0; k < 3; ++k) {
        const Rational& at = problem_.landmarks[i].centre[k];
        node.box[k] = {at - radius, at + radius};
      }
      result.nodes.push_back(std::move(node));
    }
    std::vector<int> arrivals(landmarks_.size(), 0);
    for (std::size_t i = 0; i < landmarks_.size(); ++i)
      for (const int sense : upward_senses(i)) {
        SpaceTrace trace = space_trace(problem_, i, sense);
        ++arrivals[trace.end];
        result.arcs.push_back({i, trace.end, 0, std::move(trace.points), trace.error_bound});
      }
    for (std::size_t i = 0; i < landmarks_.size(); ++i)
      if (arrivals[i] != expected_arrivals(landmarks_[i].kind))
        throw ProofFailure(whole_domain(), "the arcs of a curve in space do not fit together");
    return result;
  }

 private:
  static bool is_end(LandmarkKind kind) { return kind == LandmarkKind::entry || kind == LandmarkKind::exit; }
  static int expected_arrivals(LandmarkKind kind) {
    return kind == LandmarkKind::highest ? 2 : kind == LandmarkKind::exit ? 1 : 0;
  }

  bool is_simple_over(const Rational& u) const {
    return projection_.shadow.degree_s() < 1 || is_squarefree(projection_.shadow.at_r(u));
  }

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
      landmarks_.push_back({lifted(u, v).value_or(Point{}), kind, {u, u}});
  }

  /// The point over a simple root of E: next to it a zero of the shadow's derivative by v, and nearly one of
  /// the shadow.
  bool add_turning_point(std::size_t i) {
    const auto& [root, window] = roots_[i];
    const Rational u = root.refined_to(range_.width() * fine_).interval().midpoint();
    const Polynomial over = projection_.shadow.at_r(u);
    std::vector<Rational> places = roots_near(over.derivative());
    std::ranges::sort(places, {}, [&](const Rational& v) -> Rational { return abs(over(v)); });
    for (std::size_t k = 0; k < std::min<std::size_t>(places.size(), 3); ++k) {
      const std::optional<Point> guess = lifted(u, places[k]);
      if (!guess) continue;
      Landmark landmark{*guess, LandmarkKind::lowest, window};
      const std::optional<SpaceZero> zero = proved(landmark, to_double(window.width()) * 0x1p-40);
      if (!zero) continue;
      const int bend = orientation_on(system_of(landmark), *zero);
      if (bend == 0) continue;
      if (bend < 0) landmark.kind = LandmarkKind::highest;
      landmarks_.push_back(std::move(landmark));
      return true;
    }
    return false;
  }

  SpaceSystem system_of(const Landmark& landmark) const {
    if (!is_end(landmark.kind)) return {problem_.f, problem_.g, turning_};
    return {problem_.f, problem_.g, height_ - SpacePolynomial::constant(landmark.heights.lower)};
  }

  /// Whose u is in its interval.
  std::optional<SpaceZero> proved(const Landmark& landmark, double radius) const {
    if (!(radius > 0x1p-900 && radius < 0x1p900)) return std::nullopt;
    std::optional<SpaceZero> zero = space_zero(system_of(landmark), landmark.guess, radius);
    if (!zero || is_end(landmark.kind)) return zero;
    const Point& height = projection_.frame.height;
    const Rational spread = (abs(height[0]) + abs(height[1]) + abs(height[2])) * from_double(zero->radius);
    const Rational u = dot(height, zero->centre);
    const bool is_over = landmark.heights.lower < u - spread && u + spread < landmark.heights.upper;
    return is_over ? zero : std::nullopt;
  }

  double extent_of_guesses() const {
    double extent = 0;
    for (const Landmark& landmark : landmarks_)
      for (std::size_t k = 0; k < 3; ++k)
        extent = std::max(extent, std::fabs(to_double(landmark.guess[k] - landmarks_[0].guess[k])));
    if (!(extent > 0x1p-800 && extent < 0x1p800))
      throw BeyondDoubles("the common points must lie in the range of doubles");
    return extent;
  }

  /// As many as there are, therefore all.
  bool ends_are_apart() const {
    for (std::size_t i = 0; i < landmarks_.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) {
        if (landmarks_[i].kind != landmarks_[j].kind || !is_end(landmarks_[i].kind)) continue;
        const SpaceZero &a = problem_.landmarks[i], &b = problem_.landmarks[j];
        Rational distance = 0;
        for (std::size_t k = 0; k < 3; ++k)
          distance = std::max<Rational>(distance, abs(a.centre[k] - b.centre[k]));
        if (distance <= from_double(a.radius) + from_double(b.radius)) return false;
      }
    return true;
  }

  /// Along grad F x grad G, or against it, u grows from the landmark on.
  std::vector<int> upward_senses(std::size_t i) const {
    if (landmarks_[i].kind == LandmarkKind::lowest) return {1, -1};
    if (landmarks_[i].kind != LandmarkKind::entry) return {};
    const int sense = sign_on(turning_, problem_.landmarks[i]);
    if (sense == 0) throw ProofFailure(whole_domain(), "where a curve in space enters is not known");
    return {sense};
  }

  static inline const Rational fine_ = power_of_two(-240);

  SpaceProjection projection_;
  SpacePolynomial turning_;  // J
  SpacePolynomial height_;   // u
  RationalInterval range_{0, 0};
  std::vector<std::pair<RealAlgebraic, RationalInterval>> roots_;
  std::vector<Landmark> landmarks_;
  TraceProblem problem_;
};

CrossingCurve left_open(std::string why) {
  CrossingCurve result;
  result.open = OpenQuestion{std::move(why), Reason::not_decided};
  return result;
}

/// E has a real root that is not simple, as it has at every real point in which the surfaces touch.
bool has_multiple_real_root(const Polynomial& norm) {
  for (const PolynomialPower& power : squarefree_factors(norm)) {
    const Rational beyond = above_all_roots(power.factor);
    if (power.multiplicity > 1 && !real_roots(power.factor, -beyond, beyond).empty()) return true;
  }
  return false;
}

/// The same for both orders of the surfaces.
bool is_first(const SpacePolynomial& f, const SpacePolynomial& g) {
  if (f.degree() != g.degree()) return f.degree() > g.degree();
  return f.terms() < g.terms();
}

}  // namespace

CrossingCurve crossing_curve(const SpacePolynomial& first, const SpacePolynomial& second,
                             const std::function<double(double)>& tolerance) {
  SpacePolynomial f = first.primitive(), g = second.primitive();
  if (!is_first(f, g)) std::swap(f, g);
  lower_degrees(f, g);
  if (g.is_zero()) return {.is_same = true};
  if (g.degree() < 1) return {};
  g = g.primitive();
  std::string why = "no frame in general position";
  int tried = 0;
  for (int attempt = 0; attempt < general_frames && tried < 3; ++attempt) {
    const std::optional<SpaceProjection> projection = space_projection(f, g, general_frame(attempt));
    if (!projection) continue;
    if (projection->shadow.is_zero()) return left_open("the surfaces have a part in common");
    if (projection->shadow.degree_s() < 1) return {};
    ++tried;
    const Polynomial norm = turning_norm(*projection);
    if (norm.is_zero() || has_multiple_real_root(norm)) {
      why = norm.is_zero() ? "the surfaces touch along a curve, it seems"
                           : "the surfaces touch, or one of them is singular on the other, it seems";
      continue;
    }
    Crossing crossing(f, g, *projection, norm);
    if (crossing.find_landmarks()) return crossing.traced(tolerance);
    why = "turning points of the curve are not proved";
  }
  return left_open(why);
}

std::vector<SpaceCurve> named_curves(const CrossingCurve& curve) {
  const ConnectedParts part(curve, 0);
  std::map<int, std::size_t> position;
  std::vector<SpaceCurve> parts;
  for (std::size_t i = 0; i < curve.arcs.size(); ++i) {
    const auto [at, is_new] = position.emplace(part(curve.arcs[i]), parts.size());
    if (is_new) parts.push_back({static_cast<int>(parts.size()), SpaceCurveKind::general, {}, false, 1});
    parts[at->second].arcs.push_back(static_cast<int>(i));
  }
  return parts;
}

}  // namespace exsect
