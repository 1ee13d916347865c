// The eliminant of the turning points at one u modulo a prime or in balls, from the polynomials of the fibre:
// one source for all arithmetic, scalar and vector, and for patches with and without weights.
#pragma once

#include <cstddef>

namespace exsect {

/// Of polynomial patches, by vectors in space: (4.8).
struct PolynomialKind {
  static constexpr std::size_t coordinates = 3;
  static constexpr std::size_t s1_degree = 10;   // of S1 in u
  static constexpr std::size_t lead_degree = 4;  // of g_r and g_s
  static constexpr std::size_t degree = 128;     // of E, at most
};
/// Of patches with weights, by vectors in homogeneous coordinates: (16.9).
struct WeightedKind {
  static constexpr std::size_t coordinates = 4;
  static constexpr std::size_t s1_degree = 14;
  static constexpr std::size_t lead_degree = 16;  // of l_r and l_s
  static constexpr std::size_t degree = 160;
};

/// At one u: R, its first subresultant S1, and g_r, g_s of (4.5) or l_r, l_s of (16.9).
template <class Field, class FibreKind>
struct EliminantFibre {
  using Kind = FibreKind;
  using Residue = typename Field::Residue;
  Residue r[17];
  Residue s1[11];
  Residue lead_r;
  Residue lead_s;
};

/// Products of polynomials in s and the resultants of (4.8) and (16.9) in any arithmetic. Field gives
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
  /// net[i][j]: the coefficient of the first parameter's power i times the second's power j.
  struct Net {
    Vector c[3][3];
  };
  struct Fraction {
    Residue numerator;
    Residue denominator;
  };

  /// small[i] is the residue of i for i <= 16.
  FibreResultants(const Field& field, const Net& x, const Net& y, const Residue (&small)[17])
      : field_(field), x_(x), y_(y) {
    for (std::size_t i = 0; i < 17; ++i) small_[i] = small[i];
  }

  const Field& field() const { return field_; }

  /// E(u) from the fibre over u, by Euclid's algorithm without inverses (4.13). The denominator is zero where
  /// g_s Res(R,S1), or l_s Res(R,S1), is zero, and also where a leading coefficient of the remainder
  /// sequences vanishes.
  Fraction value(Fibre f) const {
    Residue derivative[16];
    for (std::size_t i = 1; i < 17; ++i) derivative[i - 1] = field_.multiply(f.r[i], small_[i]);
    const Fraction alignment = alignment_resultant(f.r, f.s1);
    const Fraction discriminant = remainder_sequence(f.r, derivative, 15);
    const Fraction lead = leading_factor(f);
    return {
        field_.multiply(field_.multiply(lead.numerator, discriminant.numerator), alignment.denominator),
        field_.multiply(field_.multiply(lead.denominator, discriminant.denominator), alignment.numerator)};
  }
  /// What res(R,R') / res(R,S1) is multiplied by.
  Fraction leading_factor(const Fibre& f) const {
    const Residue r2 = square(f.lead_r);
    if constexpr (Kind::coordinates == 3) {  // (4.8): g_r^6 g_s^-4
      return {field_.multiply(r2, square(r2)), square(square(f.lead_s))};
    } else {  // (16.9): l_r^4 l_s^-1
      return {square(r2), f.lead_s};
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
  /// x(u,v) = a_0 + a_1 v + a_2 v^2.
  void set_line(Vector (&a)[3], const Residue& u) const {
    const Residue u_square = square(u);
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t k = 0; k < Kind::coordinates; ++k) {
        Sum sum(x_.c[1][j].c[k], u);
        sum.add(x_.c[2][j].c[k], u_square);
        a[j].c[k] = field_.add(x_.c[0][j].c[k], field_.reduce_few(sum));
      }
  }

  Field field_;
  Net x_;
  Net y_;
  Residue small_[17];

 private:
  Fraction remainder_sequence(Residue* f, Residue* g, std::size_t n) const;
  Fraction alignment_resultant(const Residue (&r)[17], Residue (&s1)[11]) const;
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

/// res(R, S1) as a fraction: R is reduced modulo S1 by pseudo-division, l = lc(S1), so that
/// res(R, S1) = l^-63 res(S1, l^7 R mod S1). The quotient sum_t l^(6-t) e_t s^(6-t) has the coefficients
/// e_t = l^t R_(16-t) - sum_(k<t) l^(t-1-k) e_k S1_(10-t+k), and l^7 R mod S1 is
/// l^7 R - sum_k l^(6-k) e_k s^(6-k) S1 in degrees below 10.
template <class Field, class Kind>
typename FibreResultants<Field, Kind>::Fraction FibreResultants<Field, Kind>::alignment_resultant(
    const Residue (&r)[17], Residue (&s1)[11]) const {
  const Residue l = s1[10];
  Residue l_power = small_[1];  // l^t
  Residue quotient[7];          // -l^(t-1-k) e_k for k < t
  for (std::size_t t = 0; t < 7; ++t) {
    Sum sum(l_power, r[16 - t]);
    for (std::size_t k = 0; k < t; ++k) {
      sum.add(quotient[k], s1[10 - t + k]);
      quotient[k] = field_.multiply(quotient[k], l);
    }
    quotient[t] = field_.negate(field_.reduce(sum));
    l_power = field_.multiply(l_power, l);
  }
  Residue remainder[10];
  for (std::size_t j = 0; j < 10; ++j) {
    Sum sum(l_power, r[j]);
    for (std::size_t k = j < 6 ? 6 - j : 0; k < 7; ++k) sum.add(quotient[k], s1[j + k - 6]);
    remainder[j] = field_.reduce(sum);
  }
  Fraction result = remainder_sequence(s1, remainder, 9);
  Residue power = l;  // l^63
  for (int i = 0; i < 5; ++i) power = field_.multiply(square(power), l);
  result.denominator = field_.multiply(result.denominator, power);
  return result;
}

}  // namespace exsect
