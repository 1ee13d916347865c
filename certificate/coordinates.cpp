#include "certificate/coordinates.h"

#include <exsect/algebra/bivariate_factors.h>
#include <exsect/checker/factors.h>
#include <exsect/geometry/number.h>

#include <cmath>

namespace exsect::cli {
namespace {

using checker::Factor;
using checker::others;
using checker::Power;

Scalar product(const Scalar& a, const Scalar& b) {
  Scalar result;
  for (const auto& [p, c] : a) {
    for (const auto& [q, d] : b) {
      Power sum = p;
      for (std::size_t j = 0; j < 4; ++j) sum[j] += q[j];
      result[sum] += c * d;
    }
  }
  return result;
}

/// The map with polynomials for its variables, without the terms that vanish.
ExactMap composed(const ExactMap& map, const std::array<Scalar, 4>& inner) {
  std::map<Power, Point> sum;
  for (const auto& term : map.terms()) {
    if (term.c == Point{}) continue;
    Scalar factor = {{Power{}, 1}};
    for (std::size_t j = 0; j < 4; ++j)
      for (int n = 0; n < term.power[j]; ++n) factor = product(factor, inner[j]);
    for (const auto& [power, c] : factor)
      for (std::size_t d = 0; d < 3; ++d) sum[power][d] += c * term.c[d];
  }
  ExactMap result;
  for (const auto& [power, c] : sum)
    if (c != Point{}) result.add(power, c, 1);
  return result;
}

}  // namespace

std::optional<Factor> factor_in(const Coordinates& z, const ExactMap& equation, std::size_t power) {
  Factor result = {{}, {1, 1, std::max<std::size_t>(power, 1)}, {}};
  const std::array<int, 3> divisor = {1, 1, static_cast<int>(power)};
  const ExactMap inner = composed(equation, z.from);
  for (const auto& term : inner.terms()) {
    if (term.c == Point{}) continue;
    std::size_t j = 0;
    while (j < 3 && (divisor[j] == 0 || term.power[j + 1] < divisor[j])) ++j;
    if (j == 3) return std::nullopt;
    Power rest = term.power;
    rest[j + 1] -= divisor[j];
    result.columns[j].add(rest, term.c, 1);
  }
  for (ExactMap& column : result.columns) column = composed(column, z.to);
  for (std::size_t d = 0; d < 3; ++d) {
    Point unit = {};
    unit[d] = 1;
    for (const auto& [p, c] : z.to[d + 1]) result.map.add(p, unit, c);
  }
  return result;
}

Power variable(std::size_t i) {
  Power power = {};
  power[i] = 1;
  return power;
}

double near_value(const Scalar& f, const Parameters& w) {
  double sum = 0;
  double all = 0;
  for (const auto& [power, c] : f) {
    double term = to_double(c);
    for (std::size_t j = 0; j < 4; ++j) term *= std::pow(w[j], power[j]);
    sum += term;
    all += std::abs(to_double(c));
  }
  return std::abs(sum) / all;
}

Scalar in_parameters(const BivariatePolynomial& f, std::size_t first) {
  Scalar result;
  for (int i = 0; i <= f.degree_r(); ++i) {
    for (int j = 0; j <= f.coefficient(i).degree(); ++j) {
      Power power = {};
      power[first] = i;
      power[first + 1] = j;
      if (f.coefficient(i, j) != 0) result[power] = f.coefficient(i, j);
    }
  }
  return result;
}

BivariatePolynomial of_parameters(const Scalar& f, std::size_t first) {
  std::vector<std::vector<Rational>> c;
  for (const auto& [power, q] : f) {
    const auto i = static_cast<std::size_t>(power[first]), j = static_cast<std::size_t>(power[first + 1]);
    if (c.size() <= i) c.resize(i + 1);
    if (c[i].size() <= j) c[i].resize(j + 1);
    c[i][j] = q;
  }
  std::vector<Polynomial> rows;
  for (std::vector<Rational>& row : c) rows.emplace_back(std::move(row));
  return BivariatePolynomial(std::move(rows));
}

Coordinates along_line(const Line& line, std::size_t m, const Direction& c, std::size_t first) {
  Coordinates z;
  z.from[line.axis] = {{variable(0), 1}};
  z.to[0] = {{variable(line.axis), 1}};
  const auto polynomial = [&](std::size_t i, std::size_t in, int sign) {
    Scalar result;
    for (int n = 0; n < 3; ++n) {
      Power power = {};
      power[in] = n;
      if (line.at[i][static_cast<std::size_t>(n)] != 0)
        result[power] = sign * line.at[i][static_cast<std::size_t>(n)];
    }
    return result;
  };
  z.from[m] = polynomial(m, 0, 1);
  z.from[m][variable(3)] = 1;
  z.to[3] = polynomial(m, line.axis, -1);
  z.to[3][variable(m)] = 1;
  for (const std::size_t i : others(line.axis)) {
    if (i == m) continue;
    const std::size_t own = i == first ? 1 : 2;
    z.from[i] = polynomial(i, 0, 1);
    z.from[i][variable(3)] += c[i];
    z.from[i][variable(own)] += 1;
    z.to[own] = polynomial(i, line.axis, -1);
    z.to[own][variable(i)] += 1;
    for (const auto& [power, q] : z.to[3]) z.to[own][power] -= c[i] * q;
  }
  return z;
}

namespace {

/// The vector c with c_axis = 0 that the derivative maps to 0, if its rank is 2, largest entry 1.
std::optional<Direction> kernel(const ExactMap& local, std::size_t axis) {
  std::array<Point, 3> rows;
  for (std::size_t j = 0; j < 3; ++j) {
    const auto column = local.slope(others(axis)[j]);
    for (std::size_t d = 0; d < 3; ++d) rows[d][j] = column[d];
  }
  Point c = cross(rows[0], rows[1]);
  if (is_zero(c)) c = cross(rows[0], rows[2]);
  if (is_zero(c)) c = cross(rows[1], rows[2]);
  std::size_t most = 0;
  for (std::size_t d = 1; d < 3; ++d)
    if (abs(c[d]) > abs(c[most])) most = d;
  if (is_zero(c)) return std::nullopt;
  Direction result = {};
  for (std::size_t j = 0; j < 3; ++j) result[others(axis)[j]] = c[j] / c[most];
  return result;
}

}  // namespace

std::optional<Factor> touching_factor(const Line& line, const ExactMap& equation, bool surface) {
  std::optional<Direction> c;
  for (int t = 0; t < 4; ++t) {
    Direction w;
    for (std::size_t i = 0; i < 4; ++i) w[i] = value(line.at[i], Rational(t, 3));
    const auto here = kernel(equation.at(w), line.axis);
    if (!here || (c && *here != *c)) return std::nullopt;
    c = here;
  }
  for (const std::size_t m : others(line.axis)) {
    if ((*c)[m] == 0) continue;
    Direction scaled = *c;
    for (Rational& q : scaled) q /= (*c)[m];
    for (const std::size_t first : others(line.axis)) {
      if (first == m) continue;
      const auto found = factor_in(along_line(line, m, scaled, first), equation, surface ? 0 : 2);
      if (found && (!surface || checker::is_edge(found->map))) return found;
    }
  }
  return std::nullopt;
}

namespace {

/// Polynomials in two of the parameters, a and b, as such in the first two, and the reverse.
Power exchanged_power(const Power& power, std::size_t a, std::size_t b) { return {power[a], power[b], 0, 0}; }

std::array<BivariatePolynomial, 3> components_in(const ExactMap& map, std::size_t a, std::size_t b) {
  std::array<Scalar, 3> f;
  for (const auto& term : map.terms())
    for (std::size_t d = 0; d < 3; ++d)
      if (term.c[d] != 0) f[d][exchanged_power(term.power, a, b)] = term.c[d];
  return {of_parameters(f[0], 0), of_parameters(f[1], 0), of_parameters(f[2], 0)};
}

void add_polynomial(ExactMap& map, std::size_t d, const BivariatePolynomial& f, std::size_t a,
                    std::size_t b) {
  Point unit = {};
  unit[d] = 1;
  for (const auto& [power, q] : in_parameters(f, 0)) {
    Power result = {};
    result[a] = power[0];
    result[b] = power[1];
    map.add(result, unit, q);
  }
}

/// The irreducible one that is nearest to 0 at the places.
std::optional<BivariatePower> nearest_part(const BivariatePolynomial& f, const std::vector<Parameters>& near,
                                           std::size_t a, std::size_t b) {
  if (f.is_zero() || (f.degree_r() <= 0 && f.degree_s() <= 0)) return std::nullopt;
  std::optional<BivariatePower> result;
  double least = 1e-4;
  for (const BivariatePower& part : irreducible_factors(f)) {
    double most = 0;
    for (const Parameters& w : near)
      most = std::max(most, near_value(in_parameters(part.factor, 0), {w[a], w[b], 0, 0}));
    if (!(most < least)) continue;
    least = most;
    result = part;
  }
  return result;
}

}  // namespace

std::optional<Factor> factor_of_constants(const ExactMap& equation,
                                          const std::array<std::size_t, 2>& constant, const Place& c,
                                          const std::vector<Parameters>& near) {
  const std::size_t a = 1 - constant[0], b = 5 - constant[1];
  Place origin = {}, back = {};
  for (const std::size_t i : constant) origin[i] = c[i], back[i] = -c[i];
  Factor result;
  ExactMap rest;
  const ExactMap local = equation.at(origin);
  for (const auto& term : local.terms()) {
    Power power = term.power;
    const bool first = power[constant[0]] > 0, second = power[constant[1]] > 0;
    if (first || second) --power[constant[first ? 0 : 1]];
    (first ? result.columns[0] : second ? result.columns[1] : rest).add(power, term.c, 1);
  }
  std::array<BivariatePolynomial, 3> f = components_in(rest, a, b);
  const auto part = nearest_part(gcd(gcd(f[0], f[1]), f[2]), near, a, b);
  if (!part || part->multiplicity > static_cast<int>(checker::max_factor_power)) return std::nullopt;
  for (std::size_t d = 0; d < 3; ++d) {
    for (int n = 0; n < part->multiplicity; ++n) f[d] = exact_quotient(f[d], part->factor);
    add_polynomial(result.columns[2], d, f[d], a, b);
  }
  result.powers = {1, 1, static_cast<std::size_t>(part->multiplicity)};
  for (std::size_t n = 0; n < 2; ++n) {
    result.columns[n] = result.columns[n].at(back);
    Point unit = {};
    unit[n] = 1;
    result.map.add(variable(constant[n]), unit, 1);
    result.map.add(Power{}, unit, -c[constant[n]]);
  }
  add_polynomial(result.map, 2, part->factor, a, b);
  return checker::degree(checker::component(result.map, 2)) <= checker::max_factor_degree
             ? std::optional(result)
             : std::nullopt;
}

namespace {

/// The number l with F_i + l F_j = 0 in a rational place where the part vanishes and w_i and w_j are those of
/// c; nothing if there is none in sight.
std::optional<Rational> common_slope(const ExactMap& equation, const std::array<std::size_t, 2>& constant,
                                     Place w, const BivariatePolynomial& part) {
  const std::size_t a = 1 - constant[0], b = 5 - constant[1];
  for (const Rational& t : {Rational(0), Rational(1), Rational(1, 2), Rational(1, 3)}) {
    const Polynomial rest = part.at_r(t);
    if (rest.degree() != 1) continue;
    w[a] = t;
    w[b] = -rest.coefficient(0) / rest.coefficient(1);
    const ExactMap local = equation.at(w);
    const Point first = local.slope(constant[0]), second = local.slope(constant[1]);
    for (std::size_t d = 0; d < 3; ++d)
      if (second[d] != 0) return -first[d] / second[d];
  }
  return std::nullopt;
}

}  // namespace

std::optional<Factor> touching_factor_of_constants(const ExactMap& equation,
                                                   const std::array<std::size_t, 2>& constant, const Place& c,
                                                   const std::vector<Parameters>& near) {
  const auto [i, j] = constant;
  const std::size_t a = 1 - i, b = 5 - j;
  const auto crossing = factor_of_constants(equation, constant, c, near);
  if (!crossing || crossing->powers[2] != 1) return std::nullopt;
  const BivariatePolynomial part = components_in(crossing->map, a, b)[2];
  const auto slope = common_slope(equation, constant, c, part);
  if (!slope) return std::nullopt;
  // z_i = w_i - c_i, z_j = w_j - c_j - slope z_i.
  Coordinates z;
  for (const std::size_t n : {a, b}) z.from[n] = z.to[n] = {{variable(n), 1}};
  z.from[i] = {{Power{}, c[i]}, {variable(i), 1}};
  z.from[j] = {{Power{}, c[j]}, {variable(i), *slope}, {variable(j), 1}};
  z.to[i] = {{Power{}, -c[i]}, {variable(i), 1}};
  z.to[j] = {{Power{}, *slope * c[i] - c[j]}, {variable(i), -*slope}, {variable(j), 1}};
  Factor result = {{}, {1, 1, 2}, {}};
  std::array<ExactMap, 2> rest;  // without z_j, the coefficients of 1 and z_i
  const ExactMap inner = composed(equation, z.from);
  for (const auto& term : inner.terms()) {
    Power power = term.power;
    if (power[j] > 0) {
      --power[j];
      result.columns[0].add(power, term.c, 1);
    } else if (power[i] > 1) {
      power[i] -= 2;
      result.columns[2].add(power, term.c, 1);
    } else {
      const auto n = static_cast<std::size_t>(power[i]);
      power[i] = 0;
      rest[n].add(power, term.c, 1);
    }
  }
  for (std::size_t n = 0; n < 2; ++n) {
    const std::array<BivariatePolynomial, 3> f = components_in(rest[n], a, b);
    ExactMap quotient;
    for (std::size_t d = 0; d < 3; ++d) {
      if (f[d].is_zero()) continue;
      if (!(gcd(f[d], part).total_degree() == part.total_degree())) return std::nullopt;
      add_polynomial(quotient, d, exact_quotient(f[d], part), a, b);
    }
    for (const auto& term : quotient.terms()) {
      Power power = term.power;
      power[i] = static_cast<int>(n);
      result.columns[1].add(power, term.c, 1);
    }
  }
  for (ExactMap& column : result.columns) column = composed(column, z.to);
  for (const auto& [power, q] : z.to[j]) result.map.add(power, {1, 0, 0}, q);
  add_polynomial(result.map, 1, part, a, b);
  for (const auto& [power, q] : z.to[i]) result.map.add(power, {0, 0, 1}, q);
  return result;
}

}  // namespace exsect::cli
