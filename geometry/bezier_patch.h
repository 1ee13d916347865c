// Bézier patches of bidegree (2,2) with exact rational control nets.
#pragma once

#include <exsect/geometry/point.h>

#include <array>
#include <memory>
#include <mutex>
#include <vector>

namespace exsect {

/// Control points of a patch of bidegree (2,2): row index = first parameter, column index = second.
using ControlNet = std::array<std::array<Point, 3>, 3>;

/// x(u,v) = sum_ij B_i^2(u) B_j^2(v) X[i][j] over (u,v) in [0,1]^2 (0.1). Any net is legal: degeneracy is a
/// question you can ask, not an error. Immutable: copies share the net.
class BezierPatch {
 public:
  explicit BezierPatch(const ControlNet& net) : nets_(std::make_shared<Nets>(net)) {}
  // Not movable: every patch has a net.
  BezierPatch(const BezierPatch&) = default;
  BezierPatch& operator=(const BezierPatch&) = default;

  /// A patch of bidegree (m,n), m and n in {1,2}, given by m+1 rows of n+1 points, degree-elevated exactly.
  /// Throws std::invalid_argument for any other shape.
  static BezierPatch elevated(const std::vector<std::vector<Point>>& points);
  /// From the power basis: x(u,v) = sum c[i][j] u^i v^j.
  static BezierPatch from_power_basis(const ControlNet& c);

  const ControlNet& net() const { return nets_->control; }
  /// c[i][j], the vector coefficient of u^i v^j. Computed once, for all copies; any number of threads may
  /// ask.
  const ControlNet& power_basis() const;

  /// Value at any rational (u,v), inside the square or not.
  Point operator()(const Rational& u, const Rational& v) const;
  Point derivative_first(const Rational& u, const Rational& v) const;   // x_u
  Point derivative_second(const Rational& u, const Rational& v) const;  // x_v

  /// x(v,u): the parameters exchanged.
  BezierPatch exchanged() const;
  /// x(1-u, v).
  BezierPatch reversed_first() const;
  /// x(u, 1-v).
  BezierPatch reversed_second() const;
  /// The piece over [u0,u1] x [v0,v1], reparametrised affinely to [0,1]^2 (blossoming; any rationals are
  /// legal, so it also extrapolates).
  BezierPatch restricted_to(const Rational& u0, const Rational& u1, const Rational& v0,
                            const Rational& v1) const;

  friend bool operator==(const BezierPatch& a, const BezierPatch& b) {
    return a.nets_ == b.nets_ || a.net() == b.net();
  }

 private:
  struct Nets {
    explicit Nets(const ControlNet& net) : control(net) {}
    const ControlNet control;
    std::once_flag has_power;
    ControlNet power;
  };
  std::shared_ptr<Nets> nets_;
};

}  // namespace exsect
