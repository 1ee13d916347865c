#include "revolve.h"

#include <exsect/algebra/bernstein.h>
#include <exsect/algebra/nearest_rounding.h>
#include <exsect/algebra/real_algebraic.h>
#include <exsect/geometry/implicit_curve.h>
#include <exsect/geometry/number.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

namespace exsect {
namespace {

constexpr int most_profile_degree = 10;

[[noreturn]] void refuse(const std::string& reason) { throw std::invalid_argument("revolve: " + reason); }

std::string shown(const RealAlgebraic& t) {
  return t.is_rational() ? to_string(t.rational()) : "about " + std::to_string(t.to_double());
}

/// The roots of r(t) in [0,1], r not zero.
std::vector<RealAlgebraic> axis_points(const HomogeneousCurve& curve) {
  const Polynomial& r = curve.numerators[0];
  return r.degree() < 1 ? std::vector<RealAlgebraic>{} : real_roots(r, 0, 1);
}

void check_half_plane(const HomogeneousCurve& curve) {
  const Polynomial& r = curve.numerators[0];
  if (r.is_zero()) refuse("the profile lies on the axis r = 0");
  std::vector<Rational> samples = {0, 1};
  const std::vector<RealAlgebraic> roots = axis_points(curve);
  for (std::size_t i = 0; i <= roots.size(); ++i) {
    RealAlgebraic from = i == 0 ? RealAlgebraic(0) : roots[i - 1];
    RealAlgebraic to = i == roots.size() ? RealAlgebraic(1) : roots[i];
    if (from == to) continue;
    for (Rational width = power_of_two(-8); from.interval().upper >= to.interval().lower; width *= width) {
      from = from.refined_to(width);
      to = to.refined_to(width);
    }
    samples.push_back(simplest_between(from.interval().upper, to.interval().lower));
  }
  for (const Rational& t : samples)
    if (r.sign_at(t) < 0) refuse("the profile leaves the half plane r >= 0: r < 0 at t = " + to_string(t));
}

void check_axis(const HomogeneousCurve& curve) {
  // z' = (Z' W - Z W') / W^2
  const Polynomial& z = curve.numerators[1];
  const Polynomial& w = curve.denominator;
  const Polynomial slope = z.derivative() * w - z * w.derivative();
  for (const RealAlgebraic& t : axis_points(curve))
    if (sign_at(slope, t) != 0)
      refuse("substitution cannot fit this profile: it meets the axis r = 0 at t = " + shown(t) +
             " and its tangent there is not orthogonal to the axis, but F(r^2, z) has the r-derivative 2 r "
             "F_R = 0"
             " there, so its zero curves cross the axis at right angles; use elimination or product");
}

void check_options(const BezierCurve& profile, const RevolveOptions& options) {
  const bool substitution = options.method == RevolutionMethod::substitution;
  if (profile.dimension() != 2) refuse("the profile must be planar, with coordinates (r,z)");
  if (profile.is_point()) refuse("all points of the profile are equal");
  if (substitution && !options.degree) refuse("substitution needs a degree");
  if (options.degree_z && !options.degree) refuse("a degree in z needs a degree in r");
  for (const auto& degree : {options.degree, options.degree_z})
    if (degree && (*degree < 1 || *degree > most_profile_degree))
      refuse("the degree must be 1, ..., " + std::to_string(most_profile_degree));
  if (options.cells) {
    if (!substitution)
      refuse(
          "splines need substitution: (12.14) and (12.15) applied cell by cell give pieces that do not join");
    if (*options.degree < 2 || (options.degree_z && *options.degree_z < 2))
      refuse("splines need degrees of at least 2");
    for (const int n : *options.cells)
      if (n < 1 || n > 64) refuse("the number of cells must be 1, ..., 64 in each direction");
  }
  if (options.samples < 2 || options.samples > 10000) refuse("the number of samples must be 2, ..., 10000");
  if (options.weights.w1 <= 0) refuse("the weight w1 must be > 0");
  if (options.weights.w2 < 0) refuse("the weight w2 must be >= 0");
  if (options.region) {
    const Rectangle& on = *options.region;
    if (on.r.lower != 0 || on.r.upper <= 0 || on.s.width() <= 0)
      refuse("the region must be 0 <= r <= b, c <= z <= d with 0 < b, c < d");
  }
  const HomogeneousCurve curve = homogeneous(profile);
  check_half_plane(curve);
  if (substitution) check_axis(curve);
}

Rectangle default_region(const BezierCurve& profile) {
  Rational most_r = 0, least_z = profile.points()[0][1], most_z = least_z;
  for (const std::vector<Rational>& p : profile.points()) {
    most_r = std::max(most_r, p[0]);
    least_z = std::min(least_z, p[1]);
    most_z = std::max(most_z, p[1]);
  }
  const Rational margin = std::max(Rational((most_z - least_z) / 2), Rational(most_r / 2));
  return {{0, 2 * most_r}, {least_z - margin, most_z + margin}};
}

/// The curve (r(t)^2, z(t)).
BezierCurve in_squares(const BezierCurve& profile) {
  std::array<std::vector<Rational>, 3> scaled;  // w r, w z, w
  for (std::size_t i = 0; i < profile.points().size(); ++i) {
    const Rational& w = profile.weights()[i];
    scaled[0].push_back(w * profile.points()[i][0]);
    scaled[1].push_back(w * profile.points()[i][1]);
    scaled[2].push_back(w);
  }
  const int degree = 2 * profile.degree();
  const Polynomial r = from_bernstein(scaled[0]), z = from_bernstein(scaled[1]),
                   w = from_bernstein(scaled[2]);
  const auto squared = bernstein_coefficients(r * r, degree), height = bernstein_coefficients(z * w, degree);
  const std::vector<Rational> weights = bernstein_coefficients(w * w, degree);
  std::vector<std::vector<Rational>> points;
  for (std::size_t i = 0; i < weights.size(); ++i)
    points.push_back({squared[i] / weights[i], height[i] / weights[i]});
  return BezierCurve(points, weights);
}

PlanarSpace space(const BezierCurve& profile, const RevolveOptions& options, const Rectangle& region) {
  const bool squares = options.method == RevolutionMethod::substitution;
  const Rational& b = region.r.upper;
  const PlanarBox box = {{0, squares ? b * b : b}, region.s};
  const int m = *options.degree, n = options.degree_z.value_or(m);
  if (options.cells)
    return PlanarSpace::b_splines(m, n, box, (*options.cells)[0], (*options.cells)[1], in_squares(profile))
        .in_squares();
  const PlanarSpace plain =
      options.degree_z ? PlanarSpace::bernstein(m, n, box) : PlanarSpace::monomials(m, box);
  return squares ? plain.in_squares() : plain;
}

PlanarFunction fitted(const BezierCurve& profile, const RevolveOptions& options, const Rectangle& region) {
  const PlanarSpace functions = space(profile, options, region);
  const std::vector<FitSample> samples = fit_samples(profile, options.samples);
  const PlanarFit fit = fit_points_and_normals(functions, samples, options.weights,
                                               options.cells ? Arithmetic::floating : Arithmetic::exact);
  if (!fit.is_unique && !options.cells)
    refuse("the samples do not determine the fit: take more samples or a lower degree");
  constexpr int shortest = 6;
  const int digits = rounding_digits(functions, samples, fit.coefficients).value_or(shortest);
  return functions.combination(rounded_coefficients(fit.coefficients, digits));
}

BivariatePolynomial revolved(const BivariatePolynomial& f, RevolutionMethod method) {
  switch (method) {
    case RevolutionMethod::elimination:
      return revolved_by_elimination(f);
    case RevolutionMethod::product:
      return revolved_by_product(f);
    case RevolutionMethod::substitution:
      break;
  }
  return revolved_by_substitution(f);
}

}  // namespace

const char* name(RevolutionMethod method) {
  switch (method) {
    case RevolutionMethod::elimination:
      return "elimination";
    case RevolutionMethod::product:
      return "product";
    case RevolutionMethod::substitution:
      break;
  }
  return "substitution";
}

Revolution revolve(const BezierCurve& profile, const RevolveOptions& options) {
  return in_nearest_rounding([&]() -> Revolution {
    check_options(profile, options);
    const Rectangle region = options.region.value_or(default_region(profile));
    const bool exact = !options.degree;
    PlanarFunction f =
        exact ? PlanarFunction(implicit_curve(profile).equation) : fitted(profile, options, region);
    Revolution result{f, exact, region, {}, std::nullopt, std::nullopt, distance_bounds(f, profile)};
    if (f.is_polynomial()) {
      result.surfaces = {revolved(f.polynomial(), options.method)};
      result.rings = options.method == RevolutionMethod::substitution
                         ? SingularRings{{}, false}
                         : singular_rings(f.polynomial(), region);
      result.audit = audit_branches(f.polynomial(), region);
    } else {
      for (const auto& row : f.cells())
        for (const auto& cell : row)
          if (cell) result.surfaces.push_back(revolved_by_substitution(*cell));
    }
    return result;
  });
}

}  // namespace exsect
