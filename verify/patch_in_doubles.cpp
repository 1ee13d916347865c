#include "patch_in_doubles.h"

#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "derivative_bounds.h"
#include "infinite.h"

namespace exsect {
namespace {

constexpr int deepest_halving = 40;  // halvings of a net
/// A coefficient is rounded, and passes at most six times through a product and a sum.
constexpr double errors_of_value = 16;
/// A control point is rounded, and each halving takes three means.
constexpr double errors_of_net = 3 * deepest_halving + 8;

/// At least the length.
double norm(const SpacePoint& a) { return length_bound(a[0], a[1], a[2]); }

SpacePoint vector_of(const std::array<double, 4>& a) { return {a[0], a[1], a[2]}; }

std::size_t at(std::size_t i, std::size_t j) { return 4 * i + j; }

/// The power of two that brings the largest weight into [1,2).
Rational scale_of(const RationalPatch& patch) {
  Rational most = 0;
  for (int i = 0; i <= patch.degree_u(); ++i)
    for (int j = 0; j <= patch.degree_v(); ++j) most = std::max(most, patch.weight(i, j));
  long exponent = static_cast<long>(msb(numerator(most))) - static_cast<long>(msb(denominator(most)));
  if (most < power_of_two(exponent)) --exponent;
  return power_of_two(-exponent);
}

}  // namespace

PatchInDoubles::PatchInDoubles(const RationalPatch& given, const Rational& margin)
    : m_(static_cast<std::size_t>(given.reduced().degree_u())),
      n_(static_cast<std::size_t>(given.reduced().degree_v())),
      polynomial_(given.is_polynomial()) {
  const RationalPatch& patch = given.reduced();
  const Rational scale = scale_of(patch);
  for (std::size_t k = 0; k < 4; ++k) {
    const BivariatePolynomial component = patch.component(static_cast<int>(k));
    for (std::size_t i = 0; i <= m_; ++i) {
      for (std::size_t j = 0; j <= n_; ++j) {
        const auto row = static_cast<int>(i);
        const auto column = static_cast<int>(j);
        power_[at(i, j)][k] = to_double(scale * component.coefficient(row, column));
        net_[at(i, j)][k] = to_double(scale * patch.homogeneous(row, column)[k]);
      }
    }
  }
  Error value;  // of sums of all terms, for parameters in [-1,2]
  for (std::size_t i = 0; i <= m_; ++i) {
    for (std::size_t j = 0; j <= n_; ++j) {
      const auto twos = static_cast<int>(i + j);
      value.vector += std::ldexp(norm(vector_of(power_[at(i, j)])), twos);
      value.weight += std::ldexp(std::fabs(power_[at(i, j)][3]), twos);
      net_error_.vector = std::max(net_error_.vector, norm(vector_of(net_[at(i, j)])));
      net_error_.weight = std::max(net_error_.weight, std::fabs(net_[at(i, j)][3]));
    }
  }
  for (const auto& [error, count] :
       {std::pair(&value, errors_of_value), std::pair(&net_error_, errors_of_net)}) {
    error->vector = count * kUnitRoundoff * error->vector * kSlack + kUnderflowLoss;
    error->weight = polynomial_ ? 0 : count * kUnitRoundoff * error->weight * kSlack + kUnderflowLoss;
  }
  bound_derivatives(patch, margin, value);
}

/// x = X / w, where X and w are known up to `error`.
void PatchInDoubles::bound_derivatives(const RationalPatch& patch, const Rational& margin,
                                       const Error& error) {
  const Point middle = patch(Rational(1, 2), Rational(1, 2));
  const SpacePoint origin = {to_double(middle[0]), to_double(middle[1]), to_double(middle[2])};
  const DerivativeBounds bounds = derivative_bounds(patch, margin, origin, scale_of(patch));
  speed_ = bounds.first;
  second_ = bounds.second;
  const double far = norm(origin) + bounds.reach;
  const double least = bounds.least_weight - error.weight;
  rounding_ = infinite;
  if (polynomial_)
    rounding_ = error.vector;
  else if (least > error.weight)
    rounding_ = ((error.vector + far * error.weight) / least + 4 * kUnitRoundoff * far) * kSlack;
}

SpacePoint PatchInDoubles::operator()(double u, double v) const {
  Vector4 value{};
  for (std::size_t k = 0; k < 4; ++k) {
    for (std::size_t i = m_ + 1; i-- > 0;) {
      double in_v = 0;
      for (std::size_t j = n_ + 1; j-- > 0;) in_v = in_v * v + power_[at(i, j)][k];
      value[k] = value[k] * u + in_v;
    }
  }
  if (polynomial_) return {value[0], value[1], value[2]};
  return {value[0] / value[3], value[1] / value[3], value[2] / value[3]};
}

double PatchInDoubles::second_derivative(double du, double dv) const {
  return (second_[0] * du * du + 2 * second_[1] * std::fabs(du * dv) + second_[2] * dv * dv) * kSlack;
}

double PatchInDoubles::distance_from_hull(const SpacePoint& p, const Net& net) const {
  std::array<double, 3> lower = {infinite, infinite, infinite};
  std::array<double, 3> upper = {-infinite, -infinite, -infinite};
  double slack = 0;
  std::array<SpacePoint, 16> points;
  std::size_t count = 0;
  for (std::size_t i = 0; i <= m_; ++i) {
    for (std::size_t j = 0; j <= n_; ++j) {
      const Vector4& q = net[at(i, j)];
      const double least = q[3] - 2 * net_error_.weight;
      if (!(least > 0)) return -1;
      const SpacePoint point = {q[0] / q[3], q[1] / q[3], q[2] / q[3]};
      const double far = norm(point);
      const double error =
          (net_error_.vector + 2 * far * net_error_.weight) / least + 4 * kUnitRoundoff * far;
      slack = std::max(slack, 2 * error);
      for (std::size_t k = 0; k < 3; ++k) {
        lower[k] = std::min(lower[k], point[k]);
        upper[k] = std::max(upper[k], point[k]);
      }
      points[count++] = point;
    }
  }
  double gap = 0;  // the box of the points is at least that far
  for (std::size_t k = 0; k < 3; ++k) {
    const double outside = std::max({lower[k] - p[k], p[k] - upper[k], 0.0});
    gap += outside * outside;
  }
  const SpacePoint centre = between(points[0], points[count - 1], 0.5);
  double reach = 0;  // all points are within it of the centre
  for (std::size_t i = 0; i < count; ++i) reach = std::max(reach, distance(points[i], centre));
  return std::max(std::sqrt(gap), distance(p, centre) - reach) * kReduced - slack - kUnderflowLoss;
}

/// Both halves by de Casteljau's algorithm, of the first parameter or of the second.
std::array<PatchInDoubles::Net, 2> PatchInDoubles::halves(const Net& net, bool first) const {
  std::array<Net, 2> result = {net, net};
  const std::size_t degree = first ? m_ : n_;
  const std::size_t lines = first ? n_ : m_;
  const auto entry = [&](std::size_t along, std::size_t line) {
    return first ? at(along, line) : at(line, along);
  };
  for (std::size_t line = 0; line <= lines; ++line) {
    for (std::size_t level = 1; level <= degree; ++level) {
      Net& right = result[1];  // holds the means of the last level, from its start on
      for (std::size_t i = 0; i + level <= degree; ++i)
        for (std::size_t k = 0; k < 4; ++k)
          right[entry(i, line)][k] = right[entry(i, line)][k] / 2 + right[entry(i + 1, line)][k] / 2;
      result[0][entry(level, line)] = right[entry(0, line)];
    }
  }
  return result;
}

bool PatchInDoubles::certainly_farther(const SpacePoint& p, double radius) const {
  struct Piece {
    Net net;
    int depth;
  };
  std::vector<Piece> waiting = {{net_, 0}};
  constexpr std::size_t most_steps = 4096;
  for (std::size_t step = 0; step < most_steps; ++step) {
    if (waiting.empty()) return true;
    const Piece piece = waiting.back();
    waiting.pop_back();
    if (distance_from_hull(p, piece.net) > radius * kSlack) continue;
    if (piece.depth == deepest_halving) return false;
    for (const Net& half : halves(piece.net, piece.depth % 2 == 0))
      waiting.push_back({half, piece.depth + 1});
  }
  return false;
}

}  // namespace exsect
