#include "line/check_lines.h"

#include <exsect/algebra/nearest_rounding.h>
#include <exsect/algebra/real_algebraic.h>
#include <exsect/solver/line_intersection.h>

#include <stdexcept>
#include <utility>

namespace exsect {

std::vector<CheckLine> check_lines(const BezierPatch& x, const BezierPatch& y, int n) {
  return in_nearest_rounding([&] {
    if (n < 1) throw std::invalid_argument("check_lines: at least one line is needed");
    std::vector<CheckLine> lines;
    for (int i = 0; i < n; ++i) {
      const Rational u(2 * i + 1, 2 * n);
      LineIntersection line = intersect_line(x, y, {Parameter::u, u});
      if (line.solution.incomplete || !line.solution.on_patch.empty()) continue;
      const std::size_t roots = line.eliminant.degree() < 1 ? 0 : real_roots(line.eliminant, 0, 1).size();
      lines.push_back({u, std::move(line.solution.points), roots});
    }
    return lines;
  });
}

}  // namespace exsect
