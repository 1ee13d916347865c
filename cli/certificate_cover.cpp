// The subdivision of [0,1]^4 into cells without solutions and cells in tubes.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "certificate_search.h"

namespace exsect::cli {
namespace {

using Net = checker::Net<double>;
using Vector = std::array<double, 3>;

Vector difference(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
double product(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

struct Cell {
  std::array<Net, 2> nets;
  Parameters middle;
  Parameters half;
};

Cell half_of(const Cell& cell, std::size_t parameter, bool upper) {
  Cell result = cell;
  Net& net = result.nets[parameter / 2];
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t d = 0; d < 3; ++d) {
      const auto at = [&](std::size_t m) -> double& {
        return parameter % 2 == 0 ? net[m][i][d] : net[i][m][d];
      };
      const double a = (at(0) + at(1)) / 2;
      const double b = (at(1) + at(2)) / 2;
      (upper ? at(0) : at(2)) = (a + b) / 2;
      at(1) = upper ? b : a;
    }
  }
  result.half[parameter] /= 2;
  result.middle[parameter] += (upper ? 1 : -1) * result.half[parameter];
  return result;
}

/// The part of the cell where the parameter has the value, in [0,1].
Cell on_line(Cell cell, std::size_t parameter, double t) {
  Net& net = cell.nets[parameter / 2];
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t d = 0; d < 3; ++d) {
      const auto at = [&](std::size_t m) -> double& {
        return parameter % 2 == 0 ? net[m][i][d] : net[i][m][d];
      };
      at(0) = (1 - t) * (1 - t) * at(0) + 2 * t * (1 - t) * at(1) + t * t * at(2);
      at(1) = at(2) = at(0);
    }
  }
  cell.middle[parameter] = t;
  cell.half[parameter] = 0;
  return cell;
}

/// The direction with integer components that the vector points to, as long as 100 at most.
std::array<int, 3> rounded_direction(const Vector& d) {
  const double most = std::max({std::abs(d[0]), std::abs(d[1]), std::abs(d[2])});
  if (!(most > 0) || !std::isfinite(most)) return {0, 0, 0};
  std::array<int, 3> result;
  for (std::size_t i = 0; i < 3; ++i) result[i] = static_cast<int>(std::lround(100 * d[i] / most));
  return result;
}

/// The direction or its opposite, whichever separates x from y over the cell; empty if neither does.
std::string separating(const Cell& cell, const std::array<int, 3>& direction) {
  const Vector d = {double(direction[0]), double(direction[1]), double(direction[2])};
  std::array<double, 2> least = {1e300, 1e300};
  std::array<double, 2> most = {-1e300, -1e300};
  for (std::size_t n = 0; n < 2; ++n) {
    for (const auto& row : cell.nets[n]) {
      for (const Vector& p : row) {
        least[n] = std::min(least[n], product(d, p));
        most[n] = std::max(most[n], product(d, p));
      }
    }
  }
  constexpr double margin = 1e-11;
  if (least[0] - most[1] > margin) return fmt::format("{} {} {}", direction[0], direction[1], direction[2]);
  if (least[1] - most[0] > margin)
    return fmt::format("{} {} {}", -direction[0], -direction[1], -direction[2]);
  return "";
}

class Cover {
 public:
  explicit Cover(const std::vector<Tube>& tubes) : tubes_(tubes) {}

  void add(const Cell& cell, const std::vector<std::size_t>& near, int depth) {
    const std::vector<std::size_t> meeting = those_meeting(cell, near);
    for (const std::size_t i : meeting) {
      Parameters half = cell.half;
      for (double& h : half) h *= 1 + 1e-9;
      if (tubes_[i].contains(cell.middle, half)) return entries_.push_back("t" + std::to_string(i));
    }
    if (std::string d = exclusion(cell, meeting); !d.empty()) return entries_.push_back(d);
    if (depth > 150 || entries_.size() > 1000000) throw NoCertificate("a subdivision that does not end");
    const std::size_t parameter = longest(cell);
    entries_.push_back(std::string(1, "uvrs"[parameter]));
    add(half_of(cell, parameter, false), meeting, depth + 1);
    add(half_of(cell, parameter, true), meeting, depth + 1);
  }

  std::vector<std::string> entries_;

 private:
  std::vector<std::size_t> those_meeting(const Cell& cell, const std::vector<std::size_t>& near) const {
    std::vector<std::size_t> result;
    for (const std::size_t i : near) {
      const Tube& tube = tubes_[i];
      const Parameters h = tube.extent();
      bool meets = true;
      for (std::size_t j = 0; j < 4; ++j)
        meets = meets && std::abs(tube.centre[j] - cell.middle[j]) <= h[j] + cell.half[j];
      if (meets) result.push_back(i);
    }
    return result;
  }

  std::string exclusion(const Cell& cell, const std::vector<std::size_t>& meeting) const {
    const Net& x = cell.nets[0];
    const Net& y = cell.nets[1];
    const auto normal = [](const Net& n) {
      return cross(difference(n[2][2], n[0][0]), difference(n[2][0], n[0][2]));
    };
    for (const auto& d : {std::array{1, 0, 0}, std::array{0, 1, 0}, std::array{0, 0, 1},
                          rounded_direction(difference(x[1][1], y[1][1])), rounded_direction(normal(x)),
                          rounded_direction(normal(y))}) {
      if (std::string found = separating(cell, d); !found.empty()) return found;
    }
    for (const std::size_t i : meeting) {
      for (const auto& row : tubes_[i].inverse) {
        if (std::string found = separating(cell, rounded_direction(row)); !found.empty()) return found;
      }
    }
    return "";
  }

  /// The parameter over which the cell is longest in space.
  static std::size_t longest(const Cell& cell) {
    Parameters length{};
    for (std::size_t p = 0; p < 4; ++p) {
      for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t m = 0; m < 2; ++m) {
          const Net& n = cell.nets[p / 2];
          const Vector d = p % 2 == 0 ? difference(n[m + 1][i], n[m][i]) : difference(n[i][m + 1], n[i][m]);
          length[p] = std::max(length[p], product(d, d));
        }
      }
    }
    return static_cast<std::size_t>(std::max_element(length.begin(), length.end()) - length.begin());
  }

  const std::vector<Tube>& tubes_;
};

}  // namespace

std::vector<std::string> cover(const NearPair& pair, const std::vector<Tube>& tubes,
                               const std::optional<LineQuery>& line) {
  Cover result(tubes);
  std::vector<std::size_t> all(tubes.size());
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
  const Cell whole = {pair.control, {0.5, 0.5, 0.5, 0.5}, {0.5, 0.5, 0.5, 0.5}};
  result.add(line ? on_line(whole, index(line->fixed), to_double(line->value)) : whole, all, 0);
  return result.entries_;
}

}  // namespace exsect::cli
