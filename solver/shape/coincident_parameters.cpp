#include "shape/coincident_parameters.h"

#include <exsect/algebra/positive_on_square.h>
#include <exsect/algebra/rational_matrix.h>
#include <exsect/algebra/real_algebraic.h>

#include <algorithm>
#include <vector>

#include "shape/planar_patch.h"

namespace exsect {

namespace {

/// The numbers with indices 01, 02, 03, 12, 13, 23 of an alternating 4 x 4 matrix.
template <class T>
using Alternating = std::array<T, 6>;
constexpr std::array<std::array<std::size_t, 2>, 6> kPairs = {
    {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};

BivariatePolynomial by_parameter(const BivariatePolynomial& f, std::size_t parameter) {
  return parameter == 0 ? f.derivative_r() : f.derivative_s();
}

/// X ^ X_a for the parameter a: (N ^ D).(X ^ X_a) = N(X) D(X_a) - N(X_a) D(X) is 0 if N(X) / D(X) does not
/// depend on a.
Alternating<BivariatePolynomial> along(const RationalPatch& x, std::size_t parameter) {
  Alternating<BivariatePolynomial> result;
  for (std::size_t k = 0; k < 6; ++k) {
    const auto p = x.component(static_cast<int>(kPairs[k][0])),
               q = x.component(static_cast<int>(kPairs[k][1]));
    result[k] = p * by_parameter(q, parameter) - q * by_parameter(p, parameter);
  }
  return result;
}

/// One vector for each term: what N ^ D must annihilate.
void append_constraints(std::vector<Alternating<Rational>>& constraints,
                        const Alternating<BivariatePolynomial>& d) {
  int degree_r = -1, degree_s = -1;
  for (const BivariatePolynomial& f : d) {
    degree_r = std::max(degree_r, f.degree_r());
    degree_s = std::max(degree_s, f.degree_s());
  }
  for (int i = 0; i <= degree_r; ++i)
    for (int j = 0; j <= degree_s; ++j) {
      Alternating<Rational> c;
      for (std::size_t k = 0; k < 6; ++k) c[k] = d[k].coefficient(i, j);
      if (c != Alternating<Rational>{}) constraints.push_back(c);
    }
}

/// Those N ^ D with D = X_4, and the only one there is, if there is only one.
std::vector<Alternating<Rational>> pencils(const std::vector<Alternating<Rational>>& constraints) {
  std::vector<Point> affine;
  RationalMatrix all(constraints.size(), 6);
  for (std::size_t i = 0; i < constraints.size(); ++i) {
    const Alternating<Rational>& c = constraints[i];
    if (const Point part = {c[2], c[4], c[5]}; !is_zero(part)) affine.push_back(part);
    for (std::size_t k = 0; k < 6; ++k) all(i, k) = c[k];
  }
  std::vector<Alternating<Rational>> result;
  for (const Point& form : orthogonal_complement(affine))
    result.push_back({0, 0, form[0], 0, form[1], form[2]});
  const auto general = null_space(all);
  if (!result.empty() || general.size() != 1) return result;
  Alternating<Rational> c;
  std::copy(general[0].begin(), general[0].end(), c.begin());
  if (c[0] * c[5] - c[1] * c[4] + c[2] * c[3] == 0) result.push_back(c);  // of the form N ^ D
  return result;
}

/// N(X) and D(X) for some N, D with this N ^ D: rows of the alternating matrix span the same pencil.
std::array<BivariatePolynomial, 2> pencil_on(const Alternating<Rational>& c, const RationalPatch& x) {
  std::array<BivariatePolynomial, 2> rows;
  const std::size_t first = static_cast<std::size_t>(
      std::find_if(c.begin(), c.end(), [](const Rational& entry) { return entry != 0; }) - c.begin());
  for (std::size_t row = 0; row < 2; ++row)
    for (std::size_t k = 0; k < 6; ++k)
      for (std::size_t end = 0; end < 2; ++end) {
        if (kPairs[k][end] != kPairs[first][row]) continue;
        const BivariatePolynomial term =
            x.component(static_cast<int>(kPairs[k][1 - end])) * BivariatePolynomial::constant(c[k]);
        rows[row] = end == 0 ? rows[row] + term : rows[row] - term;
      }
  return rows;
}

/// The ends 0 and 1 at which a polynomial is zero; empty if it is elsewhere in [0,1], or throughout.
std::optional<std::array<bool, 2>> zero_ends(const Polynomial& f) {
  if (f.is_zero()) return std::nullopt;
  std::array<bool, 2> result = {};
  for (const RealAlgebraic& root : real_roots(f, 0, 1)) {
    if (root.compare(0) != 0 && root.compare(1) != 0) return std::nullopt;
    result[root.compare(0) == 0 ? 0 : 1] = true;
  }
  return result;
}

/// The plane of the pencil in which the point is, N(X) : D(X) = n : d, is a function of the parameter alone,
/// by assumption. Whether its derivative is zero at 0 and at 1; empty if it is elsewhere in [0,1], if a plane
/// comes twice, or if the patch meets the axis, where N(X) = D(X) = 0.
std::optional<std::array<bool, 2>> flat_ends(const Alternating<Rational>& c, const RationalPatch& x,
                                             std::size_t parameter) {
  const auto [first, second] = pencil_on(c, x);
  BivariatePolynomial common = gcd(first, second);
  if (common.is_zero()) return std::nullopt;
  const auto reduced = [&](const BivariatePolynomial& f) {
    const BivariatePolynomial quotient = exact_quotient(f, common);
    return parameter == 0 ? quotient.at_s(0) : quotient.at_r(0);
  };
  const Polynomial n = reduced(first), d = reduced(second);
  if (sign(common(0, 0)) < 0) common = common * BivariatePolynomial::constant(-1);
  if (not_positive_on_square(common)) return std::nullopt;
  const auto again = zero_ends(n * d(0) - d * n(0));
  if (!again || (*again)[1]) return std::nullopt;
  return zero_ends(n.derivative() * d - n * d.derivative());
}

}  // namespace

// (14.34a)
CoincidentParameters coincidence(const RationalPatch& x, const RationalPatch& y) {
  CoincidentParameters result;
  const std::array of_x = {along(x, 0), along(x, 1)}, of_y = {along(y, 0), along(y, 1)};
  for (std::size_t a = 0; a < 2; ++a) {
    for (std::size_t b = 0; b < 2; ++b) {
      std::vector<Alternating<Rational>> constraints;
      append_constraints(constraints, of_x[1 - a]);
      append_constraints(constraints, of_y[1 - b]);
      for (const Alternating<Rational>& pencil : pencils(constraints)) {
        const auto on_x = flat_ends(pencil, x, a);
        const auto on_y = on_x ? flat_ends(pencil, y, b) : std::nullopt;
        if (!on_y) continue;
        result.partner[a] = 2 + b;
        result.partner[2 + b] = a;
        result.flat[a] = *on_x;
        result.flat[2 + b] = *on_y;
      }
    }
  }
  return result;
}

std::array<std::size_t, 4> coincident_parameters(const RationalPatch& x, const RationalPatch& y) {
  return coincidence(x, y).partner;
}

std::array<std::optional<std::size_t>, 2> plane_coordinates(const BezierPatch& x, const BezierPatch& y) {
  std::array<std::optional<std::size_t>, 2> result;
  for (std::size_t p = 0; p < 2; ++p) {
    const auto plane = plane_of(p == 0 ? x : y);
    for (std::size_t k = 0; plane && k < 3 && !result[p]; ++k) {
      result[p] = plane->normal[k] != 0 ? std::optional(k) : std::nullopt;
    }
  }
  return result;
}

}  // namespace exsect
