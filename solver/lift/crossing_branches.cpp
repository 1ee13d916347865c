#include "lift/crossing_branches.h"

#include <exsect/algebra/bivariate_factors.h>

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

/// Multiplies the norm of all by that of a branch, and adds it; false if there is none.
bool add_branch(CrossingBranches& branches, const SpacePolynomial& f, const SpacePolynomial& g,
                const BivariatePower& shadow) {
  for (const auto& [first, second] : {std::pair(&f, &g), std::pair(&g, &f)}) {
    CrossingBranch branch = branch_on(*first, *second, shadow, branches.projection.frame.height);
    const std::optional<Polynomial> norm = norm_over(branches.projection, branch.shadow, branch.rate);
    if (!norm) return false;
    if (norm->is_zero()) continue;
    branches.norm *= branch.multiplicity == 1 ? *norm : *norm * *norm;
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
