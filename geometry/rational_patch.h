// Bézier patches of bidegrees up to (3,3) with exact rational control nets, with or without weights.
#pragma once

#include <exsect/algebra/bivariate_polynomial.h>
#include <exsect/geometry/bezier_patch.h>

#include <array>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace exsect {

/// The greatest degree of a patch in one parameter.
inline constexpr int max_patch_degree = 3;

/// A net that is no patch: `where` is the place in it, as "weights[1][2]" or "points", `reason` the violated
/// statement. what() is "where: reason".
class PatchError : public std::invalid_argument {
 public:
  PatchError(const std::string& where, const std::string& reason)
      : std::invalid_argument(where + ": " + reason), where_(where), reason_(reason) {}

  const std::string& where() const { return where_; }
  const std::string& reason() const { return reason_; }

 private:
  std::string where_;
  std::string reason_;
};

/// (w x, w y, w z, w): a control point times its weight, and the weight.
using HomogeneousPoint = std::array<Rational, 4>;

/// x(u,v) = (X_1, X_2, X_3) / X_4 over (u,v) in [0,1]^2, X = sum_ij B_i^m(u) B_j^n(v) w_ij (P_ij, 1) (16.1).
/// Invariant: 1 <= m, n <= 3, and the denominator X_4 is positive on the closed square; single weights may be
/// zero or negative. Immutable: copies share the net.
class RationalPatch {
 public:
  /// m+1 rows of n+1 points, the row belongs to the first parameter, and weights in the same shape or none:
  /// then all are 1. Throws PatchError for any other shape, a denominator that is not positive (with the
  /// parameters where it vanishes), and, with weights or of degree 3, control points that all coincide.
  explicit RationalPatch(const std::vector<std::vector<Point>>& points,
                         const std::vector<std::vector<Rational>>& weights = {});
  RationalPatch(const BezierPatch& patch);  // NOLINT: biquadratic patches are embedded
  // Not movable: every patch has a net.
  RationalPatch(const RationalPatch&) = default;
  RationalPatch& operator=(const RationalPatch&) = default;
  /// From the vectors X_ij = w_ij (P_ij, 1) themselves; the control point is at infinity where w_ij = 0 and
  /// X_ij != 0. Throws PatchError ("net") for another shape and a denominator that is not positive.
  static RationalPatch from_homogeneous(const std::vector<std::vector<HomogeneousPoint>>& net);

  int degree_u() const { return state_->m; }
  int degree_v() const { return state_->n; }

  /// 0 <= i <= degree_u(), 0 <= j <= degree_v().
  const HomogeneousPoint& homogeneous(int i, int j) const;
  const Rational& weight(int i, int j) const { return homogeneous(i, j)[3]; }
  /// The Cartesian control point; the origin where weight and vector vanish. Throws std::domain_error for a
  /// control point at infinity.
  Point point(int i, int j) const;
  /// The polynomial X_(k+1) in (r,s) = (u,v), 0 <= k < 4.
  BivariatePolynomial component(int k) const;

  /// X at any rational (u,v), inside the square or not.
  HomogeneousPoint homogeneous_at(const Rational& u, const Rational& v) const;
  /// The point at (u,v). Throws std::domain_error where the denominator vanishes, never in [0,1]^2.
  Point operator()(const Rational& u, const Rational& v) const;

  /// No weights are needed: the denominator of reduced() is constant.
  bool is_polynomial() const;
  /// (16.2): the same map of the same parameters, the common factor of the four components divided out, of
  /// the true bidegree (at least 1 each) that then shows in the power basis; weights 1 if the map is
  /// polynomial. Single control points may be at infinity, as the middle one of the half circle (1 - t^2, 2
  /// t) / (1 + t^2), -1 <= t
  /// <= 1, of degree 2. Computed once for all copies; any number of threads may ask.
  const RationalPatch& reduced() const;
  /// The same patch as one of bidegree (2,2), if it is polynomial of true bidegree at most (2,2).
  std::optional<BezierPatch> biquadratic() const;

  /// x(v,u): the parameters exchanged.
  RationalPatch transposed() const;
  /// The same map with the net of bidegree (m,n); throws std::invalid_argument unless degree_u() <= m <= 3
  /// and degree_v() <= n <= 3.
  RationalPatch elevated(int m, int n) const;
  /// The piece over [u0,u1] x [v0,v1], reparametrised affinely to [0,1]^2; u0 > u1 reverses. Throws
  /// std::invalid_argument unless all four lie in [0,1].
  RationalPatch restricted_to(const Rational& u0, const Rational& u1, const Rational& v0,
                              const Rational& v1) const;

  /// The same degrees and the same vectors: reduced() of both is not compared.
  friend bool operator==(const RationalPatch& a, const RationalPatch& b);

 private:
  using Net = std::vector<HomogeneousPoint>;  // X_ij at i (n+1) + j
  struct State {
    State(int rows, int columns, Net points) : m(rows), n(columns), net(std::move(points)) {}
    int m;
    int n;
    Net net;
    mutable std::once_flag has_reduced;
    mutable std::shared_ptr<const RationalPatch> reduced;  // empty where it is the patch itself
  };
  RationalPatch(int m, int n, Net net);
  bool has_equal_weights() const;
  explicit RationalPatch(std::shared_ptr<const State> state) : state_(std::move(state)) {}

  std::shared_ptr<const State> state_;
};

/// "bidegree (3,2)", or "bidegree (3,2) with weights": how messages speak of a patch; of the reduced one.
std::string kind_of(const RationalPatch& patch);

}  // namespace exsect
