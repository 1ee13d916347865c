#include "eliminant/ball_eliminant.h"

#include <exsect/algebra/chebyshev.h>
#include <exsect/algebra/chebyshev_roots.h>
#include <exsect/algebra/wide_ball.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "eliminant/turning_eliminant_forms.h"

namespace exsect {

namespace {

/// Balls as the arithmetic of EliminantForms.
struct BallArithmetic {
  using Residue = WideBall;
  using Sum = WideBall::Sum;
  static WideBall reduce(const Sum& a) { return a.rounded(); }
  static WideBall reduce_few(const Sum& a) { return a.rounded(); }
  static WideBall add(const WideBall& a, const WideBall& b) { return a + b; }
  static WideBall negate(const WideBall& a) { return -a; }
  static WideBall multiply(const WideBall& a, const WideBall& b) { return a * b; }
};

using BallForms = EliminantForms<BallArithmetic>;
using Fibre = BallForms::Fibre;

/// p(1/2 + t/2) for p(w) = c[0] + c[1] w + c[2] w^2, times 4.
std::array<IntegerVector, 3> centred(const std::array<IntegerVector, 3>& c) {
  std::array<IntegerVector, 3> result;
  for (std::size_t k = 0; k < 3; ++k) {
    result[0][k] = 4 * c[0][k] + 2 * c[1][k] + c[2][k];
    result[1][k] = 2 * c[1][k] + 2 * c[2][k];
    result[2][k] = c[2][k];
  }
  return result;
}

/// Both parameters from [0,1] to [-1,1].
IntegerNet centred(IntegerNet net) {
  for (auto& row : net) row = centred(row);
  net = exchanged(net);
  for (auto& row : net) row = centred(row);
  return exchanged(net);
}

BallForms forms(const IntegerPair& pair) {
  const IntegerNet x = centred(pair.x), y = centred(pair.y);
  std::array<long, 3> bits = {};  // of each coordinate
  for (const IntegerNet* net : {&x, &y})
    for (const auto& row : *net)
      for (const IntegerVector& c : row)
        for (std::size_t k = 0; k < 3; ++k)
          if (c[k] != 0) bits[k] = std::max(bits[k], static_cast<long>(msb(abs(c[k]))) + 1);
  const auto balls = [&](const IntegerNet& net) {
    BallForms::Net result;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        for (std::size_t k = 0; k < 3; ++k) result.c[i][j].c[k] = WideBall::enclosing(net[i][j][k], -bits[k]);
    return result;
  };
  WideBall small[17];
  for (int i = 0; i < 17; ++i) small[i] = WideBall(i);
  return BallForms(BallArithmetic(), balls(x), balls(y), small);
}

/// The numbers of a fibre, polynomials in u of degree at most 16, in a row.
constexpr std::size_t kEntries = 17 + 11 + 2;
using Entries = std::array<WideBall, kEntries>;

Entries entries(const Fibre& fibre) {
  Entries result;
  std::copy(std::begin(fibre.r), std::end(fibre.r), result.begin());
  std::copy(std::begin(fibre.s1), std::end(fibre.s1), result.begin() + 17);
  result[28] = fibre.g_r;
  result[29] = fibre.g_s;
  return result;
}

/// Up to sign res(f, g) of the formal degrees n + 1 and n; overwrites both. A step of Euclid's algorithm is
/// res(f, g) = lc(g)^2 res(g, f mod g) up to sign.
WideBall resultant(WideBall* f, WideBall* g, std::size_t n) {
  WideBall product(1);
  for (; n > 0; --n) {
    product = product * (g[n] * g[n]);
    const WideBall minus_inverse = -inverse(g[n]);
    const WideBall q1 = f[n + 1] * minus_inverse;  // f + (q1 s + q0) g is of degree n - 1
    WideBall::Sum sum(q1, g[n - 1]);
    sum.add(f[n]);
    const WideBall q0 = sum.rounded() * minus_inverse;
    for (std::size_t j = 0; j < n; ++j) {
      WideBall::Sum rest(q0, g[j]);
      rest.add(f[j]);
      if (j > 0) rest.add(q1, g[j - 1]);
      f[j] = rest.rounded();
    }
    std::swap(f, g);
  }
  return product * g[0];
}

/// Up to sign res(R, S1), R reduced modulo S1 first; overwrites both.
WideBall alignment_resultant(WideBall* r, WideBall* s1) {
  const WideBall minus_inverse = -inverse(s1[10]);
  WideBall product(1);  // lc(S1)^7
  for (std::size_t top = 16; top >= 10; --top) {
    product = product * s1[10];
    const WideBall q = r[top] * minus_inverse;
    for (std::size_t j = 0; j < 10; ++j) {
      WideBall::Sum rest(q, s1[j]);
      rest.add(r[top - 10 + j]);
      r[top - 10 + j] = rest.rounded();
    }
  }
  return product * resultant(s1, r, 9);
}

/// E over one fibre up to a constant factor (4.8).
WideBall eliminant_value(Entries e) {
  WideBall* const r = e.data();
  std::array<WideBall, 16> derivative;
  for (std::size_t i = 1; i < 17; ++i) derivative[i - 1] = r[i] * WideBall(static_cast<double>(i));
  std::array<WideBall, 17> copy;
  std::copy_n(r, 17, copy.begin());
  const WideBall r2 = e[28] * e[28], s2 = e[29] * e[29];
  const WideBall discriminant = resultant(copy.data(), derivative.data(), 15);
  return r2 * r2 * r2 * discriminant * inverse(s2 * s2 * alignment_resultant(r, r + 17));
}

const ChebyshevNodes& fibre_nodes() {
  static const ChebyshevNodes result(17);
  return result;
}
const ChebyshevNodes& eliminant_nodes() {
  static const ChebyshevNodes result(129);
  return result;
}

/// By a common power of two, to a largest magnitude near 1: E changes by a constant factor.
void scale(std::span<std::vector<WideBall>> entries) {
  double largest = 0;
  for (const auto& entry : entries)
    for (const WideBall& c : entry) largest = std::max(largest, c.magnitude());
  if (!(largest > 0) || !std::isfinite(largest)) return;
  const int exponent = std::ilogb(largest);
  for (auto& entry : entries)
    for (WideBall& c : entry) c = scaled(c, -exponent);
}

/// The Chebyshev coefficients of each entry of the fibres.
std::array<std::vector<WideBall>, kEntries> fibre_expansions(const BallForms& forms) {
  const ChebyshevNodes& nodes = fibre_nodes();
  std::array<std::vector<WideBall>, kEntries> values;
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const Entries fibre = entries(forms.fibre(nodes.node(k)));
    for (std::size_t i = 0; i < kEntries; ++i) values[i].push_back(fibre[i]);
  }
  for (std::size_t i = 0; i < kEntries; ++i) {
    const std::size_t degree = i < 17 ? 16 : i < 28 ? 10 : 4;
    values[i] = nodes.coefficients(values[i]);
    values[i].resize(degree + 1);
  }
  scale(std::span(values).first(17));
  scale(std::span(values).subspan(17, 11));
  scale(std::span(values).subspan(28, 1));
  scale(std::span(values).subspan(29, 1));
  return values;
}

std::vector<WideBall> values_at_nodes(const BallForms& forms) {
  const auto expansions = fibre_expansions(forms);
  const ChebyshevNodes& nodes = eliminant_nodes();
  std::vector<WideBall> values(nodes.size());
  for (std::size_t k = 0; 2 * k < nodes.size(); ++k) {
    Entries right, left;  // over t and -t
    for (std::size_t i = 0; i < kEntries; ++i) {
      WideBall::Sum even, odd;
      for (std::size_t j = 0; j < expansions[i].size(); ++j)
        (j % 2 == 0 ? even : odd).add(expansions[i][j], nodes.value(j, k));
      const WideBall a = even.rounded(), b = odd.rounded();
      right[i] = a + b;
      left[i] = a - b;
    }
    values[k] = eliminant_value(right);
    if (2 * k + 1 < nodes.size()) values[nodes.size() - 1 - k] = eliminant_value(left);
  }
  return values;
}

}  // namespace

std::optional<std::vector<RationalInterval>> turning_roots_in_balls(const IntegerPair& pair) {
  return isolate_chebyshev_roots(eliminant_nodes().coefficients(values_at_nodes(forms(pair))));
}

}  // namespace exsect
