// The contraction that shows one patch to be a graph over the other near a region. Internal to solver/;
// docs/method.md, section 6.3.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "trace/pair_system.h"
#include "trace/sheet_graph.h"
#include "trace/subdivision.h"

namespace exsect {

/// One region: (u,v) = c + a in A, |a_i| <= reach_i; (r,s) = w0 + b, |b_k| <= width_k. The matrix C,
/// `inverse`, is near the left inverse of (y_r, y_s)(w0). For fixed a the map b -> b + C(x(c + a) - y(w0 +
/// b)) has the derivative -E, E = C y' - 1, and moves b = 0 by C(x(c + a) - y(w0)).
struct SheetContraction {
  using Net = TaylorNet<DoubleBall>;
  using Matrix = std::array<std::array<double, 3>, 2>;
  using Pair = std::array<double, 2>;

  Pair c;
  Pair reach;
  Pair middle;
  Pair half;
  Net x{};
  Net y{};
  Matrix inverse{};
  Pair w0{};
  Pair width{};
  Pair image{};             // bounds of |w(a) - w0|
  std::array<Pair, 2> e{};  // bounds of |E|

  explicit SheetContraction(const SearchRegion& region);

  BallPoint<DoubleBall> centre() const;

  /// Approximate Newton steps from the middle of the region towards x(c) = y(w0) in y's tangent plane.
  bool find_centre(const PairSystem<DoubleBall>& system);

  bool is_near() const;

  /// The map of the box |b_k| <= width_k goes into its interior and is a contraction.
  bool contracts();

  /// In the norm max |b_k| / width_k.
  double contraction() const;

  /// Over a range half as far from w(A) as from the ends of the box.
  std::optional<SheetGraph> graph() const;

  /// w(A) and the region's last two intervals are disjoint.
  bool leaves_region() const;

  /// C x' over A: row r or s, column u or v.
  std::array<std::array<DoubleBall, 2>, 2> first_derivatives() const;

  /// x is regular on A: C x' is, so x' has rank 2.
  bool is_regular() const;

  /// Row k of C times a vector.
  DoubleBall projected(std::size_t k, const BallVector<DoubleBall>& v) const;
};

}  // namespace exsect
