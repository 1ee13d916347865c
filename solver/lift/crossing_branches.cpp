#include "lift/crossing_branches.h"

#include <exsect/algebra/bivariate_factors.h>
#include <exsect/algebra/sturm.h>

#include <algorithm>
#include <utility>

namespace exsect {
namespace {

/// With F restricted to G = 0 where the latter is smooth along the branch: (17.18).
CrossingBranch branch_on(const SpacePolynomial& f, const SpacePolynomial& g, BivariatePower shadow,
                         const Point& height) {
  SpacePolynomial derived = f;
  for (int i = 1; i < shadow.multiplicity; ++i) derived = turning_form(derived, g, height).primitive();
  SpacePolynomial rate = turning_form(derived, g, height);
  return {std::move(shadow.factor), shadow.multiplicity, std::move(derived), g, std::move(rate)};
}

/// Whether all real zeros of f are zeros of g. Requires f and g other than 0.
bool has_real_zeros_of(Polynomial f, const Polynomial& g) {
  for (Polynomial common = gcd(f, g); common.degree() > 0; common = gcd(f, g)) f = exact_quotient(f, common);
  return SturmSequence(f).count_all() == 0;
}

/// A polynomial of least degree that crosses G along the branch where F does, which has this norm, in the
/// place of F. What F is beside G = 0, of no matter for the curve, grows with its degree.
void simplify(CrossingBranch& branch, const SpaceProjection& projection, const Polynomial& norm) {
  constexpr int greatest_degree = 3;
  for (int degree = 1; degree < branch.f.degree() && degree <= greatest_degree; ++degree)
    for (SpacePolynomial& form : forms_through(projection, branch.shadow, degree)) {
      SpacePolynomial rate = turning_form(form, branch.g, projection.frame.height);
      if (rate.is_zero()) continue;
      const Polynomial other = norm_over(projection, branch.shadow, rate).value();
      if (other.is_zero() || !has_real_zeros_of(other, norm)) continue;
      branch.f = std::move(form);
      branch.rate = std::move(rate);
      return;
    }
}

/// Multiplies the norm of all by that of a branch, and adds it; false if there is none.
bool add_branch(CrossingBranches& branches, const SpacePolynomial& f, const SpacePolynomial& g,
                const BivariatePower& shadow) {
  for (const auto& [first, second] : {std::pair(&f, &g), std::pair(&g, &f)}) {
    CrossingBranch branch = branch_on(*first, *second, shadow, branches.projection.frame.height);
    const std::optional<Polynomial> norm = norm_over(branches.projection, branch.shadow, branch.rate);
    if (!norm) return false;
    if (norm->is_zero()) continue;
    branches.norm *= branch.multiplicity == 1 ? *norm : *norm * *norm;
    if (branch.multiplicity > 1) simplify(branch, branches.projection, *norm);
    branches.all.push_back(std::move(branch));
    return true;
  }
  return false;
}

}  // namespace

std::optional<CrossingBranches> crossing_branches(const SpacePolynomial& f, const SpacePolynomial& g,
                                                  const SpaceProjection& projection) {
  CrossingBranches branches{projection, {}, 1};
  std::vector<BivariatePower> shadows = irreducible_factors(projection.shadow);
  if (std::ranges::all_of(shadows, [](const BivariatePower& each) { return each.multiplicity == 1; })) {
    for (BivariatePower& shadow : shadows)
      branches.all.push_back(branch_on(f, g, std::move(shadow), projection.frame.height));
    branches.norm = turning_norm(projection);
    return branches;
  }
  branches.projection.shadow = BivariatePolynomial::constant(1);
  for (const BivariatePower& shadow : shadows) {
    if (!add_branch(branches, f, g, shadow)) return std::nullopt;
    branches.projection.shadow = branches.projection.shadow * shadow.factor;
  }
  return branches;
}

}  // namespace exsect
