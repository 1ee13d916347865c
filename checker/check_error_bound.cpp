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

template <class N>
N norm_above(const Vector3<N>& a) {
  return root_above(dot(a, a));
}
template <class N>
Vector3<N> difference(const Vector3<N>& a, const Vector3<N>& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

/// q rounded down to a multiple of 2^-24: short numbers.
Rational rounded_down(const Rational& q) {
  const Rational scaled = q * (1 << 24);
  return Rational(numerator(scaled) / denominator(scaled)) / (1 << 24);
}
Enclosure rounded_down(const Enclosure& a) { return a; }

/// A box around given points: middle and half extents.
template <class N>
struct Hull {
  Vector4<N> middle;
  Vector4<N> half;
};

template <class N>
Hull<N> hull(const Vector4<N>& a, const Vector4<N>& b, const N& margin) {
  Hull<N> result;
  for (std::size_t i = 0; i < 4; ++i) {
    result.middle[i] = rounded_down(N((a[i] + b[i]) / 2));
    result.half[i] = rounded_down(N(magnitude(N(a[i] - b[i])) / 2 + margin)) + N(0x1p-23);
  }
  return result;
}

/// A matrix near the inverse of the columns of DF other than the axis at the point: any matrix will do if the
/// defect comes out below 1.
template <class N>
Matrix3<N> near_inverse(const Pair<N>& local, std::size_t axis) {
  Matrix3<double> m;
  for (std::size_t d = 0; d < 3; ++d)
    for (std::size_t j = 0; j < 3; ++j) m[d][j] = approximate(local.first(d, others(axis)[j], {}).middle);
  const auto cofactor = [&](std::size_t d, std::size_t j) {
    const auto& p = m[(d + 1) % 3];
    const auto& q = m[(d + 2) % 3];
    return p[(j + 1) % 3] * q[(j + 2) % 3] - p[(j + 2) % 3] * q[(j + 1) % 3];
  };
  const double det = m[0][0] * cofactor(0, 0) + m[0][1] * cofactor(0, 1) + m[0][2] * cofactor(0, 2);
  Matrix3<N> result;
  for (std::size_t d = 0; d < 3; ++d)
    for (std::size_t j = 0; j < 3; ++j)
      if (const double entry = cofactor(d, j) / det; std::isfinite(entry)) result[j][d] = N(entry);
  return result;
}

template <class N>
class ErrorBound {
 public:
  ErrorBound(const Replay<N>& replay, const Arc<N>& arc, const std::vector<N>& radius)
      : arc_(arc), pair_(replay.pair), radius_(radius) {
    for (std::size_t d = 0; d < 3; ++d) origin_[d] = N(replay.origin[d]);
  }

  /// Every point of the arc has a place on the polyline: a point without a vertex the one nearest to it on
  /// its edge, but none before that of another point before it.
  void place_on_polyline(const std::string& where) {
    for (const ArcPoint<N>& p : arc_.points) {
      const auto& [u, v, r, s] = p.at;
      at_.push_back({value(pair_.x, 0, u, v), value(pair_.x, 1, u, v), value(pair_.x, 2, u, v)});
    }
    std::size_t a = 0;
    for (std::size_t b = 1; b < arc_.points.size(); ++b) {
      if (!arc_.points[b].vertex) continue;
      const Vector3<N> from = difference(*arc_.points[a].vertex, origin_);
      const Vector3<N> edge = difference(*arc_.points[b].vertex, *arc_.points[a].vertex);
      places_.push_back(from);
      N before = 0;
      for (std::size_t j = a + 1; j < b; ++j) {
        const N length = dot(edge, edge);
        require(length > 0, where, "an edge of the polyline has no length");
        const N nearest = dot(edge, difference(at_[j], from)) / length;
        const N t = -larger(N(-larger(before, nearest)), N(-1));
        before = t;
        places_.push_back({from[0] + t * edge[0], from[1] + t * edge[1], from[2] + t * edge[2]});
      }
      a = b;
    }
    places_.push_back(difference(*arc_.points.back().vertex, origin_));
  }

  /// The greatest distance on the steps first, ..., last - 1, all in one tube.
  N over(std::size_t axis, std::size_t first, std::size_t last, const std::string& where) const {
    N margin = 0;
    for (std::size_t j = first; j <= last; ++j) margin = larger(margin, radius_[j]);
    const Hull<N> box = hull(arc_.points[first].at, arc_.points[last].at, N(2 * margin));
    const Pair<N> here = pair_.at(box.middle);
    const CurveBounds<N> bounds = curve_bounds(here.times(near_inverse(here, axis)), axis, box.half);
    require(bounds.defect < 1, where, "no derivative over a step of the polyline");
    const Pair<N> x = {here.x, {}};
    Vector3<N> second;
    Vector3<N> slope;
    for (std::size_t d = 0; d < 3; ++d) {
      const Ball<N> xu = x.first(d, 0, box.half);
      const Ball<N> xv = x.first(d, 1, box.half);
      second[d] =
          (x.second(d, bounds.first, box.half) + xu * bounds.second[0] + xv * bounds.second[1]).magnitude();
      slope[d] = xu.magnitude() + xv.magnitude();
    }
    const N bend = norm_above(second) / 8;
    const N speed = norm_above(slope);
    N most = 0;
    N before = 0;
    for (std::size_t j = first; j <= last; ++j) {
      const N end = norm_above(difference(at_[j], places_[j])) + speed * radius_[j];
      if (j > first) {
        const N step = arc_.points[j].at[axis] - arc_.points[j - 1].at[axis];
        most = larger(most, N(larger(before, end) + step * step * bend));
      }
      before = end;
    }
    return most;
  }

 private:
  const Arc<N>& arc_;
  const Pair<N>& pair_;
  const std::vector<N>& radius_;
  Vector3<N> origin_;
  std::vector<Vector3<N>> at_;      // x at the points
  std::vector<Vector3<N>> places_;  // on the polyline
};

}  // namespace

template <class N>
void check_error_bound(const Replay<N>& replay, const Arc<N>& arc, const std::vector<N>& radius,
                       const std::string& where) {
  require(arc.points.front().vertex && arc.points.back().vertex, where, "an end of the polyline is missing");
  ErrorBound<N> bound(replay, arc, radius);
  bound.place_on_polyline(where);
  std::size_t first = 0;
  for (const Piece& piece : arc.pieces) {
    for (std::size_t j = first; j < piece.last; j += group) {
      const N most =
          bound.over(replay.certificate.tubes[piece.tube].axis, j, std::min(j + group, piece.last), where);
      require(most <= arc.error_bound, where, "the error bound is too small");
    }
    first = piece.last;
  }
}
template void check_error_bound(const Replay<Rational>&, const Arc<Rational>&, const std::vector<Rational>&,
                                const std::string&);
template void check_error_bound(const Replay<Enclosure>&, const Arc<Enclosure>&,
                                const std::vector<Enclosure>&, const std::string&);

}  // namespace exsect::checker
