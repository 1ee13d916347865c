#include "shape/fold_expansion.h"

namespace exsect {
namespace {

/// M_2 and order: 2 d_20 p + d_11 h is a multiple of d_20 to as high an order in h as the turn of the lines
/// near v = c is a polynomial in h. False if it is so to every order.
bool divide_by_turn(FoldExpansion& fold) {
  const std::array<Point, 3> first = {Rational(2) * fold.d[2][0], Rational(2) * fold.d[2][1],
                                      Rational(2) * fold.d[2][2]};
  fold.order = 1;
  fold.second = {fold.d[1][1], fold.d[1][2], {0, 0, 0}};
  std::array<Point, 3>& b = fold.second;
  while (is_zero(cross(first[0], b[0]))) {
    const Rational k = dot(b[0], first[0]) / dot(first[0], first[0]);
    fold.turns.push_back(k);
    b = {b[1] - k * first[1], b[2] - k * first[2], {0, 0, 0}};
    if (is_zero(b[0]) && is_zero(b[1])) return false;
    ++fold.order;
  }
  return true;
}

/// alpha and beta, and the contact of a planar fold; d_20 and second_0 are independent.
void divide_by_plane(FoldExpansion& fold) {
  const Point first = Rational(2) * fold.d[2][0];
  const Point& second = fold.second[0];
  const Point normal = cross(first, second);
  const Rational scale = dot(normal, normal);
  for (const std::size_t i : {0, 1}) {
    fold.alpha[i] = determinant(fold.d[2 * i][1], second, normal) / scale;
    fold.beta[i] = determinant(first, fold.d[2 * i][1], normal) / scale;
  }
  const Polynomial beta{fold.beta[0], fold.beta[1]};
  if (fold.order > 1) {
    fold.contact = beta * beta * beta *
                   (beta * Polynomial(dot(normal, fold.second[1])) -
                    Polynomial(2) * Polynomial{dot(normal, fold.d[0][2]), dot(normal, fold.d[2][2])});
    return;
  }
  const Rational n12 = dot(normal, fold.d[1][2]);
  fold.contact = Polynomial{0, n12} + beta * beta * Polynomial(n12) -
                 Polynomial(2) * beta * Polynomial{dot(normal, fold.d[0][2]), dot(normal, fold.d[2][2])};
}

}  // namespace

std::optional<FoldExpansion> fold_expansion(const BezierPatch& x, const Rational& f, const Rational& c) {
  FoldExpansion fold{f, c, x.restricted_to(f, f + 1, c, c + 1).power_basis(), 1, false, {}, {}, {}, {}, {}};
  if (!divide_by_turn(fold)) return std::nullopt;
  const Point& first = fold.d[2][0];
  fold.contact = Polynomial{2 * determinant(first, fold.second[0], fold.d[0][1]),
                            2 * determinant(first, fold.second[0], fold.d[2][1])};
  if (fold.contact.is_zero()) {
    fold.planar = true;
    divide_by_plane(fold);
  }
  if (fold.contact.is_zero()) return std::nullopt;
  return fold;
}

}  // namespace exsect
