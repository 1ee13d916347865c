#include "filter/section_forms.h"

#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace exsect {
namespace {

/// Of the equation, of coordinates, and of the exponent of its largest coefficient as it is given: so what
/// underflow loses of the section is below kSectionLoss.
constexpr double kLargestCoordinate = 0x1p64;
constexpr std::size_t kMostDegree = 4;
constexpr int kMostTermExponent = 500;
constexpr double kSectionLoss = 0x1p-300;
constexpr double kLeastSection = 0x1p-200;

double bernstein_factor(int n, int i) {
  double result = 1;
  for (int k = 1; k <= i; ++k) result = result * (n - k + 1) / k;
  return result;
}

/// The coefficients of binom(n,i) (1 + p)^i (1 - p)^(n-i) / 2^n, exact for n <= 3; the sum of their absolute
/// values is at most bernstein_factor(n,i).
std::array<double, max_patch_degree + 1> bernstein_in_p(int n, int i) {
  std::array<double, max_patch_degree + 1> c{std::ldexp(bernstein_factor(n, i), -n)};
  for (int k = 0; k < n; ++k)
    for (std::size_t at = static_cast<std::size_t>(n); at > 0; --at) c[at] += k < i ? c[at - 1] : -c[at - 1];
  return c;
}

/// A polynomial, and a bound of the sum of all differences of its coefficients from the true ones.
struct RoundedTable {
  FormTable table;
  double error;
};

double size_of(const FormTable& f) {
  double sum = 0;
  for (std::size_t i = 0; i <= f.m(); ++i)
    for (std::size_t j = 0; j <= f.n(); ++j) sum += std::fabs(f(i, j));
  return sum * kSlack;
}

/// X_(k+1). Every term is rounded 11 times at most.
RoundedTable coordinate_table(const RationalPatch& x, std::size_t k) {
  const int m = x.degree_u(), n = x.degree_v();
  RoundedTable result{{static_cast<std::size_t>(m), static_cast<std::size_t>(n)}, 0};
  for (int j = 0; j <= n; ++j) {
    std::array<double, max_patch_degree + 1> in_p{};
    for (int i = 0; i <= m; ++i) {
      const double c = to_double(x.homogeneous(i, j)[k]);
      const auto row = bernstein_in_p(m, i);
      for (std::size_t a = 0; a < row.size(); ++a) in_p[a] += c * row[a];
      result.error += std::fabs(c) * bernstein_factor(m, i) * bernstein_factor(n, j);
    }
    const auto column = bernstein_in_p(n, j);
    for (std::size_t a = 0; a <= result.table.m(); ++a)
      for (std::size_t b = 0; b <= result.table.n(); ++b) result.table(a, b) += in_p[a] * column[b];
  }
  result.error = 12 * kUnitRoundoff * result.error * kSlack + kUnderflowLoss;
  return result;
}

FormTable constant_table(double c) {
  FormTable result(0, 0);
  result(0, 0) = c;
  return result;
}

/// Requires degrees that are at most FormTable::most together.
FormTable product_of(const FormTable& a, const FormTable& b) {
  FormTable result(a.m() + b.m(), a.n() + b.n());
  for (std::size_t i = 0; i <= b.m(); ++i)
    for (std::size_t j = 0; j <= b.n(); ++j)
      for (std::size_t k = 0; k <= a.m(); ++k)
        for (std::size_t l = 0; l <= a.n(); ++l) result(i + k, j + l) += a(k, l) * b(i, j);
  return result;
}

FormTable sum_of(const FormTable& a, const FormTable& b) {
  FormTable result(std::max(a.m(), b.m()), std::max(a.n(), b.n()));
  for (const FormTable* f : {&a, &b})
    for (std::size_t i = 0; i <= f->m(); ++i)
      for (std::size_t j = 0; j <= f->n(); ++j) result(i, j) += (*f)(i, j);
  return result;
}

/// An equation F of the degree e in doubles, the largest coefficient in [1/2, 1), on X, by Horner's scheme in
/// x, in y and in z.
class Composition {
 public:
  using Terms = std::map<Exponents, double>;

  Composition(Terms terms, std::size_t degree, const std::array<RoundedTable, 4>& x)
      : terms_(std::move(terms)), x_(x) {
    powers_.push_back(constant_table(1));
    const bool is_one = x[3].table.m() == 0 && x[3].table.n() == 0 && x[3].table(0, 0) == 1;
    for (std::size_t k = 0; k < degree; ++k)
      powers_.push_back(is_one ? powers_.back() : product_of(powers_.back(), x[3].table));
  }

  FormTable run() const { return in(0, {0, 0, 0}); }

  /// A bound of the sum of all differences of coefficients (17.50).
  double error() const {
    const double e = static_cast<double>(powers_.size() - 1);
    const double rounding = (20 * e + 4) * kUnitRoundoff;
    double sum = 0;
    for (const auto& [exponents, c] : terms_) {
      const std::array<int, 4> all = {exponents[0], exponents[1], exponents[2], left_of(exponents)};
      std::array<double, 4> size;
      for (std::size_t k = 0; k < 4; ++k) size[k] = size_of(x_[k].table) + x_[k].error;
      const auto term = [&](std::size_t but) {
        double product = std::fabs(c);
        for (std::size_t k = 0; k < 4; ++k)
          for (int i = k == but ? 1 : 0; i < all[k]; ++i) product *= size[k];
        return product;
      };
      sum += rounding * term(4);
      for (std::size_t k = 0; k < 4; ++k)
        if (all[k] > 0) sum += all[k] * term(k) * x_[k].error;
    }
    return sum * kSlack + kSectionLoss;
  }

 private:
  int left_of(const Exponents& e) const { return static_cast<int>(powers_.size()) - 1 - e[0] - e[1] - e[2]; }

  /// What the coordinates from `axis` on do to those terms whose exponents before are these.
  FormTable in(std::size_t axis, Exponents exponents) const {
    if (axis == 3) {
      const auto term = terms_.find(exponents);
      return term == terms_.end() ? constant_table(0)
                                  : product_of(powers_[static_cast<std::size_t>(left_of(exponents))],
                                               constant_table(term->second));
    }
    const int most = left_of(exponents);
    FormTable sum = constant_table(0);
    for (int power = most; power >= 0; --power) {
      exponents[axis] = power;
      if (power < most && !is_zero(sum)) sum = product_of(sum, x_[axis].table);
      sum = sum_of(sum, in(axis + 1, exponents));
    }
    return sum;
  }

  static bool is_zero(const FormTable& f) { return f.m() == 0 && f.n() == 0 && f(0, 0) == 0; }

  Terms terms_;
  const std::array<RoundedTable, 4>& x_;
  std::vector<FormTable> powers_;  // of X_4
};

/// The coefficients over a power of two; empty where they are out of range.
std::optional<Composition::Terms> rounded_terms(const SpacePolynomial& f) {
  Composition::Terms terms;
  int exponent = -kMostTermExponent - 1;
  for (const auto& [exponents, c] : f.terms()) {
    const double rounded = to_double(c);
    if (!std::isfinite(rounded)) return std::nullopt;
    exponent = std::max(exponent, std::ilogb(rounded));
    terms.emplace(exponents, rounded);
  }
  if (std::abs(exponent) > kMostTermExponent) return std::nullopt;
  for (auto& [exponents, c] : terms) c = std::ldexp(c, -exponent - 1);
  return terms;
}

}  // namespace

std::optional<SectionForms> section_forms(const SpacePolynomial& equation, const RationalPatch& reduced) {
  const std::size_t degree = static_cast<std::size_t>(std::max(equation.degree(), 0));
  const std::size_t most = static_cast<std::size_t>(std::max(reduced.degree_u(), reduced.degree_v()));
  auto terms = rounded_terms(equation);
  if (!terms || degree > kMostDegree || degree * most > FormTable::most) return std::nullopt;
  std::array<RoundedTable, 4> x;
  for (std::size_t k = 0; k < 3; ++k) x[k] = coordinate_table(reduced, k);
  const bool has_no_weights = reduced.is_polynomial() && reduced.weight(0, 0) == 1;
  x[3] = has_no_weights ? RoundedTable{constant_table(1), 0} : coordinate_table(reduced, 3);
  for (const RoundedTable& f : x)
    if (!(size_of(f.table) + f.error < kLargestCoordinate)) return std::nullopt;
  const Composition composition(*std::move(terms), degree, x);
  const FormTable section = composition.run();
  const double error = composition.error();
  if (!(size_of(section) > kLeastSection)) return std::nullopt;
  SectionForms forms{SquareForm(section, error), {}, has_no_weights};
  for (std::size_t k = 0; k < 4; ++k) forms.patch[k] = SquareForm(x[k].table, x[k].error);
  return forms;
}

}  // namespace exsect
