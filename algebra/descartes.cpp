#include "descartes.h"

#include <optional>
#include <stdexcept>

#include "fixed_point_bernstein.h"
#include "flint_polynomial.h"
#include "interruption.h"
#include "root_gap.h"

namespace exsect {
namespace {

/// The depth from which a multiple root is suspected and looked for once.
constexpr long suspicious_depth = 12;
/// So many bisections are left out at least where no root is next to an end.
constexpr long least_gap = 4;

[[noreturn]] void throw_multiple_root() {
  throw std::invalid_argument("isolate_roots: the polynomial has a multiple root in the interval");
}

/// The dyadic interval [index, index + 1] / 2^depth of [0,1], of any depth.
struct DeepDyadicInterval {
  Integer index;
  long depth;

  Rational lower() const { return at(index); }
  Rational upper() const { return at(index + 1); }
  DeepDyadicInterval left_half() const { return {index * 2, depth + 1}; }
  DeepDyadicInterval right_half() const { return {index * 2 + 1, depth + 1}; }

  /// n / 2^depth.
  Rational at(const Integer& n) const {
    Rational result(n);
    mpq_div_2exp(result.backend().data(), result.backend().data(), static_cast<mp_bitcnt_t>(depth));
    return result;
  }
};

struct Node {
  DeepDyadicInterval where;
  FixedPointBernstein coefficients;
};

int exact_variations(const FlintVector& c) {
  int variations = 0;
  int last = 0;
  for (slong i = 0; i < c.size; ++i) {
    const int s = fmpz_sgn(c[i]);
    if (s == 0) continue;
    if (last == -s) ++variations;
    last = s;
  }
  return variations;
}

/// The roots in [0,1] of f(a + t(b-a)), by bisection from left to right. A node of the bisection tree is
/// decided in fixed point if the bounds of its sign changes leave only 0 or only 1; if an end has no certain
/// sign, it is computed anew from the exact polynomial, decided exactly, and split further with full
/// precision.
class Isolator {
 public:
  Isolator(const Polynomial& f, const Rational& a, const Rational& b)
      : f_(f), a_(a), width_(b - a), unit_(a == 0 && b == 1), multipliers_(f.degree() + 1) {
    const Integer common = lcm(denominator(a), denominator(b));
    const FlintInteger p(numerator(a * common)), w(numerator(width_ * common)), q(common);
    substitute_affine(on_unit_.value, NumeratorView(f).get(), p.value, w.value, q.value);
    bernstein_multipliers(multipliers_);
  }

  std::vector<IsolatingInterval> run() {
    const bool root_at_one = start();
    while (!open_.empty()) {
      interruption_point();
      Node node = std::move(open_.back());
      open_.pop_back();
      process(std::move(node));
    }
    if (root_at_one) report_root(1);
    return std::move(found_);
  }

 private:
  /// Handles the whole interval; returns whether 1 is a root.
  bool start() {
    visit_exactly({0, 0}, false);
    FlintInteger sum;
    for (slong i = 0; i < on_unit_.value->length; ++i)
      fmpz_add(sum.value, sum.value, on_unit_.value->coeffs + i);
    return fmpz_is_zero(sum.value) != 0;
  }

  void process(Node node) {
    const VariationBounds bounds = node.coefficients.variations();
    if (bounds.most == 0) return;
    if (bounds.least == 1 && bounds.most == 1)
      report_interval(node.where, node.coefficients.sign_right_of_left_end(),
                      node.coefficients.zero_at_left(), node.coefficients.zero_at_right());
    else if (node.coefficients.ends_certain())
      split(std::move(node));
    else
      visit_exactly(node.where, node.coefficients.zero_at_left());
  }

  void split(Node node) {
    if (node.where.depth >= suspicious_depth && !multiple_root_excluded_) exclude_multiple_roots();
    FixedPointBernstein left = node.coefficients.split();
    open_.push_back({node.where.right_half(), std::move(node.coefficients)});
    open_.push_back({node.where.left_half(), std::move(left)});
  }

  /// Reports a root at the left end (once: a node knows of a root found before). The root at the right end of
  /// a node is the left end of its neighbour, whose sign there is as uncertain.
  void visit_exactly(const DeepDyadicInterval& where, bool left_root_reported) {
    FlintVector c(on_unit_.value->length);
    exact_coefficients(c, where);
    const slong n = c.size - 1;
    const bool zero_at_left = fmpz_is_zero(c[0]) != 0;
    const bool zero_at_right = fmpz_is_zero(c[n]) != 0;
    if ((zero_at_left && fmpz_is_zero(c[1])) || (zero_at_right && fmpz_is_zero(c[n - 1])))
      throw_multiple_root();
    if (zero_at_left && !left_root_reported) report_root(where.lower());
    const int variations = exact_variations(c);
    if (variations == 1)
      report_interval(where, fmpz_sgn(c[zero_at_left ? 1 : 0]), zero_at_left, zero_at_right);
    if (variations <= 1) return;
    if (const auto inner = without_gap(where)) {
      if (inner->depth < kNoRoot) visit_exactly(*inner, zero_at_left);
      return;
    }
    for (slong i = 0; i <= n; ++i) fmpz_mul(c[i], c[i], multipliers_[i]);
    split({where, FixedPointBernstein(c)});
  }

  /// The part next to 0 or 1 of an interval that ends there, if it has all of its roots but 0 and 1 and is
  /// far smaller; of the depth kNoRoot if there are none. Roots near 1e-300 would ask for a thousand
  /// bisections.
  std::optional<DeepDyadicInterval> without_gap(const DeepDyadicInterval& where) {
    const auto unit = [](long depth) { return Integer(1) << static_cast<unsigned long>(depth); };
    const bool is_first = where.index == 0, is_last = where.index + 1 == unit(where.depth);
    if (is_first == is_last) return std::nullopt;
    const long depth = root_free_depth(is_first ? on_unit_.value : reversed(), where.depth);
    if (depth < where.depth + least_gap) return std::nullopt;
    if (is_first || depth == kNoRoot) return DeepDyadicInterval{0, depth};
    return DeepDyadicInterval{unit(depth) - 1, depth};
  }

  /// on_unit_ at 1 - t.
  const fmpz_poly_struct* reversed() {
    if (reversed_.value->length == 0) {
      const FlintInteger one(Integer(1)), minus_one(Integer(-1));
      substitute_affine(reversed_.value, on_unit_.value, one.value, minus_one.value, one.value);
    }
    return reversed_.value;
  }

  /// t^i (1-t)^(n-i) coefficients on the interval, up to a positive factor.
  void exact_coefficients(FlintVector& c, const DeepDyadicInterval& where) const {
    if (where.depth == 0) return to_homogeneous(c, on_unit_.value);
    const FlintInteger p(where.index), q(Integer(1) << static_cast<unsigned long>(where.depth));
    FlintInteger one;
    fmpz_one(one.value);
    FlintPolynomial on_interval;
    substitute_affine(on_interval.value, on_unit_.value, p.value, one.value, q.value);
    to_homogeneous(c, on_interval.value);
  }

  /// Bisection does not end at a multiple root in [0,1], but multiple roots elsewhere do no harm.
  void exclude_multiple_roots() {
    multiple_root_excluded_ = true;
    const Polynomial f = to_polynomial(on_unit_.value);
    if (is_squarefree(f)) return;
    const Polynomial repeated = squarefree_part(gcd(f, f.derivative()));
    if (!isolate_roots(repeated, 0, 1).empty()) throw_multiple_root();
  }

  Rational from_unit(const Rational& t) const { return unit_ ? t : a_ + width_ * t; }

  void report_root(const Rational& t) {
    const Rational root = from_unit(t);
    found_.push_back({root, root});
  }

  /// One root in the open interval, where f has the given sign near the left end. An end that is itself a
  /// root is moved inwards by bisection.
  void report_interval(const DeepDyadicInterval& where, int sign_left, bool zero_at_left,
                       bool zero_at_right) {
    Rational lower = from_unit(where.lower());
    Rational upper = from_unit(where.upper());
    while (zero_at_left || zero_at_right) {
      const Rational middle = (lower + upper) / 2;
      const int s = f_.sign_at(middle);
      if (s == 0) {
        found_.push_back({middle, middle});
        return;
      }
      (s == sign_left ? lower : upper) = middle;
      (s == sign_left ? zero_at_left : zero_at_right) = false;
    }
    found_.push_back({lower, upper});
  }

  const Polynomial& f_;
  Rational a_;
  Rational width_;
  bool unit_;
  FlintPolynomial on_unit_;   // f(a + t(b-a)) up to a positive factor
  FlintPolynomial reversed_;  // 0 until it is asked for
  FlintVector multipliers_;
  std::vector<Node> open_;  // the rightmost first
  std::vector<IsolatingInterval> found_;
  bool multiple_root_excluded_ = false;
};

std::vector<IsolatingInterval> root_at(const Polynomial& f, const Rational& a) {
  if (f.sign_at(a) != 0) return {};
  if (f.derivative().sign_at(a) == 0) throw_multiple_root();
  return {{a, a}};
}

}  // namespace

std::vector<IsolatingInterval> isolate_roots(const Polynomial& squarefree, const Rational& a,
                                             const Rational& b) {
  if (squarefree.is_zero()) throw std::domain_error("isolate_roots: the polynomial is zero");
  if (a > b) throw std::invalid_argument("isolate_roots: a <= b is required");
  if (squarefree.degree() == 0) return {};
  return a == b ? root_at(squarefree, a) : Isolator(squarefree, a, b).run();
}

}  // namespace exsect
