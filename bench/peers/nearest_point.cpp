#include "nearest_point.h"

#include <Eigen/Dense>
#include <cmath>

namespace peers {
namespace {

Eigen::Vector3d vector(const Point& p) { return {p[0], p[1], p[2]}; }

/// Value of x - y, its derivatives, and those of x alone.
struct System {
  Eigen::Vector3d value;
  Eigen::Matrix<double, 3, 4> derivative;
  Eigen::Matrix<double, 3, 4> in_space;
  Eigen::Vector3d point;
};

System system_at(const PatchPair& pair, const Eigen::Vector4d& w) {
  const Evaluated x = evaluate(pair.x, w[0], w[1]);
  const Evaluated y = evaluate(pair.y, w[2], w[3]);
  System result;
  result.point = vector(x.point);
  result.value = result.point - vector(y.point);
  result.derivative << vector(x.first), vector(x.second), -vector(y.first), -vector(y.second);
  result.in_space << vector(x.first), vector(x.second), Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero();
  return result;
}

}  // namespace

double distance(const Point& a, const Point& b) { return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]); }

double residual(const PatchPair& pair, const std::array<double, 4>& parameters) {
  return distance(evaluate(pair.x, parameters[0], parameters[1]).point,
                  evaluate(pair.y, parameters[2], parameters[3]).point);
}

std::optional<Vertex> nearest_point(const PatchPair& pair, const Point& p,
                                    const std::array<double, 4>& start) {
  constexpr int steps = 30;
  constexpr double converged = 1e-13;
  constexpr double outside = 1e-6;
  constexpr double far = 2;  // parameters from which no step leads back
  Eigen::Vector4d w(start[0], start[1], start[2], start[3]);
  const double size = pair.size();
  for (int i = 0; i < steps; ++i) {
    // Back to the curve by the shortest step, and along its tangent t to the foot of p.
    const System f = system_at(pair, w);
    const auto svd = f.derivative.jacobiSvd(Eigen::ComputeFullU | Eigen::ComputeFullV);
    Eigen::Vector4d step = -svd.solve(f.value);
    const Eigen::Vector4d t = svd.matrixV().col(3);
    const Eigen::Vector3d direction = f.in_space * t;
    if (direction.squaredNorm() > 0) {
      step += t * (vector(p) - f.point - f.in_space * step).dot(direction) / direction.squaredNorm();
    }
    if (!(step.norm() < far)) return std::nullopt;
    w += step;
    if (step.norm() > converged) continue;
    const bool inside = w.minCoeff() >= -outside && w.maxCoeff() <= 1 + outside;
    if (!inside || f.value.norm() > converged * size) return std::nullopt;
    return Vertex{evaluate(pair.x, w[0], w[1]).point, {w[0], w[1], w[2], w[3]}};
  }
  return std::nullopt;
}

}  // namespace peers
