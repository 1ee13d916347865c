#include "implicitize_curve.h"

#include <exsect/algebra/nearest_rounding.h>

#include <algorithm>
#include <stdexcept>

#include "curve/short_rational.h"

namespace exsect {
namespace {

constexpr int most_curve_degree = 12;
constexpr int most_samples = 10000;
constexpr int most_cells = 64;

void require(bool statement, const char* message) {
  if (!statement) throw std::invalid_argument(message);
}

void require_options(const PlanarOptions& options) {
  require(options.degree >= 1 && options.degree <= most_curve_degree, "the degree must be from 1 to 12");
  require(options.samples >= 2 && options.samples <= most_samples,
          "the number of samples must be from 2 to 10000");
  require(options.cells >= 1 && options.cells <= most_cells, "the number of cells must be from 1 to 64");
  require(!options.digits || (*options.digits >= 1 && *options.digits <= 100),
          "the number of digits must be from 1 to 100");
}

/// Cells along the shorter side, about as long as those along the longer one.
int matching_cells(int cells, const Rational& side, const Rational& longer) {
  const Rational wanted = side / longer * cells + Rational(1, 2);
  return std::max(1, static_cast<int>(Integer(numerator(wanted) / denominator(wanted))));
}

PlanarSpace space_of(const BezierCurve& curve, const PlanarOptions& options, const PlanarBox& box) {
  const int d = options.degree;
  if (options.space == SpaceKind::bernstein) return PlanarSpace::bernstein(d, d, box);
  if (options.space == SpaceKind::b_spline) {
    const Rational longer = std::max(box.x.width(), box.y.width());
    return PlanarSpace::b_splines(d, d, box, matching_cells(options.cells, box.x.width(), longer),
                                  matching_cells(options.cells, box.y.width(), longer), curve);
  }
  return options.method == PlanarMethod::least_squares ? PlanarSpace::monomials(d, box)
                                                       : PlanarSpace::local_monomials(d, box);
}

CurveBasis basis_of(PlanarMethod method) {
  switch (method) {
    case PlanarMethod::legendre:
      return CurveBasis::legendre;
    case PlanarMethod::chebyshev:
      return CurveBasis::chebyshev;
    case PlanarMethod::lagrange:
      return CurveBasis::lagrange;
    default:
      return CurveBasis::bernstein;
  }
}

/// Coefficients as the method finds them.
struct Found {
  std::vector<Rational> coefficients;
  std::optional<double> singular_value;
  bool is_unique;
  bool vanishes;
};

Found find(const PlanarSpace& space, const BezierCurve& curve, const std::vector<FitSample>& samples,
           const PlanarOptions& options) {
  if (options.method == PlanarMethod::least_squares) {
    const bool spline = options.space == SpaceKind::b_spline;
    const FitWeights weights =
        options.weights.value_or(FitWeights{1, spline ? Rational(1, 1000) : Rational(0)});
    PlanarFit fit = fit_points_and_normals(space, samples, weights, options.arithmetic);
    return {std::move(fit.coefficients), std::nullopt, fit.is_unique, false};
  }
  NullSpaceFit fit = fit_null_space(space, curve, basis_of(options.method), options.arithmetic);
  return {std::move(fit.coefficients), fit.singular_value, true, fit.nullity > 0};
}

PlanarImplicit certified(PlanarImplicit result, const BezierCurve& curve) {
  result.bounds = distance_bounds(result.function, curve);
  result.possibly_singular = possibly_singular(result.function, result.box);
  return result;
}

}  // namespace

const char* name(PlanarMethod method) {
  switch (method) {
    case PlanarMethod::exact:
      return "exact";
    case PlanarMethod::least_squares:
      return "least-squares";
    default:
      return name(basis_of(method));
  }
}

const char* name(SpaceKind kind) {
  return kind == SpaceKind::monomial ? "monomial" : kind == SpaceKind::bernstein ? "bernstein" : "b-spline";
}

PlanarBox enlarged_box(const BezierCurve& planar) {
  return in_nearest_rounding([&]() -> PlanarBox {
    const PlanarBox box = control_box(homogeneous(planar), 0, 1);
    const Rational margin = std::max(box.x.width(), box.y.width()) / 4;
    const auto enlarged = [&](const RationalInterval& side) {
      return RationalInterval{rounded_down(side.lower - margin, 6), rounded_up(side.upper + margin, 6)};
    };
    return {enlarged(box.x), enlarged(box.y)};
  });
}

PlanarImplicit implicitize(const BezierCurve& curve, const PlanarOptions& options) {
  return in_nearest_rounding([&]() -> PlanarImplicit {
    require_options(options);
    const ImplicitCurve exact = implicit_curve(curve);
    const PlanarBox box = options.box.value_or(enlarged_box(curve));
    PlanarImplicit result = {exact.equation, box, true, exact.power, exact.equation.total_degree(), 0, {}, {},
                             true,           {},  {}};
    if (options.method == PlanarMethod::exact) return certified(std::move(result), curve);
    const PlanarSpace space = space_of(curve, options, box);
    result.dimension = space.dimension();
    const std::vector<FitSample> samples = fit_samples(curve, options.samples);
    Found found = find(space, curve, samples, options);
    result.singular_value = found.singular_value;
    result.is_unique = found.is_unique;
    if (found.vanishes) return certified(std::move(result), curve);
    result.is_exact = false;
    result.digits = options.digits ? options.digits : rounding_digits(space, samples, found.coefficients);
    if (result.digits) found.coefficients = rounded_coefficients(found.coefficients, *result.digits);
    result.function = space.combination(found.coefficients);
    return certified(std::move(result), curve);
  });
}

}  // namespace exsect
