#include "eliminant_height.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <vector>

#include "fibre_forms.h"

// Floating point with proved errors. The coordinates are scaled by powers of two so that every integer
// becomes a double of modulus at most 1 (relative error 2^-52, or underflow). Each quantity q below is a
// fixed expression of sums, differences and products of these numbers and of u and u^2 on the unit circle
// (relative error 2^-51); its majorant Q is the same expression with moduli for numbers and sums for
// differences.
//  - A sum has relative error 2^-53, a complex product less than 2^-51 (R. Brent, C. Percival, P. Zimmermann,
//    Error bounds on complex floating-point multiplication, 2007). With at most 128 roundings on the way from
//    a number to q and at most 24 numbers in a product, |computed q - q| <= ((1+2^-51)^152 - 1) Q < 2^-43 Q,
//    and the computed Q is at least (1 - 2^-44) Q.
//  - Every intermediate majorant is below 2^60 and there are fewer than 2^16 operations, so that underflow
//    (at most 2^-1073 per operation) adds less than 2^-900.
// Hence |q| <= |computed q| + 2^-40 (computed Q) + 2^-400; the last term is large enough for its square.

namespace exsect {

namespace {

struct Complex {
  double re = 0;
  double im = 0;

  friend Complex operator+(const Complex& a, const Complex& b) { return {a.re + b.re, a.im + b.im}; }
  friend Complex operator-(const Complex& a, const Complex& b) { return {a.re - b.re, a.im - b.im}; }
  friend Complex operator*(const Complex& a, const Complex& b) {
    return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
  }
};

struct Majorant {
  double value = 0;

  friend Majorant operator+(Majorant a, Majorant b) { return {a.value + b.value}; }
  friend Majorant operator-(Majorant a, Majorant b) { return {a.value + b.value}; }
  friend Majorant operator*(Majorant a, Majorant b) { return {a.value * b.value}; }
};

/// exp(i k pi/16), 0 <= k <= 16; the other half of the 32nd roots of unity are the conjugates.
Complex root_of_unity(std::size_t k) {
  static constexpr std::array<double, 9> cosines = {1.0,
                                                    0.980785280403230449,
                                                    0.923879532511286756,
                                                    0.831469612302545237,
                                                    0.707106781186547524,
                                                    0.555570233019602225,
                                                    0.382683432365089772,
                                                    0.195090322016128268,
                                                    0.0};
  return k <= 8 ? Complex{cosines[k], cosines[8 - k]} : Complex{-cosines[16 - k], cosines[k - 8]};
}
constexpr double half_of_the_roots = 16;

/// 2^exponent mantissa with 1/2 <= |mantissa| < 1, or zero; truncated towards zero to 53 bits.
struct ScaledDouble {
  double mantissa;
  long exponent;
};
ScaledDouble scaled_double(const Integer& a) {
  long exponent = 0;
  const double mantissa = mpz_get_d_2exp(&exponent, a.backend().data());
  return {mantissa, exponent};
}

// On [1/2,1]: 2m - 2 <= log2 m <= 2m - 2 + 0.08608 (a chord of a concave function; the largest gap at 1/(2 ln
// 2)).
double log2_upper(double x) {
  int exponent = 0;
  const double m = std::frexp(x, &exponent);
  return exponent + 2 * m - 2 + 0.0862;
}
double log2_lower(const Integer& a) {
  const ScaledDouble s = scaled_double(a);
  return static_cast<double>(s.exponent) + 2 * std::abs(s.mantissa) - 2 - 1e-9;
}

using IntegerPolynomial = FormalPolynomial<Integer>;

/// A lower bound of m(f), the mean of log2 |f| over the unit circle, or nothing for f = 0. |f_j| <=
/// binom(n,j) 2^m(f) for each j, and Graeffe's f(t) f(-t), a polynomial in t^2, has twice the measure.
std::optional<double> measure_lower(IntegerPolynomial f) {
  while (!f.coefficients.empty() && f.coefficients.back() == 0) f.coefficients.pop_back();
  if (f.coefficients.empty()) return std::nullopt;
  constexpr int graeffe_steps = 3;
  for (int step = 0; step < graeffe_steps; ++step) {
    IntegerPolynomial reflected = f;
    for (std::size_t i = 1; i < f.coefficients.size(); i += 2) reflected.coefficients[i] = -f.coefficients[i];
    const IntegerPolynomial product = f * reflected;
    for (std::size_t i = 0; i < f.coefficients.size(); ++i) f.coefficients[i] = product.coefficients[2 * i];
  }
  const std::size_t n = f.coefficients.size() - 1;
  double best = -std::numeric_limits<double>::infinity();
  std::size_t binomial = 1;
  for (std::size_t j = 0; j <= n; ++j) {
    if (f.coefficients[j] != 0)
      best = std::max(best, log2_lower(f.coefficients[j]) - log2_upper(static_cast<double>(binomial)));
    binomial = binomial * (n - j) / (j + 1);
  }
  return best / (1 << graeffe_steps);
}

/// n = a_1 x a_2, g_r and g_s as polynomials in u (4.5).
struct LeadingForms {
  SpaceVector<IntegerPolynomial> n;
  IntegerPolynomial g_r;
  IntegerPolynomial g_s;

  explicit LeadingForms(const IntegerPair& pair) {
    const auto line = [&](std::size_t j) {
      SpaceVector<IntegerPolynomial> a;
      for (std::size_t k = 0; k < 3; ++k)
        a[k].coefficients = {pair.x[0][j][k], pair.x[1][j][k], pair.x[2][j][k]};
      return a;
    };
    n = cross_product(line(1), line(2));
    const auto g = [&](const SpaceVector<Integer>& c0, const SpaceVector<Integer>& c1,
                       const SpaceVector<Integer>& c2) {
      const auto bracket = [&](const SpaceVector<Integer>& c, const SpaceVector<Integer>& d) {
        return dot_product(cross_product(c, d), line(2));
      };
      return bracket(c0, c2) * bracket(c0, c2) - bracket(c1, c2) * bracket(c0, c1);
    };
    g_r = g(pair.y[2][0], pair.y[2][1], pair.y[2][2]);
    g_s = g(pair.y[0][2], pair.y[1][2], pair.y[2][2]);
  }
};

/// The pair with each coordinate scaled by 2^-exponent.
struct ScaledPair {
  std::array<std::array<std::array<double, 3>, 3>, 3> x;
  std::array<std::array<std::array<double, 3>, 3>, 3> y;
  std::array<long, 3> exponent;

  explicit ScaledPair(const IntegerPair& pair) {
    for (std::size_t k = 0; k < 3; ++k) {
      exponent[k] = std::numeric_limits<long>::min();
      const auto for_each = [&](const auto& function) {
        for (std::size_t i = 0; i < 3; ++i)
          for (std::size_t j = 0; j < 3; ++j) {
            function(pair.x[i][j][k], x[i][j][k]);
            function(pair.y[i][j][k], y[i][j][k]);
          }
      };
      for_each([&](const Integer& a, double&) {
        if (a != 0) exponent[k] = std::max(exponent[k], scaled_double(a).exponent);
      });
      for_each([&](const Integer& a, double& scaled) {
        const ScaledDouble s = scaled_double(a);
        const long shift = a == 0 ? 0 : std::max(s.exponent - exponent[k], -2000L);
        scaled = std::ldexp(s.mantissa, static_cast<int>(shift));
      });
    }
  }
};

FibreCoefficients<Complex> at_root_of_unity(const ScaledPair& pair, std::size_t node) {
  const Complex u = root_of_unity(node);
  const Complex u_square = u * u;
  FibreCoefficients<Complex> result;
  for (std::size_t j = 0; j < 3; ++j)
    for (std::size_t k = 0; k < 3; ++k) {
      result.a[j][k] =
          Complex{pair.x[0][j][k]} + u * Complex{pair.x[1][j][k]} + u_square * Complex{pair.x[2][j][k]};
      for (std::size_t i = 0; i < 3; ++i) result.y[i][j][k] = {pair.y[i][j][k]};
    }
  return result;
}

FibreCoefficients<Majorant> majorant(const ScaledPair& pair) {
  FibreCoefficients<Majorant> result;
  for (std::size_t j = 0; j < 3; ++j)
    for (std::size_t k = 0; k < 3; ++k) {
      result.a[j][k] = {std::abs(pair.x[0][j][k]) + std::abs(pair.x[1][j][k]) + std::abs(pair.x[2][j][k])};
      for (std::size_t i = 0; i < 3; ++i) result.y[i][j][k] = {std::abs(pair.y[i][j][k])};
    }
  return result;
}

/// n_k J as a polynomial of bidegree (5,5) in r and s (4.12).
template <class T>
std::vector<T> turning_form(const FibreCoefficients<T>& f, std::size_t k) {
  const SpaceVector<T> n = cross_product(f.a[1], f.a[2]);
  std::array<std::array<T, 4>, 4> d1{};  // a_1 . (y_r x y_s)
  std::array<std::array<T, 4>, 4> d2{};  // a_2 . (y_r x y_s)
  for (std::size_t i = 1; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t l = 0; l < 3; ++l)
        for (std::size_t m = 1; m < 3; ++m) {
          const SpaceVector<T> c = cross_product(f.y[i][j], f.y[l][m]);
          const T factor{static_cast<double>(i * m)};
          d1[i + l - 1][j + m - 1] = d1[i + l - 1][j + m - 1] + factor * dot_product(f.a[1], c);
          d2[i + l - 1][j + m - 1] = d2[i + l - 1][j + m - 1] + factor * dot_product(f.a[2], c);
        }
  std::vector<T> result(36);
  for (std::size_t p = 0; p < 4; ++p)
    for (std::size_t q = 0; q < 4; ++q) {
      result[6 * p + q] = result[6 * p + q] + n[k] * d1[p][q];
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) {
          SpaceVector<T> w = f.y[i][j];
          if (i + j == 0)
            for (std::size_t c = 0; c < 3; ++c) w[c] = w[c] - f.a[0][c];
          auto& sum = result[6 * (p + i) + q + j];
          sum = sum + T{2.0} * cross_product(w, f.a[2])[k] * d2[p][q];
        }
    }
  return result;
}

/// Half of log2 of the mean over the unit circle of the squared 2-norm of the coefficient vector that `form`
/// gives for a fibre: exact by Parseval's identity on 32 nodes (degree in u at most 31), rounded upwards.
template <class Form>
double log2_mean_norm(const ScaledPair& pair, const Form& form) {
  const std::vector<Majorant> bound = form(majorant(pair));
  double sum = 0;
  for (std::size_t node = 0; node <= 16; ++node) {
    const std::vector<Complex> values = form(at_root_of_unity(pair, node));
    const double weight = node == 0 || node == 16 ? 0.5 : 1;
    for (std::size_t i = 0; i < values.size(); ++i) {
      const double modulus = std::sqrt(values[i].re * values[i].re + values[i].im * values[i].im) +
                             0x1p-40 * bound[i].value + 0x1p-400;
      sum += weight * modulus * modulus;
    }
  }
  return 0.5 * (log2_upper(sum / half_of_the_roots) + 1e-9);
}

}  // namespace

std::size_t eliminant_height_bound(const IntegerPair& pair) {
  const LeadingForms leading(pair);
  const auto g_r = measure_lower(leading.g_r);
  const auto g_s = measure_lower(leading.g_s);
  if (!g_r || !g_s) throw std::domain_error("eliminant_height_bound: g_r or g_s vanishes identically");
  const ScaledPair scaled(pair);
  const auto scale = static_cast<double>(scaled.exponent[0] + scaled.exponent[1] + scaled.exponent[2]);

  std::optional<double> jacobian;  // of log2 |J| in scaled coordinates, the best k
  for (std::size_t k = 0; k < 3; ++k) {
    const auto n = measure_lower(leading.n[k]);
    if (!n) continue;
    const double scaled_n = *n - (scale - static_cast<double>(scaled.exponent[k]));
    const double bound = log2_mean_norm(scaled, [k](const auto& f) { return turning_form(f, k); }) - scaled_n;
    jacobian = jacobian ? std::min(*jacobian, bound) : bound;
  }
  if (!jacobian) throw std::domain_error("eliminant_height_bound: a_1 x a_2 vanishes identically");
  const double r_s =
      log2_mean_norm(scaled, [](const auto& f) { return fibre_eliminant(FibreForms(f)).r.coefficients; });
  const double r_r = log2_mean_norm(
      scaled, [](const auto& f) { return fibre_eliminant(FibreForms(f.exchanged())).r.coefficients; });

  // (4.13); scaling the coordinates by c_1, c_2, c_3 multiplies E by (c_1 c_2 c_3)^40 and g_r, g_s by its
  // square.
  const double log2_six = 2.585;
  const double log2_binomial = 124.2;  // binom(128,64) < 2^124.2
  const double measure =
      16 * (log2_six + *jacobian) + 5 * (r_s + r_r) - 4 * (*g_r + *g_s - 4 * scale) + 40 * scale;
  // A bound below 2^0 leaves E = 0 only.
  return static_cast<std::size_t>(std::ceil(std::max(measure + log2_binomial, 0.0))) + 1;
}

}  // namespace exsect
