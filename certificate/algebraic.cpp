#include "certificate/algebraic.h"

#include <exsect/algebra/number_field.h>

#include "certificate/claims.h"
#include "certificate/coordinates.h"
#include "certificate/long_point.h"

namespace exsect::cli {

using checker::Algebraic;

SingularSearch singular_search(const Patches& patches) {
  const auto place = [x = patches[0].biquadratic(), y = patches[1].biquadratic()](const ParameterBox& box) {
    return x && y ? algebraic_place(*x, *y, box) : std::nullopt;
  };
  return {equation_of(patches), {}, place};
}

SingularSearch singular_search(const ExactMap& section) {
  const auto place = [f = of_parameters(checker::component(section, 0), 0)](const ParameterBox& box) {
    return algebraic_place(f, box);
  };
  return {section, {false, false, true, true}, place};
}

namespace {

AlgebraicPoint point_of(const AlgebraicPlace& place) {
  const checker::Root root = {place.modulus.coefficients(), {place.between.lower, place.between.upper}};
  AlgebraicPoint point = {std::make_shared<checker::Root>(root), {}};
  for (std::size_t i = 0; i < 4; ++i) point.parameters[i] = Algebraic(place.at[i].coefficients(), point.root);
  return point;
}

/// What Newton's method finds, as numbers of one field that are a solution.
std::optional<AlgebraicPoint> field_point(const ExactMap& equation, const Node& node) {
  const auto near = long_point(equation, node, bits_of_places);
  if (!near) return std::nullopt;
  const auto is_exact = [map = checker::rounded<Algebraic>(equation)](const AlgebraicPlace& place) {
    return map.value(point_of(place).parameters) == AlgebraicColumn{};
  };
  const auto place = algebraic_place({(*near)[0], (*near)[1], (*near)[2], (*near)[3]}, is_exact);
  return place ? std::optional(point_of(*place)) : std::nullopt;
}

}  // namespace

std::vector<AlgebraicPoint> points_in_box(const SingularSearch& search, const Node& node) {
  std::vector<AlgebraicPoint> result;
  const Place place = short_place(node);
  if (is_solution(search.equation, place)) {
    const checker::Root zero = {{0, 1}, {-1, 1}};
    result.push_back({std::make_shared<checker::Root>(zero), {place[0], place[1], place[2], place[3]}});
  }
  if (const auto found = search.place(node.box))
    result.push_back(point_of(*found));
  else if (result.empty())
    if (const auto near = field_point(search.equation, node)) result.push_back(*near);
  if (result.empty()) throw NoCertificate("a special point with parameters in no number field that is found");
  return result;
}

AlgebraicMap about(const ExactMap& equation, const AlgebraicPoint& at) {
  return checker::rounded<Algebraic>(equation).at(at.parameters);
}

std::array<AlgebraicColumn, 4> columns_of_derivative(const AlgebraicMap& local) {
  return {local.slope(0), local.slope(1), local.slope(2), local.slope(3)};
}

Algebraic reciprocal(const Algebraic& a) {
  if (a.is_rational()) return 1 / a.rational();
  const auto inverse = inverse_modulo(Polynomial(a.coefficients()), Polynomial(a.root()->modulus));
  if (!inverse) throw NoCertificate("a special point in a ring with divisors of zero");
  return {inverse->coefficients(), a.root()};
}

checker::Matrix4 inverse(checker::Matrix4 m) {
  checker::Matrix4 result = {};
  for (std::size_t i = 0; i < 4; ++i) result[i][i] = 1;
  for (std::size_t i = 0; i < 4; ++i) {
    std::size_t pivot = i;
    while (pivot < 4 && m[pivot][i] == 0) ++pivot;
    if (pivot == 4) throw NoCertificate("coordinates that depend on each other");
    std::swap(m[i], m[pivot]);
    std::swap(result[i], result[pivot]);
    const checker::Algebraic factor = reciprocal(m[i][i]);
    for (std::size_t j = 0; j < 4; ++j) m[i][j] = m[i][j] * factor, result[i][j] = result[i][j] * factor;
    for (std::size_t row = 0; row < 4; ++row) {
      const checker::Algebraic times = m[row][i];
      for (std::size_t j = 0; row != i && j < 4; ++j) {
        m[row][j] = m[row][j] - times * m[i][j];
        result[row][j] = result[row][j] - times * result[i][j];
      }
    }
  }
  return result;
}

Json algebraic_claim(const Algebraic& a) {
  return a.is_rational() ? Json(to_string(a.rational())) : rationals(a.coefficients());
}

}  // namespace exsect::cli
