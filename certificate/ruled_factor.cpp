#include "certificate/ruled_factor.h"

#include <exsect/algebra/polynomial.h>
#include <exsect/checker/factors.h>
#include <exsect/geometry/number.h>
#include <exsect/solver/algebraic_place.h>

#include <algorithm>
#include <numeric>
#include <vector>

#include "certificate/long_point.h"

namespace exsect::cli {
namespace {

using checker::Power;

/// A polynomial in two parameters: the coefficients of the powers of the second one.
using Powers = std::vector<Polynomial>;

/// The direction of all terms with other parameters than these; nothing if there is not exactly one.
std::optional<Point> direction_of_others(const ExactMap& equation,
                                         const std::array<std::size_t, 2>& constant) {
  Point d = {};
  for (const auto& term : equation.terms()) {
    const bool others = std::accumulate(term.power.begin(), term.power.end(), 0) >
                        term.power[constant[0]] + term.power[constant[1]];
    if (!others || is_zero(term.c)) continue;
    if (is_zero(d)) d = term.c;
    if (!is_zero(cross(d, term.c))) return std::nullopt;
  }
  return is_zero(d) ? std::nullopt : std::optional(d);
}

/// The direction and two across it, these first.
std::array<Point, 3> rows_beside(const Point& d) {
  std::size_t k = 0;
  for (std::size_t i = 1; i < 3; ++i)
    if (abs(d[i]) > abs(d[k])) k = i;
  std::array<Point, 3> rows = {Point{}, Point{}, d};
  for (const std::size_t n : {0, 1}) {
    Point unit = {};
    unit[(k + 1 + n) % 3] = 1;
    rows[n] = cross(d, unit);
  }
  return rows;
}

Powers powers_of(const ExactMap& equation, const Point& row, const std::array<std::size_t, 2>& constant) {
  std::vector<std::vector<Rational>> c;
  for (const auto& term : equation.terms()) {
    const Rational q = dot(row, term.c);
    const auto i = static_cast<std::size_t>(term.power[constant[0]]);
    const auto j = static_cast<std::size_t>(term.power[constant[1]]);
    if (q == 0) continue;
    c.resize(std::max(c.size(), j + 1));
    c[j].resize(std::max(c[j].size(), i + 1));
    c[j][i] += q;
  }
  Powers result;
  for (std::vector<Rational>& coefficients : c) result.emplace_back(std::move(coefficients));
  return result;
}

/// f = (w_j - c) quotient + rest, where c depends on w_i.
struct Division {
  Powers quotient;
  Polynomial rest;
};
Division divided(const Powers& f, const Polynomial& c) {
  Division result = {Powers(f.empty() ? 0 : f.size() - 1), {}};
  Polynomial carried;
  for (std::size_t k = f.size(); k-- > 0;) {
    carried = f[k] + c * carried;
    (k > 0 ? result.quotient[k - 1] : result.rest) = carried;
  }
  return result;
}

void add_powers(ExactMap& map, const Powers& f, const Point& c, const std::array<std::size_t, 2>& constant) {
  for (std::size_t j = 0; j < f.size(); ++j) {
    for (int i = 0; i <= f[j].degree(); ++i) {
      Power power = {};
      power[constant[0]] = i;
      power[constant[1]] = static_cast<int>(j);
      if (f[j].coefficient(i) != 0) map.add(power, c, f[j].coefficient(i));
    }
  }
}

/// m and c for both constants, from the zero of both polynomials in the node's box.
std::optional<AlgebraicPlace> constants_at(const std::array<Powers, 2>& f,
                                           const std::array<std::size_t, 2>& constant, Node node) {
  ExactMap map;
  add_powers(map, f[0], {1, 0, 0}, constant);
  add_powers(map, f[1], {0, 1, 0}, constant);
  for (std::size_t i = 0; i < 4; ++i)
    if (i != constant[0] && i != constant[1]) node.box[i] = {0, 0};
  const auto near = long_point(map, node, bits_of_places);
  if (!near) return std::nullopt;
  const Polynomial variable({0, 1});
  return algebraic_place({(*near)[constant[0]], (*near)[constant[1]], 0, 0},
                         [&](const AlgebraicPlace& place) {
                           const auto vanishes = [&](const Powers& g) {
                             return divide(divided(g, place.at[1]).rest, place.modulus).remainder.is_zero();
                           };
                           return place.at[0] == variable && vanishes(f[0]) && vanishes(f[1]);
                         });
}

bool is_claimable(const checker::Factor& factor) {
  const auto most = [](const ExactMap& map) {
    int result = 0;
    for (std::size_t d = 0; d < 3; ++d)
      result = std::max(result, checker::degree(checker::component(map, d)));
    return result;
  };
  return most(factor.map) <= checker::max_factor_degree &&
         std::all_of(factor.columns.begin(), factor.columns.end(),
                     [&](const ExactMap& column) { return most(column) <= checker::max_factor_degree; });
}

}  // namespace

std::optional<checker::Factor> ruled_factor(const ExactMap& equation,
                                            const std::array<std::size_t, 2>& constant, const Node& node) {
  const auto d = direction_of_others(equation, constant);
  if (!d) return std::nullopt;
  const std::array<Point, 3> rows = rows_beside(*d);
  const std::array<Powers, 2> f = {powers_of(equation, rows[0], constant),
                                   powers_of(equation, rows[1], constant)};
  const auto place = constants_at(f, constant, node);
  if (!place) return std::nullopt;
  const Rational det = dot(rows[0], cross(rows[1], rows[2]));
  checker::Factor result = {{}, {1, 1, 1}, {}};
  add_powers(result.map, {place->modulus}, {1, 0, 0}, constant);
  add_powers(result.map, {Polynomial() - place->at[1], Polynomial(Rational(1))}, {0, 1, 0}, constant);
  for (const auto& term : equation.terms()) result.map.add(term.power, {0, 0, dot(rows[2], term.c)}, 1);
  for (std::size_t n = 0; n < 3; ++n) {
    const Point column = Rational(1) / det * cross(rows[(n + 1) % 3], rows[(n + 2) % 3]);
    if (n == 2) {
      result.columns[2].add(Power{}, column, 1);
      continue;
    }
    const Division parts = divided(f[n], place->at[1]);
    add_powers(result.columns[0], {divide(parts.rest, place->modulus).quotient}, column, constant);
    add_powers(result.columns[1], parts.quotient, column, constant);
  }
  return is_claimable(result) ? std::optional(result) : std::nullopt;
}

}  // namespace exsect::cli
