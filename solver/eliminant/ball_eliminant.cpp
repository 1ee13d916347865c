#include "eliminant/ball_eliminant.h"

#include <exsect/algebra/chebyshev.h>
#include <exsect/algebra/chebyshev_roots.h>
#include <exsect/algebra/wide_ball.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <mutex>
#include <span>
#include <tuple>
#include <type_traits>
#include <vector>

#include "eliminant/forms_of_kind.h"

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

/// p(1/2 + t/2) for p(w) = sum c[i] w^i, times 2^n for the n + 1 coefficients.
template <class Vectors>
Vectors centred(const Vectors& c) {
  Vectors result = c;
  for (std::size_t k = 0; k < c[0].size(); ++k) {
    for (std::size_t i = 0; i < c.size(); ++i) result[i][k] = c[i][k] << (c.size() - 1 - i);
    for (std::size_t step = 0; step + 1 < c.size(); ++step)
      for (std::size_t i = c.size() - 1; i-- > step;) result[i][k] += result[i + 1][k];
  }
  return result;
}

/// Both parameters from [0,1] to [-1,1].
template <class Net>
Net centred_net(Net net) {
  for (auto& row : net) row = centred(row);
  for (std::size_t j = 0; j < net[0].size(); ++j) {
    std::vector<typename std::decay_t<decltype(net[0])>::value_type> column;
    for (const auto& row : net) column.push_back(row[j]);
    column = centred(column);
    for (std::size_t i = 0; i < net.size(); ++i) net[i][j] = column[i];
  }
  return net;
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
  const auto set = [&](auto& result, const auto& net, const auto& own_bits) {
    long spare = bits.size() == 3 ? 0 : std::numeric_limits<long>::max();
    for (std::size_t k = 0; k < bits.size(); ++k) spare = std::min(spare, bits[k] - own_bits[k]);
    for (std::size_t i = 0; i < net.size(); ++i)
      for (std::size_t j = 0; j < net[i].size(); ++j)
        for (std::size_t k = 0; k < bits.size(); ++k)
          result.c[i][j].c[k] = WideBall::enclosing(net[i][j][k], spare - bits[k]);
  };
  typename Forms::FirstNet first = {};
  typename Forms::SecondNet second = {};
  set(first, x, bits_x);
  set(second, y, bits_y);
  typename Forms::SmallNumbers small;
  for (std::size_t i = 0; i < std::size(small); ++i) small[i] = WideBall(static_cast<double>(i));
  return Forms(BallArithmetic(), first, second, small);
}

/// The numbers of a fibre, polynomials in u, in a row: R, S1, lead_r, lead_s.
template <class Kind>
constexpr std::size_t kEntries = Kind::points + Kind::s1_points + 4;
template <class Kind>
using Entries = std::array<WideBall, kEntries<Kind>>;
template <class Kind>
constexpr std::size_t kFirstOfS1 = Kind::points + 1;

template <class Fibre, class Kind = typename Fibre::Kind>
Entries<Kind> entries(const Fibre& fibre) {
  Entries<Kind> result;
  std::copy(std::begin(fibre.r), std::end(fibre.r), result.begin());
  std::copy(std::begin(fibre.s1), std::end(fibre.s1), result.begin() + kFirstOfS1<Kind>);
  result[kEntries<Kind> - 2] = fibre.lead_r;
  result[kEntries<Kind> - 1] = fibre.lead_s;
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
template <std::size_t points, std::size_t s1_points>
WideBall alignment_resultant(WideBall* r, WideBall* s1) {
  if constexpr (s1_points == 0) {
    return WideBall(1);
  } else {
    const WideBall minus_inverse = -inverse(s1[s1_points]);
    WideBall product(1);  // a power of lc(S1)
    for (std::size_t top = points; top >= s1_points; --top) {
      product = product * s1[s1_points];
      const WideBall q = r[top] * minus_inverse;
      for (std::size_t j = 0; j < s1_points; ++j) {
        WideBall::Sum rest(q, s1[j]);
        rest.add(r[top - s1_points + j]);
        r[top - s1_points + j] = rest.rounded();
      }
    }
    return product * resultant(s1, r, s1_points - 1);
  }
}

/// E over one fibre up to a constant factor: (4.8), (16.9), (16.16).
template <class Forms, class Kind = typename Forms::Fibre::Kind>
WideBall eliminant_value(const Forms& forms, Entries<Kind> e) {
  WideBall* const r = e.data();
  std::array<WideBall, Kind::points> derivative;
  for (std::size_t i = 1; i <= Kind::points; ++i) derivative[i - 1] = r[i] * WideBall(static_cast<double>(i));
  std::array<WideBall, Kind::points + 1> copy;
  std::copy_n(r, copy.size(), copy.begin());
  const WideBall discriminant = resultant(copy.data(), derivative.data(), Kind::points - 1);
  const WideBall alignment = alignment_resultant<Kind::points, Kind::s1_points>(r, r + kFirstOfS1<Kind>);
  const auto lead = forms.leading_factor(e[kEntries<Kind> - 2], e[kEntries<Kind> - 1]);
  return lead.numerator * discriminant * inverse(lead.denominator * alignment);
}

/// Made once for each number.
const ChebyshevNodes& chebyshev_nodes(std::size_t count) {
  static std::mutex mutex;
  static std::map<std::size_t, ChebyshevNodes> known;
  const std::lock_guard lock(mutex);
  return known.try_emplace(count, count).first->second;
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
template <class Forms, class Kind = typename Forms::Fibre::Kind>
std::array<std::vector<WideBall>, kEntries<Kind>> fibre_expansions(const Forms& forms) {
  const ChebyshevNodes& nodes = chebyshev_nodes(std::max(Kind::fibre_degree, Kind::lead_degree) + 1);
  std::array<std::vector<WideBall>, kEntries<Kind>> values;
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const Entries<Kind> fibre = entries(forms.fibre(nodes.node(k)));
    for (std::size_t i = 0; i < values.size(); ++i) values[i].push_back(fibre[i]);
  }
  constexpr std::size_t s1 = kFirstOfS1<Kind>, leads = kEntries<Kind> - 2;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::size_t degree = i < s1 ? Kind::fibre_degree : i < leads ? Kind::s1_degree : Kind::lead_degree;
    values[i] = nodes.coefficients(values[i]);
    values[i].resize(degree + 1);
  }
  scale(std::span(values).first(s1));
  if constexpr (Kind::s1_points > 0) scale(std::span(values).subspan(s1, leads - s1));
  scale(std::span(values).subspan(leads, 1));
  scale(std::span(values).subspan(leads + 1, 1));
  return values;
}

template <class Forms, class Kind = typename Forms::Fibre::Kind>
std::vector<WideBall> values_at_nodes(const Forms& forms, const ChebyshevNodes& nodes) {
  const auto expansions = fibre_expansions(forms);
  std::vector<WideBall> values(nodes.size());
  for (std::size_t k = 0; 2 * k < nodes.size(); ++k) {
    Entries<Kind> right, left;  // over t and -t
    for (std::size_t i = 0; i < expansions.size(); ++i) {
      WideBall::Sum even, odd;
      for (std::size_t j = 0; j < expansions[i].size(); ++j)
        (j % 2 == 0 ? even : odd).add(expansions[i][j], nodes.value(j, k));
      const WideBall a = even.rounded(), b = odd.rounded();
      right[i] = a + b;
      left[i] = a - b;
    }
    values[k] = eliminant_value(forms, right);
    if (2 * k + 1 < nodes.size()) values[nodes.size() - 1 - k] = eliminant_value(forms, left);
  }
  return values;
}

template <class Forms, class Pair>
std::optional<std::vector<RationalInterval>> roots_in_balls(const Pair& pair) {
  const ChebyshevNodes& nodes = chebyshev_nodes(Forms::Fibre::Kind::degree(pair.x.size() - 1) + 1);
  return isolate_chebyshev_roots(nodes.coefficients(values_at_nodes(forms_of<Forms>(pair), nodes)));
}

}  // namespace

std::optional<std::vector<RationalInterval>> turning_roots_in_balls(const IntegerPair& pair) {
  return roots_in_balls<FormsOf<BallArithmetic, PolynomialKind>>(pair);
}

std::optional<std::vector<RationalInterval>> turning_roots_in_balls(const WeightedPair& pair) {
  return by_kind(pair, [&]<class Kind>(Kind) { return roots_in_balls<FormsOf<BallArithmetic, Kind>>(pair); });
}

}  // namespace exsect
