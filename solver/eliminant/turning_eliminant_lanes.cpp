#include "eliminant/turning_eliminant_lanes.h"

// Compiled for AVX2 and FMA: no inline function that other files may also contain is used here, because the
// linker could choose this copy for all.
#ifdef __x86_64__

#include "eliminant/fibre_table.h"
#include "eliminant/forms_of_kind.h"
#include "eliminant/residue_lanes.h"
#include "eliminant/stripped_eliminant_forms.h"

namespace exsect {

namespace {

using lanes::Lane;
using lanes::Primes;

Primes prime_lanes(const double (&p)[4]) {
  const Lane primes = _mm256_loadu_pd(p);
  return {primes, _mm256_div_pd(_mm256_set1_pd(1), primes)};
}

lanes::TwoLanes twice(Lane a) { return {a, a}; }

template <class Net, std::size_t rows, std::size_t columns, std::size_t coordinates>
Net loaded(const double (&net)[rows][columns][coordinates][4]) {
  Net result;
  for (std::size_t i = 0; i < rows; ++i)
    for (std::size_t j = 0; j < columns; ++j)
      for (std::size_t k = 0; k < coordinates; ++k)
        result.c[i][j].c[k] = twice(_mm256_loadu_pd(net[i][j][k]));
  return result;
}

/// a^(p-2) for each prime: the inverse, and 0 for 0.
Lane inverse(const Primes& f, Lane a) {
  double p[4];
  _mm256_storeu_pd(p, f.p);
  const __m256i exponent =
      _mm256_set_epi64x(static_cast<long long>(p[3]) - 2, static_cast<long long>(p[2]) - 2,
                        static_cast<long long>(p[1]) - 2, static_cast<long long>(p[0]) - 2);
  const Lane one = _mm256_set1_pd(1);
  Lane result = one;
  for (int bit = 47; bit >= 0; --bit) {
    // A factor for each lane by the sign bit of the shifted exponent.
    const __m256i shifted = _mm256_sll_epi64(exponent, _mm_cvtsi32_si128(63 - bit));
    result = lanes::multiply(f, lanes::multiply(f, result, result),
                             _mm256_blendv_pd(one, a, _mm256_castsi256_pd(shifted)));
  }
  return result;
}

/// Four steps of differences in one pass: values[i], i >= k, becomes the fourth difference of the values that
/// end there, or for i < k + 3 one of lower order, where the differences of order k - 1 begin at k - 1.
/// From 0.61 p moduli at most double in each step: below 2^52.
void four_differences(const Primes& f, std::size_t k, std::size_t points, Lane* values) {
  Lane before[4];  // the differences that end one place earlier
  before[0] = values[k - 1];
  for (std::size_t i = k; i < points && i < k + 3; ++i) {
    Lane value = values[i];
    for (std::size_t level = 0; level <= i - k; ++level) {
      const Lane difference = _mm256_sub_pd(value, before[level]);
      before[level] = value;
      value = difference;
    }
    before[i - k + 1] = value;
    values[i] = lanes::reduce(f, value);
  }
  for (std::size_t i = k + 3; i < points; ++i) {
    Lane value = values[i];
    for (Lane& last : before) {
      const Lane difference = _mm256_sub_pd(value, last);
      last = value;
      value = difference;
    }
    values[i] = lanes::reduce(f, value);
  }
}

/// Four steps of Horner's rule in one pass: the coefficients from k - 3 on of g (t + nodes[0]) + values[k],
/// and so on with nodes[1], ..., where g has the coefficients from k + 1 on.
void four_horner_steps(const Primes& f, const Lane (&nodes)[4], std::size_t k, std::size_t points,
                       Lane* values) {
  Lane after[4];  // the coefficient after, before each step
  for (Lane& last : after) last = values[points - 1];
  for (std::size_t j = points - 1; j-- > k;) {
    Lane value = values[j];
    for (std::size_t step = 0; step < 4; ++step) {
      const Lane next = lanes::multiply_add(f, nodes[step], after[step], value);
      after[step] = value;
      value = next;
    }
    values[j] = value;
  }
  for (std::size_t first = 1; first < 4; ++first) {
    Lane value = values[k - first];
    for (std::size_t step = first; step < 4; ++step) {
      const Lane next = lanes::multiply_add(f, nodes[step], after[step], value);
      after[step] = value;
      value = next;
    }
    values[k - first] = value;
  }
}

/// Newton's form sum_k D_k / k! prod_{i<k} (t - t_i), D_k the k-th difference, then Horner's rule.
/// inverse_factorial is 1/(points-1)!.
void interpolate(const Primes& f, Lane first, std::size_t points, Lane inverse_factorial, Lane* values) {
  for (std::size_t k = 1; k < points; k += 4) four_differences(f, k, points, values);
  for (std::size_t k = points; k-- > 2;) {
    values[k] = lanes::multiply(f, values[k], inverse_factorial);
    inverse_factorial = lanes::multiply(f, inverse_factorial, _mm256_set1_pd(static_cast<double>(k)));
  }
  const auto minus_node = [&](std::size_t k) {
    return lanes::negate(lanes::add(f, first, _mm256_set1_pd(static_cast<double>(k))));
  };
  std::size_t k = points - 1;
  for (; k % 4 != 0; --k)
    for (std::size_t j = k - 1; j + 1 < points; ++j)
      values[j] = lanes::multiply_add(f, minus_node(k - 1), values[j + 1], values[j]);
  for (; k > 0; k -= 4) {
    const Lane nodes[4] = {minus_node(k - 1), minus_node(k - 2), minus_node(k - 3), minus_node(k - 4)};
    four_horner_steps(f, nodes, k - 1, points, values);
  }
}

Lane factorial(const Primes& f, std::size_t n) {
  Lane result = _mm256_set1_pd(1);
  for (std::size_t k = 2; k <= n; ++k)
    result = lanes::multiply(f, result, _mm256_set1_pd(static_cast<double>(k)));
  return result;
}

/// The fibre at one of the two points.
template <class Kind>
using LaneFibre = EliminantFibre<lanes::LaneArithmetic, Kind>;

template <class Kind>
void split(const EliminantFibre<lanes::TwoLaneArithmetic, Kind>& fibre, LaneFibre<Kind>& a,
           LaneFibre<Kind>& b) {
  for (std::size_t i = 0; i <= Kind::points; ++i) a.r[i] = fibre.r[i].a, b.r[i] = fibre.r[i].b;
  for (std::size_t i = 0; i <= Kind::s1_points; ++i) a.s1[i] = fibre.s1[i].a, b.s1[i] = fibre.s1[i].b;
  a.lead_r = fibre.lead_r.a, b.lead_r = fibre.lead_r.b;
  a.lead_s = fibre.lead_s.a, b.lead_s = fibre.lead_s.b;
}

template <class Kind>
EliminantFibre<lanes::TwoLaneArithmetic, Kind> joined(const LaneFibre<Kind>& a, const LaneFibre<Kind>& b) {
  EliminantFibre<lanes::TwoLaneArithmetic, Kind> fibre;
  for (std::size_t i = 0; i <= Kind::points; ++i) fibre.r[i] = {a.r[i], b.r[i]};
  for (std::size_t i = 0; i <= Kind::s1_points; ++i) fibre.s1[i] = {a.s1[i], b.s1[i]};
  fibre.lead_r = {a.lead_r, b.lead_r};
  fibre.lead_s = {a.lead_s, b.lead_s};
  return fibre;
}

template <class Forms>
FibreTable<lanes::LaneArithmetic, typename Forms::Fibre::Kind> fibre_table(const Primes& f,
                                                                           const Forms& forms,
                                                                           lanes::TwoLanes u) {
  using Kind = typename Forms::Fibre::Kind;
  constexpr std::size_t size = FibreTable<lanes::LaneArithmetic, Kind>::size;
  LaneFibre<Kind> fibres[size];
  LaneFibre<Kind> spare;
  const Lane two = _mm256_set1_pd(2);
  for (std::size_t k = 0; k < size; k += 2) {
    split(forms.fibre(u), fibres[k], k + 1 == size ? spare : fibres[k + 1]);
    u = {lanes::add(f, u.a, two), lanes::add(f, u.b, two)};
  }
  return {lanes::LaneArithmetic(f), fibres};
}

template <class Forms, class... Factor>
Forms made_forms(const Primes& f, const LanePair<typename Forms::Fibre::Kind>& pair,
                 const Factor&... factor) {
  typename Forms::SmallNumbers small;
  double i = 0;
  for (lanes::TwoLanes& each : small) each = twice(_mm256_set1_pd(i++));
  return Forms(lanes::TwoLaneArithmetic(f), loaded<typename Forms::FirstNet>(pair.x),
               loaded<typename Forms::SecondNet>(pair.y), small, factor...);
}

template <class Forms>
Forms loaded_forms(const Primes& f, const LanePair<typename Forms::Fibre::Kind>& pair) {
  if constexpr (requires { pair.factor; }) {
    constexpr std::size_t degree = Forms::Fibre::Kind::factor_degree;
    FixedFactor<lanes::TwoLanes, degree> factor;
    for (std::size_t i = 0; i <= degree; ++i) factor.c[i] = twice(_mm256_loadu_pd(pair.factor[i]));
    factor.inverse = twice(inverse(f, factor.c[degree].a));
    return made_forms<Forms>(f, pair, factor);
  } else {
    return made_forms<Forms>(f, pair);
  }
}

/// Numerators and denominators of E(first + i), i < points.
template <class Forms>
void fractions(const LanePair<typename Forms::Fibre::Kind>& pair, const Primes& f, Lane first,
               std::size_t points, Lane* numerators, Lane* denominators) {
  const Forms forms = loaded_forms<Forms>(f, pair);
  auto table = fibre_table(f, forms, {first, lanes::add(f, first, _mm256_set1_pd(1))});
  for (std::size_t i = 0; i < points; i += 4) {
    LaneFibre<typename Forms::Fibre::Kind> fibres[4];
    table.next(fibres);
    for (std::size_t k = 0; k < 4 && i + k < points; k += 2) {
      const typename Forms::Fraction value = forms.value(joined(fibres[k], fibres[k + 1]));
      numerators[i + k] = value.numerator.a;
      denominators[i + k] = value.denominator.a;
      if (i + k + 1 == points) break;
      numerators[i + k + 1] = value.numerator.b;
      denominators[i + k + 1] = value.denominator.b;
    }
  }
}

template <class Forms>
void coefficients_in_lanes(const LanePair<typename Forms::Fibre::Kind>& pair, const double (&first)[4],
                           std::size_t points, double (*coefficients)[4], bool (&defined)[4]) {
  const Primes f = prime_lanes(pair.primes);
  const Lane first_node = _mm256_loadu_pd(first);
  Lane values[max_lane_points];
  Lane denominators[max_lane_points];
  fractions<Forms>(pair, f, first_node, points, values, denominators);

  // One inversion for the product of the denominators and (points-1)!.
  Lane products[max_lane_points];  // of the denominators before
  Lane product = _mm256_set1_pd(1);
  for (std::size_t i = 0; i < points; ++i) {
    products[i] = product;
    product = lanes::multiply(f, product, denominators[i]);
  }
  const int zero = _mm256_movemask_pd(_mm256_cmp_pd(product, _mm256_setzero_pd(), _CMP_EQ_OQ));
  for (int lane = 0; lane < 4; ++lane) defined[lane] = (zero >> lane & 1) == 0;
  const Lane n_factorial = factorial(f, points - 1);
  const Lane both = inverse(f, lanes::multiply(f, product, n_factorial));
  Lane suffix = lanes::multiply(f, both, n_factorial);  // the inverse of the first i + 1 denominators
  for (std::size_t i = points; i-- > 0;) {
    values[i] = lanes::multiply(f, values[i], lanes::multiply(f, suffix, products[i]));
    suffix = lanes::multiply(f, suffix, denominators[i]);
  }
  interpolate(f, first_node, points, lanes::multiply(f, both, product), values);
  for (std::size_t i = 0; i < points; ++i) _mm256_storeu_pd(coefficients[i], values[i]);
}

}  // namespace

template <class Kind>
void eliminant_in_lanes(const LanePair<Kind>& pair, const double (&first)[4], std::size_t points,
                        double (*coefficients)[4], bool (&defined)[4]) {
  coefficients_in_lanes<FormsOf<lanes::TwoLaneArithmetic, Kind>>(pair, first, points, coefficients, defined);
}

#define EXSECT_INSTANTIATE(...)                                                                   \
  template void eliminant_in_lanes(const LanePair<__VA_ARGS__>&, const double(&)[4], std::size_t, \
                                   double(*)[4], bool(&)[4]);
EXSECT_INSTANTIATE(PolynomialKind)
EXSECT_WEIGHTED_KINDS(EXSECT_INSTANTIATE)
EXSECT_STRIPPED_KINDS(EXSECT_INSTANTIATE)
#undef EXSECT_INSTANTIATE

void interpolate_in_lanes(const double (&primes)[4], const double (&first)[4], std::size_t points,
                          double (*values)[4]) {
  const Primes f = prime_lanes(primes);
  Lane v[max_lane_points];
  for (std::size_t i = 0; i < points; ++i) v[i] = _mm256_loadu_pd(values[i]);
  interpolate(f, _mm256_loadu_pd(first), points, inverse(f, factorial(f, points - 1)), v);
  for (std::size_t i = 0; i < points; ++i) _mm256_storeu_pd(values[i], v[i]);
}

}  // namespace exsect

#endif
