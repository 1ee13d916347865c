#include "output/drawing/drawn_arcs.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace exsect::cli {
namespace {

/// Short rationals between the ends, denser towards them, where arcs may be steep.
std::vector<Rational> samples(const Rational& from, const Rational& to) {
  const double width = to_double(Rational(to - from));
  const int n = std::clamp(static_cast<int>(std::ceil(120 * width)), 6, 80);
  std::vector<Rational> result;
  for (int k = 0; k <= n; ++k) {
    const double t = (1 - std::cos(std::numbers::pi * k / n)) / 2;
    const Rational near = Rational(static_cast<int>(std::lround(t * 4096)), 4096);
    // not quite to the ends, where the number of points may be another one
    result.push_back(from + (Rational(1, 65536) + near * Rational(65534, 65536)) * (to - from));
  }
  return result;
}

}  // namespace

std::vector<PlanePolyline> drawn_arcs(const BivariatePolynomial& f, const CurveArcs& curve) {
  std::vector<PlanePolyline> result(curve.arcs.size());
  for (std::size_t i = 0; i < curve.gaps.size(); ++i) {
    const std::vector<std::size_t>& arcs = curve.gaps[i].arcs;
    if (arcs.empty()) continue;
    for (const Rational& u : samples(curve.events[i].u.upper, curve.events[i + 1].u.lower)) {
      const std::vector<RealAlgebraic> roots = real_roots(f.at_r(u), 0, 1);
      if (roots.size() < arcs.size()) continue;
      for (std::size_t k = 0; k < arcs.size(); ++k)
        result[arcs[k]].push_back({to_double(u), roots[k].to_double()});
    }
  }
  return result;
}

}  // namespace exsect::cli
