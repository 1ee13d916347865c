#include "filter/overlap.h"

#include <algorithm>
#include <cmath>

#include "answer/rim_arc.h"
#include "filter/mean_derivatives.h"
#include "filter/tube.h"
#include "shape/shifted_copy.h"

namespace exsect::filter {

namespace {

constexpr long kMostBoxesApart = 6000;
constexpr int kDeepestApart = 24;  // levels of both patches together
/// How near to each other numbers are in doubles that would be the same in exact arithmetic.
constexpr double kClosePieces = 0x1p-30;
/// Of the rectangle that both squares have in common: below, other ways may be shorter.
constexpr double kLeastWidth = 0x1p-20;

/// (u,v) = (maps[0](r), maps[1](s)), or (maps[0](s), maps[1](r)) if exchanged.
struct Pieces {
  std::array<AffineMap, 2> maps;
  bool exchanged;

  std::size_t parameter(std::size_t of_x) const { return exchanged ? 1 - of_x : of_x; }
};

/// t -> offset + factor t for centred parameters.
struct Guess {
  double offset;
  double factor;
};

/// The map A with h = k g(A(t)) for some number k, up to rounding, if there is one: as shifted_copy does.
Guess guess_between(const std::array<Vec3, 3>& g, const std::array<Vec3, 3>& h) {
  const auto ratio = [](const Vec3& a, const Vec3& b) { return dot(a, b) / dot(b, b); };
  if (largest(g[2]) < kClosePieces * (largest(g[0]) + largest(g[1]))) {
    const double k = ratio(cross(h[0], g[1]), cross(g[0], g[1]));
    return {ratio(h[0] - k * g[0], k * g[1]), ratio(h[1], g[1]) / k};
  }
  const double kb = ratio(cross(h[1], g[2]), cross(g[1], g[2]));
  return {ratio(h[1] - kb * g[1], 2 * kb * g[2]), ratio(h[2], g[2]) / kb};
}

/// False if the patches are not in doubles what the maps would make of them, or have no rectangle in common.
bool may_overlap(const Pair& pair, bool exchanged) {
  const Coefficients& x = pair.x.power;
  const Coefficients& y = pair.y.power;
  const auto at = [&](std::size_t i, std::size_t j) { return y[exchanged ? 3 * j + i : 3 * i + j]; };
  const std::array<Guess, 2> maps = {guess_between({x[2], x[5], x[8]}, {at(0, 2), at(1, 2), at(2, 2)}),
                                     guess_between({x[6], x[7], x[8]}, {at(2, 0), at(2, 1), at(2, 2)})};
  for (const Guess& map : maps) {
    const double half = 0.5 * std::fabs(map.factor);
    const double width = std::min(map.offset + half, 0.5) - std::max(map.offset - half, -0.5);
    if (!(width > kLeastWidth)) {
      return false;
    }
  }
  for (const double r : {-0.5, 0.5}) {
    for (const double s : {-0.5, 0.5}) {
      const double u = maps[0].offset + maps[0].factor * r;
      const double v = maps[1].offset + maps[1].factor * s;
      if (!(largest(value_at<Biquadratic>(x, u, v) -
                    (exchanged ? value_at<Biquadratic>(y, s, r) : value_at<Biquadratic>(y, r, s))) <
            kClosePieces)) {
        return false;
      }
    }
  }
  return true;
}

std::optional<Pieces> find_pieces(const BezierPatch& x, const BezierPatch& y, const Pair& pair) {
  for (const bool exchanged : {false, true}) {
    if (may_overlap(pair, exchanged)) {
      const auto copy = shifted_copy(x, exchanged ? y.exchanged() : y);
      return copy ? std::optional(Pieces{copy->maps, exchanged}) : std::nullopt;
    }
  }
  return std::nullopt;
}

class InjectivityProof {
 public:
  InjectivityProof(const Pair& pair, const Pieces& pieces, Trees& trees, long& boxes)
      : pair_(pair), pieces_(pieces), trees_(trees), boxes_(boxes) {
    for (std::size_t i = 0; i < 2; ++i) {
      const AffineMap& map = pieces.maps[i];
      offset_[i] = to_double(map(Rational(1, 2)) - Rational(1, 2));
      factor_[i] = to_double(map.factor);
      error_[i] = kPlaceRounding * (1 + std::fabs(offset_[i]) + std::fabs(factor_[i]));
    }
  }

  /// Different points of the surface, in the first square and in the second one, are different in space.
  bool run() {
    if (!(error_[0] < 1 && error_[1] < 1)) {
      return false;
    }
    std::vector<PiecePair> stack = {{0, 0}};
    for (long count = 0; !stack.empty(); ++count) {
      const PiecePair item = stack.back();
      stack.pop_back();
      ++boxes_;
      const SubPatch& x = trees_.x[item.x];
      const SubPatch& y = trees_.y[item.y];
      if (separated(x, y, pair_.net_error) || is_injective(hull(x, y))) {
        continue;
      }
      if (count > kMostBoxesApart || x.level + y.level >= kDeepestApart) {
        return false;
      }
      trees_.split_larger(item, stack);
    }
    return true;
  }

 private:
  Rectangle hull(const SubPatch& x, const SubPatch& y) const {
    const std::array<double, 2> on_x = {x.first, x.second};
    const std::array<double, 2> on_y = {y.first, y.second};
    Rectangle result;
    for (std::size_t i = 0; i < 2; ++i) {
      const double from = on_y[pieces_.parameter(i)];
      const auto [lower, upper] =
          std::minmax({offset_[i] + factor_[i] * from, offset_[i] + factor_[i] * (from + y.width)});
      result.lower[i] = std::min(on_x[i], lower - error_[i]);
      result.upper[i] = std::max(on_x[i] + x.width, upper + error_[i]);
    }
    return result;
  }

  /// x_2 - x_1 = du a + dv b along the segment between two points of the rectangle, a and b means of x_u and
  /// x_v. In coordinates of the tangent plane in the middle a is within d_u of (1,0), and b within d_v of
  /// (0,1): (14.24).
  bool is_injective(const Rectangle& where) const {
    const auto expansion = expand(pair_.x, where);
    if (!expansion) {
      return false;
    }
    const Coefficients& c = expansion->at_middle;
    const Vec3 n = cross(c[3], c[1]);
    const double inverse = 1 / dot(n, n);
    const std::array<Vec3, 2> rows = {inverse * cross(c[1], n), inverse * cross(n, c[3])};
    std::array<double, 2> du;
    std::array<double, 2> dv;
    for (std::size_t i = 0; i < 2; ++i) {
      const double error =
          (std::fabs(rows[i][0]) + std::fabs(rows[i][1]) + std::fabs(rows[i][2])) * 2 * pair_.total_error;
      const MeanDerivative first = mean_first(*expansion, rows[i]);
      const MeanDerivative second = mean_second(*expansion, rows[i]);
      du[i] = std::fabs(first.middle - (i == 0 ? 1 : 0)) + first.deviation + error;
      dv[i] = std::fabs(second.middle - (i == 1 ? 1 : 0)) + second.deviation + error;
    }
    return kSlack * du[0] < 1 && kSlack * dv[1] < 1 &&
           kSlack * du[1] * dv[0] < (1 - kSlack * du[0]) * (1 - kSlack * dv[1]);
  }

  const Pair& pair_;
  const Pieces& pieces_;
  Trees& trees_;
  long& boxes_;
  std::array<double, 2> offset_{};  // of the maps of centred parameters
  std::array<double, 2> factor_{};
  std::array<double, 2> error_{};
};

/// [0,1] and its image.
RationalInterval part_in_square(const AffineMap& map) {
  const Rational from = map(0);
  const Rational to = map(1);
  return {std::max(std::min(from, to), Rational(0)), std::min(std::max(from, to), Rational(1))};
}

class OverlapGraph {
 public:
  OverlapGraph(const BezierPatch& x, const Pieces& pieces, double tolerance)
      : x_(x), pieces_(pieces), tolerance_(tolerance) {}

  std::optional<GraphBuilder> run(const RationalInterval& u, const RationalInterval& v) {
    const std::array<RimEnd, 4> ends = {add_node(u.lower, v.lower), add_node(u.upper, v.lower),
                                        add_node(u.upper, v.upper), add_node(u.lower, v.upper)};
    std::vector<Arc> chain;
    for (std::size_t i = 0; i < 4; ++i) {
      chain.push_back(rim_arc(x_, ends[i], ends[(i + 1) % 4], ArcPlace::patch_boundary, tolerance_));
      if (!(chain.back().error_bound <= tolerance_)) {
        return std::nullopt;
      }
    }
    graph_.add_overlap({std::move(chain)});
    return std::move(graph_);
  }

 private:
  RimEnd add_node(const Rational& u, const Rational& v) {
    std::array<Rational, 4> at = {u, v, 0, 0};
    at[2 + pieces_.parameter(0)] = pieces_.maps[0].inverse(u);
    at[2 + pieces_.parameter(1)] = pieces_.maps[1].inverse(v);
    Node node = rim_node(at);
    const Point p = x_(u, v);
    for (std::size_t c = 0; c < 3; ++c) {
      node.point[c] = to_double(p[c]);
    }
    return {at, graph_.add_node(std::move(node), 0x1p-53)};
  }

  const BezierPatch& x_;
  const Pieces& pieces_;
  double tolerance_;
  GraphBuilder graph_;
};

}  // namespace

std::optional<GraphBuilder> overlap_of_pieces(const BezierPatch& x, const BezierPatch& y, const Pair& pair,
                                              Trees& trees, double tolerance, long& boxes) {
  const auto pieces = find_pieces(x, y, pair);
  if (!pieces) {
    return std::nullopt;
  }
  const RationalInterval u = part_in_square(pieces->maps[0]);
  const RationalInterval v = part_in_square(pieces->maps[1]);
  if (!(u.lower < u.upper && v.lower < v.upper) || !InjectivityProof(pair, *pieces, trees, boxes).run()) {
    return std::nullopt;
  }
  return OverlapGraph(x, *pieces, tolerance).run(u, v);
}

}  // namespace exsect::filter
