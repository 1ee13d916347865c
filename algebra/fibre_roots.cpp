// Roots of a polynomial over Q(s): Descartes' rule in the Bernstein basis, the coefficients enclosed in
// balls.
#include <algorithm>
#include <memory>
#include <stdexcept>
#include <utility>

#include "descartes.h"
#include "fibre_polynomial.h"
#include "quadratic_refinement.h"
#include "triangular_point.h"

namespace exsect {
namespace {

/// Owner of an array of arb.
class BallVector {
 public:
  explicit BallVector(slong size) : size_(size), data_(_arb_vec_init(size)) {}
  BallVector(const BallVector&) = delete;
  BallVector& operator=(const BallVector&) = delete;
  ~BallVector() { _arb_vec_clear(data_, size_); }
  slong size() const { return size_; }
  arb_ptr operator[](slong i) const { return data_ + i; }
  arb_ptr back() const { return data_ + (size_ - 1); }

 private:
  slong size_;
  arb_ptr data_;
};

/// The greatest number of sign changes, zeros skipped, over all choices of numbers from the balls.
int most_variations(const BallVector& b) {
  constexpr int none = -1000;
  // The most changes in a choice whose last nonzero sign is +, -, or that is zero so far.
  int plus = none, minus = none, zero = 0;
  for (slong i = 0; i < b.size(); ++i) {
    if (arb_is_zero(b[i])) continue;
    const bool positive = arb_is_positive(b[i]) != 0;
    const bool negative = arb_is_negative(b[i]) != 0;
    const int to_plus = std::max({plus, minus + 1, zero});
    const int to_minus = std::max({minus, plus + 1, zero});
    plus = negative ? none : to_plus;
    minus = positive ? none : to_minus;
    if (positive || negative) zero = none;
  }
  return std::max({plus, minus, zero});
}

/// Whether the ends, settled, have opposite nonzero signs: then the number of sign changes is odd.
bool has_opposite_ends(const BallVector& b) {
  return arf_sgn(arb_midref(b[0])) * arf_sgn(arb_midref(b.back())) < 0;
}

/// One run with a fixed precision. Descartes' rule holds for every choice of coefficients in the balls, the
/// true one among them; the signs at interval ends are decided exactly.
class FibreIsolation {
 public:
  FibreIsolation(const BivariatePolynomial& f, const RealAlgebraic& s, slong precision)
      : f_(f), s_(s.refined_to(power_of_two(-precision))), precision_(precision) {}

  /// The roots in [a,b], a < b; false if the precision does not suffice.
  bool run(const Rational& a, const Rational& b) {
    BallVector bernstein(f_.degree_r() + 1);
    convert(bernstein, a, b);
    if (!settle(bernstein[0], a) || !settle(bernstein.back(), b)) return false;
    if (arb_is_zero(bernstein[0])) roots_.push_back({a, a});
    if (!isolate(a, b, bernstein, 0)) return false;
    if (arb_is_zero(bernstein.back())) roots_.push_back({b, b});
    return true;
  }

  const std::vector<RationalInterval>& roots() const { return roots_; }

 private:
  /// Bernstein coefficients of f(a + (b-a) t, s) = sum c_i t^i: b_j = sum_i c_i binom(j,i) / binom(n,i).
  void convert(BallVector& bernstein, const Rational& a, const Rational& b) {
    FlintBallPolynomial power, line;
    FlintBall c, term;
    enclose(power.value, f_, s_, precision_);
    arb_set_fmpq(c.value, FlintRational(b - a).value, precision_);
    arb_poly_set_coeff_arb(line.value, 1, c.value);
    arb_set_fmpq(c.value, FlintRational(a).value, precision_);
    arb_poly_set_coeff_arb(line.value, 0, c.value);
    arb_poly_compose(power.value, power.value, line.value, precision_);
    const slong n = bernstein.size() - 1;
    FlintInteger binomial;
    for (slong i = 0; i <= n; ++i) {
      arb_poly_get_coeff_arb(c.value, power.value, i);
      fmpz_bin_uiui(binomial.value, static_cast<ulong>(n), static_cast<ulong>(i));
      arb_div_fmpz(c.value, c.value, binomial.value, precision_);
      for (slong j = i; j <= n; ++j) {
        fmpz_bin_uiui(binomial.value, static_cast<ulong>(j), static_cast<ulong>(i));
        arb_mul_fmpz(term.value, c.value, binomial.value, precision_);
        arb_add(bernstein[j], bernstein[j], term.value, precision_);
      }
    }
  }

  /// The value at the rational r is made exactly zero if it is; false if it is not but the ball does not tell
  /// the sign.
  bool settle(arb_t value, const Rational& r) {
    if (!arb_contains_zero(value)) return true;
    if (sign_at(f_.at_r(r), s_) != 0) return false;
    arb_zero(value);
    return true;
  }

  /// The roots in the open interval.
  bool isolate(const Rational& lower, const Rational& upper, const BallVector& b, slong depth) {
    const int most = most_variations(b);
    if (most == 0) return true;
    if (most == 1 && has_opposite_ends(b)) {
      roots_.push_back({lower, upper});
      return true;
    }
    if (depth == precision_) return false;
    const slong n = b.size() - 1;
    BallVector left(n + 1), right(n + 1);
    bisect(left, right, b);
    const Rational middle = (lower + upper) / 2;
    if (!settle(right[0], middle)) return false;
    arb_set(left.back(), right[0]);
    if (!isolate(lower, middle, left, depth + 1)) return false;
    if (arb_is_zero(right[0])) roots_.push_back({middle, middle});
    return isolate(middle, upper, right, depth + 1);
  }

  /// De Casteljau's algorithm at 1/2.
  void bisect(BallVector& left, BallVector& right, const BallVector& b) const {
    const slong n = b.size() - 1;
    for (slong i = 0; i <= n; ++i) arb_set(right[i], b[i]);
    for (slong k = 0; k <= n; ++k) {
      arb_set(left[k], right[0]);
      for (slong i = 0; i < n - k; ++i) {
        arb_add(right[i], right[i], right[i + 1], precision_);
        arb_mul_2exp_si(right[i], right[i], -1);
      }
    }
  }

  const BivariatePolynomial& f_;
  RealAlgebraic s_;
  slong precision_;
  std::vector<RationalInterval> roots_;
};

/// f squarefree over Q(s), reduced at s, not constant.
std::vector<RationalInterval> isolate_roots_at(const BivariatePolynomial& f, const RealAlgebraic& s,
                                               const Rational& a, const Rational& b) {
  if (s.is_rational()) return isolate_roots(f.at_s(s.rational()), a, b);
  if (a == b) {
    if (sign_at(f.at_r(a), s) != 0) return {};
    return {{a, a}};
  }
  for (slong precision = 128;; precision *= 2) {
    FibreIsolation isolation(f, s, precision);
    if (isolation.run(a, b)) return isolation.roots();
  }
}

}  // namespace

std::vector<TriangularPoint> roots_at(const BivariatePolynomial& f, const RealAlgebraic& s, const Rational& a,
                                      const Rational& b) {
  if (a > b) throw std::invalid_argument("roots_at: a <= b is required");
  const RealAlgebraic fine = s.refined_to(power_of_two(-64));
  const BivariatePolynomial reduced = reduced_at(f, fine);
  if (reduced.is_zero()) throw std::domain_error("roots_at: the polynomial vanishes identically at s");
  if (reduced.degree_r() == 0) return {};
  const BivariatePolynomial g = squarefree_part_at(reduced, fine);
  const auto whole =
      f.degree_r() == reduced.degree_r() ? std::make_shared<const BivariatePolynomial>(f) : nullptr;
  std::vector<TriangularPoint> points;
  for (const RationalInterval& r : isolate_roots_at(g, fine, a, b)) points.emplace_back(fine, g, r, whole);
  return points;
}

}  // namespace exsect
