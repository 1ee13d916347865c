#include "triangular_point.h"

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <utility>

#include "fibre_polynomial.h"
#include "quadratic_refinement.h"

namespace exsect {
namespace {

/// r -> g(r, s) at dyadic r, the coefficients enclosed over an ever narrower interval of s.
class FibreFunction : public DyadicFunction {
 public:
  FibreFunction(const BivariatePolynomial& g, const RealAlgebraic& s) : g_(g), s_(s) {}

  void evaluate(arb_t value, const fmpz_t numerator, slong exponent, slong accuracy) override {
    FlintBall r;
    arb_set_fmpz(r.value, numerator);
    arb_mul_2exp_si(r.value, r.value, -exponent);
    slong wanted = std::max<slong>(64, loss_ + exponent - loss_exponent_ + accuracy + 8);
    for (int attempt = 0;; ++attempt) {
      enclose_coefficients(wanted);
      arb_poly_evaluate_horner(value, coefficients_.value, r.value, bits_);
      if (!arb_contains_zero(value)) {
        const slong achieved = std::min(bits_, arb_rel_accuracy_bits(value));
        loss_ = bits_ - achieved;
        loss_exponent_ = exponent;
        if (2 * achieved >= accuracy) return;
        wanted = bits_ + accuracy - achieved;
        continue;
      }
      if (attempt == 1 && sign_at(g_.at_r(dyadic(numerator, exponent)), s_) == 0) {
        arb_zero(value);
        return;
      }
      wanted = 2 * bits_;
    }
  }

  /// As far as it had to be refined.
  const RealAlgebraic& s() const { return s_; }

 private:
  void enclose_coefficients(slong bits) {
    if (bits <= bits_) return;
    bits_ = bits;
    s_ = s_.refined_to(power_of_two(-bits));
    enclose(coefficients_.value, g_, s_, bits);
  }

  const BivariatePolynomial& g_;
  RealAlgebraic s_;
  FlintBallPolynomial coefficients_;
  slong bits_ = 0;           // the width of s is at most 2^-bits_, the working precision bits_
  slong loss_ = 0;           // bits lost in the last evaluation
  slong loss_exponent_ = 0;  // the exponent it was made at
};

/// The sign of h on the whole box, or 0 if an enclosure does not show it.
int enclosed_sign(const BivariatePolynomial& h, const TriangularPoint& p, slong precision) {
  FlintBallPolynomial coefficients;
  FlintBall r, value;
  enclose(coefficients.value, h, p.s(), precision);
  set_ball(r.value, p.r_interval(), precision);
  arb_poly_evaluate_horner(value.value, coefficients.value, r.value, precision);
  return arb_contains_zero(value.value) ? 0 : arf_sgn(arb_midref(value.value));
}

/// Whether h vanishes at p, if h and g, which is that of p or has its roots, have one common root at most and
/// that is told: the root of g in the interval is the only one there.
std::optional<bool> vanishes_in_balls(const BivariatePolynomial& h, const BivariatePolynomial& g,
                                      const TriangularPoint& p) {
  constexpr slong precision = 1024;
  CommonRoots roots;
  find_common_roots(roots, h, g, p.s().refined_to(power_of_two(-512)));
  if (roots.number == CommonRoots::Number::none) return false;
  if (roots.number == CommonRoots::Number::unknown) return std::nullopt;
  FlintBall interval;
  set_ball(interval.value, p.r_interval(), precision);
  if (!arb_overlaps(interval.value, roots.root.value)) return false;
  FlintBall lower, upper;
  set_ball(lower.value, RationalInterval{p.r_interval().lower, p.r_interval().lower}, precision);
  set_ball(upper.value, RationalInterval{p.r_interval().upper, p.r_interval().upper}, precision);
  if (arb_lt(lower.value, roots.root.value) && arb_lt(roots.root.value, upper.value)) return true;
  return std::nullopt;
}

/// Whether h vanishes at p: whether gcd(h, g) over Q(s) has the root r. It divides g, which is nonzero at the
/// ends of the interval of r and has one root inside, a simple one.
bool vanishes_at(const BivariatePolynomial& h, const TriangularPoint& p) {
  for (const BivariatePolynomial* g : {&p.whole(), &p.g()})
    if (const auto known = vanishes_in_balls(h, *g, p)) return *known;
  const BivariatePolynomial common = gcd_at(h, p.g(), p.s());
  if (common.degree_r() <= 0) return false;
  return sign_at(common.at_r(p.r_interval().lower), p.s()) !=
         sign_at(common.at_r(p.r_interval().upper), p.s());
}

}  // namespace

TriangularPoint::TriangularPoint(RealAlgebraic s, BivariatePolynomial g, RationalInterval r_interval)
    : s_(std::move(s)), g_(std::move(g)), r_(std::move(r_interval)) {
  if (r_.lower > r_.upper) throw std::invalid_argument("TriangularPoint: the interval of r is empty");
  sign_lower_ = sign_at(g_.at_r(r_.lower), s_);
  if (r_.lower == r_.upper ? sign_lower_ != 0 : sign_lower_ == 0)
    throw std::invalid_argument(
        "TriangularPoint: g vanishes at the end of an open interval, or not at a given r");
  if (r_.lower != r_.upper && sign_at(g_.at_r(r_.upper), s_) != -sign_lower_)
    throw std::invalid_argument("TriangularPoint: the signs of g at the ends are not opposite and nonzero");
}

TriangularPoint::TriangularPoint(RealAlgebraic s, BivariatePolynomial g, RationalInterval r_interval,
                                 std::shared_ptr<const BivariatePolynomial> whole)
    : TriangularPoint(std::move(s), std::move(g), std::move(r_interval)) {
  whole_ = std::move(whole);
}

TriangularPoint TriangularPoint::refined_to(const Rational& width) const {
  if (width <= 0) throw std::invalid_argument("TriangularPoint::refined_to: the width is not positive");
  TriangularPoint result = *this;
  if (r_.width() > width) {
    FibreFunction g(g_, s_);
    result.r_ = refine(g, r_, sign_lower_, width);
    if (result.r_.lower == result.r_.upper) result.sign_lower_ = 0;
    result.s_ = g.s();
  }
  result.s_ = result.s_.refined_to(width);
  return result;
}

int sign_at(const BivariatePolynomial& h, const TriangularPoint& p) {
  if (h.is_zero()) return 0;
  TriangularPoint point = p;
  for (long bits = 32;; bits *= 2) {
    point = point.refined_to(power_of_two(-bits));
    if (point.r_interval().lower == point.r_interval().upper)
      return sign_at(h.at_r(point.r_interval().lower), point.s());
    if (const int s = enclosed_sign(h, point, bits + 64)) return s;
    if (bits == 64 && vanishes_at(h, point)) return 0;
  }
}

}  // namespace exsect
