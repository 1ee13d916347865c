#include "certificate/patches.h"

#include "certificate/search.h"

namespace exsect::cli {

RationalPatch certified_form(const RationalPatch& patch) {
  if (!patch.is_polynomial()) throw NoCertificate("a patch with weights");
  const auto biquadratic = patch.biquadratic();
  return biquadratic ? RationalPatch(*biquadratic) : patch.reduced();
}

checker::Net<Rational> control_net(const RationalPatch& patch) {
  checker::Net<Rational> net(static_cast<std::size_t>(patch.degree_u()),
                             static_cast<std::size_t>(patch.degree_v()));
  net.each([&](std::size_t i, std::size_t j) {
    net[i][j] = patch.point(static_cast<int>(i), static_cast<int>(j));
  });
  return net;
}

checker::Net<Rational> power_basis(const RationalPatch& patch) {
  checker::Net<Rational> net = control_net(patch);
  net.to_powers();
  return net;
}

ExactMap equation_of(const Patches& patches) {
  return checker::pair_map(power_basis(patches[0]), power_basis(patches[1]));
}

bool is_solution(const Patches& patches, const Place& w) {
  return patches[0](w[0], w[1]) == patches[1](w[2], w[3]);
}

}  // namespace exsect::cli
