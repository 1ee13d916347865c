#include "self/poles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "curve/half_space.h"
#include "self/chart.h"
#include "self/local_derivatives.h"
#include "self/pinch_matrix.h"

namespace exsect {
namespace {

constexpr int kGuesses = 12;
constexpr double kMargin = 0x1p-10;

/// The pole is its side u = 0.
RationalPatch turned_to(const Pole& pole, const RationalPatch& piece) {
  const RationalPatch first = pole.fixed == 0 ? piece : piece.transposed();
  return pole.value == 0 ? first : first.restricted_to(1, 0, 0, 1);
}

/// A control vector of X - Q X_4 for the pole Q.
Point direction(const RationalPatch& patch, int i, int j, const Point& pole) {
  const HomogeneousPoint& p = patch.homogeneous(i, j);
  return {p[0] - p[3] * pole[0], p[1] - p[3] * pole[1], p[2] - p[3] * pole[2]};
}

/// Those off the side u = 0, times a factor.
void append_directions(std::vector<Point>& all, const RationalPatch& turned, const Pole& pole, int factor) {
  for (int i = 1; i <= turned.degree_u(); ++i)
    for (int j = 0; j <= turned.degree_v(); ++j)
      all.push_back(Rational(factor) * direction(turned, i, j, pole.point));
}

using CoefficientRow = std::vector<DoubleBall>;  // Bernstein coefficients
using CoefficientNet = std::vector<CoefficientRow>;

CoefficientNet derivative_by_u(const CoefficientNet& net) {
  CoefficientNet result;
  const DoubleBall degree(static_cast<double>(net.size() - 1));
  for (std::size_t i = 0; i + 1 < net.size(); ++i) {
    result.emplace_back();
    for (std::size_t j = 0; j < net[i].size(); ++j)
      result.back().push_back(degree * (net[i + 1][j] - net[i][j]));
  }
  return result;
}

CoefficientNet derivative_by_v(const CoefficientNet& net) {
  CoefficientNet result;
  const DoubleBall degree(static_cast<double>(net[0].size() - 1));
  for (const CoefficientRow& row : net) {
    result.emplace_back();
    for (std::size_t j = 0; j + 1 < row.size(); ++j) result.back().push_back(degree * (row[j + 1] - row[j]));
  }
  return result;
}

/// All values over the square; 0 if there are no coefficients.
DoubleBall hull_of(const CoefficientNet& net) {
  CoefficientRow all;
  for (const CoefficientRow& row : net) all.insert(all.end(), row.begin(), row.end());
  return hull_of(all);
}

/// X - Q X_4 = u D(u,v), and the weight: a column of (D, weight) for each of the unknowns of (14.69), over
/// the square.
struct PoleColumns {
  std::array<BallVector<DoubleBall>, 3> space;  // D_u, D_v, D
  std::array<DoubleBall, 3> weight;             // u w_u - w, u w_v, u w
};

PoleColumns columns_of(const RationalPatch& turned, const Pole& pole) {
  const int m = turned.degree_u(), n = turned.degree_v();
  PoleColumns result;
  for (std::size_t c = 0; c < 3; ++c) {
    CoefficientNet d;
    for (int i = 1; i <= m; ++i) {
      d.emplace_back();
      for (int j = 0; j <= n; ++j)
        d.back().push_back(DoubleBall::enclosing(Rational(m, i) * direction(turned, i, j, pole.point)[c]));
    }
    result.space[0][c] = hull_of(derivative_by_u(d));
    result.space[1][c] = hull_of(derivative_by_v(d));
    result.space[2][c] = hull_of(d);
  }
  CoefficientNet w;
  for (int i = 0; i <= m; ++i) {
    w.emplace_back();
    for (int j = 0; j <= n; ++j) w.back().push_back(DoubleBall::enclosing(turned.weight(i, j)));
  }
  const DoubleBall u(0.5, 0.5);
  result.weight = {u * hull_of(derivative_by_u(w)) - hull_of(w), u * hull_of(derivative_by_v(w)),
                   u * hull_of(w)};
  return result;
}

using Deviations = std::array<std::array<double, 3>, 3>;

/// |M - 1| for M the columns in coordinates in which those in the middle are the unit vectors: D and D_v span
/// a plane of space, and the weight takes the first place, with half of D as u w is 0 to w.
Deviations deviations(const PoleColumns& columns) {
  const auto across = cross(columns.space[1], columns.space[2]);
  const auto dual = inverse({across, columns.space[1], columns.space[2]});
  const double weight = columns.weight[0].approximation();
  Deviations p{};
  for (std::size_t j = 0; j < 3; ++j) {
    const DoubleBall along = product(dual[1], columns.space[j]), out = product(dual[2], columns.space[j]);
    const DoubleBall first = DoubleBall(0.5) * out + columns.weight[j] * DoubleBall(1 / weight);
    const std::array<DoubleBall, 3> column = {first, along, out};
    for (std::size_t i = 0; i < 3; ++i) p[i][j] = (column[i] - DoubleBall(i == j ? 1 : 0)).upper_magnitude();
  }
  return p;
}

/// P z < z for some z > 0: every matrix within P of the unit matrix is regular, and the row of D is positive
/// there.
bool is_contraction(const Deviations& p) {
  std::array<double, 3> z = {1, 1, 1};
  for (int k = 0; k < kGuesses; ++k) {
    std::array<double, 3> next{};
    bool is_less = true;
    for (std::size_t i = 0; i < 3; ++i) {
      next[i] = p[i][0] * z[0] + p[i][1] * z[1] + p[i][2] * z[2];
      is_less = is_less && next[i] * kSlack + kUnderflowLoss < z[i];
    }
    if (is_less) return true;
    const double most = std::max({next[0], next[1], next[2]});
    if (!std::isfinite(most)) return false;
    for (std::size_t i = 0; i < 3; ++i) z[i] = next[i] / most + kMargin;
  }
  return false;
}

}  // namespace

std::vector<Pole> poles_of(const RationalPatch& patch) {
  std::vector<Pole> poles;
  for (const std::size_t fixed : {0U, 1U})
    for (const int value : {0, 1}) {
      const Pole pole{fixed, value, patch(fixed == 0 ? value : 0, fixed == 0 ? 0 : value)};
      const RationalPatch turned = turned_to(pole, patch);
      bool is_point = true;
      for (int j = 0; j <= turned.degree_v(); ++j)
        is_point = is_point && is_zero(direction(turned, 0, j, pole.point));
      if (is_point) poles.push_back(pole);
    }
  return poles;
}

bool reaches(const ParameterRectangle& where, const Pole& pole) {
  const RationalInterval& range = pole.fixed == 0 ? where.u : where.v;
  return pole.value == 0 ? range.lower == 0 : range.upper == 1;
}

bool are_apart_but_for(const Pole& pole, const RationalPatch& a, const RationalPatch& b) {
  std::vector<Point> all;
  append_directions(all, turned_to(pole, a), pole, 1);
  append_directions(all, turned_to(pole, b), pole, -1);
  return lie_in_half_space(all);
}

bool is_injective_but_for(const Pole& pole, const RationalPatch& piece) {
  return is_contraction(deviations(columns_of(turned_to(pole, piece), pole)));
}

Node pole_node(const Pole& pole) {
  Node node{};
  node.kinds = {NodeKind::boundary};
  for (std::size_t j = 0; j < 4; ++j) {
    const bool is_fixed = j % 2 == pole.fixed;
    node.box[j] = is_fixed ? RationalInterval{pole.value, pole.value} : RationalInterval{0, 1};
    node.approx[j] = is_fixed ? pole.value : 0.5;
    if (is_fixed) {
      node.on.push_back({all_parameters[j], pole.value});
    } else {
      node.free.push_back(all_parameters[j]);
    }
  }
  for (std::size_t c = 0; c < 3; ++c) node.point[c] = to_double(pole.point[c]);
  return node;
}

}  // namespace exsect
