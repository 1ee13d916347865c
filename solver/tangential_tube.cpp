#include "tangential_tube.h"

#include <algorithm>
#include <cmath>

#include "contact_expansion.h"

namespace exsect {

namespace {

// Covers the rounding of sums of fewer than 1000 nonnegative terms, each a product of at most 16 factors.
constexpr double kSlack = 1 + 0x1p-40;
constexpr double kWidthOfReach = 1;
constexpr double kWorstContraction = 0.5;

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

/// C and the slope for one axis.
struct Linearisation {
  std::size_t axis;
  Matrix3 preconditioner;
  std::array<double, 4> slope;
};

template <class Ball>
std::optional<Linearisation> linearised(const ContactEquations<Ball>& phi, std::size_t axis) {
  const auto jacobian = linear_part(phi, axis);
  const auto others = other_axes(axis);
  std::array<Row3, 3> columns;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t row = 0; row < 3; ++row) {
      columns[i][row] = jacobian[row][others[i]].approximation();
    }
  }
  const auto c = approximate_inverse(columns);
  if (!c) {
    return std::nullopt;
  }
  Linearisation result{axis, *c, {}};
  result.slope[axis] = 1;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t row = 0; row < 3; ++row) {
      result.slope[others[i]] -= (*c)[i][row] * jacobian[row][axis].approximation();
    }
  }
  return result;
}

double steepness(const Linearisation& l) {
  return std::max(
      {std::fabs(l.slope[0]), std::fabs(l.slope[1]), std::fabs(l.slope[2]), std::fabs(l.slope[3])});
}

template <class Ball>
std::optional<Linearisation> best_linearisation(const Expansion<Ball>& at,
                                                const std::array<std::size_t, 2>& rows) {
  std::optional<Linearisation> best;
  for (std::size_t axis = 0; axis < 4; ++axis) {
    const auto candidate = linearised(contact_equations(at, rows, axis), axis);
    if (candidate && (!best || steepness(*candidate) < steepness(*best))) {
      best = candidate;
    }
  }
  return best;
}

double power(double x, std::size_t n) { return n == 0 ? 1 : n == 1 ? x : n == 2 ? x * x : x * x * x; }

/// Bounds of |d_j g - ideal| over |offset in parameter i| <= h[i], [row][parameter]; g = C Phi around a
/// centre, ideal = identity for j != axis and -d for j = axis.
using JacobianDeviation = std::array<std::array<double, 4>, 3>;

template <class Ball>
JacobianDeviation jacobian_deviation(const ContactEquations<Ball>& g, std::size_t axis,
                                     const std::array<double, 4>& slope, const std::array<double, 4>& h) {
  const auto variables = contact_variables(axis);
  const auto others = other_axes(axis);
  const auto linear = linear_part(g, axis);
  std::array<std::array<double, 4>, 4> p;  // powers of the widths, with one factor less in `less`
  std::array<std::array<double, 4>, 4> less{};
  for (std::size_t w = 0; w < 4; ++w) {
    for (std::size_t n = 0; n < 4; ++n) {
      p[w][n] = power(h[variables[w]], n);
      less[w][n] = n == 0 ? 0 : p[w][n - 1];
    }
  }
  JacobianDeviation result{};
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t j = 0; j < 4; ++j) {
      const double ideal = j == axis ? -slope[others[row]] : (others[row] == j ? 1.0 : 0.0);
      result[row][j] = (linear[row][j] - Ball(ideal)).upper_magnitude();
    }
    std::array<double, 4> sum;
    for (std::size_t v = 0; v < 4; ++v) {
      sum[v] = result[row][variables[v]];
    }
    for_each_term([&](std::size_t t, const std::array<std::size_t, 4>& e) {
      const double c = e[0] + e[1] + e[2] + e[3] < 2 ? 0 : g[row].c[t].upper_magnitude();
      if (c == 0) {
        return;
      }
      const auto [i, j, k, l] = e;
      if (i > 0) {
        sum[0] += c * static_cast<double>(i) * less[0][i] * p[1][j] * p[2][k] * p[3][l];
      }
      if (j > 0) {
        sum[1] += c * static_cast<double>(j) * p[0][i] * less[1][j] * p[2][k] * p[3][l];
      }
      if (k > 0) {
        sum[2] += c * static_cast<double>(k) * p[0][i] * p[1][j] * less[2][k] * p[3][l];
      }
      if (l > 0) {
        sum[3] += c * static_cast<double>(l) * p[0][i] * p[1][j] * p[2][k] * less[3][l];
      }
    });
    for (std::size_t v = 0; v < 4; ++v) {
      result[row][variables[v]] = sum[v];
    }
  }
  return result;
}

double largest_row_sum(const JacobianDeviation& e, std::size_t axis) {
  double largest = 0;
  for (const auto& row : e) {
    double sum = 0;
    for (const std::size_t j : other_axes(axis)) {
      sum += row[j];
    }
    largest = std::max(largest, sum);
  }
  return kSlack * largest;
}

/// |C Phi'(box) d| <= sum_j E_j |d_j|: the ideal matrix maps d to 0.
double direction_residual(const JacobianDeviation& e, const std::array<double, 4>& d) {
  double largest = 0;
  for (const auto& row : e) {
    double sum = 0;
    for (std::size_t j = 0; j < 4; ++j) {
      sum += row[j] * std::fabs(d[j]);
    }
    largest = std::max(largest, sum);
  }
  return kSlack * largest;
}

/// |C Phi(p + tau d)| for |tau| <= reach, power by power of tau.
template <class Ball>
double residual_on_line(const ContactEquations<Ball>& g, std::size_t axis, const std::array<double, 4>& d,
                        double reach) {
  const auto variables = contact_variables(axis);
  double largest = 0;
  for (std::size_t row = 0; row < 3; ++row) {
    std::array<Ball, 11> by_degree;
    for_each_term([&](std::size_t t, const std::array<std::size_t, 4>& e) {
      Ball term = g[row].c[t];
      for (std::size_t v = 0; v < 4; ++v) {
        for (std::size_t n = 0; n < e[v]; ++n) {
          term *= Ball(d[variables[v]]);
        }
      }
      by_degree[e[0] + e[1] + e[2] + e[3]] += term;
    });
    double sum = 0;
    double scale = 1;
    for (const Ball& coefficient : by_degree) {
      sum += coefficient.upper_magnitude() * scale;
      scale *= reach;
    }
    largest = std::max(largest, sum);
  }
  return kSlack * largest;
}

template <class Ball>
Ball from_line(const TangentialTube<Ball>& tube, const BallPoint<Ball>& box, const Ball& tau, std::size_t j) {
  return box[j] - tube.centre[j] - tau * Ball(tube.slope[j]);
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
  const auto line =
      axis ? linearised(contact_equations(at, tube.rows, *axis), *axis) : best_linearisation(at, tube.rows);
  if (!line) {
    return std::nullopt;
  }
  tube.axis = line->axis;
  tube.preconditioner = line->preconditioner;
  tube.slope = line->slope;
  tube.reach = reach;
  tube.halfwidth = kWidthOfReach * reach;
  std::array<double, 4> h{};
  for (std::size_t j = 0; j < 4; ++j) {
    h[j] = kSlack * (std::fabs(tube.slope[j]) * reach + (j == tube.axis ? 0 : tube.halfwidth));
  }
  const auto g = preconditioned(tube.preconditioner, contact_equations(at, tube.rows, tube.axis));
  const JacobianDeviation e = jacobian_deviation(g, tube.axis, tube.slope, h);
  tube.contraction = largest_row_sum(e, tube.axis);
  const double f = residual_on_line(g, tube.axis, tube.slope, reach);
  if (!(tube.contraction <= kWorstContraction) || !(16 * f <= tube.halfwidth)) {
    return std::nullopt;
  }
  tube.core = (tube.halfwidth - 8 * f) / (3 * kSlack);
  tube.slope_error = kSlack * direction_residual(e, tube.slope) / (1 - tube.contraction);
  return tube;
}

template <class Ball>
std::optional<BallPoint<Ball>> corrected_to_contact(const PairSystem<Ball>& system,
                                                    const BallPoint<Ball>& start, std::size_t axis,
                                                    int steps) {
  return newton_steps<Ball>(start, axis, steps, [&](const BallPoint<Ball>& p) {
    const Expansion<Ball> at(system, p);
    const auto rows = tangent_rows(at);
    const auto line = linearised(contact_equations(at, rows, axis), axis);
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

// With C and d made for the middle of the part, |C DPhi - (I, -d)| <= E on a box around it that holds the
// part. The exact w' has 0 = C Phi'(w) w' = C Phi'(w) d + M (w' - d) with |M - I| <= sigma, the greatest row
// sum of E without the axis, and |C Phi'(w) d| <= sum_j E_j |d_j|: |w' - d| <= sum_j E_j |d_j| / (1 - sigma).
template <class Ball>
ArcEnclosure<Ball> enclosure_between(const PairSystem<Ball>& system, const TangentialTube<Ball>& tube,
                                     double from, double to) {
  const double half = 0.5 * std::fabs(to - from) * kSlack;
  const BallPoint<Ball> middle = point_at(system, tube, 0.5 * (from + to));
  BallPoint<Ball> centre;
  double radius = 0;
  for (std::size_t j = 0; j < 4; ++j) {
    centre[j] = middle[j].midpoint();
    radius = std::max(radius, (middle[j] - centre[j]).upper_magnitude());
  }
  const auto phi = contact_equations(Expansion<Ball>(system, centre), tube.rows, tube.axis);
  const Linearisation local =
      linearised(phi, tube.axis).value_or(Linearisation{tube.axis, tube.preconditioner, tube.slope});
  const auto g = preconditioned(local.preconditioner, phi);
  std::array<double, 4> d = tube.slope;
  double error = tube.slope_error;
  for (int i = 0; i < 3; ++i) {
    std::array<double, 4> h{};
    for (std::size_t j = 0; j < 4; ++j) {
      h[j] = kSlack * (half * (std::fabs(d[j]) + (j == tube.axis ? 0 : error)) + radius);
    }
    const JacobianDeviation e = jacobian_deviation(g, tube.axis, local.slope, h);
    const double sigma = largest_row_sum(e, tube.axis);
    const double bound = kSlack * direction_residual(e, local.slope) / (1 - sigma);
    if (!(sigma < 1) || !(bound < error)) {
      break;
    }
    d = local.slope;
    error = bound;
  }
  ArcEnclosure<Ball> result;
  for (std::size_t j = 0; j < 4; ++j) {
    const bool exact = j == tube.axis;
    result.at[j] = middle[j].widened(half * (std::fabs(d[j]) + (exact ? 0 : error)) * kSlack);
    result.slope[j] = exact ? Ball(1) : Ball(d[j]).widened(error);
  }
  return result;
}

template <class Ball>
Ball offset(const TangentialTube<Ball>& tube, const BallPoint<Ball>& point) {
  return point[tube.axis] - tube.centre[tube.axis];
}

template <class Ball>
bool contains(const TangentialTube<Ball>& tube, const BallPoint<Ball>& box) {
  const Ball tau = offset(tube, box);
  const auto others = other_axes(tube.axis);
  return tau.upper_magnitude() <= tube.reach && std::all_of(others.begin(), others.end(), [&](std::size_t j) {
           return from_line(tube, box, tau, j).upper_magnitude() <= tube.core;
         });
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
  template ArcEnclosure<Ball> enclosure_between(const PairSystem<Ball>&, const TangentialTube<Ball>&,     \
                                                double, double);                                          \
  template Ball offset(const TangentialTube<Ball>&, const BallPoint<Ball>&);                              \
  template bool contains(const TangentialTube<Ball>&, const BallPoint<Ball>&);                            \
  template bool excludes(const TangentialTube<Ball>&, const BallPoint<Ball>&);

EXSECT_INSTANTIATE_TANGENTIAL(DoubleBall)
EXSECT_INSTANTIATE_TANGENTIAL(DoubleDoubleBall)
EXSECT_INSTANTIATE_TANGENTIAL(ArbBall<256>)
#undef EXSECT_INSTANTIATE_TANGENTIAL

}  // namespace exsect
