// The eliminant of the turning points at one u modulo a prime or in balls, from the polynomials of the fibre:
// one source for all arithmetic, scalar and vector, and for patches with and without weights.
#pragma once

#include "eliminant/eliminant_kinds.h"

namespace exsect {

/// At one u: R, its first subresultant S1, and g_r, g_s of (4.5) or the leading coefficients l_r, l_s.
template <class Field, class FibreKind>
struct EliminantFibre {
  using Kind = FibreKind;
  using Residue = typename Field::Residue;
  Residue r[Kind::points + 1];
  Residue s1[Kind::s1_points + 1];
  Residue lead_r;
  Residue lead_s;
};

/// Products of polynomials in s and the resultants of (4.8), (16.9) and (16.16) in any arithmetic. Field
/// gives
///  - Residue, and Sum, a sum of at most 28 products: `Sum sum(a, b)` or `Sum sum`, `sum.add(a, b)`;
///  - reduce(Sum), and reduce_few(Sum) for at most three products;
///  - add(a, b), negate(a), multiply(a, b).
/// Plain arrays only: nothing here is an inline function that another file could share.
template <class Field, class Kind>
class FibreResultants {
 public:
  using Residue = typename Field::Residue;
  using Sum = typename Field::Sum;
  using Fibre = EliminantFibre<Field, Kind>;
  struct Vector {
    Residue c[Kind::coordinates];
  };
  /// c[i][j]: the coefficient of the first parameter's power i times the second's power j.
  template <std::size_t first_degree, std::size_t second_degree>
  struct Net {
    Vector c[first_degree + 1][second_degree + 1];
  };
  using FirstNet = Net<Kind::u_degree, Kind::v_degree>;
  using SecondNet = Net<Kind::r_degree, Kind::s_degree>;
  using SmallNumbers = Residue[Kind::points + 1];
  struct Fraction {
    Residue numerator;
    Residue denominator;
  };

  /// small[i] is the residue of i, at least as many as SmallNumbers.
  FibreResultants(const Field& field, const FirstNet& x, const SecondNet& y, const Residue* small)
      : field_(field), x_(x), y_(y) {
    for (std::size_t i = 0; i <= Kind::points; ++i) small_[i] = small[i];
  }

  const Field& field() const { return field_; }

  /// E(u) from the fibre over u, by R' = S1 J at its points (4.6), (16.8), (16.15) and Euclid's algorithm
  /// without inverses (4.13). The denominator is zero where
  /// g_s Res(R,S1), or l_s Res(R,S1), is zero, and also where a leading coefficient of the remainder
  /// sequences vanishes.
  Fraction value(Fibre f) const {
    Residue derivative[Kind::points];
    for (std::size_t i = 1; i <= Kind::points; ++i) derivative[i - 1] = field_.multiply(f.r[i], small_[i]);
    const Fraction alignment = alignment_resultant(f.r, f.s1);
    const Fraction discriminant = remainder_sequence(f.r, derivative, Kind::points - 1);
    const Fraction lead = leading_factor(f.lead_r, f.lead_s);
    return {
        field_.multiply(field_.multiply(lead.numerator, discriminant.numerator), alignment.denominator),
        field_.multiply(field_.multiply(lead.denominator, discriminant.denominator), alignment.numerator)};
  }
  /// By the points over the roots that R has for all u: none.
  Residue fixed_factor(const Fibre& /*fibre*/) const { return small_[1]; }
  /// What res(R,R') / res(R,S1) is multiplied by.
  Fraction leading_factor(const Residue& lead_r, const Residue& lead_s) const {
    if constexpr (Kind::coordinates == 3) {  // (4.8): g_r^6 g_s^-4
      return {power<6>(lead_r), power<4>(lead_s)};
    } else {  // (16.9), (16.16)
      return {power<Kind::lead_power>(lead_r), lead_s};
    }
  }

 protected:
  /// f g as polynomials in s, constant term first.
  template <std::size_t m, std::size_t n>
  struct Product {
    const Residue (&f)[m];
    const Residue (&g)[n];

    void add_coefficient(Sum& sum, std::size_t k) const {
      const std::size_t begin = k < n ? 0 : k - n + 1;
      const std::size_t end = k < m ? k + 1 : m;
      for (std::size_t i = begin; i < end; ++i) sum.add(f[i], g[k - i]);
    }
  };
  template <std::size_t m, std::size_t n>
  static Product<m, n> product(const Residue (&f)[m], const Residue (&g)[n]) {
    return {f, g};
  }
  /// f^2, for 2 f given.
  template <std::size_t m>
  struct Square {
    const Residue (&f)[m];
    const Residue (&twice_f)[m];

    void add_coefficient(Sum& sum, std::size_t k) const {
      for (std::size_t i = k < m ? 0 : k - m + 1; 2 * i < k; ++i) sum.add(twice_f[i], f[k - i]);
      if (k % 2 == 0) sum.add(f[k / 2], f[k / 2]);
    }
  };
  template <std::size_t m>
  static Square<m> square(const Residue (&f)[m], const Residue (&twice_f)[m]) {
    return {f, twice_f};
  }
  template <std::size_t size, class... Products>
  void set_sum(Residue (&result)[size], const Products&... products) const {
    for (std::size_t k = 0; k < size; ++k) {
      Sum sum;
      (products.add_coefficient(sum, k), ...);
      result[k] = field_.reduce(sum);
    }
  }
  template <std::size_t size>
  void set_negated(Residue (&result)[size], const Residue (&f)[size]) const {
    for (std::size_t k = 0; k < size; ++k) result[k] = field_.negate(f[k]);
  }
  template <std::size_t size>
  void set_doubled(Residue (&result)[size], const Residue (&f)[size]) const {
    for (std::size_t k = 0; k < size; ++k) result[k] = field_.add(f[k], f[k]);
  }
  Residue square(const Residue& a) const { return field_.multiply(a, a); }
  template <std::size_t exponent>
  Residue power(const Residue& a) const {
    if constexpr (exponent == 0) {
      return small_[1];
    } else if constexpr (exponent == 1) {
      return a;
    } else {
      const Residue root = square(power<exponent / 2>(a));
      return exponent % 2 == 0 ? root : field_.multiply(root, a);
    }
  }

  Residue dot(const Vector& a, const Vector& b) const {
    Sum sum(a.c[0], b.c[0]);
    for (std::size_t k = 1; k < Kind::coordinates; ++k) sum.add(a.c[k], b.c[k]);
    return Kind::coordinates == 3 ? field_.reduce_few(sum) : field_.reduce(sum);
  }
  Residue minor(const Vector& a, const Vector& b, std::size_t i, std::size_t j) const {
    Sum sum(a.c[i], b.c[j]);
    sum.add(field_.negate(a.c[j]), b.c[i]);
    return field_.reduce_few(sum);
  }
  /// x(u,v) = a_0 + a_1 v + ..., of degree at most 3 in u.
  void set_line(Vector (&a)[Kind::v_degree + 1], const Residue& u) const {
    static_assert(Kind::u_degree == 2 || Kind::u_degree == 3);
    const Residue u_square = square(u);
    const Residue u_last = Kind::u_degree == 2 ? u_square : field_.multiply(u_square, u);
    for (std::size_t j = 0; j <= Kind::v_degree; ++j)
      for (std::size_t k = 0; k < Kind::coordinates; ++k) {
        Sum sum(x_.c[1][j].c[k], u);
        sum.add(x_.c[Kind::u_degree][j].c[k], u_last);
        if constexpr (Kind::u_degree == 3) sum.add(x_.c[2][j].c[k], u_square);
        a[j].c[k] = field_.add(x_.c[0][j].c[k], field_.reduce_few(sum));
      }
  }

  Field field_;
  FirstNet x_;
  SecondNet y_;
  SmallNumbers small_;

 private:
  Fraction remainder_sequence(Residue* f, Residue* g, std::size_t n) const;
  Fraction alignment_resultant(const Residue (&r)[Kind::points + 1],
                               Residue (&s1)[Kind::s1_points + 1]) const;
};

/// res(f,g) of formal degrees n+1 and n as a fraction; overwrites both. One step (4.13):
/// l = g_n, l^2 f - (q1 s + q0) g has degree n-1 and res(f,g) = l^(2-2n) res(g, remainder).
template <class Field, class Kind>
typename FibreResultants<Field, Kind>::Fraction FibreResultants<Field, Kind>::remainder_sequence(
    Residue* f, Residue* g, std::size_t n) const {
  Residue product = small_[1];      // of the leading coefficients l_n so far
  Residue denominator = small_[1];  // of the products so far: each l_n enters n-1 times
  for (; n >= 1; --n) {
    const Residue l = g[n];
    if (n >= 2) {
      product = field_.multiply(product, l);
      denominator = field_.multiply(denominator, product);
    }
    const Residue minus_l = field_.negate(l);
    const Residue l_square = square(l);
    const Residue q1 = field_.multiply(f[n + 1], minus_l);
    Sum quotient(f[n + 1], g[n - 1]);
    quotient.add(minus_l, f[n]);
    const Residue q0 = field_.reduce_few(quotient);
    Sum lowest(l_square, f[0]);
    lowest.add(q0, g[0]);
    f[0] = field_.reduce_few(lowest);
    for (std::size_t j = 1; j < n; ++j) {
      Sum sum(l_square, f[j]);
      sum.add(q1, g[j - 1]);
      sum.add(q0, g[j]);
      f[j] = field_.reduce_few(sum);
    }
    Residue* const remainder = f;
    f = g;
    g = remainder;
  }
  return {g[0], square(denominator)};
}

/// res(R, S1) as a fraction. For the degrees d of R and e of S1, l = lc(S1), t = d - e + 1 steps of
/// pseudo-division leave l^t R mod S1, so that res(R, S1) = l^(-t (e-1)) res(S1, l^t R mod S1). The quotient
/// sum_k l^(t-1-k) e_k s^(t-1-k) has the coefficients e_k = l^k R_(d-k) - sum_(j<k) l^(k-1-j) e_j S1_(e-k+j),
/// and l^t R mod S1 is l^t R - sum_k l^(t-1-k) e_k s^(t-1-k) S1 in degrees below e. S1 = 1 if e = 0.
template <class Field, class Kind>
typename FibreResultants<Field, Kind>::Fraction FibreResultants<Field, Kind>::alignment_resultant(
    const Residue (&r)[Kind::points + 1], Residue (&s1)[Kind::s1_points + 1]) const {
  if constexpr (Kind::s1_points == 0) {
    return {small_[1], small_[1]};
  } else {
    constexpr std::size_t d = Kind::points, e = Kind::s1_points, steps = d - e + 1;
    const Residue l = s1[e];
    Residue l_power = small_[1];  // l^k
    Residue quotient[steps];      // -l^(k-1-j) e_j for j < k
    for (std::size_t k = 0; k < steps; ++k) {
      Sum sum(l_power, r[d - k]);
      for (std::size_t j = 0; j < k; ++j) {
        sum.add(quotient[j], s1[e - k + j]);
        quotient[j] = field_.multiply(quotient[j], l);
      }
      quotient[k] = field_.negate(field_.reduce(sum));
      l_power = field_.multiply(l_power, l);
    }
    Residue remainder[e];
    for (std::size_t i = 0; i < e; ++i) {
      Sum sum(l_power, r[i]);
      for (std::size_t k = i < steps - 1 ? steps - 1 - i : 0; k < steps; ++k)
        sum.add(quotient[k], s1[i + k - (steps - 1)]);
      remainder[i] = field_.reduce(sum);
    }
    Fraction result = remainder_sequence(s1, remainder, e - 1);
    result.denominator = field_.multiply(result.denominator, power<steps*(e - 1)>(l));
    return result;
  }
}

}  // namespace exsect
