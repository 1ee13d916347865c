#include "certificate/cover.h"

// The subdivision of [0,1]^4 into cells without solutions and cells in tubes.
#include <exsect/checker/factors.h>
#include <fmt/compile.h>

#include <algorithm>
#include <cmath>

namespace exsect::cli {
namespace {

using Net = checker::WeightedNet<double>;

Vector sum(const Vector& a, const Vector& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
Vector difference(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

/// Control points in space whose convex hull holds a patch over a cell, if all weights are positive.
struct Hull {
  checker::Net<double> points;
  double least_weight = 1;

  explicit Hull(const Net& net) : points(net.points) {
    if (!net.has_weights()) return;
    points.each([&](std::size_t i, std::size_t j) {
      const double w = net.weight(i, j);
      least_weight = std::min(least_weight, w);
      for (double& c : points[i][j])
        if (w > 0) c /= w;
    });
  }
  /// The least and the greatest n . P of its points.
  std::array<double, 2> range(const Vector& n) const {
    std::array<double, 2> result = {1e300, -1e300};
    points.each([&](std::size_t i, std::size_t j) {
      const double c = checker::dot(n, points[i][j]);
      result = {std::min(result[0], c), std::max(result[1], c)};
    });
    return result;
  }
  const Vector& middle() const { return points[points.degree(0) / 2][points.degree(1) / 2]; }
  /// Twice the mean edge in the direction of the parameter p.
  Vector edge(std::size_t p) const {
    const std::size_t a = points.degree(0);
    const std::size_t b = points.degree(1);
    const Vector rising = difference(points[a][b], points[0][0]);
    const Vector falling = difference(points[a][0], points[0][b]);
    return p == 0 ? sum(rising, falling) : difference(rising, falling);
  }
  /// The greatest square of a distance of neighbours in the direction of p.
  double longest_step(std::size_t p) const {
    double most = 0;
    for (std::size_t i = 0; i <= points.degree(1 - p); ++i) {
      for (std::size_t m = 0; m < points.degree(p); ++m) {
        const Vector d = difference(points.along(p, m + 1, i), points.along(p, m, i));
        most = std::max(most, checker::dot(d, d));
      }
    }
    return most;
  }
};

/// A patch over a cell.
struct Piece {
  Net net;
  Hull hull = Hull(net);
};
using Pieces = std::array<const Piece*, 2>;

/// With its pieces, which others share.
struct Cell {
  Pieces pieces;
  Parameters middle;
  Parameters half;
  const checker::SectionNet<double>* section = nullptr;  // F_1 of an equation, instead of pieces
};

/// The lower half and the upper one, with the pieces of the whole.
std::array<Cell, 2> halves(Cell cell, std::size_t parameter) {
  cell.half[parameter] /= 2;
  std::array<Cell, 2> result = {cell, cell};
  result[0].middle[parameter] -= cell.half[parameter];
  result[1].middle[parameter] += cell.half[parameter];
  return result;
}

/// The direction or its opposite, whichever has all Bernstein coefficients of its product with F greater than
/// their errors, where those of the direction are in [least, most]; empty if neither has.
std::string separating(const std::array<int, 3>& direction, double least, double most) {
  const auto& [x, y, z] = direction;
  const double margin = 1e-11 + 1e-14 * (std::abs(double(x)) + std::abs(double(y)) + std::abs(double(z)));
  if (least > margin) return fmt::format(FMT_COMPILE("{},{},{}"), x, y, z);
  if (-most > margin) return fmt::format(FMT_COMPILE("{},{},{}"), -x, -y, -z);
  return "";
}
/// Of two patches: w_x w_y (n . x - n . y) is beyond all points of both hulls.
std::string separating(const Pieces& pieces, const std::array<int, 3>& direction) {
  const Hull& x = pieces[0]->hull;
  const Hull& y = pieces[1]->hull;
  const Vector d = {double(direction[0]), double(direction[1]), double(direction[2])};
  const std::array<double, 2> a = x.range(d);
  const double other = checker::dot(d, y.middle());
  if (a[0] <= other && other <= a[1]) return "";
  const std::array<double, 2> b = y.range(d);
  const double weight = x.least_weight * y.least_weight;
  return separating(direction, weight * (a[0] - b[1]), weight * (a[1] - b[0]));
}
/// Of an equation, of which F_1 alone counts.
std::string separating(const checker::SectionNet<double>& section) {
  std::array<double, 2> range = {1e300, -1e300};
  section.each([&](std::size_t i, std::size_t j) {
    range = {std::min(range[0], section[i][j][0]), std::max(range[1], section[i][j][0])};
  });
  return separating({1, 0, 0}, range[0], range[1]);
}

Cell mirrored(const Cell& cell) {
  const auto swapped = [](const Parameters& w) { return Parameters{w[2], w[3], w[0], w[1]}; };
  return {{cell.pieces[1], cell.pieces[0]}, swapped(cell.middle), swapped(cell.half)};
}

class Cover {
 public:
  Cover(const NearPair& pair, const Places& places)
      : pair_(pair),
        places_(places),
        divided_{in_enclosures(pair.charts[0].divided[0]), in_enclosures(pair.charts[0].divided[1])} {}

  void add(const Cell& cell, const std::vector<std::size_t>& near, int depth) {
    const std::vector<std::size_t> meeting = those_meeting(cell, near);
    if (std::string place = place_of(cell, meeting); !place.empty()) return entries_.push_back(place);
    if (depth > 150 || entries_.size() > max_entries) throw NoCertificate("a subdivision that does not end");
    const std::size_t parameter = longest(cell);
    entries_.emplace_back(1, "uvrs"[parameter]);
    auto [lower, upper] = halves(cell, parameter);
    const auto both = [&] {
      add(lower, meeting, depth + 1);
      add(upper, meeting, depth + 1);
    };
    if (cell.section) {
      checker::SectionNet<double> above = *cell.section;
      const checker::SectionNet<double> below = above.split(parameter);
      lower.section = &below;
      upper.section = &above;
      return both();
    }
    const std::size_t patch = parameter / 2;
    Net net = cell.pieces[patch]->net;
    const Piece below = {net.split(parameter % 2)};
    const Piece above = {net};
    lower.pieces[patch] = &below;
    upper.pieces[patch] = &above;
    both();
  }

  std::vector<std::string> entries_;

 private:
  /// What a leaf says; empty if the cell has to be halved.
  std::string place_of(const Cell& cell, const std::vector<std::size_t>& meeting) const {
    if (places_.self && cell.middle[0] + cell.half[0] <= cell.middle[2] - cell.half[2]) return "lower";
    for (const std::size_t i : meeting) {
      const Tube& tube = places_.tubes[i];
      if (contains(tube, cell)) return "t" + std::to_string(i);
      if (places_.self && tube.chart == Chart::pair && contains(tube, mirrored(cell)))
        return "m" + std::to_string(i);
    }
    for (std::size_t i = 0; i < places_.stars.size(); ++i)
      if (contains(places_.stars[i], cell)) return "p" + std::to_string(i);
    checker::Box<double> box;
    for (std::size_t j = 0; j < 4; ++j) box[j] = {cell.middle[j], cell.half[j] * (1 + 1e-9)};
    for (std::size_t i = 0; i < places_.planes.size(); ++i)
      if (checker::independent<double>(places_.planes[i]->columns, box)) return "s" + std::to_string(i);
    if (std::string d = exclusion(cell); !d.empty()) return d;
    return places_.self ? injective(cell) : "";
  }

  static bool contains(const checker::Star& star, const Cell& cell) {
    for (std::size_t j = 0; j < 4; ++j) {
      double middle = 0;
      double radius = 0;
      for (std::size_t i = 0; i < 4; ++i) {
        const auto c = checker::number<double>(star.coordinates[j][i]);
        middle += c * (cell.middle[i] - checker::number<double>(star.at[i]));
        radius += std::abs(c) * cell.half[i];
      }
      if (std::abs(middle) + radius > 1 - 1e-9) return false;
    }
    return true;
  }

  bool contains(const Tube& tube, const Cell& cell) const {
    constexpr double more = 1 + 1e-9;
    checker::Box<double> box;
    for (std::size_t j = 0; j < 4; ++j) box[j] = {cell.middle[j], cell.half[j] * more};
    if (tube.chart == Chart::pair) return tube.surrounds(box);
    const auto& divided = pair_.charts[tube.chart == Chart::first ? 0 : 1].divided;
    return tube.surrounds(checker::pairs_in_chart(tube, divided, checker::halves(tube.chart, box)));
  }

  /// The tubes that the cell, or its mirror image, may meet.
  std::vector<std::size_t> those_meeting(const Cell& cell, const std::vector<std::size_t>& near) const {
    std::vector<std::size_t> result;
    for (const std::size_t i : near) {
      const Tube& tube = places_.tubes[i];
      if (meets(tube, cell) || (places_.self && meets(tube, mirrored(cell)))) result.push_back(i);
    }
    return result;
  }

  static bool meets(const Tube& tube, const Cell& cell) {
    Parameters h = tube.extent();
    Parameters centre = tube.centre;
    if (tube.chart != Chart::pair) {
      const double t = std::sqrt(tube.centre[3] + tube.reach);
      const std::size_t p = tube.chart == Chart::first ? 0 : 1;
      centre[p] = centre[p + 2] = tube.centre[0];
      centre[1 - p] = centre[3 - p] = tube.centre[1];
      const double m = std::abs(tube.centre[2]) + h[2];
      h = {h[0] + t, h[1] + m * t, h[0] + t, h[1] + m * t};
      if (p == 1) h = {h[1], h[0], h[3], h[2]};
    }
    for (std::size_t j = 0; j < 4; ++j)
      if (std::abs(centre[j] - cell.middle[j]) > h[j] + cell.half[j]) return false;
    return true;
  }

  /// A direction that proves different points of the cell to be different in space, if there is one.
  std::string injective(const Cell& cell) const {
    using checker::Enclosure;
    checker::Box<double> box;
    checker::Box<Enclosure> exact;
    for (std::size_t j = 0; j < 4; ++j) {
      box[j] = {cell.middle[j], cell.half[j]};
      exact[j] = {Enclosure(cell.middle[j]), Enclosure(cell.half[j])};
    }
    const checker::Divided<double>& maps = pair_.charts[0].divided;
    const checker::Box<double> pairs = checker::halves(Chart::first, box);
    const checker::DividedOver<double> over(maps, pairs);
    const auto middle = [](const auto& v) { return Vector{v[0].middle, v[1].middle, v[2].middle}; };
    const auto n = rounded_direction(checker::cross(middle(over.r(0)), middle(over.q())));
    if (checker::volume({double(n[0]), double(n[1]), double(n[2])}, maps, pairs).sign() == 0) return "";
    const checker::Vector3<Enclosure> direction = {n[0], n[1], n[2]};
    const Enclosure least =
        checker::volume(direction, divided_, checker::halves(Chart::first, exact)).least();
    // Coefficients are rounded in the check: for the errors of this, twice those found here.
    if (!(3 * approximate(least) > 2 * least.above())) return "";
    return fmt::format("i{},{},{}", n[0], n[1], n[2]);
  }

  static std::string exclusion(const Cell& cell) {
    if (cell.section) return separating(*cell.section);
    const Hull& x = cell.pieces[0]->hull;
    const Hull& y = cell.pieces[1]->hull;
    if (!(std::min(x.least_weight, y.least_weight) > 0)) return "";
    const bool small = *std::max_element(cell.half.begin(), cell.half.end()) < 0x1p-8;
    const double size = small ? 1e5 : 100;
    // Parallelograms that are apart are separated by a normal to two of their edges, if not in one plane.
    const std::array edges = {x.edge(0), x.edge(1), y.edge(0), y.edge(1)};
    for (std::size_t n = 0; n < 10; ++n) {
      constexpr std::array<std::array<std::size_t, 2>, 6> pairs = {
          {{0, 1}, {2, 3}, {0, 2}, {0, 3}, {1, 2}, {1, 3}}};
      std::array<int, 3> d = {};
      if (n < 3)
        d[n] = 1;
      else if (n == 3)
        d = rounded_direction(difference(x.middle(), y.middle()));
      else
        d = rounded_direction(checker::cross(edges[pairs[n - 4][0]], edges[pairs[n - 4][1]]), size);
      if (std::string found = separating(cell.pieces, d); !found.empty()) return found;
    }
    return "";
  }

  /// The parameter over which the cell is longest in space; one along which nothing moves counts a little.
  static std::size_t longest(const Cell& cell) {
    if (cell.section) return cell.half[0] < cell.half[1] ? 1 : 0;
    Parameters length{};
    for (std::size_t p = 0; p < 4; ++p)
      length[p] = std::max(cell.pieces[p / 2]->hull.longest_step(p % 2), cell.half[p] * cell.half[p] / 1024);
    return static_cast<std::size_t>(std::max_element(length.begin(), length.end()) - length.begin());
  }

  static constexpr std::size_t max_entries = 300000;
  const NearPair& pair_;
  const Places& places_;
  const checker::Divided<checker::Enclosure> divided_;  // of one patch
};

}  // namespace

std::array<int, 3> rounded_direction(const Vector& d, double size) {
  const double most = std::max({std::abs(d[0]), std::abs(d[1]), std::abs(d[2])});
  if (!(most > 0) || !std::isfinite(most)) return {0, 0, 0};
  std::array<int, 3> result;
  for (std::size_t i = 0; i < 3; ++i)
    result[i] = static_cast<int>(size * d[i] / most + std::copysign(0.5, d[i]));
  return result;
}

std::vector<std::string> cover(const NearPair& pair, const Places& places,
                               const std::optional<LineQuery>& line) {
  Cover result(pair, places);
  std::vector<std::size_t> all;
  for (std::size_t i = 0; i < places.tubes.size(); ++i)
    if (places.tubes[i].chart != Chart::star) all.push_back(i);
  const double other = pair.section ? 0 : 0.5;  // r and s of an equation are 1/2
  std::array<Net, 2> nets = pair.control;
  Parameters middle = {0.5, 0.5, 0.5, 0.5}, half = {0.5, 0.5, other, other};
  if (line) {  // the part where the parameter has its value
    const std::size_t fixed = index(line->fixed);
    middle[fixed] = to_double(line->value);
    half[fixed] = 0;
    nets[fixed / 2].restrict_to(fixed % 2, middle[fixed]);
  }
  const std::array<Piece, 2> pieces = {Piece{nets[0]}, Piece{nets[1]}};
  result.add({{&pieces[0], &pieces[1]}, middle, half, pair.section ? &*pair.section : nullptr}, all, 0);
  return result.entries_;
}

}  // namespace exsect::cli
