#include "verify.h"

#include <exsect/algebra/nearest_rounding.h>
#include <exsect/solver/intersect.h>

#include <array>
#include <cmath>
#include <stdexcept>

#include "answer/model_scale.h"
#include "verifier.h"

namespace exsect {

Verdict verify(const Candidate& candidate, const BezierPatch& x, const BezierPatch& y,
               const IntersectResult& exact, double tolerance) {
  return in_nearest_rounding([&] {
    if (!(tolerance > 0) || !std::isfinite(tolerance))
      throw std::invalid_argument("the tolerance must be positive and finite");
    return Verifier(candidate, x, y, exact, tolerance)();
  });
}

Verification verify(const Candidate& candidate, const BezierPatch& x, const BezierPatch& y,
                    const VerifyOptions& options) {
  return in_nearest_rounding([&]() -> Verification {
    if (!(options.tolerance > 0) || !std::isfinite(options.tolerance))
      throw std::invalid_argument("the tolerance must be positive and finite");
    const double extent = model_scale(x, y).extent;
    const double tolerance = options.tolerance * (extent > 0 ? extent : 1);
    IntersectOptions fine;
    fine.max_seconds = options.max_seconds;
    fine.progress = options.progress;
    constexpr int most_rounds = 3;
    for (int round = 1;; ++round) {
      fine.tolerance = std::ldexp(options.tolerance, -1 - 3 * round);
      IntersectResult exact = intersect(x, y, fine);
      Verdict verdict = verify(candidate, x, y, exact, tolerance);
      if (verdict.agreement != Agreement::undecided || !verdict.exact_is_complete || round == most_rounds)
        return {std::move(verdict), std::move(exact)};
    }
  });
}

const char* name(Agreement agreement) {
  constexpr std::array<const char*, 3> names = {"agrees", "disagrees", "undecided"};
  return names[static_cast<std::size_t>(agreement)];
}

const char* name(DifferenceKind kind) {
  constexpr std::array<const char*, 12> names = {
      "lost-curve",     "gap",        "spurious-curve",  "wrong-connection",
      "split",          "repeated",   "curve-as-points", "false-point",
      "point-on-curve", "lost-point", "repeated-point",  "wrong-contact"};
  return names[static_cast<std::size_t>(kind)];
}

const char* name(Representation representation) {
  constexpr std::array<const char*, 3> names = {"space", "first", "second"};
  return names[static_cast<std::size_t>(representation)];
}

const char* name(Coverage coverage) {
  constexpr std::array<const char*, 4> names = {"covered", "partly", "missed", "undecided"};
  return names[static_cast<std::size_t>(coverage)];
}

}  // namespace exsect
