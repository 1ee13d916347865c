// The distance between an arc and its polyline in space.
#include <algorithm>
#include <cmath>

#include "replay.h"

namespace exsect::checker {
namespace {

/// Steps of an arc that are bounded together.
constexpr std::size_t group = 4;

long bits(const Integer& n) { return n == 0 ? 0 : static_cast<long>(msb(n)) + 1; }

/// At least the square root, by less than 2^-60 of it.
Rational root_above(const Rational& q) {
  if (q == 0) return 0;
  const long shift = std::max(0L, 64 - (bits(numerator(q)) - bits(denominator(q))) / 2);
  const Integer scaled = (numerator(q) << (2 * static_cast<unsigned long>(shift))) / denominator(q) + 1;
  return Rational(sqrt(scaled) + 1) * power_of_two(-shift);
}

Rational norm_above(const std::array<Rational, 3>& a) { return root_above(dot(a, a)); }

/// A box around given points: middle and half extents, multiples of 2^-24.
struct Hull {
  Vector4<Rational> middle;
  Vector4<Rational> half;
};

Hull hull(const Vector4<Rational>& a, const Vector4<Rational>& b, const Rational& margin) {
  const Rational unit = power_of_two(-24);
  Hull result;
  for (std::size_t i = 0; i < 4; ++i) {
    const Rational middle = (a[i] + b[i]) / (2 * unit);
    const Integer rounded = numerator(middle) / denominator(middle);
    result.middle[i] = unit * rounded;
    const Rational half = (magnitude(Rational(a[i] - b[i])) / 2 + margin) / unit;
    result.half[i] = unit * (numerator(half) / denominator(half) + 2);
  }
  return result;
}

/// A matrix near the inverse of the columns of DF other than the axis at the point: any matrix will do if the
/// defect comes out below 1.
Matrix3<Rational> near_inverse(const Pair<Rational>& local, std::size_t axis) {
  Matrix3<Rational> m;
  for (std::size_t d = 0; d < 3; ++d)
    for (std::size_t j = 0; j < 3; ++j) m[d][j] = local.first(d, others(axis)[j], {}).middle;
  const Rational det = determinant(m[0], m[1], m[2]);
  Matrix3<Rational> result;
  for (std::size_t d = 0; d < 3 && det != 0; ++d) {
    const Point row = cross(m[(d + 1) % 3], m[(d + 2) % 3]);
    for (std::size_t j = 0; j < 3; ++j) {
      const double entry = to_double(row[j] / det);
      if (std::isfinite(entry)) result[j][d] = from_double(entry);
    }
  }
  return result;
}

class ErrorBound {
 public:
  ErrorBound(const Arc& arc, const Pair<Rational>& pair, const std::vector<Rational>& radius)
      : arc_(arc), pair_(pair), radius_(radius) {}

  /// Every point of the arc has its own place on the polyline: at a point without a vertex, the place nearest
  /// to it on its edge. Rejected if these places are not in order.
  void place_on_polyline(const std::string& where) {
    for (const ArcPoint& p : arc_.points) at_.push_back(pair_point(p.at));
    std::size_t a = 0;
    for (std::size_t b = 1; b < arc_.points.size(); ++b) {
      if (!arc_.points[b].vertex) continue;
      const Point from = *arc_.points[a].vertex;
      const Point edge = *arc_.points[b].vertex - from;
      places_.push_back(from);
      Rational before = 0;
      for (std::size_t j = a + 1; j < b; ++j) {
        const Rational length = dot(edge, edge);
        require(length > 0, where, "an edge of the polyline has no length");
        const Rational t = dot(edge, at_[j] - from) / length;
        require(before <= t && t <= 1, where, "a point is not beside its edge of the polyline");
        before = t;
        places_.push_back(from + t * edge);
      }
      a = b;
    }
    places_.push_back(*arc_.points.back().vertex);
  }

  /// The greatest distance on the steps first, ..., last - 1, all in one tube.
  Rational over(const Tube<Rational>& tube, std::size_t first, std::size_t last,
                const std::string& where) const {
    Rational margin = 0;
    for (std::size_t j = first; j <= last; ++j) margin = larger(margin, radius_[j]);
    const Hull box = hull(arc_.points[first].at, arc_.points[last].at, 2 * margin);
    const Pair<Rational> here = pair_.at(box.middle);
    const CurveBounds<Rational> bounds =
        curve_bounds(here.times(near_inverse(here, tube.axis)), tube.axis, box.half);
    require(bounds.defect < 1, where, "no derivative over a step of the polyline");
    const Pair<Rational> x = {here.x, {}};
    std::array<Rational, 3> second;
    std::array<Rational, 3> slope;
    for (std::size_t d = 0; d < 3; ++d) {
      const Ball<Rational> xu = x.first(d, 0, box.half);
      const Ball<Rational> xv = x.first(d, 1, box.half);
      second[d] =
          (x.second(d, bounds.first, box.half) + xu * bounds.second[0] + xv * bounds.second[1]).magnitude();
      slope[d] = xu.magnitude() + xv.magnitude();
    }
    const Rational bend = norm_above(second) / 8;
    const Rational speed = norm_above(slope);
    Rational most = 0;
    Rational before = 0;
    for (std::size_t j = first; j <= last; ++j) {
      const Rational end = norm_above(at_[j] - places_[j]) + speed * radius_[j];
      if (j > first) {
        const Rational step = arc_.points[j].at[tube.axis] - arc_.points[j - 1].at[tube.axis];
        most = larger(most, Rational(larger(before, end) + step * step * bend));
      }
      before = end;
    }
    return most;
  }

 private:
  Point pair_point(const Vector4<Rational>& w) const {
    Point result;
    for (std::size_t d = 0; d < 3; ++d) {
      const auto row = [&](std::size_t i) {
        const auto& c = pair_.x[i];
        return Rational(c[0][d] + w[1] * (c[1][d] + w[1] * c[2][d]));
      };
      result[d] = row(0) + w[0] * (row(1) + w[0] * row(2));
    }
    return result;
  }

  const Arc& arc_;
  const Pair<Rational>& pair_;
  const std::vector<Rational>& radius_;
  std::vector<Point> at_;      // x at the points
  std::vector<Point> places_;  // on the polyline
};

}  // namespace

void check_error_bound(const Arc& arc, const Pair<Rational>& pair, const std::vector<ProvedTube>& tubes,
                       const std::vector<Rational>& radius, const std::string& where) {
  require(arc.points.front().vertex && arc.points.back().vertex, where, "an end of the polyline is missing");
  ErrorBound bound(arc, pair, radius);
  bound.place_on_polyline(where);
  std::size_t first = 0;
  for (const Piece& piece : arc.pieces) {
    for (std::size_t j = first; j < piece.last; j += group) {
      const Rational most = bound.over(tubes[piece.tube].claim, j, std::min(j + group, piece.last), where);
      require(most <= arc.error_bound, where, "the error bound is too small");
    }
    first = piece.last;
  }
}

}  // namespace exsect::checker
