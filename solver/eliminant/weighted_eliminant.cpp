#include "eliminant/weighted_eliminant.h"

#include <exsect/algebra/enclosed_roots.h>
#include <exsect/algebra/fixed_point_interval.h>
#include <exsect/algebra/nearest_rounding.h>
#include <exsect/algebra/real_algebraic.h>

#include <algorithm>
#include <array>
#include <functional>
#include <utility>

#include "eliminant/ball_eliminant.h"
#include "eliminant/coordinate_bits.h"
#include "eliminant/special_eliminant.h"
#include "eliminant/stripped_eliminant.h"
#include "eliminant/turning_eliminant_modular.h"
#include "eliminant/vector_eliminant.h"
#include "eliminant/weighted_eliminant_height.h"
#include "eliminant/weighted_pair.h"

namespace exsect {

namespace {

/// As of polynomial patches.
constexpr std::size_t kMostBits = std::size_t{1} << 19;
/// The slack of the height bound and what is lost by cancellation from powers to the Bernstein basis grow
/// with the degree.
std::size_t bits_kept(std::size_t degree) { return 512 + 8 * degree; }

/// The bits for which values in balls and values modulo primes take about the same time.
constexpr std::size_t kLongBits = 6000;

std::size_t expected_bits(const WeightedPair& pair) {
  return coordinate_bits(pair) * by_kind(pair, [](const auto& kind) { return kind.coordinate_degree; });
}

/// The same pair with r and s exchanged.
WeightedPair with_second_transposed(const WeightedPair& pair) {
  WeightedPair result = pair;
  for (std::size_t i = 0; i < pair.y.size(); ++i)
    for (std::size_t j = 0; j < pair.y.size(); ++j) result.y[i][j] = pair.y[j][i];
  return result;
}

/// Where lines of y are points. Of y of one degree in both parameters these may be lines of r or of s.
std::optional<ModularIntegers> without_point_lines(const WeightedPair& pair) {
  if (auto residues = stripped_eliminant(pair, eliminant_height_bound(pair))) return residues;
  if (pair.y.size() != pair.y.front().size()) return std::nullopt;
  const WeightedPair transposed = with_second_transposed(pair);
  return stripped_eliminant(transposed, eliminant_height_bound(transposed));
}

/// Empty where E is not defined.
std::optional<ModularIntegers> modulo_primes(const WeightedPair& pair) {
  return by_kind(pair, [&]<class Kind>(Kind) -> std::optional<ModularIntegers> {
    using Eliminant = WeightedModularEliminant<Kind>;
    if (expected_bits(pair) > kMostBits) return std::nullopt;
    if (!is_generic<Eliminant>(pair)) return without_point_lines(pair);
    const std::size_t bits = eliminant_height_bound(pair);
    if (auto by_vectors = vector_eliminant(pair, bits)) return by_vectors;
    return interpolate_modular_polynomial(Kind::degree(pair.x.size() - 1), bits,
                                          [&](const PrimeField& field, Residue first, std::size_t count) {
                                            return Eliminant(field, pair).values(first, count);
                                          });
  });
}

Polynomial eliminant_of(const ModularIntegers& residues) {
  return primitive_with_positive_lead(polynomial_of(chinese_remainder(residues)));
}

/// Bits of the places of exact roots.
constexpr int kRefined = 60;

/// With the multiplicities of the factors (Yun) as orders.
std::vector<EliminantRoot> exact_roots(const Polynomial& e) {
  std::vector<std::pair<RealAlgebraic, int>> values;
  for (const auto& [factor, multiplicity] : squarefree_factors(e))
    for (const RealAlgebraic& root : real_roots(factor, 0, 1))
      if (root.compare(0) > 0 && root.compare(1) < 0) values.emplace_back(root, multiplicity);
  std::ranges::sort(values);
  std::vector<EliminantRoot> roots;
  for (const auto& [value, multiplicity] : values)
    roots.push_back({value.refined_to(power_of_two(-kRefined)).interval(), multiplicity});
  return roots;
}

/// The pair with its parameters exchanged so that the sweep is along u, of a Kind.
WeightedPair swept_pair(const RationalPatch& x, const RationalPatch& y, Parameter sweep) {
  const bool of_x = sweep == Parameter::u || sweep == Parameter::v;
  const bool second = sweep == Parameter::v || sweep == Parameter::s;
  const RationalPatch& swept = (of_x ? x : y).reduced();
  const RationalPatch& other = (of_x ? y : x).reduced();
  return weighted_pair(second ? swept.transposed() : swept,
                       other.degree_u() > other.degree_v() ? other.transposed() : other);
}

}  // namespace

std::vector<Parameter> eliminant_sweeps(const RationalPatch& x, const RationalPatch& y) {
  const RationalPatch& first = x.reduced();
  const RationalPatch& second = y.reduced();
  const std::array<int, 4> degrees = {first.degree_u(), first.degree_v(), second.degree_u(),
                                      second.degree_v()};
  const bool all_conics = std::ranges::all_of(degrees, [](int degree) { return degree == 2; });
  std::vector<Parameter> sweeps;
  for (const Parameter p : all_parameters)
    if (all_conics || degrees[index(p) ^ 1] == 1) sweeps.push_back(p);
  // (16.17) is greater where the swept parameter is of lower degree, the product of all four being the same.
  std::ranges::stable_sort(sweeps, std::greater(), [&](Parameter p) { return degrees[index(p)]; });
  return sweeps;
}

std::optional<Polynomial> weighted_eliminant(const RationalPatch& x, const RationalPatch& y,
                                             Parameter sweep) {
  return in_nearest_rounding([&]() -> std::optional<Polynomial> {
    const auto residues = modulo_primes(swept_pair(x, y, sweep));
    if (!residues) return std::nullopt;
    return eliminant_of(*residues);
  });
}

std::optional<std::vector<EliminantRoot>> weighted_turning_roots(const RationalPatch& x,
                                                                 const RationalPatch& y, Parameter sweep) {
  return in_nearest_rounding([&]() -> std::optional<std::vector<EliminantRoot>> {
    const WeightedPair pair = swept_pair(x, y, sweep);
    if (expected_bits(pair) > kLongBits) {
      if (const auto roots = turning_roots_in_balls(pair)) return simple_roots(*roots);
    }
    const auto residues = modulo_primes(pair);
    if (!residues) return std::nullopt;
    LeadingParts parts = leading_parts(*residues, bits_kept(residues->residues.front().size()));
    const auto roots = isolate_enclosed_roots({std::move(parts.leading), std::move(parts.error)});
    return roots ? simple_roots(*roots) : exact_roots(eliminant_of(*residues));
  });
}

}  // namespace exsect
