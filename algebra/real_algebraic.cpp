#include "real_algebraic.h"

#include <exsect/algebra/nearest_rounding.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "descartes.h"
#include "flint_polynomial.h"
#include "interruption.h"
#include "quadratic_refinement.h"

namespace exsect {
namespace {

/// The primitive linear polynomial with this root.
Polynomial linear_polynomial(const Rational& root) {
  return Polynomial(std::vector<Rational>{-Rational(numerator(root)), Rational(denominator(root))});
}

std::strong_ordering order_of_sign(int s) {
  return s < 0   ? std::strong_ordering::less
         : s > 0 ? std::strong_ordering::greater
                 : std::strong_ordering::equal;
}

/// True proves f and g coprime: if p does not divide the leading coefficient of g, the degree of gcd(f, g)
/// over Q is at most its degree modulo p. False proves nothing.
bool coprime_modulo_prime(const Polynomial& f, const Polynomial& g) {
  constexpr mp_limb_t p = 9223372036854775783ULL;
  const NumeratorView f_numerator(f), g_numerator(g);
  if (fmpz_fdiv_ui(fmpz_poly_lead(g_numerator.get()), p) == 0) return false;
  nmod_poly_t a, b;
  nmod_poly_init(a, p);
  nmod_poly_init(b, p);
  fmpz_poly_get_nmod_poly(a, f_numerator.get());
  fmpz_poly_get_nmod_poly(b, g_numerator.get());
  nmod_poly_gcd(a, a, b);
  const bool coprime = nmod_poly_length(a) == 1;
  nmod_poly_clear(a);
  nmod_poly_clear(b);
  return coprime;
}

/// Whether f and g vanish together in the open interval. Requires g squarefree with at most one root inside,
/// and at each end f or g nonzero.
bool common_root(const Polynomial& f, const Polynomial& g, const RationalInterval& interval) {
  if (coprime_modulo_prime(f, g)) return false;
  const Polynomial common = gcd(f, g);
  // It divides both: nonzero at the ends, at most one root inside, and that one simple.
  return common.degree() > 0 && common.sign_at(interval.lower) != common.sign_at(interval.upper);
}

/// The same in doubles, for intervals in [-1,1]; 0 more often.
///
/// With u = 2^-53: the midpoint m and the half width h of the ends cut to doubles, h increased for the
/// rounding of these (2 u each) and of m; M = |m| + h. Coefficients are divided by a power of two above all
/// of them and cut to doubles a_i, with errors of 2 u |a_i|, or below 2^-1000. Horner's rule at m errs by (2
/// i + 1) u |a_i| |m|^i in term i, to first order, and |f(s) - f(m)| <= h f~'(M), f~ with coefficients |a_i|:
/// in all by less than 1.01 (h f~'(M) + 2 u M f~'(M) + 4 u f~(M)) + 2^-900 for degrees up to 1000.
int sign_in_doubles(const Polynomial& f, const RationalInterval& interval) {
  constexpr double roundoff = 0x1p-53;
  const double lower = mpq_get_d(interval.lower.backend().data());
  const double upper = mpq_get_d(interval.upper.backend().data());
  if (!(lower >= -1 && upper <= 1) || f.degree() > 1000) return 0;
  const fmpz* coefficients = f.rep().value->coeffs;
  slong exponent = 0;
  for (slong i = 0; i <= f.degree(); ++i)
    exponent = std::max<slong>(exponent, static_cast<slong>(fmpz_bits(coefficients + i)));
  const double middle = 0.5 * (lower + upper);
  const double half = (0.5 * (upper - lower) + 8 * roundoff) * (1 + 4 * roundoff);
  const double size = (std::fabs(middle) + half) * (1 + 4 * roundoff);
  double value = 0, bound = 0, slope = 0;
  for (slong i = f.degree(); i >= 0; --i) {
    slong e = 0;
    const double mantissa = fmpz_get_d_2exp(&e, coefficients + i);
    const double a = std::ldexp(mantissa, static_cast<int>(std::max<slong>(e - exponent, -2000)));
    value = value * middle + a;
    slope = slope * size + bound;
    bound = bound * size + std::fabs(a);
  }
  const double error = 1.01 * ((half + 2 * roundoff * size) * slope + 4 * roundoff * bound) + 0x1p-900;
  return value > error ? 1 : value < -error ? -1 : 0;
}

/// The sign of f on the whole interval, or 0 if an enclosure does not show it.
int sign_on(const Polynomial& f, const RationalInterval& interval) {
  if (const int s = in_nearest_rounding([&] { return sign_in_doubles(f, interval); })) return s;
  const fmpz* coefficients = f.rep().value->coeffs;
  // Rounding errors stay below the effect of the width of the interval.
  const slong precision = std::max<slong>(0, grid_exponent(interval.width())) + 64;
  FlintBall point, value;
  set_ball(point.value, interval, precision);
  arb_set_round_fmpz(value.value, coefficients + f.degree(), precision);
  for (slong i = f.degree() - 1; i >= 0; --i) {
    arb_mul(value.value, value.value, point.value, precision);
    arb_add_fmpz(value.value, value.value, coefficients + i, precision);
  }
  return arb_contains_zero(value.value) ? 0 : arf_sgn(arb_midref(value.value));
}

}  // namespace

RealAlgebraic::RealAlgebraic(const Rational& value)
    : RealAlgebraic(std::make_shared<const Polynomial>(linear_polynomial(value)), {value, value}, 0) {}

RealAlgebraic::RealAlgebraic(std::shared_ptr<const Polynomial> polynomial, RationalInterval interval,
                             int sign_lower)
    : polynomial_(std::move(polynomial)),
      lower_(std::move(interval.lower)),
      upper_(std::move(interval.upper)),
      sign_lower_(sign_lower) {}

RealAlgebraic RealAlgebraic::root_of(const Polynomial& f, const RationalInterval& isolating) {
  if (isolating.lower >= isolating.upper)
    throw std::invalid_argument("RealAlgebraic::root_of: the isolating interval is empty");
  const int sign_lower = f.sign_at(isolating.lower);
  if (sign_lower == 0 || f.sign_at(isolating.upper) != -sign_lower)
    throw std::invalid_argument("RealAlgebraic::root_of: the signs at the ends are not opposite and nonzero");
  if (f.degree() == 1) return -f.coefficient(0) / f.coefficient(1);
  return {std::make_shared<const Polynomial>(f.primitive()), isolating, sign_lower};
}

const Rational& RealAlgebraic::rational() const {
  if (!is_rational()) throw std::domain_error("RealAlgebraic::rational: not known to be rational");
  return lower_;
}

RealAlgebraic RealAlgebraic::refined_to(const Rational& width) const {
  if (width <= 0) throw std::invalid_argument("RealAlgebraic::refined_to: the width is not positive");
  if (upper_ - lower_ <= width) return *this;
  DyadicPolynomial f(*polynomial_, interval());
  RationalInterval refined = refine(f, interval(), sign_lower_, width);
  if (refined.lower == refined.upper) return refined.lower;
  return {polynomial_, std::move(refined), sign_lower_};
}

double RealAlgebraic::to_double() const {
  if (is_rational()) return exsect::to_double(lower_);
  if (lower_ < 0 && upper_ > 0 && polynomial_->coefficient(0) == 0) return 0;
  RealAlgebraic a = *this;
  while (!a.is_rational() && a.lower_ <= 0 && a.upper_ >= 0) {
    interruption_point();
    a = a.refined_to((a.upper_ - a.lower_) / 16);
  }
  // Both ends have the sign of the number: relative width 2^-54.
  a = a.refined_to(std::max<Rational>(std::min<Rational>(abs(a.lower_), abs(a.upper_)), power_of_two(-1074)) *
                   power_of_two(-54));
  return exsect::to_double(a.interval().midpoint());
}

int RealAlgebraic::compare(const Rational& q) const {
  if (is_rational()) return sign(lower_ - q);
  if (q <= lower_) return 1;
  if (q >= upper_) return -1;
  // The sign is sign_lower_ exactly between lower_ and the number.
  return polynomial_->sign_at(q) * sign_lower_;
}

std::strong_ordering operator<=>(const RealAlgebraic& a, const RealAlgebraic& b) {
  if (b.is_rational()) return order_of_sign(a.compare(b.lower_));
  if (a.is_rational()) return order_of_sign(-b.compare(a.lower_));
  // The intervals are open.
  if (a.upper_ <= b.lower_) return std::strong_ordering::less;
  if (b.upper_ <= a.lower_) return std::strong_ordering::greater;

  bool distinct = false;
  if (a.polynomial_ == b.polynomial_ || *a.polynomial_ == *b.polynomial_) {
    // Equal exactly if the root is common to both intervals: the signs at the ends of the intersection tell.
    const int lower = a.lower_ >= b.lower_ ? a.sign_lower_ : b.sign_lower_;
    const int upper = a.upper_ <= b.upper_ ? -a.sign_lower_ : -b.sign_lower_;
    if (lower != upper) return std::strong_ordering::equal;
    distinct = true;
  }
  const Rational width = std::min<Rational>(a.upper_ - a.lower_, b.upper_ - b.lower_);
  for (long bits = 32;; bits *= 2) {
    const RealAlgebraic x = a.refined_to(width * power_of_two(-bits));
    const RealAlgebraic y = b.refined_to(width * power_of_two(-bits));
    if (x.is_rational() || y.is_rational() || x.upper_ <= y.lower_ || y.upper_ <= x.lower_) return x <=> y;
    if (distinct) continue;
    const RationalInterval both{std::max(x.lower_, y.lower_), std::min(x.upper_, y.upper_)};
    if (common_root(*x.polynomial_, *y.polynomial_, both)) return std::strong_ordering::equal;
    distinct = true;
  }
}

int sign_at(const Polynomial& f, const RealAlgebraic& alpha) {
  if (alpha.is_rational()) return f.sign_at(alpha.rational());
  if (f.degree() <= 0) return sign(f.coefficient(0));
  if (const int s = sign_on(f, alpha.interval())) return s;
  const Rational width = alpha.interval().width();
  RealAlgebraic a = alpha;
  // Zero is likely only where a narrow enclosure fails.
  bool may_vanish = true;
  for (long bits = width < power_of_two(-40) ? 0 : 32;; bits = 2 * bits + 32) {
    if (bits > 0) {
      a = a.refined_to(width * power_of_two(-bits));
      if (a.is_rational()) return f.sign_at(a.rational());
      if (const int s = sign_on(f, a.interval())) return s;
    }
    if (may_vanish && common_root(f, a.polynomial(), a.interval())) return 0;
    may_vanish = false;
  }
}

std::vector<RealAlgebraic> real_roots(const Polynomial& f, const Rational& a, const Rational& b) {
  const auto part = std::make_shared<const Polynomial>(squarefree_part(f));
  std::vector<RealAlgebraic> roots;
  int sign = 0;  // right of the root before, 0 if not known yet; it changes at every root
  for (IsolatingInterval& interval : isolate_roots(*part, a, b)) {
    if (interval.lower == interval.upper) {
      roots.emplace_back(interval.lower);
    } else if (part->degree() == 1) {
      roots.emplace_back(-part->coefficient(0) / part->coefficient(1));
    } else {
      if (sign == 0) sign = part->sign_at(interval.lower);
      roots.push_back(RealAlgebraic(part, std::move(interval), sign));
    }
    sign = -sign;
  }
  return roots;
}

}  // namespace exsect
