// Checks of certified points by substitution back, independent of how they were found.
#pragma once

#include <exsect/algebra/fixed_point_interval.h>
#include <exsect/algebra/quadratic_sign.h>
#include <exsect/geometry/bezier_patch.h>
#include <exsect/solver/line_patch.h>

#include <algorithm>
#include <array>

#include "support/catch.h"

namespace exsect {

inline bool contains(const ParameterBox& box, const std::array<Rational, 4>& point) {
  for (std::size_t i = 0; i < 4; ++i)
    if (point[i] < box[i].lower || point[i] > box[i].upper) return false;
  return true;
}

/// x(u,v) - y(r,s) over the box, coordinate k.
inline RationalInterval difference_over(const BezierPatch& x, const BezierPatch& y, const ParameterBox& box,
                                        std::size_t k, long bits) {
  const auto coordinate = [&](const BezierPatch& patch, std::size_t first) {
    const ControlNet c = patch.power_basis();
    std::vector<Polynomial> rows;
    for (const auto& row : c) rows.emplace_back(std::vector<Rational>{row[0][k], row[1][k], row[2][k]});
    return enclose(BivariatePolynomial(rows), FixedPointInterval(box[first], bits),
                   FixedPointInterval(box[first + 1], bits));
  };
  return (coordinate(x, 0) - coordinate(y, 2)).interval();
}

/// The box has the width asked for, lies in [0,1]^4 and is nested; x - y contains 0 over boxes of width
/// 2^-200.
inline void check_point(const BezierPatch& x, const BezierPatch& y, const CertifiedPoint& p) {
  const Rational width = power_of_two(-200);
  const CertifiedPoint fine = p.refined_to(width);
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(p.box()[i].width() <= power_of_two(-50));
    CHECK(fine.box()[i].width() <= width);
    CHECK(fine.box()[i].lower <= fine.box()[i].upper);
    CHECK(fine.box()[i].lower >= p.box()[i].lower);
    CHECK(fine.box()[i].upper <= p.box()[i].upper);
    CHECK(p.box()[i].lower >= 0);
    CHECK(p.box()[i].upper <= 1);
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const RationalInterval d = difference_over(x, y, fine.box(), k, 300);
    CHECK(d.lower <= 0);
    CHECK(d.upper >= 0);
    CHECK(d.width() < power_of_two(-180));
  }
  for (const Parameter q : all_parameters)
    for (const int side : {0, 1}) {
      const RationalInterval& i = fine.box()[index(q)];
      if (p.on({q, side}))
        CHECK((i.lower == side && i.upper == side));
      else
        CHECK((i.lower > 0 || i.upper < 1));
    }
}

inline bool in_interval(const FeasibleInterval& i, const RealAlgebraic& s) {
  if (s < i.from || i.to < s) return false;
  return (i.from_closed || i.from < s) && (i.to_closed || s < i.to);
}

/// A root of the eliminant carries a point on branch i if and only if the root is in a feasible interval of
/// branch i and the plane's root r_i there lies on the cylinder (A, D, 2 A alpha - B beta +- beta sqrt D for
/// Z = alpha + beta r).
inline void check_feasibility(const LineIntersection& line) {
  if (line.shape != LineShape::conic || line.eliminant.degree() <= 0) return;
  const BivariatePolynomial& p = line.pullback.plane;
  const Polynomial a = p.coefficient(2);
  const Polynomial b = p.coefficient(1);
  const Polynomial d = b * b - Polynomial(4) * a * p.coefficient(0);
  BivariatePolynomial z = line.pullback.cylinder();
  while (z.degree_r() >= 2) {
    BivariatePolynomial shifted = p * z.coefficient(z.degree_r());
    for (int i = 2; i < z.degree_r(); ++i) shifted = shifted * BivariatePolynomial::r();
    z = z * a - shifted;
  }
  std::size_t expected = 0;
  for (const RealAlgebraic& s : real_roots(line.eliminant, 0, 1)) {
    if (sign_at(a, s) == 0) return;
    for (const FeasibleBranch& branch : line.feasible) {
      const Polynomial alpha = Polynomial(2) * a * z.coefficient(0) - b * z.coefficient(1);
      const Polynomial beta = Polynomial(branch.branch == 1 ? -1 : 1) * z.coefficient(1);
      const bool on_cylinder = sign_at(d, s) >= 0 && quadratic_sign(alpha, beta, d, s) == 0;
      const bool feasible =
          std::ranges::any_of(branch.intervals, [&](const auto& i) { return in_interval(i, s); });
      const bool double_root = sign_at(d, s) == 0 && branch.branch == 2;
      if (on_cylinder && feasible && !double_root) ++expected;
    }
  }
  CHECK(line.solution.points.size() == expected);
}

}  // namespace exsect
