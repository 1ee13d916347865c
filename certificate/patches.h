// Two patches of any kind, and F, as certificates speak of them.
#pragma once

#include <exsect/checker/map.h>
#include <exsect/geometry/rational_patch.h>
#include <exsect/geometry/space_polynomial.h>

#include <array>
#include <stdexcept>

namespace exsect::cli {

/// There is no certificate for this result; what() names the event that has none.
class NoCertificate : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

using Patches = std::array<RationalPatch, 2>;
using ExactMap = checker::Map<Rational>;
using Place = checker::Vector4<Rational>;  // of four parameters, exactly
using Direction = checker::Vector4<Rational>;

/// The same map of the same parameters: of bidegree (2,2), if it can have this bidegree, otherwise reduced,
/// unless control points would be at infinity. Throws NoCertificate if there are some in the patch itself.
RationalPatch certified_form(const RationalPatch& patch);

/// Control points of the patch in its bidegree, times their weights, and the coefficients of u^i v^j. Weights
/// only if the patch is not polynomial.
checker::WeightedNet<Rational> control_net(const RationalPatch& patch);
checker::WeightedNet<Rational> power_basis(const RationalPatch& patch);

/// F = w_y X - w_x Y.
ExactMap equation_of(const Patches& patches);
/// F = (w_x^d f(x(u,v)), r - 1/2, s - 1/2), d the degree of f.
ExactMap equation_of(const SpacePolynomial& f, const RationalPatch& x);
/// F = 0 at the place, in [0,1]^4 or not.
bool is_solution(const ExactMap& equation, const Place& w);

}  // namespace exsect::cli
