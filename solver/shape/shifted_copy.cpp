#include "shape/shifted_copy.h"

#include <exsect/algebra/rational_matrix.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace exsect {

namespace {

using Coordinates = std::vector<Rational>;
/// The coefficient of t^i at i; the last one is not zero.
using CoordinatesPolynomial = std::vector<Coordinates>;
/// Homogeneous coordinates of a patch: the coefficient of u^i v^j at [i][j].
using Tensor = std::vector<std::vector<Coordinates>>;

bool is_null(const Coordinates& v) {
  return std::ranges::all_of(v, [](const Rational& c) { return c == 0; });
}

/// a - c b, with the c that takes the first coordinate of b that is not zero out of a. Requires b != 0.
Coordinates reduced_by(const Coordinates& a, const Coordinates& b, Rational* factor = nullptr) {
  const auto pivot = std::ranges::find_if(b, [](const Rational& c) { return c != 0; }) - b.begin();
  const Rational c = a[static_cast<std::size_t>(pivot)] / b[static_cast<std::size_t>(pivot)];
  if (factor != nullptr) *factor = c;
  Coordinates result = a;
  for (std::size_t k = 0; k < a.size(); ++k) result[k] -= c * b[k];
  return result;
}

/// The c with a = c b, if there is one. Requires b != 0.
std::optional<Rational> multiple(const Coordinates& a, const Coordinates& b) {
  Rational c;
  return is_null(reduced_by(a, b, &c)) ? std::optional(c) : std::nullopt;
}

CoordinatesPolynomial trimmed(CoordinatesPolynomial g) {
  while (!g.empty() && is_null(g.back())) g.pop_back();
  return g;
}

/// The maps A with h = k g(A(t)) for some number k other than 0, two at most; none if all
/// coefficients of g are multiples of one vector. With t -> a + b t, (14.40).
std::vector<AffineMap> maps_between(const CoordinatesPolynomial& g, const CoordinatesPolynomial& h) {
  if (g.size() != h.size() || g.size() < 2) return {};
  const std::size_t d = g.size() - 1;
  const auto top = multiple(h[d], g[d]);  // k b^d
  std::size_t e = d;
  while (e > 0 && is_null(reduced_by(g[e], g[d]))) --e;
  const Coordinates across = reduced_by(g[e], g[d]);
  if (!top || is_null(across)) return {};
  const auto next = multiple(reduced_by(h[e], g[d]), across);  // k b^e
  if (!next || *next == 0) return {};
  const auto root = rational_root(*top / *next, static_cast<unsigned>(d - e));
  if (!root) return {};
  std::vector<AffineMap> maps;
  for (const Rational& b : {*root, Rational(-*root)}) {
    // The coefficients before the last ones: h[d-1] = k b^(d-1) (g[d-1] + d a g[d]).
    const Rational k = *top / b;
    Coordinates rest = h[d - 1];
    for (std::size_t i = 0; i < rest.size(); ++i) rest[i] -= k * g[d - 1][i];
    const auto a = multiple(rest, g[d]);
    if (a) maps.push_back({*a / (k * Rational(d)), b});
    if ((d - e) % 2 == 1) break;
  }
  // Of a patch that is even in the parameter both are right; the one that meets the square comes first.
  const auto meets_square = [](const AffineMap& map) {
    return std::max(map(0), map(1)) > 0 && std::min(map(0), map(1)) < 1;
  };
  std::ranges::stable_partition(maps, meets_square);
  return maps;
}

Tensor transposed(const Tensor& x) {
  Tensor result(x[0].size(), std::vector<Coordinates>(x.size()));
  for (std::size_t i = 0; i < x.size(); ++i)
    for (std::size_t j = 0; j < x[0].size(); ++j) result[j][i] = x[i][j];
  return result;
}

/// The power basis instead of Bernstein's in the first parameter: binomial(n,i) times the i-th differences.
void expand_first(Tensor& x) {
  const std::size_t n = x.size() - 1;
  for (std::size_t order = 1; order <= n; ++order) {
    const Rational factor(n - order + 1, order);
    for (std::size_t i = n; i >= order; --i)
      for (std::size_t j = 0; j < x[0].size(); ++j)
        for (std::size_t k = 0; k < 4; ++k) x[i][j][k] = factor * (x[i][j][k] - x[i - 1][j][k]);
  }
}

Tensor tensor(const HomogeneousNet& net) {
  Tensor result;
  for (const std::vector<HomogeneousPoint>& row : net) {
    result.emplace_back();
    for (const HomogeneousPoint& p : row) result.back().emplace_back(p.begin(), p.end());
  }
  for (int turn = 0; turn < 2; ++turn) {
    expand_first(result);
    result = transposed(result);
  }
  return result;
}

HomogeneousNet net_of(const RationalPatch& patch) {
  HomogeneousNet net(static_cast<std::size_t>(patch.degree_u()) + 1);
  for (std::size_t i = 0; i < net.size(); ++i)
    for (int j = 0; j <= patch.degree_v(); ++j) net[i].push_back(patch.homogeneous(static_cast<int>(i), j));
  return net;
}

/// The highest derivative by v, up to a number, as a polynomial in u.
CoordinatesPolynomial highest(const Tensor& x) {
  for (std::size_t j = x[0].size(); j-- > 0;) {
    CoordinatesPolynomial g;
    for (const std::vector<Coordinates>& row : x) g.push_back(row[j]);
    if (g = trimmed(std::move(g)); !g.empty()) return g;
  }
  return {};
}

/// All coefficients of powers of v, one after the other, as a polynomial in u.
CoordinatesPolynomial joined(const Tensor& x) {
  CoordinatesPolynomial g;
  for (const std::vector<Coordinates>& row : x) {
    g.emplace_back();
    for (const Coordinates& v : row) g.back().insert(g.back().end(), v.begin(), v.end());
  }
  return trimmed(std::move(g));
}

/// x(A(u),v), by Horner's rule.
Tensor composed(const Tensor& x, const AffineMap& map) {
  Tensor result(x.size(), std::vector<Coordinates>(x[0].size(), Coordinates(4)));
  for (std::size_t n = x.size(); n-- > 0;) {
    for (std::size_t j = 0; j < x[0].size(); ++j) {
      for (std::size_t k = 0; k < 4; ++k) {
        for (std::size_t i = x.size() - 1; i > 0; --i) {
          result[i][j][k] = map.offset * result[i][j][k] + map.factor * result[i - 1][j][k];
        }
        result[0][j][k] = map.offset * result[0][j][k] + x[n][j][k];
      }
    }
  }
  return result;
}

/// The linear forms of x that depend on u alone, as one polynomial: those of y are the same forms.
std::array<CoordinatesPolynomial, 2> forms_in_first(const Tensor& x, const Tensor& y) {
  RationalMatrix across(x.size() * (x[0].size() - 1), 4);
  std::size_t row = 0;
  for (const std::vector<Coordinates>& line : x)
    for (std::size_t j = 1; j < line.size(); ++j, ++row)
      for (std::size_t k = 0; k < 4; ++k) across(row, k) = line[j][k];
  const std::vector<std::vector<Integer>> forms = null_space(across);
  const auto values = [&](const Tensor& patch) {
    CoordinatesPolynomial g;
    for (const std::vector<Coordinates>& line : patch) {
      g.emplace_back();
      for (const std::vector<Integer>& form : forms) {
        Rational value = 0;
        for (std::size_t k = 0; k < 4; ++k) value += Rational(form[k]) * line[0][k];
        g.back().push_back(value);
      }
    }
    return trimmed(std::move(g));
  };
  return {values(x), values(y)};
}

std::vector<AffineMap> maps_of_first(const Tensor& x, const Tensor& y) {
  std::vector<AffineMap> maps = maps_between(highest(x), highest(y));
  if (!maps.empty()) return maps;
  const auto [g, h] = forms_in_first(x, y);
  return maps_between(g, h);
}

bool is_multiple(const Tensor& y, const Tensor& x) {
  const CoordinatesPolynomial g = joined(x);
  const CoordinatesPolynomial h = joined(y);
  if (g.size() != h.size() || x[0].size() != y[0].size()) return false;
  const auto k = multiple(h.back(), g.back());
  return k && *k != 0 && std::ranges::equal(h, g, [&](const Coordinates& b, const Coordinates& a) {
           return std::ranges::equal(b, a, [&](const Rational& q, const Rational& p) { return q == *k * p; });
         });
}

/// Those of (A,B) with y = k x(A,B) for which A can be read off without B.
std::optional<ShiftedCopy> copy_by_first(const Tensor& x, const Tensor& y) {
  for (const AffineMap& a : maps_of_first(x, y)) {
    const Tensor moved = transposed(composed(x, a));
    for (const AffineMap& b : maps_between(joined(moved), joined(transposed(y)))) {
      if (is_multiple(transposed(y), composed(moved, b))) return ShiftedCopy{{a, b}};
    }
  }
  return std::nullopt;
}

/// Without the rows and columns of zeros that elevated degrees leave.
Tensor trimmed(Tensor x) {
  for (int turn = 0; turn < 2; ++turn) {
    while (x.size() > 1 && std::ranges::all_of(x.back(), is_null)) x.pop_back();
    x = transposed(x);
  }
  return x;
}

}  // namespace

std::optional<ShiftedCopy> shifted_copy(const RationalPatch& x, const RationalPatch& y) {
  return shifted_copy(net_of(x.reduced()), net_of(y.reduced()));
}

std::optional<ShiftedCopy> shifted_copy(const HomogeneousNet& x, const HomogeneousNet& y) {
  const Tensor of_x = trimmed(tensor(x));
  const Tensor of_y = trimmed(tensor(y));
  if (of_x.size() != of_y.size() || of_x[0].size() != of_y[0].size()) return std::nullopt;
  if (const auto copy = copy_by_first(of_x, of_y)) return copy;
  const auto exchanged = copy_by_first(transposed(of_x), transposed(of_y));
  if (!exchanged) return std::nullopt;
  return ShiftedCopy{{exchanged->maps[1], exchanged->maps[0]}};
}

}  // namespace exsect
