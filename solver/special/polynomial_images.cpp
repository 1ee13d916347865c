#include "special/polynomial_images.h"

#include <exsect/algebra/ball.h>
#include <exsect/algebra/determinant.h>
#include <exsect/algebra/rational_matrix.h>
#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <utility>

#include "answer/parameter_names.h"

namespace exsect {

namespace {

using LinearForm = HomogeneousPoint;  // of the homogeneous coordinates
using Forms = std::vector<LinearForm>;

Rational value_of(const LinearForm& form, const HomogeneousPoint& at) {
  Rational sum = 0;
  for (std::size_t c = 0; c < 4; ++c) sum += form[c] * at[c];
  return sum;
}

/// Rows of the pencil: the values of the forms at X_(i+1)j, and at X_ij.
struct PencilRow {
  std::vector<Rational> next;
  std::vector<Rational> here;
};
std::vector<PencilRow> pencil(const RationalPatch& patch, const Forms& forms) {
  std::vector<PencilRow> rows;
  for (int i = 0; i < patch.degree_u(); ++i)
    for (int j = 0; j <= patch.degree_v(); ++j) {
      PencilRow& row = rows.emplace_back();
      for (const LinearForm& form : forms) {
        row.next.push_back(value_of(form, patch.homogeneous(i + 1, j)));
        row.here.push_back(value_of(form, patch.homogeneous(i, j)));
      }
    }
  return rows;
}

/// The combinations of the forms whose values l(X_(i+1)j) are k l(X_ij).
Forms forms_at(const std::vector<PencilRow>& rows, const Forms& forms, const Rational& k) {
  RationalMatrix matrix(rows.size(), forms.size());
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (std::size_t j = 0; j < forms.size(); ++j) matrix(i, j) = rows[i].next[j] - k * rows[i].here[j];
  Forms result;
  for (const std::vector<Integer>& combination : null_space(matrix)) {
    LinearForm& form = result.emplace_back();
    for (std::size_t j = 0; j < forms.size(); ++j)
      for (std::size_t c = 0; c < 4; ++c) form[c] += Rational(combination[j]) * forms[j][c];
  }
  return result;
}

/// Forms of the span that are a basis of it modulo those that vanish on the patch.
Forms independent_on(const RationalPatch& patch, const Forms& span) {
  Forms basis;
  for (const LinearForm& form : span) {
    basis.push_back(form);
    RationalMatrix values(static_cast<std::size_t>((patch.degree_u() + 1) * (patch.degree_v() + 1)),
                          basis.size());
    for (std::size_t row = 0; row < values.rows(); ++row)
      for (std::size_t j = 0; j < basis.size(); ++j) {
        const auto at = std::div(static_cast<int>(row), patch.degree_v() + 1);
        values(row, j) = value_of(basis[j], patch.homogeneous(at.quot, at.rem));
      }
    if (rank(values) < basis.size()) basis.pop_back();
  }
  return basis;
}

/// The common divisor of minors of the pencil, whose rows are independent for no other k than its roots.
Polynomial dependence(const std::vector<PencilRow>& rows, std::size_t size) {
  Polynomial common;
  for (std::size_t first = 0; first + size <= rows.size(); ++first) {
    std::vector<std::vector<BivariatePolynomial>> minor(size);
    for (std::size_t i = 0; i < size; ++i)
      for (std::size_t j = 0; j < size; ++j) {
        const PencilRow& row = rows[first + i];
        minor[i].push_back(BivariatePolynomial({Polynomial({row.next[j], -row.here[j]})}));
      }
    common = gcd(common, determinant(minor).coefficient(0));
  }
  return common;
}

/// The rational k > 0 with a form of the span as in (14.80) that does not vanish on the patch are among
/// these; empty if that may be all k.
std::optional<std::vector<Rational>> possible_ratios(const RationalPatch& patch, const Forms& span) {
  const Forms basis = independent_on(patch, span);
  const Polynomial common = dependence(pencil(patch, basis), basis.size());
  if (common.is_zero()) return std::nullopt;
  std::vector<Rational> ratios;
  if (common.degree() < 1) return ratios;
  for (const auto& [factor, multiplicity] : irreducible_factors(common)) {
    if (factor.degree() != 1) continue;
    const Rational root = -factor.coefficient(0) / factor.coefficient(1);
    if (root > 0) ratios.push_back(root);
  }
  return ratios;
}

/// A form of the span that is positive on both patches, where forms have one sign on each.
std::optional<LinearForm> positive_form(const Forms& span, const RationalPatch& x, const RationalPatch& y) {
  for (const int t : {0, 1, -1, 2, -2, 3, -3}) {
    LinearForm form = span.front();
    Rational power = 1;
    for (std::size_t i = 1; i < span.size(); ++i) {
      power *= t;
      for (std::size_t c = 0; c < 4; ++c) form[c] += power * span[i][c];
    }
    const int on_x = sign(value_of(form, x.homogeneous(0, 0)));
    if (on_x == 0 || on_x != sign(value_of(form, y.homogeneous(0, 0)))) continue;
    for (Rational& coefficient : form) coefficient *= on_x;
    return form;
  }
  return std::nullopt;
}

/// The search for a form with (14.80): ratios of parameters that admit all are chosen last.
class FormSearch {
 public:
  FormSearch(const RationalPatch& x, const RationalPatch& y)
      : patches_{x, x.transposed(), y, y.transposed()} {}

  /// Of the forms of the span.
  std::optional<LinearForm> found_in(const Forms& span) {
    std::optional<std::size_t> any;
    for (std::size_t p = 0; p < patches_.size(); ++p) {
      if (ratios_[p] != 0) continue;
      if (const auto possible = possible_ratios(patches_[p], span)) return found_with(*possible, p, span);
      if (!any) any = p;
    }
    return any ? found_with({1}, *any, span) : positive_form(span, patches_[0], patches_[2]);
  }

  const std::array<Rational, 4>& ratios() const { return ratios_; }

 private:
  std::optional<LinearForm> found_with(const std::vector<Rational>& possible, std::size_t p,
                                       const Forms& span) {
    for (const Rational& k : possible) {
      ratios_[p] = k;
      const Forms rest = forms_at(pencil(patches_[p], span), span, k);
      if (rest.empty()) continue;
      if (auto form = found_in(rest)) return form;
    }
    ratios_[p] = 0;
    return std::nullopt;
  }

  std::array<RationalPatch, 4> patches_;
  std::array<Rational, 4> ratios_;  // 0: not known
};

/// (14.81); polynomial by (14.80).
std::optional<BezierPatch> seen_in(const RationalPatch& patch, const LinearForm& form, const Point& centre,
                                   const Rational& k, const Rational& l) {
  std::vector<std::vector<HomogeneousPoint>> net;
  Rational of_row = 1;
  for (int i = 0; i <= patch.degree_u(); ++i, of_row /= k) {
    net.emplace_back();
    Rational factor = of_row;
    for (int j = 0; j <= patch.degree_v(); ++j, factor /= l) {
      const HomogeneousPoint& p = patch.homogeneous(i, j);
      HomogeneousPoint& q = net.back().emplace_back();
      for (std::size_t c = 0; c < 3; ++c) q[c] = factor * (p[c] - p[3] * centre[c]);
      q[3] = factor * value_of(form, p);
    }
  }
  return RationalPatch::from_homogeneous(net).biquadratic();
}

/// As in length_bound().
double length(const std::array<double, 3>& v) { return length_bound(v[0], v[1], v[2]); }

/// The map q -> p of (14.82), rounded, with bounds.
class BackMap {
 public:
  explicit BackMap(const PolynomialImages& images) : slope_length_(0) {
    std::array<double, 3> sizes;
    for (std::size_t c = 0; c < 3; ++c) {
      centre_[c] = DoubleBall::enclosing(images.centre[c]);
      slope_[c] = DoubleBall::enclosing(images.slope[c]);
      sizes[c] = slope_[c].upper_magnitude();
    }
    slope_length_ = length(sizes);
  }

  /// How points on a polyline are mapped.
  struct Bounds {
    double rounding = 0;                                       // how far vertices are moved
    double reach = 0;                                          // |p - centre|
    double divisor = std::numeric_limits<double>::infinity();  // 1 - slope.q, from below
  };
  void operator()(std::array<double, 3>& point, Bounds& bounds) const {
    DoubleBall divisor = 1;
    for (std::size_t c = 0; c < 3; ++c) divisor -= slope_[c] * point[c];
    const double d = divisor.approximation();
    const double least = divisor.is_positive() ? divisor.lower_magnitude() : 0;
    std::array<double, 3> sizes, errors;
    for (std::size_t c = 0; c < 3; ++c) {
      const double quotient = point[c] / d;
      const double error =
          kSlack * std::fabs(quotient) * (divisor.radius() / least + 2 * kUnitRoundoff) + kUnderflow;
      const DoubleBall p = centre_[c] + DoubleBall(quotient, error);
      sizes[c] = std::fabs(quotient) + error;
      errors[c] = p.radius();
      point[c] = p.approximation();
    }
    bounds.rounding = larger_bound(bounds.rounding, length(errors));
    bounds.reach = larger_bound(bounds.reach, length(sizes));
    bounds.divisor = std::min(bounds.divisor, least);
  }

  /// (14.83)
  double bound(double of_image, const Bounds& bounds) const {
    const double divisor = bounds.divisor / kSlack - kSlack * slope_length_ * of_image;
    const double sum = of_image * (1 + bounds.reach * slope_length_) / divisor + bounds.rounding;
    return divisor > 0 && std::isfinite(sum) ? kSlack * sum : HUGE_VAL;
  }

  void operator()(Arc& arc) const {
    Bounds bounds;
    for (PolylineVertex& vertex : arc.polyline) (*this)(vertex.point, bounds);
    arc.error_bound = bound(arc.error_bound, bounds);
  }

 private:
  static constexpr double kUnderflow = 0x1p-1070;

  std::array<DoubleBall, 3> centre_;
  std::array<DoubleBall, 3> slope_;
  double slope_length_;
};

}  // namespace

std::optional<PolynomialImages> polynomial_images(const RationalPatch& x, const RationalPatch& y) {
  const RationalPatch& first = x.reduced();
  const RationalPatch& second = y.reduced();
  if (std::max({first.degree_u(), first.degree_v(), second.degree_u(), second.degree_v()}) > 2)
    return std::nullopt;
  FormSearch search(first, second);
  std::optional<LinearForm> form = search.found_in({{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}});
  if (!form) return std::nullopt;
  const std::array<Rational, 4>& k = search.ratios();
  const Point centre = first.point(0, 0);
  const Rational unit = value_of(*form, {centre[0], centre[1], centre[2], 1});
  for (Rational& coefficient : *form) coefficient /= unit;
  auto image_of_x = seen_in(first, *form, centre, k[0], k[1]);
  auto image_of_y = seen_in(second, *form, centre, k[2], k[3]);
  if (!image_of_x || !image_of_y) return std::nullopt;
  return PolynomialImages{
      *std::move(image_of_x), *std::move(image_of_y), k, centre, {(*form)[0], (*form)[1], (*form)[2]}};
}

void put_back(const PolynomialImages& images, IntersectResult& result) {
  for (const Parameter p : all_parameters) change_parameter(result, p, images.ratios[index(p)]);
  const BackMap map(images);
  BackMap::Bounds unused;
  for (Node& node : result.graph.nodes) map(node.point, unused);
  std::ranges::for_each(result.graph.arcs, map);
  for (Overlap& overlap : result.graph.overlaps)
    for (std::vector<Arc>& chain : overlap.chains) std::ranges::for_each(chain, map);
}

double growth(const PolynomialImages& images, const std::vector<Point>& points) {
  double largest = 0;
  const auto rounded = [](const Point& p) {
    return std::array{to_double(p[0]), to_double(p[1]), to_double(p[2])};
  };
  const double slope = length(rounded(images.slope));
  for (const Point& p : points) {
    const Point away = p - images.centre;
    const double form = 1 + to_double(dot(images.slope, away));
    largest = std::max(largest, (1 + length(rounded(away)) * slope) * form);
  }
  return largest;
}

}  // namespace exsect
