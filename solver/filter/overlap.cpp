#include "filter/overlap.h"

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>

#include "answer/rim_arc.h"
#include "filter/affine_parameters.h"
#include "filter/injectivity.h"
#include "filter/tube.h"

namespace exsect::filter {

namespace {

constexpr long kMostBoxesApart = 6000;
constexpr int kDeepestApart = 24;  // levels of both patches together
/// Coefficients below this may be zero but for rounding, and directions that differ by less the same one.
constexpr double kCloseDirections = 0x1p-30;

/// The degrees in both parameters, but for coefficients that may be zero.
template <class K>
std::array<std::size_t, 2> true_degrees(const PatchOf<K>& patch) {
  std::array<std::size_t, 2> result = {0, 0};
  for (std::size_t i = 0; i < K::count; ++i) {
    if (!(largest(patch.power[i]) > patch.error[i])) continue;
    result[0] = std::max(result[0], i / K::side);
    result[1] = std::max(result[1], i % K::side);
  }
  return result;
}

/// Up to `rounding` in the products of their coordinates.
template <std::size_t N>
bool nearly_parallel(const Vec<N>& a, const Vec<N>& b, double rounding = 0) {
  const double size = kCloseDirections * largest(a) * largest(b) + rounding;
  for (std::size_t i = 0; i < N; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (!(std::fabs(a[i] * b[j] - a[j] * b[i]) <= size)) return false;
    }
  }
  return true;
}

/// Whether the highest derivative by one of the parameters changes its direction with the other one.
template <class K>
bool has_turning_derivative(const CoefficientsOf<K>& power, std::size_t m, std::size_t n) {
  const Row<K>& top = power[K::side * m + n];
  for (std::size_t i = 0; i < K::side; ++i) {
    if (!nearly_parallel(power[K::side * m + i], top) || !nearly_parallel(power[K::side * i + n], top)) {
      return true;
    }
  }
  return false;
}

/// False if the patches have no maps: the coefficients of the highest powers of both parameters would have
/// one direction. A guess that costs little, and decides what is asked exactly.
template <class K>
bool may_overlap(const PairOf<K>& pair, bool exchanged) {
  const auto [m, n] = true_degrees(pair.x);
  const auto of_y = true_degrees(pair.y);
  if (of_y != (exchanged ? std::array{n, m} : std::array{m, n})) return false;
  const std::size_t top = K::side * m + n;
  const std::size_t top_of_y = K::side * of_y[0] + of_y[1];
  const Row<K>& a = pair.x.power[top];
  const Row<K>& b = pair.y.power[top_of_y];
  if (nearly_parallel(a, b) && has_turning_derivative<K>(pair.x.power, m, n)) return true;
  // Directions of height fields say nothing, nor do those that are mostly rounding, of small pieces; and maps
  // take longer to look for than a pair in doubles. The exact solution finds those of biquadratic ones.
  if (std::is_same_v<K, Biquadratic>) return false;
  const double rounding = 2 * (pair.x.error[top] * largest(b) + pair.y.error[top_of_y] * largest(a));
  return nearly_parallel(a, b, rounding) && seem_to_be_pieces(pair);
}

template <class K>
std::optional<OverlapOfPieces> find_pieces(const ExactPatch<K>& x, const ExactPatch<K>& y,
                                           const PairOf<K>& pair) {
  for (const bool exchanged : {false, true}) {
    if (!may_overlap<K>(pair, exchanged)) continue;
    ControlVectors of_y = control_vectors(y);
    if (exchanged) {
      for (std::size_t i = 0; i < K::side; ++i) {
        for (std::size_t j = 0; j < i; ++j) std::swap(of_y[i][j], of_y[j][i]);
      }
    }
    const auto copy = shifted_copy(control_vectors(x), of_y);
    if (copy) return OverlapOfPieces{copy->maps, exchanged};
  }
  return std::nullopt;
}

template <class K>
class InjectivityProof {
 public:
  InjectivityProof(const PairOf<K>& pair, const OverlapOfPieces& pieces, TreesOf<K>& trees, long& boxes)
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
      const SubPatchOf<K>& x = trees_.x[item.x];
      const SubPatchOf<K>& y = trees_.y[item.y];
      if (separated(x, y, pair_.net_error) || is_injective<K>(pair_.x, 2 * pair_.total_error, hull(x, y))) {
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
  Rectangle hull(const SubPatchOf<K>& x, const SubPatchOf<K>& y) const {
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

  const PairOf<K>& pair_;
  const OverlapOfPieces& pieces_;
  TreesOf<K>& trees_;
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

/// Rims are drawn within `tolerance` where that can be, and have to be within `accepted`.
class OverlapGraph {
 public:
  OverlapGraph(const RationalPatch& x, const OverlapOfPieces& pieces, double tolerance, double accepted)
      : x_(x), pieces_(pieces), tolerance_(tolerance), accepted_(accepted) {}

  std::optional<GraphBuilder> run(const RationalInterval& u, const RationalInterval& v) {
    const std::array<RimEnd, 4> ends = {add_node(u.lower, v.lower), add_node(u.upper, v.lower),
                                        add_node(u.upper, v.upper), add_node(u.lower, v.upper)};
    std::vector<Arc> chain;
    for (std::size_t i = 0; i < 4; ++i) {
      chain.push_back(rim_arc(x_, ends[i], ends[(i + 1) % 4], ArcPlace::patch_boundary, tolerance_));
      if (!(chain.back().error_bound <= accepted_)) {
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

  const RationalPatch& x_;
  const OverlapOfPieces& pieces_;
  double tolerance_;
  double accepted_;
  GraphBuilder graph_;
};

}  // namespace

template <class K>
std::optional<OverlapOfPieces> pieces_of_one_surface(const ExactPatch<K>& x, const ExactPatch<K>& y,
                                                     const PairOf<K>& pair) {
  const auto pieces = find_pieces<K>(x, y, pair);
  if (!pieces) return std::nullopt;
  const RationalInterval u = part_in_square(pieces->maps[0]);
  const RationalInterval v = part_in_square(pieces->maps[1]);
  if (!(u.lower < u.upper && v.lower < v.upper)) return std::nullopt;
  return pieces;
}

template <class K>
std::optional<OverlapOfPieces> overlap_of_pieces(const ExactPatch<K>& x, const ExactPatch<K>& y,
                                                 const PairOf<K>& pair, TreesOf<K>& trees, long& boxes) {
  auto pieces = pieces_of_one_surface<K>(x, y, pair);
  if (pieces && !InjectivityProof<K>(pair, *pieces, trees, boxes).run()) pieces.reset();
  return pieces;
}

template <class K>
bool meet_as_neighbours(Common common, const ExactPatch<K>& x, const ExactPatch<K>& y, const PairOf<K>& pair,
                        TreesOf<K>& trees, long& boxes) {
  const auto pieces = find_pieces<K>(x, y, pair);
  if (!pieces) return false;
  const auto is_point = [](const AffineMap& map) {
    const RationalInterval part = part_in_square(map);
    return part.lower == part.upper;
  };
  const auto is_all = [](const AffineMap& map) {
    return part_in_square(map).width() == 1 && abs(map.factor) == 1;
  };
  const auto& [first, second] = pieces->maps;
  const bool shared = common == Common::corner
                          ? is_point(first) && is_point(second)
                          : (is_point(first) && is_all(second)) || (is_point(second) && is_all(first));
  return shared && InjectivityProof<K>(pair, *pieces, trees, boxes).run();
}

std::optional<GraphBuilder> overlap_graph(const RationalPatch& x, const OverlapOfPieces& overlap,
                                          double tolerance, double accepted) {
  return OverlapGraph(x, overlap, tolerance, accepted)
      .run(part_in_square(overlap.maps[0]), part_in_square(overlap.maps[1]));
}

#define EXSECT_INSTANTIATE(K)                                                                               \
  template std::optional<OverlapOfPieces> pieces_of_one_surface<K>(const ExactPatch<K>&,                    \
                                                                   const ExactPatch<K>&, const PairOf<K>&); \
  template std::optional<OverlapOfPieces> overlap_of_pieces<K>(const ExactPatch<K>&, const ExactPatch<K>&,  \
                                                               const PairOf<K>&, TreesOf<K>&, long&);       \
  template bool meet_as_neighbours<K>(Common, const ExactPatch<K>&, const ExactPatch<K>&, const PairOf<K>&, \
                                      TreesOf<K>&, long&);
EXSECT_FILTER_KINDS(EXSECT_INSTANTIATE)
#undef EXSECT_INSTANTIATE

}  // namespace exsect::filter
