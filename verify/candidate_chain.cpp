#include "candidate_chain.h"

#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "infinite.h"

namespace exsect {
namespace {

constexpr int deepest = 40;
constexpr std::size_t most_pieces = std::size_t{1} << 20;

/// A Bézier curve with weights over [from, to].
struct Segment {
  double from;
  double to;
  std::vector<SpacePoint> points;
  std::vector<double> weights;
};

/// Homogeneous control points as rationals, for the blossom.
using Homogeneous = std::array<Rational, 4>;

Homogeneous homogeneous(const SplineCurve& curve, std::size_t i) {
  const Rational w = curve.weights.empty() ? Rational(1) : from_double(curve.weights[i]);
  const auto& p = curve.points[i];
  return {w * from_double(p[0]), w * from_double(p[1]), w * from_double(p[2]), w};
}

/// Blossom of the span [knots[k], knots[k+1]] at the given arguments (de Boor), exactly.
Homogeneous blossom(const SplineCurve& curve, std::size_t k, const std::vector<Rational>& arguments) {
  const auto d = static_cast<std::size_t>(curve.degree);
  std::vector<Homogeneous> net;
  for (std::size_t i = 0; i <= d; ++i) net.push_back(homogeneous(curve, k - d + i));
  for (std::size_t level = 1; level <= d; ++level) {
    for (std::size_t i = d; i >= level; --i) {
      const Rational a = from_double(curve.knots[k - d + i]);
      const Rational b = from_double(curve.knots[k + i + 1 - level]);
      const Rational t = (arguments[level - 1] - a) / (b - a);
      for (std::size_t c = 0; c < 4; ++c) net[i][c] = (1 - t) * net[i - 1][c] + t * net[i][c];
    }
  }
  return net[d];
}

/// The control points of one span, each rounded once, and the weights times one power of two: the greatest is
/// between 1/2 and 1.
Segment span(const SplineCurve& curve, std::size_t k) {
  Segment result{curve.knots[k], curve.knots[k + 1], {}, {}};
  if (curve.degree == 1 && curve.weights.empty()) {
    result.points = {curve.points[k - 1], curve.points[k]};
    result.weights = {1, 1};
    return result;
  }
  const auto d = static_cast<std::size_t>(curve.degree);
  const Rational from = from_double(result.from);
  const Rational to = from_double(result.to);
  std::vector<Rational> weights;
  for (std::size_t j = 0; j <= d; ++j) {
    std::vector<Rational> arguments(d - j, from);
    arguments.resize(d, to);
    const Homogeneous point = blossom(curve, k, arguments);
    result.points.push_back(
        {to_double(point[0] / point[3]), to_double(point[1] / point[3]), to_double(point[2] / point[3])});
    weights.push_back(point[3]);
  }
  int exponent = 0;
  std::frexp(to_double(*std::max_element(weights.begin(), weights.end())), &exponent);
  for (const Rational& w : weights) result.weights.push_back(to_double(w * power_of_two(-exponent)));
  return result;
}

/// Largest distance of a control point from its place on the chord: the foot, or where feet do not ascend the
/// place in proportion to its number. Places that ascend, run through by the same basis functions, are a
/// monotone motion along the chord (variation diminishing), so this bounds the Fréchet distance (15.1).
double deviation(const Segment& s) {
  const std::size_t d = s.points.size() - 1;
  std::vector<double> places;
  for (const SpacePoint& p : s.points) places.push_back(foot(p, s.points.front(), s.points.back()));
  if (!std::is_sorted(places.begin(), places.end()))
    for (std::size_t i = 0; i <= d; ++i) places[i] = static_cast<double>(i) / static_cast<double>(d);
  double result = 0;
  for (std::size_t i = 1; i < d; ++i) {
    const double off = distance(s.points[i], between(s.points.front(), s.points.back(), places[i]));
    if (!(off <= std::numeric_limits<double>::max())) return infinite;
    result = std::max(result, off);
  }
  return result;
}

/// Means of weights that are so near to each other keep their relative accuracy; where they are not, a
/// segment is not halved.
bool has_even_weights(const Segment& s) {
  const auto [least, most] = std::minmax_element(s.weights.begin(), s.weights.end());
  return *least >= *most * 0x1p-500;
}

/// Both halves by de Casteljau's algorithm.
std::array<Segment, 2> halves(const Segment& s) {
  const std::size_t n = s.points.size();
  const double middle = s.from + (s.to - s.from) / 2;
  Segment left{s.from, middle, s.points, s.weights};
  Segment right{middle, s.to, s.points, s.weights};
  std::vector<SpacePoint> points = s.points;
  std::vector<double> weights = s.weights;
  for (std::size_t level = 1; level < n; ++level) {
    for (std::size_t i = 0; i + level < n; ++i) {
      const double w = weights[i] / 2 + weights[i + 1] / 2;
      points[i] = between(points[i], points[i + 1], weights[i + 1] / 2 / w);
      weights[i] = w;
    }
    left.points[level] = points[0];
    left.weights[level] = weights[0];
    right.points[n - 1 - level] = points[n - 1 - level];
    right.weights[n - 1 - level] = weights[n - 1 - level];
  }
  return {left, right};
}

/// Straight pieces of a spline in its own space, in the order of the curve.
struct StraightPiece {
  double from;
  double to;
  SpacePoint a;
  SpacePoint b;
  double bound;
};

/// Each of at most 40 levels moves a point by at most 4 (degree + 1) roundings of its size. Halves are no
/// nearer to their chords than `rounding`.
void cut(const Segment& s, double flat, int depth, double rounding, std::vector<StraightPiece>& pieces) {
  const double bound = s.points.size() == 2 ? 0 : deviation(s) * kSlack + rounding;
  const bool is_last = depth == 0 || pieces.size() > most_pieces || !has_even_weights(s);
  if (is_last || !(bound > std::max(flat, 2 * rounding))) {
    pieces.push_back({s.from, s.to, s.points.front(), s.points.back(), bound + rounding});
    return;
  }
  for (const Segment& half : halves(s)) cut(half, flat, depth - 1, rounding, pieces);
}

std::vector<StraightPiece> straight_pieces(const SplineCurve& curve, bool closed, double flat) {
  const auto d = static_cast<std::size_t>(curve.degree);
  double size = 0;
  for (const auto& p : curve.points) size = std::max(size, largest(p));
  const double rounding = curve.degree == 1 && curve.weights.empty()
                              ? 0
                              : 4 * deepest * static_cast<double>(d + 1) * 4 * size * kUnitRoundoff;
  std::vector<StraightPiece> pieces;
  for (std::size_t k = d; k < curve.points.size(); ++k)
    if (curve.knots[k] < curve.knots[k + 1]) cut(span(curve, k), flat, deepest, rounding, pieces);
  if (closed && pieces.back().b != pieces.front().a)
    pieces.push_back({curve.to(), curve.to() + 1, pieces.back().b, pieces.front().a, rounding});
  return pieces;
}

Chain started(const SpacePoint& point, double at) {
  Chain chain;
  chain.points = {point};
  chain.at = {at};
  return chain;
}

/// `bound`, and what the rounding of distances from the piece may be.
void add(Chain& chain, const SpacePoint& point, double at, double bound) {
  const bool known = std::isfinite(point[0]) && std::isfinite(point[1]) && std::isfinite(point[2]);
  bound += 0x1p-48 * std::max(largest(chain.points.back()), largest(point));
  if (!known || !(bound <= std::numeric_limits<double>::max())) bound = infinite;
  chain.points.push_back(known ? point : chain.points.back());
  chain.at.push_back(at);
  chain.bound.push_back(bound);
}

}  // namespace

Chain chain_in_space(const SplineCurve& curve, bool closed, double flat) {
  const std::vector<StraightPiece> pieces = straight_pieces(curve, closed, flat);
  Chain chain = started(pieces.front().a, pieces.front().from);
  for (const StraightPiece& piece : pieces) add(chain, piece.b, piece.to, piece.bound);
  chain.closed = chain.points.front() == chain.points.back();
  return chain;
}

Chain chain_on_patch(const SplineCurve& curve, bool closed, const PatchInDoubles& patch, double flat) {
  const double speed = patch.speed(0) + patch.speed(1);
  const std::vector<StraightPiece> pieces =
      straight_pieces(curve, closed, speed > 0 ? flat / (4 * speed) : flat);
  Chain chain = started(patch(pieces.front().a[0], pieces.front().a[1]), pieces.front().from);
  for (const StraightPiece& piece : pieces) {
    const double du = piece.b[0] - piece.a[0];
    const double dv = piece.b[1] - piece.a[1];
    const double k = patch.second_derivative(du, dv);
    // a chord over 1/n of the segment is within k / (8 n^2) of its image (5.4)
    const double most = std::clamp(static_cast<double>(most_pieces / pieces.size()), 1.0, 4096.0);
    const double n = std::clamp(std::ceil(std::sqrt(k / (4 * flat))), 1.0, most);
    const double bound = (k / (8 * n * n) + speed * piece.bound) * kSlack + 2 * patch.rounding();
    for (double i = 1; i <= n; ++i) {
      const double t = i / n;
      const double at = i == n ? piece.to : piece.from + t * (piece.to - piece.from);
      const SpacePoint w = i == n ? piece.b : between(piece.a, piece.b, t);
      add(chain, patch(w[0], w[1]), at, bound);
    }
  }
  chain.closed = chain.points.front() == chain.points.back();
  return chain;
}

}  // namespace exsect
