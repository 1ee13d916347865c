#include "integer_pull_back.h"

#include <stdexcept>
#include <utility>
#include <vector>

#include "line_forms.h"

namespace exsect {
namespace {

/// The control points times the binomials, from the Bernstein basis to the power basis in place: the three
/// numbers are those of one coordinate in one parameter.
void to_power_basis(Integer& b0, Integer& b1, Integer& b2) {
  b2 += b0 - 2 * b1;
  b1 = 2 * (b1 - b0);
}

/// Coordinate k of every control point times `multiplier`, a common denominator, in the power basis.
void set_coordinate(IntegerNet& net, const BezierPatch& patch, std::size_t k, const Integer& multiplier) {
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const Rational& x = patch.net()[i][j][k];
      net[i][j][k] = numerator(x) * (multiplier / denominator(x));
    }
    to_power_basis(net[i][0][k], net[i][1][k], net[i][2][k]);
  }
  for (std::size_t j = 0; j < 3; ++j) to_power_basis(net[0][j][k], net[1][j][k], net[2][j][k]);
}

/// Calls f with coordinate k of every coefficient of both nets.
template <class Function>
void for_each_coordinate(IntegerPair& pair, std::size_t k, Function f) {
  for (IntegerNet* net : {&pair.first, &pair.second})
    for (auto& row : *net)
      for (IntegerVector& c : row) f(c[k]);
}

BivariatePolynomial pull_back_over_integers(const AffineFormOver<Integer>& form, const IntegerNet& y) {
  std::vector<Polynomial> coefficients;
  for (std::size_t i = 0; i < 3; ++i) {
    std::vector<Rational> in_s;
    for (std::size_t j = 0; j < 3; ++j) {
      Integer sum = i == 0 && j == 0 ? form.constant : Integer(0);
      for (std::size_t k = 0; k < 3; ++k)
        if (!form.normal[k].is_zero()) sum += form.normal[k] * y[i][j][k];
      in_s.emplace_back(std::move(sum));
    }
    coefficients.emplace_back(in_s);
  }
  return BivariatePolynomial(std::move(coefficients));
}

/// The form in P from a form in weight P, the homogeneous coordinates of the line.
AffineFormOver<Integer> on_unweighted(AffineFormOver<Integer> form, const Integer& weight) {
  for (Integer& c : form.normal) c *= weight;
  return form;
}

}  // namespace

IntegerPair integer_pair(const BezierPatch& x, const BezierPatch& y) {
  IntegerPair pair;
  for (std::size_t k = 0; k < 3; ++k) {
    Integer multiplier = 1;
    for (const BezierPatch* patch : {&x, &y})
      for (const auto& row : patch->net())
        for (const Point& p : row) multiplier = lcm(multiplier, denominator(p[k]));
    set_coordinate(pair.first, x, k, multiplier);
    set_coordinate(pair.second, y, k, multiplier);
    Integer content = 0;
    for_each_coordinate(pair, k, [&](const Integer& c) { content = gcd(content, c); });
    if (content > 1) for_each_coordinate(pair, k, [&](Integer& c) { c /= content; });
    pair.scale[k] = content > 1 ? Rational(multiplier, content) : Rational(multiplier);
  }
  return pair;
}

IntegerNet exchanged(const IntegerNet& net) {
  IntegerNet result;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) result[i][j] = net[j][i];
  return result;
}

IntegerLine line_at_first(const IntegerNet& net, const Rational& u0) {
  const Integer p = numerator(u0);
  const Integer q = denominator(u0);
  const std::array<Integer, 3> powers = {q * q, p * q, p * p};  // of (1, u0, u0^2) times q^2
  IntegerLine line;
  for (std::size_t j = 0; j < 3; ++j)
    for (std::size_t k = 0; k < 3; ++k)
      line.a[j][k] = powers[0] * net[0][j][k] + powers[1] * net[1][j][k] + powers[2] * net[2][j][k];
  line.weight = powers[0];
  return line;
}

bool is_conic(const IntegerLine& line) {
  const IntegerVector n = cross_over(line.a[1], line.a[2]);
  return !(n[0].is_zero() && n[1].is_zero() && n[2].is_zero());
}

PullBack axis_pull_back(const IntegerLine& line, const IntegerNet& y) {
  const IntegerVector n = cross_over(line.a[1], line.a[2]);
  const std::size_t k = largest_coordinate(n);
  if (n[k].is_zero())
    throw std::domain_error("parameter line: a1 x a2 = 0, the line is straight, not a conic");
  const LineFormsOver<Integer> forms = axis_forms_over(line.a, n, k);
  const auto pulled_back = [&](const AffineFormOver<Integer>& form) {
    return pull_back_over_integers(on_unweighted(form, line.weight), y);
  };
  return {pulled_back(forms.plane), pulled_back(forms.e0), pulled_back(forms.e1), pulled_back(forms.e2)};
}

}  // namespace exsect
