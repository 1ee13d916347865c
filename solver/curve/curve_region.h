// Parts of the unit square that are cut out by inequalities, and where points lie to them, exact.
// docs/method-equations.md, section 17.8.
#pragma once

#include <exsect/algebra/triangular_point.h>

#include <cstddef>
#include <functional>
#include <vector>

namespace exsect {

/// A closed part of the plane: the points in which, in each of the clauses, one at least of its bounds is not
/// negative. Without clauses it is the whole plane. Invariant: clauses hold positions in `bounds`. Bounds in
/// no clause do not bound it, but have their zeros among the critical values.
struct CurveRegion {
  CurveRegion() = default;
  /// h >= 0.
  CurveRegion(const BivariatePolynomial& h) : bounds{h}, clauses{{0}} {}  // NOLINT: as the half plane it is

  std::vector<BivariatePolynomial> bounds;  // u in the place of r and v in that of s
  std::vector<std::vector<std::size_t>> clauses;
  std::vector<std::size_t> marked = {};  // bounds whose zeros are to be nodes, whether they bound or not
};

/// inside, outside: the signs in the point settle that the region, or its complement, has all points near
/// it. rim: they do not, or a marked bound is 0; the point belongs to the region.
enum class RegionPlace { inside, rim, outside };

/// (17.9), for signs of the bounds in these clauses: 1, -1, and 0 where it is not known, or either.
RegionPlace place_by_signs(const std::vector<std::vector<std::size_t>>& clauses,
                           const std::function<int(std::size_t)>& sign_of_bound);

/// Where points (u,v) lie, which have u as their s and v as their r.
class PlacedRegion {
 public:
  explicit PlacedRegion(const CurveRegion& region);

  bool is_plane() const { return clauses_.empty(); }
  RegionPlace place_of(const TriangularPoint& point) const;
  bool contains(const TriangularPoint& point) const { return place_of(point) != RegionPlace::outside; }

 private:
  std::vector<BivariatePolynomial> bounds_;  // v first
  std::vector<std::vector<std::size_t>> clauses_;
  std::vector<std::size_t> marked_;
};

}  // namespace exsect
