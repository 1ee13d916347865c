// What the exact descriptions of points on a parameter line have in common. Internal to solver/.
#pragma once

#include <exsect/solver/certified_point.h>

#include <optional>
#include <vector>

#include "line/line_place.h"

namespace exsect {

/// Which ends of [0,1] t, r and s are at, exactly: 0, 1 or neither.
struct LocalSides {
  std::optional<int> t;
  std::optional<int> r;
  std::optional<int> s;
};

struct LocalBox {
  RationalInterval t;
  RationalInterval r;
  RationalInterval s;
};

/// 0 or 1.
std::optional<int> side_of(const RealAlgebraic& s);

std::vector<Side> global_sides(const LinePlace& place, const LocalSides& local);

/// Multiplicity of the root s of f.
int root_multiplicity(const Polynomial& f, const RealAlgebraic& s);

/// Branch of (9.16) from the sign of P_r = 2 A r + B. Where P is linear in r throughout there is one
/// branch, 1.
int branch_from(int sign_of_derivative, bool linear);

/// Local boxes of width at most half the width asked for, put in place: rounded outward to short dyadics, cut
/// to [0,1], exact on sides.
class LinePointSource : public CertifiedPoint::Source {
 public:
  LinePointSource(LinePlace place, LocalSides sides) : place_(std::move(place)), sides_(sides) {}

  ParameterBox box(const Rational& width) const final;

 protected:
  virtual LocalBox local_box(const Rational& width) const = 0;

  /// A parameter as a fraction.
  struct Fraction {
    BivariatePolynomial numerator;
    BivariatePolynomial denominator;
  };
  ExactParameters in_place(TriangularPoint at, const Fraction& t, const Fraction& r, const Fraction& s) const;

 private:
  LinePlace place_;
  LocalSides sides_;
};

}  // namespace exsect
