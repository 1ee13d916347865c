// What a surface of revolution has besides the sheet that is wanted: singular rings and unwanted branches.
#pragma once

#include <exsect/algebra/real_algebraic.h>
#include <exsect/algebra/tensor_bernstein.h>
#include <exsect/geometry/revolution.h>

#include <vector>

namespace exsect {

/// A circle r = const > 0, z = const in which the sheet and its mirrored copy meet: even = odd = 0. The
/// closed intervals hold r and z; no other ring has its r and z in both.
struct SingularRing {
  RationalInterval r;
  RationalInterval z;
};

struct SingularRings {
  std::vector<SingularRing> rings;  // ascending in z
  /// gcd(even, odd) is not constant: all of its zeros are singular on g, which it divides twice.
  bool common_factor;
};

/// The rings of g = even^2 - R odd^2 with 0 < r <= b and z in the closed interval; `on.r` is [0,b], else
/// std::invalid_argument. Boxes at most 2^-40 wide in R and z relative to the region. Throws
/// std::domain_error for f = 0.
SingularRings singular_rings(const BivariatePolynomial& f, const Rectangle& on);

/// Between two neighbouring critical values of z the numbers of roots do not change.
struct BranchCount {
  Rational sample;
  int own;       // roots r of f(r,z) in (0,b)
  int mirrored;  // in (-b,0): what elimination and product add; 0 for f even in r
};

/// `gaps` has one more element than `critical`.
struct BranchAudit {
  std::vector<RealAlgebraic> critical;  // values of z in the open interval of the region, ascending
  std::vector<BranchCount> gaps;

  /// Some gap has more than one own root or a mirrored one.
  bool has_unwanted() const;
};

/// Counts by Sturm's theorem at one z between neighbouring real roots of disc_r f, lc_r f, f(0,z), f(b,z) and
/// f(-b,z). `on.r` is [0,b], else std::invalid_argument. Throws std::domain_error for f = 0.
BranchAudit audit_branches(const BivariatePolynomial& f, const Rectangle& on);

}  // namespace exsect
