// The eliminant of the turning points at one u modulo a prime, for any arithmetic of residues: one source for
// the scalar and the vector code.
#pragma once

#include <cstddef>

namespace exsect {

/// R, its first subresultant S1, and g_r, g_s at one u (4.3)-(4.5).
template <class Field>
struct EliminantFibre {
  using Residue = typename Field::Residue;
  Residue r[17];
  Residue s1[11];
  Residue g_r;
  Residue g_s;
};

/// The equations (4.3)-(4.8) and (4.13) of docs/method.md at single values of u. Field gives
///  - Residue, and Sum, a sum of at most 28 products: `Sum sum(a, b)` or `Sum sum`, `sum.add(a, b)`;
///  - reduce(Sum), and reduce_few(Sum) for at most three products;
///  - add(a, b), negate(a), multiply(a, b).
/// Plain arrays only: nothing here is an inline function that another file could share.
template <class Field>
class EliminantForms {
 public:
  using Residue = typename Field::Residue;
  using Sum = typename Field::Sum;
  struct Vector {
    Residue c[3];
  };
  /// net[i][j]: the coefficient of the first parameter's power i times the second's power j.
  struct Net {
    Vector c[3][3];
  };
  using Fibre = EliminantFibre<Field>;
  struct Fraction {
    Residue numerator;
    Residue denominator;
  };

  /// small[i] is the residue of i for i <= 16.
  EliminantForms(const Field& field, const Net& x, const Net& y, const Residue (&small)[17])
      : field_(field), x_(x), y_(y) {
    for (std::size_t i = 0; i < 17; ++i) small_[i] = small[i];
    cross_coefficients(y_cross_[0], 0, 1);
    cross_coefficients(y_cross_[1], 0, 2);
    cross_coefficients(y_cross_[2], 1, 2);
  }

  const Field& field() const { return field_; }

  Fibre fibre(const Residue& u) const;

  /// E(u) from the fibre over u, by Euclid's algorithm without inverses (4.13). The denominator is zero where
  /// g_s Res(R,S1) = 0, and also where a leading coefficient of the remainder sequences vanishes.
  Fraction value(Fibre f) const {
    Residue derivative[16];
    for (std::size_t i = 1; i < 17; ++i) derivative[i - 1] = field_.multiply(f.r[i], small_[i]);
    const Fraction alignment = alignment_resultant(f.r, f.s1);
    const Fraction discriminant = remainder_sequence(f.r, derivative, 15);
    // (4.8): E = g_r^6 g_s^-4 res(R,R') / res(R,S1)
    const Residue r2 = square(f.g_r);
    const Residue numerator = field_.multiply(field_.multiply(r2, square(r2)), discriminant.numerator);
    const Residue denominator = field_.multiply(square(square(f.g_s)), discriminant.denominator);
    return {field_.multiply(numerator, alignment.denominator),
            field_.multiply(denominator, alignment.numerator)};
  }

 private:
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

  Residue minor(const Vector& a, const Vector& b, std::size_t i, std::size_t j) const {
    Sum sum(a.c[i], b.c[j]);
    sum.add(field_.negate(a.c[j]), b.c[i]);
    return field_.reduce_few(sum);
  }
  Vector cross(const Vector& a, const Vector& b) const {
    return {minor(a, b, 1, 2), minor(a, b, 2, 0), minor(a, b, 0, 1)};
  }
  Residue dot(const Vector& a, const Vector& b) const {
    Sum sum(a.c[0], b.c[0]);
    sum.add(a.c[1], b.c[1]);
    sum.add(a.c[2], b.c[2]);
    return field_.reduce_few(sum);
  }
  /// y_i x y_j as polynomials in s.
  void cross_coefficients(Vector (&result)[5], std::size_t i, std::size_t j) const {
    for (std::size_t d = 0; d < 3; ++d)
      for (std::size_t e = 0; e < 3; ++e) {
        const Vector term = cross(y_.c[i][d], y_.c[j][e]);
        const bool first = d == 0 || e == 2;  // of the terms of degree d + e
        for (std::size_t k = 0; k < 3; ++k)
          result[d + e].c[k] = first ? term.c[k] : field_.add(result[d + e].c[k], term.c[k]);
      }
  }
  /// a . (w_i x w_j), where w_0 = y_0 - a_0 and w_i = y_i otherwise.
  void set_bracket(Residue (&result)[5], const Vector& a, const Vector& a0_cross_a, std::size_t i,
                   std::size_t j) const {
    for (std::size_t d = 0; d < 5; ++d) {
      const Vector& y_cross = y_cross_[i + j - 1][d];
      Sum sum(a.c[0], y_cross.c[0]);
      sum.add(a.c[1], y_cross.c[1]);
      sum.add(a.c[2], y_cross.c[2]);
      if (i == 0 && d < 3)  // a . (-a_0 x w_j) = (a_0 x a) . w_j
        for (std::size_t k = 0; k < 3; ++k) sum.add(a0_cross_a.c[k], y_.c[j][d].c[k]);
      result[d] = field_.reduce(sum);
    }
  }
  Residue leading_bracket(const Vector& a, std::size_t i, std::size_t j) const {
    return dot(a, cross(y_.c[2][i], y_.c[2][j]));
  }

  Fraction remainder_sequence(Residue* f, Residue* g, std::size_t n) const;
  Fraction alignment_resultant(const Residue (&r)[17], Residue (&s1)[11]) const;

  Field field_;
  Net x_;
  Net y_;
  Residue small_[17];
  Vector y_cross_[3][5];  // of y_0 x y_1, y_0 x y_2, y_1 x y_2
};

template <class Field>
typename EliminantForms<Field>::Fibre EliminantForms<Field>::fibre(const Residue& u) const {
  const Residue u_square = square(u);
  Vector a[3];  // x(u,v) = a_0 + a_1 v + a_2 v^2
  for (std::size_t j = 0; j < 3; ++j)
    for (std::size_t k = 0; k < 3; ++k) {
      Sum sum(x_.c[1][j].c[k], u);
      sum.add(x_.c[2][j].c[k], u_square);
      a[j].c[k] = field_.add(x_.c[0][j].c[k], field_.reduce_few(sum));
    }
  const Vector n = cross(a[1], a[2]);
  const Vector a0_cross_a1 = cross(a[0], a[1]);
  const Vector a0_cross_a2 = cross(a[0], a[2]);

  // A and B of the plane A r^2 + B r + C, and the brackets with a_2 and a_1 (4.3).
  Residue pa[3], pb[3];
  for (std::size_t d = 0; d < 3; ++d) {
    pa[d] = dot(n, y_.c[2][d]);
    pb[d] = dot(n, y_.c[1][d]);
  }
  Residue la[5], lb[5], lc[5], ma[5], mb[5], mc[5];
  set_bracket(la, a[2], a0_cross_a2, 0, 2);
  set_bracket(lb, a[2], a0_cross_a2, 1, 2);
  set_bracket(lc, a[2], a0_cross_a2, 0, 1);
  set_bracket(ma, a[1], a0_cross_a1, 0, 2);
  set_bracket(mb, a[1], a0_cross_a1, 1, 2);
  set_bracket(mc, a[1], a0_cross_a1, 0, 1);
  Residue minus_lb[5], minus_mb[5], twice_la[5], minus_twice_la[5], twice_ma[5], twice_lb[5], twice_rl[9];
  set_negated(minus_lb, lb);
  set_negated(minus_mb, mb);
  set_doubled(twice_la, la);
  set_negated(minus_twice_la, twice_la);
  set_doubled(twice_ma, ma);
  set_doubled(twice_lb, lb);

  // (4.4): R = A^2 rm - pml pul + rl pmu + rl^2 and S1 = A (A Mb - 2 La Lb) + B Lb^2.
  Residue rl[9], rm[9], pml[9], minus_pul[7], pmu[7], a_square[5], lb_square[9], inner[9];
  set_sum(rl, square(la, twice_la), product(minus_lb, lc));
  set_sum(rm, square(ma, twice_ma), product(minus_mb, mc));
  set_sum(pml, product(twice_la, ma), product(minus_lb, mc), product(minus_mb, lc));
  set_sum(minus_pul, product(pa, minus_twice_la), product(pb, lb));
  set_sum(pmu, product(pa, twice_ma), product(pb, minus_mb));
  set_sum(a_square, product(pa, pa));
  set_sum(lb_square, square(lb, twice_lb));
  set_sum(inner, product(twice_la, minus_lb), product(pa, mb));

  set_doubled(twice_rl, rl);

  Fibre result;
  set_sum(result.r, product(a_square, rm), product(minus_pul, pml), product(pmu, rl), square(rl, twice_rl));
  set_sum(result.s1, product(pa, inner), product(pb, lb_square));
  // (4.5): g_s is the coefficient of s^8 in rl, g_r the same with r and s exchanged.
  result.g_s = rl[8];
  const Residue middle = leading_bracket(a[2], 0, 2);
  Sum g_r(middle, middle);
  g_r.add(field_.negate(leading_bracket(a[2], 1, 2)), leading_bracket(a[2], 0, 1));
  result.g_r = field_.reduce_few(g_r);
  return result;
}

/// res(f,g) of formal degrees n+1 and n as a fraction; overwrites both. One step (4.13):
/// l = g_n, l^2 f - (q1 s + q0) g has degree n-1 and res(f,g) = l^(2-2n) res(g, remainder).
template <class Field>
typename EliminantForms<Field>::Fraction EliminantForms<Field>::remainder_sequence(Residue* f, Residue* g,
                                                                                   std::size_t n) const {
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
template <class Field>
typename EliminantForms<Field>::Fraction EliminantForms<Field>::alignment_resultant(const Residue (&r)[17],
                                                                                    Residue (&s1)[11]) const {
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

/// The fibres over first, first + 1, first + 2, ...: R, S1, g_r, g_s are polynomials in u of degrees at most
/// 16, 10, 4, 4, so that additions in their tables of differences are enough. Field as for EliminantForms,
/// and add_unreduced(a, b) for sums of at most 16 residues, which reduced(a) makes residues again; multiply,
/// Sum are not needed.
template <class Field>
class FibreTable {
 public:
  using Residue = typename Field::Residue;
  using Fibre = EliminantFibre<Field>;

  /// fibres[i] is the one over first + i.
  FibreTable(const Field& field, const Fibre (&fibres)[17]) : field_(field) {
    for (std::size_t k = 0; k < 17; ++k) {
      for (std::size_t i = 0; i < 17; ++i) r_[i][k] = fibres[k].r[i];
      for (std::size_t i = 0; i < 11 && k < 11; ++i) s1_[i][k] = fibres[k].s1[i];
      if (k < 5) {
        g_r_[k] = fibres[k].g_r;
        g_s_[k] = fibres[k].g_s;
      }
    }
    for (auto& row : r_) set_differences(row);
    for (auto& row : s1_) set_differences(row);
    set_differences(g_r_);
    set_differences(g_s_);
  }

  /// The next four.
  void next(Fibre (&fibres)[4]) {
    Residue values[4];
    for (std::size_t i = 0; i < 17; ++i) {
      advance(r_[i], values);
      for (std::size_t k = 0; k < 4; ++k) fibres[k].r[i] = values[k];
    }
    for (std::size_t i = 0; i < 11; ++i) {
      advance(s1_[i], values);
      for (std::size_t k = 0; k < 4; ++k) fibres[k].s1[i] = values[k];
    }
    advance(g_r_, values);
    for (std::size_t k = 0; k < 4; ++k) fibres[k].g_r = values[k];
    advance(g_s_, values);
    for (std::size_t k = 0; k < 4; ++k) fibres[k].g_s = values[k];
  }

 private:
  /// From values to differences of order 0, 1, ... at the first one.
  template <std::size_t n>
  void set_differences(Residue (&row)[n]) const {
    for (std::size_t k = 1; k < n; ++k)
      for (std::size_t i = n - 1; i >= k; --i) row[i] = field_.add(row[i], field_.negate(row[i - 1]));
  }
  /// By four values; `values` are the current one and the three after it. A step adds to each difference the
  /// next one: moduli at most double.
  template <std::size_t n>
  void advance(Residue (&row)[n], Residue (&values)[4]) const {
    Residue after[4];  // the next difference before each of the four steps
    for (Residue& difference : after) difference = row[n - 1];
    Residue now[4];
    for (std::size_t i = n - 1; i-- > 0;) {
      Residue sum = row[i];
      for (std::size_t k = 0; k < 4; ++k) {
        now[k] = sum;
        sum = field_.add_unreduced(sum, after[k]);
        after[k] = now[k];
      }
      row[i] = field_.reduced(sum);
    }
    for (std::size_t k = 0; k < 4; ++k) values[k] = field_.reduced(now[k]);
  }

  Field field_;
  Residue r_[17][17];
  Residue s1_[11][11];
  Residue g_r_[5];
  Residue g_s_[5];
};

}  // namespace exsect
