#include "reduced_net.h"

#include <exsect/algebra/bernstein.h>
#include <exsect/algebra/modular.h>

#include <algorithm>
#include <utility>

namespace exsect {
namespace {

using Residues = std::vector<Residue>;

const PrimeField& field() {
  static const PrimeField result(prime_below(prime_field_limit));
  return result;
}

/// Where one parameter is set, and the factor from one coordinate to the next in their combination: any
/// numbers.
constexpr std::int64_t kPlace = 271828;
constexpr std::int64_t kFactor = 314159;

/// Four numbers a vector, in the order of the net; empty if p divides a denominator.
Residues residues_of(const std::vector<HomogeneousPoint>& net) {
  Residues above, below;
  for (const HomogeneousPoint& p : net)
    for (const Rational& c : p) {
      above.push_back(field().residue(numerator(c)));
      below.push_back(field().residue(denominator(c)));
    }
  if (std::ranges::count(below, field().zero()) != 0) return {};
  invert_all(field(), below);
  for (std::size_t i = 0; i < above.size(); ++i) above[i] = field().multiply(above[i], below[i]);
  return above;
}

/// The value at kPlace, by de Casteljau's algorithm.
Residue value_at_place(Residues row) {
  const Residue t = field().residue(kPlace), rest = field().subtract(field().one(), t);
  for (; row.size() > 1; row.pop_back())
    for (std::size_t i = 0; i + 1 < row.size(); ++i)
      row[i] = field().add(field().multiply(rest, row[i]), field().multiply(t, row[i + 1]));
  return row.front();
}

/// Of the net as it is after its second parameter is set: coefficients of the form sum_i C(m,i) c_i s^(m-i)
/// t^i, s = 1 - u, t = u. No common zero: neither with s + t = 0, where the degree would be less than m, nor
/// with another ratio, which is that of a common factor.
bool has_no_common_zero(const std::vector<std::array<Residue, 4>>& row) {
  Residues weight, others;
  const int m = static_cast<int>(row.size()) - 1;
  for (int i = 0; i <= m; ++i) {
    const std::array<Residue, 4>& c = row[static_cast<std::size_t>(i)];
    const Residue times = field().residue(binomial(m, i));
    weight.push_back(field().multiply(times, c[3]));
    others.push_back(field().multiply(times, evaluate(field(), {c.data(), 3}, field().residue(kFactor))));
  }
  return resultant(field(), std::move(weight), std::move(others)) != 0;
}

}  // namespace

bool is_surely_reduced(const std::vector<HomogeneousPoint>& net, int m, int n) {
  const bool equal =
      std::ranges::all_of(net, [&](const HomogeneousPoint& p) { return p[3] == net.front()[3]; });
  if (equal && net.front()[3] != 1) return false;
  const Residues all = residues_of(net);
  if (all.empty()) return false;
  const std::size_t rows = static_cast<std::size_t>(m) + 1, columns = static_cast<std::size_t>(n) + 1;
  const auto one_by_one = [&](std::size_t count, std::size_t step, std::size_t others, std::size_t across) {
    std::vector<std::array<Residue, 4>> row(count);
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t k = 0; k < 4; ++k) {
        Residues line;
        for (std::size_t j = 0; j < others; ++j) line.push_back(all[4 * (i * step + j * across) + k]);
        row[i][k] = value_at_place(std::move(line));
      }
    return has_no_common_zero(row);
  };
  return one_by_one(rows, columns, columns, 1) && one_by_one(columns, 1, rows, columns);
}

}  // namespace exsect
