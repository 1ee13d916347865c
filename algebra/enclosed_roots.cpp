#include "enclosed_roots.h"

#include <algorithm>

#include "dyadic_interval.h"
#include "fixed_point_bernstein.h"
#include "flint_polynomial.h"

namespace exsect {
namespace {

constexpr int deepest = 48;

struct EnclosedNode {
  DyadicInterval where;
  FixedPointBernstein coefficients;
  bool fresh;  // made from the polynomial itself
};

class EnclosedIsolator {
 public:
  explicit EnclosedIsolator(const EnclosedPolynomial& f)
      : error_(f.error), multipliers_(static_cast<slong>(f.coefficients.size())) {
    const slong length = multipliers_.size;
    fmpz_poly_fit_length(f_.value, length);
    for (slong i = 0; i < length; ++i)
      fmpz_set_mpz(f_.value->coeffs + i, f.coefficients[static_cast<std::size_t>(i)].backend().data());
    _fmpz_poly_set_length(f_.value, length);
    _fmpz_poly_normalise(f_.value);
    bernstein_multipliers(multipliers_);
  }

  std::optional<std::vector<RationalInterval>> run() {
    open_.push_back(fresh_node({0, 0}));
    while (!open_.empty()) {
      EnclosedNode node = std::move(open_.back());
      open_.pop_back();
      if (!process(node) && (node.fresh || !process(node = fresh_node(node.where)))) return std::nullopt;
    }
    return std::move(found_);
  }

 private:
  /// False if the signs do not suffice. A certain number of changes implies certain signs at the ends: either
  /// choice would change it.
  bool process(EnclosedNode& node) {
    const VariationBounds bounds = node.coefficients.variations();
    if (bounds.least == bounds.most && bounds.most <= 1) {
      if (bounds.most == 1) found_.push_back(node.where.interval());
      return true;
    }
    if (node.where.depth == deepest || !node.coefficients.ends_certain()) return false;
    FixedPointBernstein left = node.coefficients.split();
    open_.push_back({node.where.half(1), std::move(node.coefficients), false});
    open_.push_back({node.where.half(0), std::move(left), false});
    return true;
  }

  /// Of q^n f((p + t)/q), p = index, q = 2^depth, times lcm_j binom(n,j). Its powers of t have an error of at
  /// most (n + 1) q^n error, because p + 1 <= q. A Bernstein coefficient is sum_j binom(n-j,i-j) c_j /
  /// binom(n,i), whose weights add up to binom(n+1,i) / binom(n,i) <= n + 1.
  EnclosedNode fresh_node(const DyadicInterval& where) const {
    const slong length = multipliers_.size;
    FlintInteger p(where.index), q(Integer(1) << static_cast<unsigned>(where.depth)), one,
        error(error_ * length);
    fmpz_one(one.value);
    FlintPolynomial power;
    substitute_affine(power.value, f_.value, p.value, one.value, q.value);
    // substitute_affine takes the true degree, which an enclosure need not have.
    FlintInteger scale;
    fmpz_pow_ui(scale.value, q.value, static_cast<ulong>(length - f_.value->length));
    fmpz_poly_scalar_mul_fmpz(power.value, power.value, scale.value);
    FlintVector c(length);
    to_homogeneous(c, power.value);
    for (slong i = 0; i < length; ++i) fmpz_mul(c[i], c[i], multipliers_[i]);
    fmpz_mul(error.value, error.value, multipliers_[0]);
    if (where.depth > 0) {
      fmpz_mul_si(error.value, error.value, length);
      fmpz_mul_2exp(error.value, error.value, static_cast<ulong>(where.depth * (length - 1)));
    }
    return {where, FixedPointBernstein(c, error.value), true};
  }

  FlintPolynomial f_;
  Integer error_;
  FlintVector multipliers_;
  std::vector<EnclosedNode> open_;  // the rightmost first
  std::vector<RationalInterval> found_;
};

}  // namespace

std::optional<std::vector<RationalInterval>> isolate_enclosed_roots(const EnclosedPolynomial& f) {
  return EnclosedIsolator(f).run();
}

}  // namespace exsect
