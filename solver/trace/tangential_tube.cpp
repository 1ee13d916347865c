#include "trace/tangential_tube.h"

#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <cmath>

#include "trace/contact_expansion.h"

namespace exsect {

namespace {

constexpr double kWidthOfReach = 1;
constexpr double kWorstTangentialContraction = 0.5;

template <class Ball>
BallVector<Ball> contact_value(const Expansion<Ball>& at, const std::array<std::size_t, 2>& rows,
                               std::size_t axis) {
  const BallVector<Ball> f = at.value();
  return {f[rows[0]], f[rows[1]], at.tangent()[axis]};
}

/// The coordinates apart from the one in which the common normal is largest.
template <class Ball>
std::array<std::size_t, 2> tangent_rows(const Expansion<Ball>& at) {
  const BallVector<Ball> n = cross(at.x[3], at.x[1]);
  std::size_t largest = 0;
  for (std::size_t c = 1; c < 3; ++c) {
    if (std::fabs(n[c].approximation()) > std::fabs(n[largest].approximation())) {
      largest = c;
    }
  }
  return {largest == 0 ? 1U : 0U, largest == 2 ? 1U : 2U};
}

double steepness(const Linearisation& l) {
  return larger_bound(std::fabs(l.slope[0]), std::fabs(l.slope[1]), std::fabs(l.slope[2]),
                      std::fabs(l.slope[3]));
}

template <class Ball>
std::optional<Linearisation> best_linearisation(const Expansion<Ball>& at,
                                                const std::array<std::size_t, 2>& rows) {
  std::optional<Linearisation> best;
  for (std::size_t axis = 0; axis < 4; ++axis) {
    const auto candidate = linearised(linear_part(contact_equations(at, rows, axis)), axis);
    if (candidate && (!best || steepness(*candidate) < steepness(*best))) {
      best = candidate;
    }
  }
  return best;
}

}  // namespace

// Krawczyk on every slice tau: f >= |C Phi(p + tau d)| and f + rho Z < Z. The point of the arc is within f/(1
// - rho) <= 2 f of the line. Let w1 be it, w2 another zero of F in the same slice of the core. C Phi is
// injective on the slice, and t -> (C Phi)^-1 (t C Phi(w2)), 0 <= t <= 1, is a path from w1 to w2 that stays
// within (1 + rho)/(1 - rho) |w2 - w1| <= 3 (2 f + core) of w1: inside the region if 8 f + 3 core <= Z. F_a =
// F_b = 0 along it and T_k = t T_k(w2). T_k is the determinant of the derivatives of F in the slice, so for t
// > 0 the third coordinate of F is strictly monotone along the path, unless T_k(w2) = 0: then w2 = w1. So
// F(w2) = F(w1) = 0 is possible for w2 = w1 only.
template <class Ball>
std::optional<TangentialTube<Ball>> certify_tangential_tube(const PairSystem<Ball>& system,
                                                            const BallPoint<Ball>& centre, double reach,
                                                            std::optional<std::size_t> axis) {
  TangentialTube<Ball> tube;
  for (std::size_t j = 0; j < 4; ++j) {
    tube.centre[j] = centre[j].midpoint();
  }
  const Expansion<Ball> at(system, tube.centre);
  tube.rows = tangent_rows(at);
  const auto line = axis ? linearised(linear_part(contact_equations(at, tube.rows, *axis)), *axis)
                         : best_linearisation(at, tube.rows);
  if (!line) {
    return std::nullopt;
  }
  tube.axis = line->axis;
  tube.preconditioner = line->preconditioner;
  tube.slope = line->slope;
  tube.reach = reach;
  tube.halfwidth = kWidthOfReach * reach;
  const auto g = preconditioned(tube.preconditioner, contact_equations(at, tube.rows, tube.axis));
  const JacobianDeviation e = jacobian_deviation(g, tube.axis, tube.slope, half_widths(tube));
  tube.contraction = largest_of(row_sums(e, tube.axis));
  const double f = largest_of(residual_on_line(g, tube.axis, tube.slope, reach));
  if (!(tube.contraction <= kWorstTangentialContraction) || !(16 * f <= tube.halfwidth)) {
    return std::nullopt;
  }
  tube.core = (tube.halfwidth - 8 * f) / (3 * kSlack);
  tube.slope_error = slope_errors(e, tube.axis, tube.slope, tube.contraction);
  return tube;
}

template <class Ball>
std::optional<BallPoint<Ball>> corrected_to_contact(const PairSystem<Ball>& system,
                                                    const BallPoint<Ball>& start, std::size_t axis,
                                                    int steps) {
  return newton_steps<Ball>(start, axis, steps, [&](const BallPoint<Ball>& p) {
    const Expansion<Ball> at(system, p);
    const auto rows = tangent_rows(at);
    const auto line = linearised(linear_part(contact_equations(at, rows, axis)), axis);
    return line ? std::optional(preconditioned(line->preconditioner, contact_value(at, rows, axis)))
                : std::nullopt;
  });
}

template <class Ball>
BallPoint<Ball> point_at(const PairSystem<Ball>& system, const TangentialTube<Ball>& tube, double tau) {
  const auto others = other_axes(tube.axis);
  BallPoint<Ball> w;
  for (std::size_t j = 0; j < 4; ++j) {
    w[j] = tube.centre[j] + Ball(tau) * Ball(tube.slope[j]);
    w[j] = j == tube.axis ? w[j] : w[j].midpoint();
  }
  auto [best_point, residual] = contracted<Ball>(w, tube.axis, [&](const BallPoint<Ball>& at) {
    return preconditioned(tube.preconditioner,
                          contact_value(Expansion<Ball>(system, at), tube.rows, tube.axis));
  });
  const double radius = kSlack * *std::max_element(residual.begin(), residual.end()) / (1 - tube.contraction);
  for (const std::size_t j : others) {
    const bool inside = from_line(tube, best_point, Ball(tau), j).upper_magnitude() <= tube.halfwidth;
    if (!inside || !(radius < tube.halfwidth)) {  // the bound holds in the region only
      for (const std::size_t i : others) {
        best_point[i] = (tube.centre[i] + Ball(tau) * Ball(tube.slope[i])).widened(tube.core);
      }
      return best_point;
    }
  }
  for (const std::size_t j : others) {
    best_point[j] = best_point[j].widened(radius);
  }
  return best_point;
}

template <class Ball>
bool contains(const TangentialTube<Ball>& tube, const BallPoint<Ball>& box) {
  return contains_within(tube, box, tube.core);
}

template <class Ball>
bool excludes(const TangentialTube<Ball>& tube, const BallPoint<Ball>& box) {
  const Ball tau = offset(tube, box);
  const auto others = other_axes(tube.axis);
  return tau.lower_magnitude() > tube.reach || std::any_of(others.begin(), others.end(), [&](std::size_t j) {
           return from_line(tube, box, tau, j).lower_magnitude() > tube.core;
         });
}

#define EXSECT_INSTANTIATE_TANGENTIAL(Ball)                                                               \
  template std::optional<TangentialTube<Ball>> certify_tangential_tube(                                   \
      const PairSystem<Ball>&, const BallPoint<Ball>&, double, std::optional<std::size_t>);               \
  template std::optional<BallPoint<Ball>> corrected_to_contact(const PairSystem<Ball>&,                   \
                                                               const BallPoint<Ball>&, std::size_t, int); \
  template BallPoint<Ball> point_at(const PairSystem<Ball>&, const TangentialTube<Ball>&, double);        \
  template bool contains(const TangentialTube<Ball>&, const BallPoint<Ball>&);                            \
  template bool excludes(const TangentialTube<Ball>&, const BallPoint<Ball>&);

EXSECT_INSTANTIATE_TANGENTIAL(DoubleBall)
EXSECT_INSTANTIATE_TANGENTIAL(DoubleDoubleBall)
EXSECT_INSTANTIATE_TANGENTIAL(ArbBall<256>)
EXSECT_INSTANTIATE_TANGENTIAL(ArbBall<1024>)
#undef EXSECT_INSTANTIATE_TANGENTIAL

}  // namespace exsect
