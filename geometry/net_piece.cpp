#include "net_piece.h"

#include <algorithm>
#include <utility>

namespace exsect {
namespace {

/// A parameter p/d.
struct Argument {
  Integer p;
  Integer d;

  explicit Argument(const Rational& t) : p(numerator(t)), d(denominator(t)) {}
};

/// One step of de Casteljau's algorithm: d times the combinations (1 - p/d) a + p/d b of neighbours, one
/// fewer than the numbers.
void step(std::vector<Integer>& row, const Argument& t) {
  if (t.p == 0) {  // d = 1
    row.pop_back();
    return;
  }
  const Integer rest = t.d - t.p;
  for (std::size_t i = 0; i + 1 < row.size(); ++i) {
    row[i] *= rest;
    mpz_addmul(row[i].backend().data(), t.p.backend().data(), row[i + 1].backend().data());
  }
  row.pop_back();
}

/// The polar form of the numbers with k arguments `outer` and the others `inner`, for all k, each times the
/// denominators of its arguments.
std::vector<Integer> polar_forms(std::vector<Integer> row, const Argument& outer, const Argument& inner) {
  std::vector<Integer> result;
  for (std::size_t count = row.size(); count > 0; --count) {
    std::vector<Integer> rest = row;
    while (rest.size() > 1) step(rest, inner);
    result.push_back(std::move(rest.front()));
    if (row.size() > 1) step(row, outer);
  }
  return result;
}

/// With k arguments `to`, k = 0, 1, ..., the others `from`. Steps at 0 cost nothing.
void restrict_row(std::vector<Integer>& row, const Argument& from, const Argument& to) {
  if (from.p == 0) {
    row = polar_forms(std::move(row), to, from);
  } else {
    row = polar_forms(std::move(row), from, to);
    std::ranges::reverse(row);
  }
}

/// d0^(n-k) d1^k, k = 0, ..., n.
std::vector<Integer> denominators(int n, const Integer& d0, const Integer& d1) {
  std::vector<Integer> result(static_cast<std::size_t>(n) + 1, 1);
  for (std::size_t k = 0; k < result.size(); ++k)
    for (std::size_t i = 0; i + 1 < result.size(); ++i) result[k] *= i < k ? d1 : d0;
  return result;
}

/// n/d, d > 0, in lowest terms.
Rational quotient(const Integer& n, const Integer& d) {
  const mpz_srcptr below = d.backend().data();
  const std::size_t bits = mpz_sizeinbase(below, 2) - 1;
  if (n == 0 || mpz_scan1(below, 0) != bits) return Rational(n, d);
  const std::size_t common = std::min<std::size_t>(bits, mpz_scan1(n.backend().data(), 0));
  Rational result;
  mpq_t& q = result.backend().data();
  mpz_tdiv_q_2exp(mpq_numref(q), n.backend().data(), common);
  mpz_tdiv_q_2exp(mpq_denref(q), below, common);
  return result;
}

/// Numbers of one coordinate as integers over a common denominator.
struct CoordinateNet {
  std::vector<Integer> numerators;
  Integer denominator = 1;

  CoordinateNet(const std::vector<HomogeneousPoint>& net, std::size_t k) {
    const auto below = [&](const HomogeneousPoint& p) { return mpq_denref(p[k].backend().data()); };
    const mpz_ptr d = denominator.backend().data();
    for (const HomogeneousPoint& p : net) mpz_lcm(d, d, below(p));
    for (const HomogeneousPoint& p : net) {
      Integer& a = numerators.emplace_back();
      mpz_divexact(a.backend().data(), d, below(p));
      mpz_mul(a.backend().data(), a.backend().data(), mpq_numref(p[k].backend().data()));
    }
  }

  /// Those at first, first + stride, ...
  template <class Change>
  void change(std::size_t first, std::size_t stride, std::size_t count, const Change& change_row) {
    std::vector<Integer> row;
    for (std::size_t i = 0; i < count; ++i) row.push_back(std::move(numerators[first + i * stride]));
    change_row(row);
    for (std::size_t i = 0; i < count; ++i) numerators[first + i * stride] = std::move(row[i]);
  }
};

}  // namespace

std::vector<HomogeneousPoint> net_of_piece(const std::vector<HomogeneousPoint>& net, int m, int n,
                                           const std::array<Rational, 2>& u,
                                           const std::array<Rational, 2>& v) {
  const Argument u0(u[0]), u1(u[1]), v0(v[0]), v1(v[1]);
  const std::size_t rows = static_cast<std::size_t>(m) + 1, columns = static_cast<std::size_t>(n) + 1;
  const std::vector<Integer> of_row = denominators(m, u0.d, u1.d), of_column = denominators(n, v0.d, v1.d);
  std::vector<HomogeneousPoint> result(net.size());
  for (std::size_t k = 0; k < 4; ++k) {
    CoordinateNet x(net, k);
    if (u[0] != 0 || u[1] != 1)
      for (std::size_t j = 0; j < columns; ++j)
        x.change(j, columns, rows, [&](std::vector<Integer>& row) { restrict_row(row, u0, u1); });
    if (v[0] != 0 || v[1] != 1)
      for (std::size_t i = 0; i < rows; ++i)
        x.change(i * columns, 1, columns, [&](std::vector<Integer>& row) { restrict_row(row, v0, v1); });
    for (std::size_t i = 0; i < rows; ++i)
      for (std::size_t j = 0; j < columns; ++j)
        result[i * columns + j][k] =
            quotient(x.numerators[i * columns + j], x.denominator * of_row[i] * of_column[j]);
  }
  return result;
}

}  // namespace exsect
