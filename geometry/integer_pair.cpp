#include "integer_pair.h"

#include "vector_algebra.h"

namespace exsect {
namespace {

/// From the Bernstein basis to the power basis in place, one coordinate in one parameter.
void to_power_basis(Integer& b0, Integer& b1, Integer& b2) {
  b1 -= b0;
  b2 -= b0;
  b2 -= b1;
  b2 -= b1;
  b1 *= 2;
}

/// b = a / q for a divisor q: a shift if q is a power of two.
void set_quotient(mpz_t b, const mpz_t a, const mpz_t q) {
  const mp_bitcnt_t zeros = mpz_scan1(q, 0);
  if (zeros + 1 == mpz_sizeinbase(q, 2))
    mpz_tdiv_q_2exp(b, a, zeros);
  else
    mpz_divexact(b, a, q);
}

/// Sets coordinate k of the net to the power basis of the patch times `multiplier`, a common denominator.
void set_coordinate(IntegerNet& net, const BezierPatch& patch, std::size_t k, const Integer& multiplier) {
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const mpq_t& x = patch.net()[i][j][k].backend().data();
      mpz_t& c = net[i][j][k].backend().data();
      set_quotient(c, multiplier.backend().data(), mpq_denref(x));
      mpz_mul(c, c, mpq_numref(x));
    }
    to_power_basis(net[i][0][k], net[i][1][k], net[i][2][k]);
  }
  for (std::size_t j = 0; j < 3; ++j) to_power_basis(net[0][j][k], net[1][j][k], net[2][j][k]);
}

Integer common_denominator(const BezierPatch& x, const BezierPatch& y, std::size_t k) {
  Integer result = 1;
  mpz_t& lcm = result.backend().data();
  for (const BezierPatch* patch : {&x, &y})
    for (const auto& row : patch->net())
      for (const Point& p : row)
        if (const auto denominator = mpq_denref(p[k].backend().data()); !mpz_divisible_p(lcm, denominator))
          mpz_lcm(lcm, lcm, denominator);
  return result;
}

/// Calls f with coordinate k of every coefficient of both nets.
template <class Function>
void for_each_coordinate(IntegerPair& pair, std::size_t k, Function f) {
  for (IntegerNet* net : {&pair.x, &pair.y})
    for (auto& row : *net)
      for (IntegerVector& c : row) f(c[k].backend().data());
}

void divide_by_content(IntegerPair& pair, std::size_t k) {
  Integer content = 0;
  mpz_t& gcd = content.backend().data();
  for_each_coordinate(pair, k, [&](mpz_t& c) {
    if (mpz_cmp_ui(gcd, 1) != 0) mpz_gcd(gcd, gcd, c);
  });
  if (content > 1) for_each_coordinate(pair, k, [&](mpz_t& c) { mpz_divexact(c, c, gcd); });
}

}  // namespace

IntegerPair integer_pair(const BezierPatch& x, const BezierPatch& y) {
  IntegerPair pair;
  for (std::size_t k = 0; k < 3; ++k) {
    const Integer multiplier = common_denominator(x, y, k);
    set_coordinate(pair.x, x, k, multiplier);
    set_coordinate(pair.y, y, k, multiplier);
    pair.y[0][0][k] -= pair.x[0][0][k];
    pair.x[0][0][k] = 0;
    divide_by_content(pair, k);
  }
  return pair;
}

IntegerNet exchanged(const IntegerNet& net) {
  IntegerNet result;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) result[i][j] = net[j][i];
  return result;
}

IntegerLine line_at_first(const IntegerNet& net, const Rational& u0) {
  const Integer p = numerator(u0);
  const Integer q = denominator(u0);
  IntegerLine line;
  line.weight = q * q;
  for (std::size_t j = 0; j < 3; ++j) {
    for (std::size_t k = 0; k < 3; ++k) {
      // q^2 (c0 + c1 u0 + c2 u0^2) = (c2 p + c1 q) p + c0 q^2
      line.a[j][k] = (net[2][j][k] * p + net[1][j][k] * q) * p + net[0][j][k] * line.weight;
    }
  }
  return line;
}

bool is_conic(const IntegerLine& line) {
  const IntegerVector n = cross_over(line.a[1], line.a[2]);
  return !(n[0].is_zero() && n[1].is_zero() && n[2].is_zero());
}

}  // namespace exsect
