#include "revolution_patch.h"

#include <exsect/algebra/nearest_rounding.h>

#include <stdexcept>
#include <utility>

#include "curve/plane_curve.h"

namespace exsect {
namespace {

/// g and even odd on the patch.
struct Pulled {
  BivariatePolynomial surface;
  BivariatePolynomial sheet;
};

Pulled pulled(const BivariatePolynomial& f, const BezierPatch& patch) {
  if (f.is_zero()) throw std::domain_error("revolution: the zero polynomial");
  const ParityParts parts = parity_parts(f);
  if (parts.odd.is_zero()) return {compose_revolution(parts.even, patch), {}};
  return {compose_revolution(revolved_by_product(f), patch),
          compose_revolution(parts.even * parts.odd, patch)};
}

/// An even profile has one sheet.
Sheet sheet_at(const Pulled& curve, const Rational& u, const RealAlgebraic& v) {
  return curve.sheet.is_zero() ? Sheet::own : sheet_of_sign(sign_at(curve.sheet.at_r(u), v));
}

}  // namespace

RevolutionPatchCurve intersect_revolution(const BivariatePolynomial& f, const BezierPatch& patch) {
  return in_nearest_rounding([&]() -> RevolutionPatchCurve {
    const Pulled curve = pulled(f, patch);
    RevolutionPatchCurve result{{}, {}, {}, {}, {}};
    if (curve.surface.is_zero()) return result;
    result.equation = squarefree(curve.surface);
    BivariatePolynomial& inner = result.inner = result.equation;
    for (const int side : {0, 1}) {
      if (!inner.at_s(side).is_zero()) continue;
      result.whole_sides.push_back(side);
      inner = exact_quotient(inner, BivariatePolynomial::s() - BivariatePolynomial::constant(side));
    }
    result.arcs = curve_arcs(inner);
    for (const CurveGap& gap : result.arcs.gaps) {
      if (gap.arcs.empty()) continue;
      const std::vector<RealAlgebraic> roots = real_roots(inner.at_r(gap.sample), 0, 1);
      for (const RealAlgebraic& v : roots) result.sheets.push_back(sheet_at(curve, gap.sample, v));
    }
    return result;
  });
}

RevolutionPatchLine points_on_line(const BivariatePolynomial& f, const BezierPatch& patch,
                                   const Rational& u0) {
  return in_nearest_rounding([&]() -> RevolutionPatchLine {
    if (u0 < 0 || u0 > 1) throw std::invalid_argument("points_on_line: u must be in [0,1]");
    const Pulled curve = pulled(f, patch);
    const Polynomial in_v = curve.surface.at_r(u0);
    RevolutionPatchLine line{{}, in_v.is_zero()};
    if (in_v.degree() < 1) return line;
    for (RealAlgebraic& v : real_roots(in_v, 0, 1)) {
      const Sheet sheet = sheet_at(curve, u0, v);
      line.points.push_back({std::move(v), sheet});
    }
    return line;
  });
}

}  // namespace exsect
