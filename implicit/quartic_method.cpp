#include "quartic_method.h"

#include <exsect/algebra/bernstein_box.h>
#include <exsect/algebra/nearest_rounding.h>
#include <exsect/algebra/real_algebraic.h>
#include <exsect/geometry/bounding_box.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>
#include <utility>

namespace exsect {
namespace {

using Box = std::array<int, 2>;

/// Marks the boxes of x that the piece cannot be excluded from.
class Cover {
 public:
  Cover(const QuarticPiece& piece, const BoundingBox& around, int depth, std::vector<Box>& marked)
      : bound_(piece.bound), around_(around), depth_(depth), marked_(marked) {}

  void search(const BernsteinBox& q, const BezierPatch& x, int depth, const Box& at) {
    if (!intersects(bounding_box(x), around_) || q.lower() > bound_ || q.upper() < -bound_) return;
    if (depth == depth_) {
      marked_.push_back(at);
      return;
    }
    const auto halves = q.split_r();
    const std::array<std::pair<BernsteinBox, BernsteinBox>, 2> quarters = {halves.first.split_s(),
                                                                           halves.second.split_s()};
    for (const int i : {0, 1})
      for (const int j : {0, 1}) {
        const auto& column = quarters[static_cast<std::size_t>(i)];
        search(j == 0 ? column.first : column.second,
               x.restricted_to(Rational(i, 2), Rational(i + 1, 2), Rational(j, 2), Rational(j + 1, 2)),
               depth + 1, {2 * at[0] + i, 2 * at[1] + j});
      }
  }

 private:
  const Rational& bound_;
  const BoundingBox& around_;
  int depth_;
  std::vector<Box>& marked_;
};

/// Groups of boxes that touch, be it at a corner.
std::vector<QuarticRegion> regions(std::set<Box> marked) {
  std::vector<QuarticRegion> result;
  while (!marked.empty()) {
    QuarticRegion region{{*marked.begin()}, true};
    marked.erase(marked.begin());
    for (std::size_t next = 0; next < region.boxes.size(); ++next) {
      const Box box = region.boxes[next];
      for (int di = -1; di <= 1; ++di)
        for (int dj = -1; dj <= 1; ++dj) {
          const auto neighbour = marked.find({box[0] + di, box[1] + dj});
          if (neighbour == marked.end()) continue;
          region.boxes.push_back(*neighbour);
          marked.erase(neighbour);
        }
    }
    std::sort(region.boxes.begin(), region.boxes.end());
    result.push_back(std::move(region));
  }
  return result;
}

/// Whether the closed box of the given number meets the interval of v on the line u.
bool meets_on_line(const Box& box, const Rational& size, const Rational& u, const RationalInterval& v) {
  return box[0] * size <= u && u <= (box[0] + 1) * size && box[1] * size <= v.upper &&
         v.lower <= (box[1] + 1) * size;
}

void mark_true(std::vector<QuarticRegion>& regions, const std::vector<CheckLine>& lines,
               const Rational& size) {
  constexpr std::size_t v = index(Parameter::v);
  for (QuarticRegion& region : regions)
    for (const CheckLine& line : lines)
      for (const CertifiedPoint& point : line.points)
        if (std::any_of(region.boxes.begin(), region.boxes.end(),
                        [&](const Box& box) { return meets_on_line(box, size, line.u, point.box()[v]); }))
          region.is_phantom = false;
}

/// The v of the points of the pieces' curves on the line, as doubles.
std::vector<double> approximate_points(const BezierPatch& x, const std::vector<QuarticPiece>& pieces,
                                       const std::vector<BoundingBox>& around, const Rational& u) {
  std::vector<double> result;
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    const Polynomial in_v = pieces[k].composed.at_r(u);
    if (in_v.degree() < 1) continue;
    for (const RealAlgebraic& v : real_roots(in_v, 0, 1)) {
      const double value = v.to_double();
      if (around[k].contains(x(u, from_double(value)))) result.push_back(value);
    }
  }
  return result;
}

double nearest(const std::vector<double>& values, double to) {
  double distance = 2;  // more than any in [0,1]
  for (const double value : values) distance = std::min(distance, std::abs(value - to));
  return distance;
}

QuarticCheck measured(const BezierPatch& x, const std::vector<QuarticPiece>& pieces,
                      const std::vector<BoundingBox>& around, const std::vector<CheckLine>& lines,
                      double near) {
  constexpr std::size_t v = index(Parameter::v);
  QuarticCheck check{0, 0, 0, 0};
  for (const CheckLine& line : lines) {
    std::vector<double> exact;
    for (const CertifiedPoint& point : line.points) exact.push_back(to_double(point.box()[v].midpoint()));
    const std::vector<double> approximate = approximate_points(x, pieces, around, line.u);
    check.points += exact.size();
    for (const double value : exact) {
      const double deviation = nearest(approximate, value);
      if (deviation > near)
        ++check.missed;
      else
        check.largest_deviation = std::max(check.largest_deviation, deviation);
    }
    for (const double value : approximate)
      if (nearest(exact, value) > near) ++check.phantoms;
  }
  return check;
}

}  // namespace

QuarticMethod intersect_by_quartics(const BezierPatch& x, const BezierPatch& y, const QuarticOptions& options,
                                    const std::vector<CheckLine>& lines) {
  return in_nearest_rounding([&] {
    if (options.pieces < 0 || options.pieces > 3)
      throw std::invalid_argument("quartics: pieces must be 0, ..., 3");
    if (options.boxes < 3 || options.boxes > 8)
      throw std::invalid_argument("quartics: boxes must be 3, ..., 8");
    QuarticMethod result;
    std::vector<BoundingBox> around;
    std::set<Box> marked;
    const int parts = 1 << options.pieces;
    for (int i = 0; i < parts; ++i)
      for (int j = 0; j < parts; ++j) {
        const RationalInterval r = {Rational(i, parts), Rational(i + 1, parts)},
                               s = {Rational(j, parts), Rational(j + 1, parts)};
        const BezierPatch part = y.restricted_to(r.lower, r.upper, s.lower, s.upper);
        around.push_back(bounding_box(part));
        const ApproximateEquation q = approximate_equation(part, 4, options.fit);
        result.pieces.push_back({r, s, compose(q.equation, x), q.bound, {}});
        QuarticPiece& piece = result.pieces.back();
        Cover(piece, around.back(), options.boxes, piece.boxes)
            .search(BernsteinBox(piece.composed, {0, 1}, {0, 1}), x, 0, {0, 0});
        marked.insert(piece.boxes.begin(), piece.boxes.end());
      }
    const Rational size(1, 1 << options.boxes);
    result.regions = regions(std::move(marked));
    mark_true(result.regions, lines, size);
    result.check = measured(x, result.pieces, around, lines, to_double(size));
    return result;
  });
}

}  // namespace exsect
