#include "quadratic_refinement.h"

#include <algorithm>
#include <cstdlib>
#include <optional>

#include "flint_polynomial.h"
#include "interruption.h"

namespace exsect {
namespace {

slong bit_length(mpz_srcptr n) { return static_cast<slong>(mpz_sizeinbase(n, 2)); }

/// |q| < 2^result.
slong magnitude_exponent(const Rational& q) {
  const mpq_srcptr p = q.backend().data();
  return bit_length(mpq_numref(p)) - bit_length(mpq_denref(p)) + 1;
}

/// Abbott, "Quadratic interval refinement for real roots" (2006): a secant guess on a grid of 2^t parts is
/// tried by the signs at two neighbouring grid points; success doubles t, failure halves it, and t = 1 is
/// bisection.
class Refinement {
 public:
  Refinement(DyadicFunction& f, int sign_lower, const Rational& width)
      : f_(f), sign_lower_(sign_lower), width_(width), target_(grid_exponent(width)) {}

  RationalInterval run(const RationalInterval& isolating) {
    RationalInterval interval = isolating;
    // Each round gives a cell or an interval shorter than half.
    while (interval.width() > width_) {
      if (std::optional<RationalInterval> shorter = find_cell(interval))
        interval = *shorter;
      else
        return refine_cell();
    }
    return interval;
  }

 private:
  /// Bisects on the coarsest grid with a cell no longer than the interval. Empty if the root is in the cell
  /// found; else the root itself, or the interval between an end that is not on the grid and the nearest grid
  /// point.
  std::optional<RationalInterval> find_cell(const RationalInterval& interval) {
    exponent_ = grid_exponent(interval.width());
    const Rational scale = power_of_two(exponent_);
    const FlintRational low(interval.lower * scale), high(interval.upper * scale);
    FlintInteger last, middle;
    fmpz_fdiv_q(cell_.value, fmpq_numref(low.value), fmpq_denref(low.value));
    fmpz_cdiv_q(last.value, fmpq_numref(high.value), fmpq_denref(high.value));
    for (;;) {
      fmpz_add(middle.value, cell_.value, last.value);
      fmpz_fdiv_q_2exp(middle.value, middle.value, 1);
      if (fmpz_equal(middle.value, cell_.value)) break;
      f_.evaluate(left_.value, middle.value, exponent_, 2);
      if (arb_is_zero(left_.value)) return point(middle.value, exponent_);
      fmpz_swap(sign_of(left_) == sign_lower_ ? cell_.value : last.value, middle.value);
    }
    RationalInterval found{dyadic(cell_.value, exponent_), dyadic(last.value, exponent_)};
    if (found.lower >= interval.lower && found.upper <= interval.upper) return std::nullopt;
    return RationalInterval{std::max(found.lower, interval.lower), std::min(found.upper, interval.upper)};
  }

  RationalInterval refine_cell() {
    // A narrow cell is the result of successful steps before, the last of which was about as long as that.
    slong step = std::max<slong>(2, exponent_ / 2);
    if (exponent_ < target_) {
      FlintInteger end;
      fmpz_add_ui(end.value, cell_.value, 1);
      f_.evaluate(left_.value, cell_.value, exponent_, 2 * step);
      f_.evaluate(right_.value, end.value, exponent_, 2 * step);
    }
    while (exponent_ < target_) {
      interruption_point();
      step = std::min(step, target_ - exponent_);
      const bool success = try_step(step);
      if (exact_) return *exact_;
      step = success ? 2 * step : std::max<slong>(1, step / 2);
    }
    FlintInteger end;
    fmpz_add_ui(end.value, cell_.value, 1);
    return {dyadic(cell_.value, exponent_), dyadic(end.value, exponent_)};
  }

  /// Divides the cell into 2^step parts. True if the part with the root was found: it is the cell now.
  bool try_step(slong step) {
    FlintInteger guess, parts, cell, other;
    fmpz_one_2exp(parts.value, static_cast<ulong>(step));
    secant_guess(guess.value, parts.value, step);
    const slong exponent = exponent_ + step;
    const slong accuracy = std::min(2 * step, std::max<slong>(0, target_ - exponent)) + 4;
    fmpz_mul_2exp(cell.value, cell_.value, static_cast<ulong>(step));
    fmpz_add(other.value, cell.value, guess.value);
    f_.evaluate(first_.value, other.value, exponent, accuracy);
    if (arb_is_zero(first_.value)) return set_exact(other.value, exponent);
    const bool root_above = sign_of(first_) == sign_lower_;
    if (root_above)
      fmpz_add_ui(guess.value, guess.value, 1);
    else
      fmpz_sub_ui(guess.value, guess.value, 1);
    // At the ends of the old cell the sign is known.
    if (fmpz_is_zero(guess.value)) {
      arb_set(second_.value, left_.value);
    } else if (fmpz_equal(guess.value, parts.value)) {
      arb_set(second_.value, right_.value);
    } else {
      fmpz_add(other.value, cell.value, guess.value);
      f_.evaluate(second_.value, other.value, exponent, accuracy);
      if (arb_is_zero(second_.value)) return set_exact(other.value, exponent);
      if (sign_of(second_) == sign_of(first_)) return false;
    }
    if (root_above) fmpz_sub_ui(guess.value, guess.value, 1);
    fmpz_add(cell_.value, cell.value, guess.value);
    exponent_ = exponent;
    arb_swap(left_.value, first_.value);
    arb_swap(right_.value, second_.value);
    if (!root_above) arb_swap(left_.value, right_.value);
    return true;
  }

  /// The inner grid point nearest to the zero of the secant; any inner grid point would be correct.
  void secant_guess(fmpz_t guess, const fmpz_t parts, slong step) {
    const slong precision = step + 16;
    FlintBall quotient;
    arf_struct* q = arb_midref(quotient.value);
    arf_sub(q, arb_midref(left_.value), arb_midref(right_.value), precision, ARF_RND_NEAR);
    arf_div(q, arb_midref(left_.value), q, precision, ARF_RND_NEAR);
    arf_mul_2exp_si(q, q, step);
    arf_get_fmpz(guess, q, ARF_RND_NEAR);
    if (fmpz_sgn(guess) <= 0) fmpz_one(guess);
    if (fmpz_cmp(guess, parts) >= 0) fmpz_sub_ui(guess, parts, 1);
  }

  static RationalInterval point(const fmpz_t numerator, slong exponent) {
    const Rational root = dyadic(numerator, exponent);
    return {root, root};
  }
  bool set_exact(const fmpz_t numerator, slong exponent) {
    exact_ = point(numerator, exponent);
    return true;
  }
  static int sign_of(const FlintBall& nonzero) { return arf_sgn(arb_midref(nonzero.value)); }

  DyadicFunction& f_;
  int sign_lower_;
  Rational width_;
  slong target_;
  FlintInteger cell_;  // the cell is (cell_, cell_ + 1) / 2^exponent_
  slong exponent_ = 0;
  FlintBall left_, right_;  // values at its ends
  FlintBall first_, second_;
  std::optional<RationalInterval> exact_;
};

}  // namespace

Rational dyadic(const fmpz_t numerator, slong exponent) {
  FlintRational q;
  fmpz_set(fmpq_numref(q.value), numerator);
  if (exponent >= 0)
    fmpq_div_2exp(q.value, q.value, static_cast<ulong>(exponent));
  else
    fmpq_mul_2exp(q.value, q.value, static_cast<ulong>(-exponent));
  return q.to_rational();
}

void set_ball(arb_t ball, const RationalInterval& interval, slong precision) {
  FlintBall upper;
  arb_set_fmpq(ball, FlintRational(interval.lower).value, precision);
  arb_set_fmpq(upper.value, FlintRational(interval.upper).value, precision);
  arb_union(ball, ball, upper.value, precision);
}

slong grid_exponent(const Rational& width) {
  const mpz_srcptr n = mpq_numref(width.backend().data());
  const mpz_srcptr d = mpq_denref(width.backend().data());
  // 2^-k <= n/d holds for k = bits(d) - bits(n) + 1, not for bits(d) - bits(n) - 1.
  const slong k = bit_length(d) - bit_length(n);
  if (mpz_scan1(d, 0) + 1 == static_cast<mp_bitcnt_t>(bit_length(d))) return k;
  Integer shifted;
  mpz_mul_2exp(shifted.backend().data(), k >= 0 ? n : d, static_cast<mp_bitcnt_t>(std::labs(k)));
  const int order = mpz_cmp(shifted.backend().data(), k >= 0 ? d : n);
  return (k >= 0 ? order >= 0 : order <= 0) ? k : k + 1;
}

DyadicPolynomial::DyadicPolynomial(const Polynomial& f, const RationalInterval& domain)
    : coefficients_(f.rep().value->coeffs),
      degree_(f.degree()),
      horner_(coefficients_, degree_,
              std::max(magnitude_exponent(domain.lower), magnitude_exponent(domain.upper))) {}

void DyadicPolynomial::evaluate(arb_t value, const fmpz_t numerator, slong exponent, slong accuracy) {
  // A value other than zero is at least 2^-(degree exponent): beyond this many limbs only zero is not
  // recognised.
  const slong most_limbs = (horner_.top() + degree_ * std::max<slong>(0, exponent)) / FLINT_BITS + 2;
  const slong wanted = std::max<slong>(0, loss_ + exponent - loss_exponent_) + accuracy + 16;
  slong limbs = std::max<slong>(2, (wanted + FLINT_BITS - 1) / FLINT_BITS);
  for (; limbs < most_limbs; limbs *= 2) {
    horner_.evaluate(value, numerator, exponent, limbs);
    if (arb_contains_zero(value)) continue;
    loss_ = horner_.top() - arf_abs_bound_lt_2exp_si(arb_midref(value));
    loss_exponent_ = exponent;
    return;
  }
  evaluate_exactly(value, numerator, exponent);
}

void DyadicPolynomial::evaluate_exactly(arb_t value, const fmpz_t numerator, slong exponent) const {
  FlintBall point;
  arb_set_fmpz(point.value, numerator);
  arb_mul_2exp_si(point.value, point.value, -exponent);
  arb_set_fmpz(value, coefficients_ + degree_);
  for (slong i = degree_ - 1; i >= 0; --i) {
    arb_mul(value, value, point.value, ARF_PREC_EXACT);
    arb_add_fmpz(value, value, coefficients_ + i, ARF_PREC_EXACT);
  }
}

RationalInterval refine(DyadicFunction& f, const RationalInterval& isolating, int sign_lower,
                        const Rational& width) {
  return Refinement(f, sign_lower, width).run(isolating);
}

}  // namespace exsect
