#include "quadratic_sign.h"

#include <stdexcept>

namespace exsect {
namespace {

/// The sign of alpha + beta sqrt(D) from the signs of alpha, beta, D; `norm_sign` gives that of alpha^2 -
/// beta^2 D and is asked for only where alpha and beta sqrt(D) have opposite signs.
template <typename NormSign>
int combine(int alpha, int beta, int d, NormSign norm_sign) {
  if (d < 0) throw std::domain_error("quadratic_sign: D is negative");
  if (d == 0 || beta == 0 || alpha == beta) return alpha;
  if (alpha == 0) return beta;
  return alpha * norm_sign();
}

}  // namespace

int quadratic_sign(const Rational& alpha, const Rational& beta, const Rational& d) {
  return combine(sign(alpha), sign(beta), sign(d), [&] { return sign(alpha * alpha - beta * beta * d); });
}

int quadratic_sign(const Polynomial& alpha, const Polynomial& beta, const Polynomial& d,
                   const RealAlgebraic& s) {
  return combine(sign_at(alpha, s), sign_at(beta, s), sign_at(d, s),
                 [&] { return sign_at(alpha * alpha - beta * beta * d, s); });
}

}  // namespace exsect
