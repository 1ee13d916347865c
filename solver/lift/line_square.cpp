#include "lift/line_square.h"

namespace exsect {

SymmetricMatrix symmetric_matrix(const BivariatePolynomial& f, const BivariatePolynomial& g) {
  const auto entry = [&](int i, int j, int share) {
    const Rational part(1, share);
    return Polynomial{part * f.coefficient(i, j), part * g.coefficient(i, j)};
  };
  const Polynomial uv = entry(1, 1, 2), u = entry(1, 0, 2), v = entry(0, 1, 2);
  return {{{entry(2, 0, 1), uv, u}, {uv, entry(0, 2, 1), v}, {u, v, entry(0, 0, 1)}}};
}

std::vector<LineSquare> line_squares(const SymmetricMatrix& m) {
  Polynomial common;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      common = gcd(common, m[i][j] * m[(i + 1) % 3][(j + 1) % 3] - m[i][(j + 1) % 3] * m[(i + 1) % 3][j]);
  std::vector<LineSquare> squares;
  if (common.degree() < 1) return squares;
  const auto number = [](const Rational& q) { return BivariatePolynomial::constant(q); };
  for (const PolynomialPower& power : irreducible_factors(common)) {
    if (power.factor.degree() != 1) continue;
    const Rational at = -power.factor.coefficient(0) / power.factor.coefficient(1);
    for (std::size_t i = 0; i < 3; ++i) {
      const Rational factor = m[i][i](at);
      if (factor == 0) continue;
      squares.push_back({at,
                         number(m[i][0](at)) * BivariatePolynomial::r() +
                             number(m[i][1](at)) * BivariatePolynomial::s() + number(m[i][2](at)),
                         factor});
      break;
    }
  }
  return squares;
}

}  // namespace exsect
