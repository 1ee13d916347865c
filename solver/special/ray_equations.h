// The equations (14.111) of curves out of a common pole, with their derivatives. Internal to solver/;
// docs/method-doubles.md, section 14.24.
#pragma once

#include <array>
#include <optional>

#include "special/pole_blowup.h"

namespace exsect {

/// Of the three equations over a box: derivatives by t, s, c and a.
struct RayColumns {
  EnclosedVector t, s, c, a;
};

/// F(a,t,s,c) = W D - c w E for c = b/a > 0, of the coordinates of space, or, where all directions have a
/// normal, of rows along it, divided by a once more, and across it.
class RayEquations {
 public:
  /// `first` and `second` have to outlive it; sets their heights.
  RayEquations(Blowup& first, Blowup& second);

  /// Inside of it is c of all solutions over the box of (t,s); empty if it is not proved positive and finite.
  std::optional<RationalInterval> ratio_on(const Rectangle& box) const;
  /// Second derivatives of row i, of which row 0 is along the normal, by tt, ts, tc, ss, sc, cc.
  std::array<DoubleBall, 6> bend_on(std::size_t i, const Rectangle& box, const RationalInterval& ratio) const;
  RayColumns columns_on(const Rectangle& box, const RationalInterval& ratio) const;
  /// There is a zero for a = 0 with (t,s,c) inside of the box (14.112).
  bool has_solution(const Rectangle& box, const RationalInterval& ratio, const RayColumns& columns) const;
  /// A zero at which the derivatives by t, s and c are linearly dependent is the only one in the box for this
  /// a (14.141).
  bool isolates_contact(const Rectangle& box, const RationalInterval& ratio, const RayColumns& columns) const;
  /// For a = 0 it has a zero with t = c, and s = d, given one of them or both, over the box (14.142).
  bool begins_at(const std::optional<Rational>& t, const std::optional<Rational>& s,
                 const Rectangle& box) const;

 private:
  /// W f - c^power w g.
  struct Row {
    BivariatePolynomial f, g;
    int power;
  };
  /// A vector along which E hardly changes with s: of E, what is orthogonal to E_s in the middle of the box.
  Point steady_row(const Rectangle& box) const;
  EnclosedVector value_at(const Rational& t, const Rational& s, const Rational& c) const;
  Rectangle on_second(const Rectangle& box, const RationalInterval& ratio) const;
  DoubleBall all_a() const { return DoubleBall::enclosing(RationalInterval{0, first_.reach}); }

  const Blowup& first_;
  const Blowup& second_;
  std::array<Row, 3> rows_;
  bool has_normal_ = false;
};

}  // namespace exsect
