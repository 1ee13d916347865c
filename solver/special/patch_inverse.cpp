#include "special/patch_inverse.h"

#include <exsect/algebra/rational_matrix.h>

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "curve/half_space.h"

namespace exsect {
namespace {

using Relation = std::vector<Integer>;
using Functions = std::vector<BivariatePolynomial>;

constexpr int kMostDegree = 4;  // of the equation

/// The monomials of one degree on a patch of which the others are combinations.
struct FormBasis {
  int degree;
  std::size_t size;  // of all monomials
  std::vector<std::size_t> positions;
  Functions functions;

  SpaceForm form(const std::vector<Rational>& coefficients) const {
    SpaceForm result{degree, std::vector<Rational>(size)};
    for (std::size_t i = 0; i < positions.size(); ++i) result.coefficients[positions[i]] = coefficients[i];
    return result;
  }
};

/// Those are left out that come last in a relation; empty if these are not different ones.
std::optional<FormBasis> form_basis(const VectorPolynomial& y, int degree) {
  const Functions all = monomials(y, degree);
  const std::vector<Relation> known = relations(all);
  std::set<std::size_t> last;
  for (const Relation& relation : known) {
    std::size_t i = relation.size() - 1;
    while (relation[i] == 0) --i;
    last.insert(i);
  }
  if (last.size() != known.size()) return std::nullopt;
  FormBasis result{degree, all.size(), {}, {}};
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (last.contains(i)) continue;
    result.positions.push_back(i);
    result.functions.push_back(all[i]);
  }
  return result;
}

/// With bound unknown yet.
struct Candidate {
  SpaceForm numerator;
  SpaceForm denominator;
};

/// Bernstein coefficients of the denominators, and of the power of the weight.
struct DenominatorSigns {
  DenominatorSigns(const VectorPolynomial& y, int degree) : y_(y), degree_(degree) {
    for (const BivariatePolynomial& f : y) {
      m_ = std::max(m_, degree * f.degree_r() + 2);
      n_ = std::max(n_, degree * f.degree_s() + 2);
    }
    SpaceForm weight{degree, std::vector<Rational>(monomials(y, degree).size())};
    weight.coefficients.back() = 1;
    weights_ = values(weight);
  }

  std::vector<Rational> values(const SpaceForm& form) const {
    return bernstein_values(on_patch(form, y_), m_, n_);
  }

  /// What half of the least quotient shows, or 0 for values that are not negative alone.
  std::optional<Rational> bound(const std::vector<Rational>& denominators) const {
    if (std::ranges::any_of(denominators, [](const Rational& d) { return d < 0; })) return std::nullopt;
    if (std::ranges::any_of(denominators, [](const Rational& d) { return d == 0; })) return Rational(0);
    std::optional<Rational> least;
    for (std::size_t i = 0; i < weights_.size(); ++i)
      if (weights_[i] > 0 && (!least || denominators[i] < *least * weights_[i]))
        least = denominators[i] / weights_[i];
    return least ? Rational(*least / 2) : Rational(0);
  }

 private:
  const VectorPolynomial& y_;
  int degree_;
  int m_ = 0, n_ = 0;
  std::vector<Rational> weights_;
};

/// Combinations of three relations at most to be tried: each alone, with both signs, and all together so that
/// the denominators, divided by their greatest values, are positive.
std::vector<Point> combinations(const std::vector<std::vector<Rational>>& denominators) {
  const std::size_t count = denominators.front().size();
  std::vector<Point> result;
  std::vector<std::array<double, 3>> vectors(count);
  Point scale = {1, 1, 1};
  for (std::size_t k = 0; k < denominators.size(); ++k) {
    Rational greatest = 0;
    for (const Rational& d : denominators[k]) greatest = std::max<Rational>(greatest, abs(d));
    if (greatest == 0) continue;
    scale[k] = 1 / greatest;
    for (std::size_t i = 0; i < count; ++i) vectors[i][k] = to_double(denominators[k][i] * scale[k]);
    for (const int sign : {1, -1}) {
      Point alone = {0, 0, 0};
      alone[k] = sign;
      result.push_back(alone);
    }
  }
  if (const auto n = positive_direction(vectors))
    result.push_back({(*n)[0] * scale[0], (*n)[1] * scale[1], (*n)[2] * scale[2]});
  return result;
}

/// Of the forms, the combinations with a denominator that is positive if there is one, else not negative and
/// 0 in as few places as possible: at an apex, but not along one of its rulings.
std::optional<ParameterQuotient> best_combination(const VectorPolynomial& y,
                                                  const std::vector<Candidate>& candidates) {
  const int degree = candidates.front().denominator.degree;
  const DenominatorSigns signs(y, degree);
  std::vector<std::vector<Rational>> denominators;
  for (const Candidate& candidate : candidates) denominators.push_back(signs.values(candidate.denominator));
  std::optional<ParameterQuotient> best;
  std::ptrdiff_t most_positive = 0;
  for (const Point& combined : combinations(denominators)) {
    const std::size_t size = candidates.front().numerator.coefficients.size();
    SpaceForm numerator{degree, std::vector<Rational>(size)}, denominator = numerator;
    for (std::size_t k = 0; k < candidates.size(); ++k)
      for (std::size_t c = 0; c < size; ++c) {
        numerator.coefficients[c] += combined[k] * candidates[k].numerator.coefficients[c];
        denominator.coefficients[c] += combined[k] * candidates[k].denominator.coefficients[c];
      }
    const std::vector<Rational> values = signs.values(denominator);
    const auto bound = signs.bound(values);
    const auto positive = std::ranges::count_if(values, [](const Rational& d) { return d > 0; });
    if (bound && (!best || *bound > best->bound || positive > most_positive)) {
      best = {numerator, denominator, *bound, {}};
      most_positive = positive;
    }
    if (best && best->bound > 0) break;
  }
  return best;
}

/// (17.23) for w = p and forms of this degree, with the parameter p as a polynomial.
std::optional<ParameterQuotient> linear_quotient(const VectorPolynomial& y, const BivariatePolynomial& p,
                                                 int degree) {
  const auto basis = form_basis(y, degree);
  if (!basis) return std::nullopt;
  Functions functions = basis->functions;
  for (const BivariatePolynomial& f : basis->functions)
    functions.push_back(BivariatePolynomial::constant(-1) * p * f);
  const std::vector<Relation> known = relations(functions);
  if (known.empty() || known.size() > 3) return std::nullopt;
  std::vector<Candidate> candidates;
  for (const Relation& relation : known) {
    const auto middle = relation.begin() + static_cast<std::ptrdiff_t>(basis->functions.size());
    candidates.push_back({basis->form({relation.begin(), middle}), basis->form({middle, relation.end()})});
  }
  return best_combination(y, candidates);
}

/// The relation c + b p + a p^2 = 0 of linear forms, if there is one alone.
std::optional<std::array<SpaceForm, 3>> quadratic_relation(const VectorPolynomial& y,
                                                           const BivariatePolynomial& p) {
  const auto basis = form_basis(y, 1);
  if (!basis) return std::nullopt;
  Functions functions;
  for (const BivariatePolynomial& power : {BivariatePolynomial::constant(1), p, p * p})
    for (const BivariatePolynomial& f : basis->functions) functions.push_back(power * f);
  const std::vector<Relation> known = relations(functions);
  if (known.size() != 1) return std::nullopt;
  std::array<SpaceForm, 3> result;
  auto from = known.front().begin();
  for (SpaceForm& form : result) {
    const auto to = from + static_cast<std::ptrdiff_t>(basis->functions.size());
    form = basis->form({from, to});
    from = to;
  }
  return result;
}

/// (17.23) for planes of a pencil and a quadratic map (17.24): the relation is the planes of p = 0 and p = 1
/// times a and b.
std::optional<ParameterQuotient> pencil_quotient(const VectorPolynomial& y, const BivariatePolynomial& p) {
  const auto relation = quadratic_relation(y, p);
  if (!relation) return std::nullopt;
  const auto& [c, b, a] = *relation;
  SpaceForm rest = c, denominator = c;
  RationalMatrix planes(4, 3);
  for (std::size_t k = 0; k < 4; ++k) {
    rest.coefficients[k] += b.coefficients[k] + a.coefficients[k];
    denominator.coefficients[k] -= rest.coefficients[k];
    planes(k, 0) = rest.coefficients[k];
    planes(k, 1) = c.coefficients[k];
    planes(k, 2) = a.coefficients[k];
  }
  const std::vector<Relation> pencil = null_space(planes);
  if (pencil.size() != 1 || pencil.front()[2] == 0) return std::nullopt;
  const Rational scale(pencil.front()[2]);
  const UnitMap map{pencil.front()[1] / scale, pencil.front()[0] / scale};
  if (map.start < -1 || map.end < -1) return std::nullopt;
  auto result = best_combination(y, {{c, denominator}});
  if (result) result->map = map;
  return result;
}

/// The first one alone if it is there, as nothing more has to be asked of it.
std::vector<ParameterQuotient> quotients(const VectorPolynomial& y, const BivariatePolynomial& p) {
  if (const auto linear = linear_quotient(y, p, 1)) return {*linear};
  std::vector<ParameterQuotient> result;
  if (const auto pencil = pencil_quotient(y, p)) result.push_back(*pencil);
  if (const auto quadratic = linear_quotient(y, p, 2)) result.push_back(*quadratic);
  return result;
}

VectorPolynomial exchanged(const VectorPolynomial& y) {
  return {y[0].exchanged(), y[1].exchanged(), y[2].exchanged(), y[3].exchanged()};
}

bool are_parallel(const VectorPolynomial& y, const VectorPolynomial& z) {
  for (std::size_t i = 0; i < y.size(); ++i)
    for (std::size_t j = i + 1; j < y.size(); ++j)
      if (!(y[i] * z[j] == y[j] * z[i])) return false;
  return true;
}

bool is_definite(const BivariatePolynomial& f) {
  const std::vector<Rational> values = bernstein_values(f);
  return std::ranges::all_of(values, [&](const Rational& c) { return sign(c) == sign(values[0]) && c != 0; });
}

/// A denominator is not positive at points z of the surface, of positive weight; and z is never 0.
bool is_excluded(const VectorPolynomial& z, const std::array<const ParameterQuotient*, 2>& of) {
  return is_definite(z[3]) && std::ranges::any_of(of, [&](const ParameterQuotient* q) {
           BivariatePolynomial value = on_patch(q->denominator, z);
           if (q->denominator.degree % 2 == 1) value = value * z[3];
           return std::ranges::all_of(bernstein_values(value), [](const Rational& c) { return c <= 0; });
         });
}

/// (17.26): what Lemma 17.15 asks of the parameters with the same w.
bool are_told_apart(const VectorPolynomial& y, const ParameterQuotient& of_r, const ParameterQuotient& of_s) {
  const bool r = !of_r.map.is_identity(), s = !of_s.map.is_identity();
  const auto in_r = [&](const VectorPolynomial& z) { return at_conjugate(conjugation(of_r.map), z); };
  const auto in_s = [&](const VectorPolynomial& z) {
    return exchanged(at_conjugate(conjugation(of_s.map), exchanged(z)));
  };
  const std::array of = {&of_r, &of_s};
  if ((r && !is_excluded(in_r(y), of)) || (s && !is_excluded(in_s(y), of))) return false;
  if (!r || !s) return true;
  const VectorPolynomial both = in_r(in_s(y));
  return is_definite(both[3]) && (are_parallel(y, both) || is_excluded(both, of));
}

/// The equation of the surface, if it is of degree 4 at most.
std::optional<SpaceForm> equation(const VectorPolynomial& y) {
  for (int degree = 1; degree <= kMostDegree; ++degree) {
    const std::vector<Relation> known = relations(monomials(y, degree));
    if (known.empty()) continue;
    if (known.size() > 1) return std::nullopt;
    return SpaceForm{degree, {known.front().begin(), known.front().end()}};
  }
  return std::nullopt;
}

}  // namespace

std::optional<PatchInverse> patch_inverse(const RationalPatch& patch) {
  const VectorPolynomial y = components(patch.reduced());
  const std::vector<ParameterQuotient> of_r = quotients(y, BivariatePolynomial::r());
  if (of_r.empty()) return std::nullopt;
  for (const ParameterQuotient& of_s : quotients(y, BivariatePolynomial::s()))
    for (const ParameterQuotient& r : of_r)
      if (are_told_apart(y, r, of_s)) {
        const auto known = equation(y);
        return known ? std::optional(PatchInverse{*known, {r, of_s}}) : std::nullopt;
      }
  return std::nullopt;
}

}  // namespace exsect
