#include "certificate/patches.h"

#include <exsect/checker/section.h>

namespace exsect::cli {

namespace {

bool is_finite(const RationalPatch& patch) {
  for (int i = 0; i <= patch.degree_u(); ++i)
    for (int j = 0; j <= patch.degree_v(); ++j)
      if (const HomogeneousPoint& p = patch.homogeneous(i, j); p[3] == 0 && p != HomogeneousPoint{})
        return false;
  return true;
}

}  // namespace

RationalPatch certified_form(const RationalPatch& patch) {
  if (const auto biquadratic = patch.biquadratic()) return *biquadratic;
  if (is_finite(patch.reduced())) return patch.reduced();
  if (!is_finite(patch)) throw NoCertificate("a control point at infinity");
  return patch;
}

checker::WeightedNet<Rational> control_net(const RationalPatch& patch) {
  checker::WeightedNet<Rational> net;
  const auto m = static_cast<std::size_t>(patch.degree_u());
  const auto n = static_cast<std::size_t>(patch.degree_v());
  net.points = checker::Net<Rational>(m, n);
  if (!patch.is_polynomial()) net.weights = checker::Grid<Rational, 1>(m, n);
  net.points.each([&](std::size_t i, std::size_t j) {
    const HomogeneousPoint& p = patch.homogeneous(static_cast<int>(i), static_cast<int>(j));
    net.points[i][j] = {p[0], p[1], p[2]};
    if (net.has_weights()) net.weights[i][j][0] = p[3];
  });
  return net;
}

checker::WeightedNet<Rational> power_basis(const RationalPatch& patch) {
  checker::WeightedNet<Rational> net = control_net(patch);
  net.to_powers();
  return net;
}

ExactMap equation_of(const Patches& patches) {
  return checker::pair_map(power_basis(patches[0]), power_basis(patches[1]));
}

ExactMap equation_of(const SpacePolynomial& f, const RationalPatch& x) {
  return checker::section_map(checker::Section(f.terms(), power_basis(x)).polynomial());
}

bool is_solution(const ExactMap& equation, const Place& w) {
  return equation.value(w) == checker::Vector3<Rational>{};
}

}  // namespace exsect::cli
