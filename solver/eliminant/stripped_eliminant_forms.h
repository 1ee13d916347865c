// The polynomials of the fibre without the powers of D that divide them for all u, for any arithmetic.
// Internal to solver/.
#pragma once

#include "eliminant/forms_of_kind.h"

namespace exsect {

/// D(s) of (16.19), of this degree, constant term first, and the inverse of its leading coefficient.
template <class Residue, std::size_t degree>
struct FixedFactor {
  Residue c[degree + 1];
  Residue inverse;
};

/// R~, S1~ and E of (16.20) in docs/method-equations.md at single values of u.
template <class Field, class Whole, std::size_t degree>
class StrippedEliminantForms : public FibreResultants<Field, StrippedKind<Whole, degree>> {
  using Base = FibreResultants<Field, StrippedKind<Whole, degree>>;
  using WholeForms = FormsOf<Field, Whole>;
  using Base::field_;

 public:
  using typename Base::Fibre;
  using typename Base::Fraction;
  using typename Base::Residue;
  using typename Base::Sum;
  using FirstNet = typename WholeForms::FirstNet;
  using SecondNet = typename WholeForms::SecondNet;
  using SmallNumbers = typename WholeForms::SmallNumbers;
  using Factor = FixedFactor<Residue, degree>;

  StrippedEliminantForms(const Field& field, const FirstNet& x, const SecondNet& y, const SmallNumbers& small,
                         const Factor& factor)
      : Base(field, {}, {}, small), whole_(field, x, y, small), factor_(factor) {}

  /// Of R~ and S1~.
  Fibre fibre(const Residue& u) const {
    auto whole = whole_.fibre(u);
    constexpr std::size_t r_size = Whole::points + 1, s1_size = Whole::s1_points + 1;
    for (std::size_t i = 0; i < Kind::r_power; ++i) divide(whole.r, r_size - i * degree);
    for (std::size_t i = 0; i < Kind::s1_power; ++i) divide(whole.s1, s1_size - i * degree);
    // Quotients stand in the places of the highest powers.
    Fibre result;
    for (std::size_t i = 0; i <= Kind::points; ++i) result.r[i] = whole.r[i + Whole::points - Kind::points];
    for (std::size_t i = 0; i <= Kind::s1_points; ++i)
      result.s1[i] = whole.s1[i + Whole::s1_points - Kind::s1_points];
    result.lead_r = whole.lead_r;
    result.lead_s = result.r[Kind::points];
    return result;
  }

  /// res(R~, D)^k up to a sign that does not depend on u.
  Residue fixed_factor(const Fibre& f) const {
    constexpr std::size_t n = Kind::points;
    Residue r[n + 1];
    for (std::size_t i = 0; i <= n; ++i) r[i] = f.r[i];
    divide(r, n + 1);
    const Residue& lead = factor_.c[degree];
    Residue result;
    if constexpr (degree == 1) {
      result = field_.multiply(this->template power<n>(lead), r[0]);
    } else {  // with r0 + r1 s, modulo D: lead^(n-1) (r1^2 c0 - r0 r1 c1 + r0^2 lead)
      static_assert(degree == 2);
      Sum linear(r[1], factor_.c[0]);
      linear.add(field_.negate(r[0]), factor_.c[1]);
      Sum sum(r[1], field_.reduce_few(linear));
      sum.add(this->square(r[0]), lead);
      result = field_.multiply(this->template power<n - 1>(lead), field_.reduce_few(sum));
    }
    return this->template power<Kind::r_power - Kind::s1_power>(result);
  }

  Fraction value(const Fibre& f) const {
    const Fraction without = Base::value(f);
    return {field_.multiply(without.numerator, fixed_factor(f)), without.denominator};
  }

 private:
  using Kind = StrippedKind<Whole, degree>;

  /// The last `size` elements of f divided by D: quotient after remainder.
  template <std::size_t all>
  void divide(Residue (&f)[all], std::size_t size) const {
    Residue* const g = f + (all - size);
    for (std::size_t k = size; k-- > degree;) {
      g[k] = field_.multiply(g[k], factor_.inverse);
      const Residue minus = field_.negate(g[k]);
      for (std::size_t i = 0; i < degree; ++i) {
        Residue& c = g[k - degree + i];
        c = field_.add(c, field_.multiply(minus, factor_.c[i]));
      }
    }
  }

  WholeForms whole_;
  Factor factor_;
};

template <class Field, class Whole, std::size_t degree>
struct FormsOfKind<Field, StrippedKind<Whole, degree>> {
  using Type = StrippedEliminantForms<Field, Whole, degree>;
};

}  // namespace exsect
