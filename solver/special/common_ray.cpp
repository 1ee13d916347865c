#include "special/common_ray.h"

#include <exsect/geometry/vector_algebra.h>

#include <algorithm>
#include <array>

namespace exsect {
namespace {

using Line = std::array<Polynomial, 4>;  // in homogeneous coordinates

/// X(.,t), or a derivative of it by t.
template <class Component>
Line line_of(const RationalPatch& patch, const Component& component) {
  Line line;
  for (int k = 0; k < 4; ++k) line[static_cast<std::size_t>(k)] = component(patch.component(k));
  return line;
}

/// D/w at first order: its value and its derivative by the parameter, of X - P w = a D.
struct Departure {
  explicit Departure(const Line& line) : weight(line[3].coefficient(0)), weight_rate(line[3].coefficient(1)) {
    for (std::size_t c = 0; c < 3; ++c) {
      const Rational p = line[c].coefficient(0) / weight;
      value[c] = line[c].coefficient(1) - p * line[3].coefficient(1);
      rate[c] = line[c].coefficient(2) - p * line[3].coefficient(2);
    }
  }
  Rational weight, weight_rate;
  Point value, rate;
};

/// (1 + bend a)^n f(ratio a / (1 + bend a)).
Polynomial moved(const Polynomial& f, int n, const Rational& ratio, const Rational& bend) {
  const Polynomial above({0, ratio}), below({1, bend});
  Polynomial sum, power(1);
  for (int k = n; k >= 0; --k) {
    sum = sum * above + power * Polynomial(f.coefficient(k));
    power *= below;
  }
  return sum;
}

int degree_of(const Line& line) {
  int degree = 0;
  for (const Polynomial& f : line) degree = std::max(degree, f.degree());
  return degree;
}

Line moved(const Line& line, int n, const CommonRay& by) {
  Line result;
  for (std::size_t k = 0; k < 4; ++k) result[k] = moved(line[k], n, by.ratio, by.bend);
  return result;
}

bool are_same_points(const Line& x, const Line& y) {
  return std::ranges::all_of(std::array<std::size_t, 3>{0, 1, 2},
                             [&](std::size_t c) { return (x[c] * y[3] - y[c] * x[3]).is_zero(); });
}

}  // namespace

std::optional<CommonRay> common_ray(const RationalPatch& x, const RationalPatch& y, const Rational& t,
                                    const Rational& s) {
  const Line first = line_of(x, [&](const BivariatePolynomial& f) { return f.at_s(t); });
  const Line second = line_of(y, [&](const BivariatePolynomial& f) { return f.at_s(s); });
  const Departure d(first), e(second);
  const Rational square = dot(d.value, d.value);
  CommonRay ray{t, s, dot(d.value, e.value) * e.weight / (dot(e.value, e.value) * d.weight), 0, false};
  if (ray.ratio <= 0) return std::nullopt;
  // By the derivative of W D (1 + bend a) = ratio w E for a = 0, multiplied by D.
  ray.bend = (ray.ratio * (d.weight_rate * dot(e.value, d.value) - e.weight_rate * square) +
              ray.ratio * ray.ratio * d.weight * dot(e.rate, d.value) - e.weight * dot(d.rate, d.value)) /
             (e.weight * square);
  const int n = degree_of(second);
  const Line image = moved(second, n, ray);
  if (!are_same_points(first, image)) return std::nullopt;
  Line along;
  for (std::size_t k = 0; k < 4; ++k) along[k] = first[k].derivative();
  const Line first_t = line_of(x, [&](const BivariatePolynomial& f) { return f.derivative_s().at_s(t); });
  const Line second_s = line_of(y, [&](const BivariatePolynomial& f) { return f.derivative_s().at_s(s); });
  const Line beside = moved(second_s, std::max(n, degree_of(second_s)), ray);
  ray.is_contact = determinant_over(first, along, first_t, beside).is_zero();
  return ray;
}

}  // namespace exsect
