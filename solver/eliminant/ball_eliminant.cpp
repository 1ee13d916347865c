#include "eliminant/ball_eliminant.h"

#include <exsect/algebra/chebyshev.h>
#include <exsect/algebra/chebyshev_roots.h>
#include <exsect/algebra/wide_ball.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <tuple>
#include <type_traits>

#include "eliminant/turning_eliminant_forms.h"
#include "eliminant/weighted_eliminant_forms.h"

namespace exsect {

namespace {

/// Balls as the arithmetic of FibreResultants.
struct BallArithmetic {
  using Residue = WideBall;
  using Sum = WideBall::Sum;
  static WideBall reduce(const Sum& a) { return a.rounded(); }
  static WideBall reduce_few(const Sum& a) { return a.rounded(); }
  static WideBall add(const WideBall& a, const WideBall& b) { return a + b; }
  static WideBall negate(const WideBall& a) { return -a; }
  static WideBall multiply(const WideBall& a, const WideBall& b) { return a * b; }
};

/// p(1/2 + t/2) for p(w) = c[0] + c[1] w + c[2] w^2, times 4.
template <class Vector>
std::array<Vector, 3> centred(const std::array<Vector, 3>& c) {
  std::array<Vector, 3> result;
  for (std::size_t k = 0; k < c[0].size(); ++k) {
    result[0][k] = 4 * c[0][k] + 2 * c[1][k] + c[2][k];
    result[1][k] = 2 * c[1][k] + 2 * c[2][k];
    result[2][k] = c[2][k];
  }
  return result;
}

/// Both parameters from [0,1] to [-1,1].
template <class Vector>
std::array<std::array<Vector, 3>, 3> centred_net(const std::array<std::array<Vector, 3>, 3>& net) {
  std::array<std::array<Vector, 3>, 3> rows, result;
  for (std::size_t i = 0; i < 3; ++i) rows[i] = centred(net[i]);
  for (std::size_t j = 0; j < 3; ++j) {
    const std::array<Vector, 3> column = centred<Vector>({rows[0][j], rows[1][j], rows[2][j]});
    for (std::size_t i = 0; i < 3; ++i) result[i][j] = column[i];
  }
  return result;
}

/// The bits of each coordinate, 0 where it is zero.
template <class Net>
auto bits_of(const Net& net) {
  std::array<long, std::tuple_size_v<std::decay_t<decltype(net[0][0])>>> bits = {};
  for (const auto& row : net)
    for (const auto& c : row)
      for (std::size_t k = 0; k < c.size(); ++k)
        if (c[k] != 0) bits[k] = std::max(bits[k], static_cast<long>(msb(abs(c[k]))) + 1);
  return bits;
}

/// The coordinates are divided by powers of two, and where there are weights each patch by one of its own.
template <class Forms, class Pair>
Forms forms_of(const Pair& pair) {
  const auto x = centred_net(pair.x), y = centred_net(pair.y);
  auto bits = bits_of(x);
  const auto bits_x = bits, bits_y = bits_of(y);
  for (std::size_t k = 0; k < bits.size(); ++k) bits[k] = std::max(bits[k], bits_y[k]);
  const auto balls = [&](const auto& net, const auto& own_bits) {
    long spare = bits.size() == 3 ? 0 : std::numeric_limits<long>::max();
    for (std::size_t k = 0; k < bits.size(); ++k) spare = std::min(spare, bits[k] - own_bits[k]);
    typename Forms::Net result;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        for (std::size_t k = 0; k < bits.size(); ++k)
          result.c[i][j].c[k] = WideBall::enclosing(net[i][j][k], spare - bits[k]);
    return result;
  };
  WideBall small[17];
  for (int i = 0; i < 17; ++i) small[i] = WideBall(i);
  return Forms(BallArithmetic(), balls(x, bits_x), balls(y, bits_y), small);
}

/// The numbers of a fibre, polynomials in u of degree at most 16, in a row.
constexpr std::size_t kEntries = 17 + 11 + 2;
using Entries = std::array<WideBall, kEntries>;

template <class Fibre>
Entries entries(const Fibre& fibre) {
  Entries result;
  std::copy(std::begin(fibre.r), std::end(fibre.r), result.begin());
  std::copy(std::begin(fibre.s1), std::end(fibre.s1), result.begin() + 17);
  result[28] = fibre.lead_r;
  result[29] = fibre.lead_s;
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

/// E over one fibre up to a constant factor: (4.8), (16.9).
template <class Kind>
WideBall eliminant_value(Entries e) {
  WideBall* const r = e.data();
  std::array<WideBall, 16> derivative;
  for (std::size_t i = 1; i < 17; ++i) derivative[i - 1] = r[i] * WideBall(static_cast<double>(i));
  std::array<WideBall, 17> copy;
  std::copy_n(r, 17, copy.begin());
  const WideBall discriminant = resultant(copy.data(), derivative.data(), 15);
  const WideBall alignment = alignment_resultant(r, r + 17);
  const WideBall r2 = e[28] * e[28];
  if constexpr (Kind::coordinates == 3) {
    const WideBall s2 = e[29] * e[29];
    return r2 * r2 * r2 * discriminant * inverse(s2 * s2 * alignment);
  } else {
    return r2 * r2 * discriminant * inverse(e[29] * alignment);
  }
}

const ChebyshevNodes& fibre_nodes() {
  static const ChebyshevNodes result(17);
  return result;
}
template <class Kind>
const ChebyshevNodes& eliminant_nodes() {
  static const ChebyshevNodes result(Kind::degree + 1);
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
template <class Forms>
std::array<std::vector<WideBall>, kEntries> fibre_expansions(const Forms& forms) {
  using Kind = typename Forms::Fibre::Kind;
  const ChebyshevNodes& nodes = fibre_nodes();
  std::array<std::vector<WideBall>, kEntries> values;
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const Entries fibre = entries(forms.fibre(nodes.node(k)));
    for (std::size_t i = 0; i < kEntries; ++i) values[i].push_back(fibre[i]);
  }
  for (std::size_t i = 0; i < kEntries; ++i) {
    const std::size_t degree = i < 17 ? 16 : i < 28 ? Kind::s1_degree : Kind::lead_degree;
    values[i] = nodes.coefficients(values[i]);
    values[i].resize(degree + 1);
  }
  scale(std::span(values).first(17));
  scale(std::span(values).subspan(17, 11));
  scale(std::span(values).subspan(28, 1));
  scale(std::span(values).subspan(29, 1));
  return values;
}

template <class Forms>
std::vector<WideBall> values_at_nodes(const Forms& forms) {
  using Kind = typename Forms::Fibre::Kind;
  const auto expansions = fibre_expansions(forms);
  const ChebyshevNodes& nodes = eliminant_nodes<Kind>();
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
    values[k] = eliminant_value<Kind>(right);
    if (2 * k + 1 < nodes.size()) values[nodes.size() - 1 - k] = eliminant_value<Kind>(left);
  }
  return values;
}

template <class Forms, class Pair>
std::optional<std::vector<RationalInterval>> roots_in_balls(const Pair& pair) {
  const std::vector<WideBall> values = values_at_nodes(forms_of<Forms>(pair));
  return isolate_chebyshev_roots(eliminant_nodes<typename Forms::Fibre::Kind>().coefficients(values));
}

}  // namespace

std::optional<std::vector<RationalInterval>> turning_roots_in_balls(const IntegerPair& pair) {
  return roots_in_balls<EliminantForms<BallArithmetic>>(pair);
}

std::optional<std::vector<RationalInterval>> turning_roots_in_balls(const WeightedPair& pair) {
  return roots_in_balls<WeightedEliminantForms<BallArithmetic>>(pair);
}

}  // namespace exsect
