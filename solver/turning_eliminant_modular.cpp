#include "turning_eliminant_modular.h"

#include <utility>
#include <vector>

namespace exsect {

namespace {

/// Sums of products of polynomials with residue coefficients, reduced once at the end. The coefficient of s^k
/// may collect PrimeField::max_products products.
template <std::size_t size>
class ProductSum {
 public:
  template <std::size_t m, std::size_t n>
  ProductSum& add(const std::array<Residue, m>& f, const std::array<Residue, n>& g) {
    static_assert(m + n - 1 <= size);
#pragma GCC unroll 9
    for (std::size_t i = 0; i < m; ++i)
#pragma GCC unroll 9
      for (std::size_t j = 0; j < n; ++j) sums_[i + j] += static_cast<WideWord>(f[i]) * g[j];
    return *this;
  }
  ProductSum& add(const Residue& a, const std::array<Residue, size>& f) {
    for (std::size_t i = 0; i < size; ++i) sums_[i] += static_cast<WideWord>(a) * f[i];
    return *this;
  }
  std::array<Residue, size> reduced(const PrimeField& field) const {
    std::array<Residue, size> result;
    for (std::size_t i = 0; i < size; ++i) result[i] = field.reduce(sums_[i]);
    return result;
  }

 private:
  std::array<WideWord, size> sums_{};
};

template <std::size_t size>
std::array<Residue, size> negated(const PrimeField& field, std::array<Residue, size> f) {
  for (auto& c : f) c = field.negate(c);
  return f;
}

template <std::size_t size>
std::array<Residue, size> doubled(const PrimeField& field, std::array<Residue, size> f) {
  for (auto& c : f) c = field.add(c, c);
  return f;
}

/// res(f,g) of formal degrees n+1 and n as a fraction; overwrites both. One step (4.13):
/// l = g_n, l^2 f - (q1 s + q0) g has degree n-1 and res(f,g) = l^(2-2n) res(g, remainder).
ResidueFraction remainder_sequence(const PrimeField& field, Residue* f, Residue* g, std::size_t n) {
  Residue product = field.one();      // of the leading coefficients l_n so far
  Residue denominator = field.one();  // of the products so far: each l_n enters n-1 times
  for (; n >= 1; --n) {
    const Residue l = g[n];
    if (n >= 2) {
      product = field.multiply(product, l);
      denominator = field.multiply(denominator, product);
    }
    const Residue square = field.multiply(l, l);
    const Residue q1 = field.negate(field.multiply(f[n + 1], l));
    const Residue q0 = field.reduce(static_cast<WideWord>(f[n + 1]) * g[n - 1] +
                                    static_cast<WideWord>(field.negate(l)) * f[n]);
    f[0] = field.reduce(static_cast<WideWord>(square) * f[0] + static_cast<WideWord>(q0) * g[0]);
    for (std::size_t j = 1; j < n; ++j)
      f[j] = field.reduce(static_cast<WideWord>(square) * f[j] + static_cast<WideWord>(q1) * g[j - 1] +
                          static_cast<WideWord>(q0) * g[j]);
    std::swap(f, g);
  }
  return {g[0], field.multiply(denominator, denominator)};
}

}  // namespace

ModularEliminant::ModularEliminant(const PrimeField& field, const IntegerPair& pair) : field_(field) {
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t k = 0; k < 3; ++k) {
        x_[i][j][k] = field.residue(pair.x[i][j][k]);
        y_[i][j][k] = field.residue(pair.y[i][j][k]);
      }
  constexpr std::array<std::array<std::size_t, 2>, 3> rows = {{{0, 1}, {0, 2}, {1, 2}}};
  for (std::size_t row = 0; row < 3; ++row)
    for (auto& coordinate : y_cross_[row]) coordinate = {};
  for (std::size_t row = 0; row < 3; ++row)
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) {
        const Vector product = cross(y_[rows[row][0]][i], y_[rows[row][1]][j]);
        for (std::size_t k = 0; k < 3; ++k) {
          auto& c = y_cross_[row][k][i + j];
          c = field.add(c, product[k]);
        }
      }
}

ModularEliminant::Vector ModularEliminant::cross(const Vector& a, const Vector& b) const {
  const auto minor = [&](std::size_t i, std::size_t j) {
    return field_.reduce(static_cast<WideWord>(a[i]) * b[j] +
                         static_cast<WideWord>(field_.negate(a[j])) * b[i]);
  };
  return {minor(1, 2), minor(2, 0), minor(0, 1)};
}

Residue ModularEliminant::dot(const Vector& a, const Vector& b) const {
  return field_.reduce(static_cast<WideWord>(a[0]) * b[0] + static_cast<WideWord>(a[1]) * b[1] +
                       static_cast<WideWord>(a[2]) * b[2]);
}

/// a . (w_i x w_j), where w_0 = y_0 - a_0 and w_i = y_i otherwise.
ModularEliminant::Coefficients<5> ModularEliminant::bracket(const Vector& a, const Vector& a0_cross_a,
                                                            std::size_t i, std::size_t j) const {
  const auto& cross_product = y_cross_[i + j - 1];
  Coefficients<5> result;
  for (std::size_t d = 0; d < 5; ++d) {
    WideWord sum = 0;
    for (std::size_t k = 0; k < 3; ++k) sum += static_cast<WideWord>(a[k]) * cross_product[k][d];
    if (i == 0 && d < 3)  // a . (-a_0 x w_j) = (a_0 x a) . w_j
      for (std::size_t k = 0; k < 3; ++k) sum += static_cast<WideWord>(a0_cross_a[k]) * y_[j][d][k];
    result[d] = field_.reduce(sum);
  }
  return result;
}

ModularEliminant::Fibre ModularEliminant::fibre(Residue u) const {
  const Residue u_square = field_.multiply(u, u);
  std::array<Vector, 3> a;  // x(u,v) = a_0 + a_1 v + a_2 v^2
  for (std::size_t j = 0; j < 3; ++j)
    for (std::size_t k = 0; k < 3; ++k)
      a[j][k] = field_.add(x_[0][j][k], field_.reduce(static_cast<WideWord>(x_[1][j][k]) * u +
                                                      static_cast<WideWord>(x_[2][j][k]) * u_square));
  const Vector n = cross(a[1], a[2]);
  const Vector a0_cross_a1 = cross(a[0], a[1]);
  const Vector a0_cross_a2 = cross(a[0], a[2]);

  // The plane P = A r^2 + B r + C, and the brackets with a_2 and a_1 (4.3).
  Coefficients<3> pa;
  Coefficients<3> pb;
  Coefficients<3> pc;
  for (std::size_t d = 0; d < 3; ++d) {
    pa[d] = dot(n, y_[2][d]);
    pb[d] = dot(n, y_[1][d]);
    pc[d] = dot(n, y_[0][d]);
  }
  pc[0] = field_.subtract(pc[0], dot(n, a[0]));
  const auto la = bracket(a[2], a0_cross_a2, 0, 2);
  const auto lb = bracket(a[2], a0_cross_a2, 1, 2);
  const auto lc = bracket(a[2], a0_cross_a2, 0, 1);
  const auto ma = bracket(a[1], a0_cross_a1, 0, 2);
  const auto mb = bracket(a[1], a0_cross_a1, 1, 2);
  const auto mc = bracket(a[1], a0_cross_a1, 0, 1);
  const auto minus_lb = negated(field_, lb);
  const auto minus_mb = negated(field_, mb);
  const auto twice_la = doubled(field_, la);

  // (4.4): R = A^2 rm - pml pul + rl pmu + rl^2 and S1 = A (A Mb - 2 La Lb) + B Lb^2.
  const auto rl = ProductSum<9>().add(la, la).add(minus_lb, lc).reduced(field_);
  const auto rm = ProductSum<9>().add(ma, ma).add(minus_mb, mc).reduced(field_);
  const auto pml = ProductSum<9>().add(twice_la, ma).add(minus_lb, mc).add(minus_mb, lc).reduced(field_);
  const auto minus_pul = ProductSum<7>().add(negated(field_, twice_la), pa).add(lb, pb).reduced(field_);
  const auto pmu = ProductSum<7>().add(doubled(field_, ma), pa).add(minus_mb, pb).reduced(field_);
  const auto a_square = ProductSum<5>().add(pa, pa).reduced(field_);
  const auto lb_square = ProductSum<9>().add(lb, lb).reduced(field_);
  Coefficients<9> inner = ProductSum<9>().add(twice_la, minus_lb).add(pa, mb).reduced(field_);

  Fibre result;
  result.r = ProductSum<17>().add(a_square, rm).add(minus_pul, pml).add(rl, pmu).add(rl, rl).reduced(field_);
  result.s1 = ProductSum<11>().add(pa, inner).add(pb, lb_square).reduced(field_);
  // (4.5): g_s is the coefficient of s^8 in rl, g_r the same with r and s exchanged.
  result.g_s = rl[8];
  const auto r_bracket = [&](std::size_t i, std::size_t j) { return dot(a[2], cross(y_[2][i], y_[2][j])); };
  result.g_r = field_.reduce(static_cast<WideWord>(r_bracket(0, 2)) * r_bracket(0, 2) +
                             static_cast<WideWord>(field_.negate(r_bracket(1, 2))) * r_bracket(0, 1));
  return result;
}

namespace {

template <std::size_t size>
std::array<Residue, size - 1> derivative(const PrimeField& field, const std::array<Residue, size>& f) {
  std::array<Residue, size - 1> result;
  for (std::size_t i = 1; i < size; ++i)
    result[i - 1] = field.multiply(f[i], field.residue(static_cast<std::int64_t>(i)));
  return result;
}

/// res(R, S1) as a fraction: R is reduced modulo S1 by seven pseudo-division steps, l = lc(S1), so that
/// res(R, S1) = l^-63 res(S1, l^7 R mod S1).
ResidueFraction alignment_resultant(const PrimeField& field, std::array<Residue, 17> r,
                                    std::array<Residue, 11> s1) {
  const Residue l = s1[10];
  for (std::size_t top = 16; top >= 10; --top) {
    const Residue q = field.negate(r[top]);
    for (std::size_t j = 0; j < top - 10; ++j) r[j] = field.multiply(l, r[j]);
    for (std::size_t j = 0; j < 10; ++j)
      r[top - 10 + j] =
          field.reduce(static_cast<WideWord>(l) * r[top - 10 + j] + static_cast<WideWord>(q) * s1[j]);
  }
  ResidueFraction result = remainder_sequence(field, s1.data(), r.data(), 9);
  result.denominator = field.multiply(result.denominator, field.power(l, 63));
  return result;
}

}  // namespace

ResidueFraction ModularEliminant::fast_value(Residue u) const {
  Fibre f = fibre(u);
  const ResidueFraction alignment = alignment_resultant(field_, f.r, f.s1);
  if (alignment.denominator == 0) return {0, 0};
  auto r_derivative = derivative(field_, f.r);
  const ResidueFraction discriminant = remainder_sequence(field_, f.r.data(), r_derivative.data(), 15);
  // (4.8): E = g_r^6 g_s^-4 res(R,R') / res(R,S1)
  const Residue numerator = field_.multiply(field_.power(f.g_r, 6), discriminant.numerator);
  const Residue denominator = field_.multiply(field_.power(f.g_s, 4), discriminant.denominator);
  return {field_.multiply(numerator, alignment.denominator),
          field_.multiply(denominator, alignment.numerator)};
}

ResidueFraction ModularEliminant::value(Residue u) const {
  const Fibre f = fibre(u);
  const auto d = derivative(field_, f.r);
  const std::vector<Residue> r(f.r.begin(), f.r.end());
  return {field_.multiply(field_.power(f.g_r, 6), resultant(field_, r, {d.begin(), d.end()})),
          field_.multiply(field_.power(f.g_s, 4), resultant(field_, r, {f.s1.begin(), f.s1.end()}))};
}

}  // namespace exsect
