#include "certificate/regular.h"

#include <exsect/checker/curve_bounds.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "certificate/claims.h"
#include "certificate/search.h"

namespace exsect::cli {
namespace {

using checker::Algebraic;
using checker::others;
using checker::Star;

using ExactTangent = checker::Vector4<Algebraic>;
using Columns = std::vector<checker::Vector3<Algebraic>>;

/// The columns of DF.
std::array<checker::Vector3<Algebraic>, 4> columns_of_derivative(const ExactMap& equation,
                                                                 const AlgebraicPoint& at) {
  std::array<checker::Vector3<Algebraic>, 4> result;
  const checker::Map<Algebraic> local = checker::rounded<Algebraic>(equation).at(at.parameters);
  for (const auto& term : local.terms())
    for (std::size_t j = 0; j < 4; ++j)
      if (std::accumulate(term.power.begin(), term.power.end(), 0) == 1 && term.power[j] == 1)
        result[j] = term.c;
  return result;
}

/// The kernel of DF, 0 if its rank is not 3.
ExactTangent exact_tangent(const std::array<checker::Vector3<Algebraic>, 4>& columns) {
  ExactTangent result;
  for (std::size_t k = 0; k < 4; ++k) {
    const auto o = others(k);
    result[k] = Algebraic(k % 2 == 0 ? 1 : -1) *
                checker::dot(columns[o[0]], checker::cross(columns[o[1]], columns[o[2]]));
  }
  return result;
}

std::size_t largest_coordinate(const checker::Vector3<Algebraic>& c) {
  const auto size = [&](std::size_t d) { return std::abs(checker::number<double>(c[d])); };
  return size(0) >= size(1) && size(0) >= size(2) ? 0 : size(1) >= size(2) ? 1 : 2;
}

checker::Vector3<Algebraic> unit_row(std::size_t d) {
  checker::Vector3<Algebraic> result;
  result[d] = 1;
  return result;
}

/// Three independent rows, of which as many as possible vanish on the vectors; these come last. The vectors
/// are those columns of DF along which the curve runs: one less than their number is their rank.
checker::Matrix3<Algebraic> rows_across(const Columns& vectors) {
  if (vectors.size() == 3) {
    const auto normal = checker::cross(vectors[0], vectors[1]);
    const std::size_t d = largest_coordinate(normal);
    return {unit_row((d + 1) % 3), unit_row((d + 2) % 3), normal};
  }
  if (vectors.size() == 2) {
    const std::size_t d = largest_coordinate(vectors[0]);
    return {unit_row(d), checker::cross(vectors[0], unit_row((d + 1) % 3)),
            checker::cross(vectors[0], unit_row((d + 2) % 3))};
  }
  return {unit_row(0), unit_row(1), unit_row(2)};
}

/// A power of 2 between twice and four times |a|; 1 for 0.
Rational scale_above(double a) {
  return std::abs(a) > 0x1p-60 ? power_of_two(std::ilogb(a) + 2) : Rational(1);
}

Parameters near_place(const AlgebraicPoint& at) {
  Parameters result;
  for (std::size_t i = 0; i < 4; ++i) result[i] = checker::number<double>(at.parameters[i]);
  return result;
}

/// The curve's derivatives at the point, nothing if it has none there along the axis.
std::optional<checker::CurveBounds<double>> curve_derivatives(const Map& map, const Parameters& w,
                                                              std::size_t axis) {
  const Map local = map.at(w);
  const auto c = inverse(local, axis);
  if (!c) return std::nullopt;
  return checker::curve_bounds(local.times(*c), axis, {});
}

}  // namespace

std::optional<Star> regular_star(const ExactMap& equation, const AlgebraicPoint& at) {
  const auto columns = columns_of_derivative(equation, at);
  const ExactTangent tangent = exact_tangent(columns);
  const auto size = [&](std::size_t j) { return std::abs(checker::number<double>(tangent[j])); };
  std::size_t axis = 0;
  for (std::size_t j = 1; j < 4; ++j)
    if (size(j) > size(axis)) axis = j;
  if (tangent[axis] == 0) return std::nullopt;
  const auto along = curve_derivatives(checker::rounded<double>(equation), near_place(at), axis);
  if (!along) return std::nullopt;
  Star star = {at.root, at.parameters, {}, {}, {1, 1, 1, 1}, {}, {1, 1, 1}, {}};
  Columns moving;
  for (std::size_t j = 0; j < 4; ++j) {
    const bool turns = tangent[j] == 0;
    star.weights[j] = turns ? 2 : 1;
    star.axes[j][j] = j == axis ? Rational(1)
                      : turns   ? scale_above(along->second[j].middle / 2)
                                : scale_above(along->first[j].middle);
    if (!turns) moving.push_back(columns[j]);
  }
  star.rows = rows_across(moving);
  return star;
}

bool turns_at_side(const Map& near, const SingularSearch& search, const Node& node) {
  const auto along = curve_derivatives(near, node.approx, best_axis(near, node.approx));
  if (!along) return false;
  const auto may_turn = [&](const Side& side) {
    const std::size_t i = index(side.parameter);
    return std::abs(along->first[i].middle) < 1e-6 && std::abs(along->second[i].middle) > 1e-3;
  };
  if (std::none_of(node.on.begin(), node.on.end(), may_turn)) return false;
  try {
    for (const AlgebraicPoint& at : points_in_box(search, node)) {
      const ExactTangent tangent = exact_tangent(columns_of_derivative(search.equation, at));
      const auto turns = [&](const Side& side) { return tangent[index(side.parameter)] == 0; };
      if (tangent != ExactTangent{} && std::any_of(node.on.begin(), node.on.end(), turns)) return true;
    }
  } catch (const NoCertificate&) {
  }
  return false;
}

}  // namespace exsect::cli
