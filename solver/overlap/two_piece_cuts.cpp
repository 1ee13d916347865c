#include "overlap/two_piece_cuts.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "answer/parameter_box.h"
#include "line/known_tangent.h"
#include "overlap/pair_map.h"

namespace exsect {
namespace {

constexpr int kFinestBits = 256;

class PointOfHull : public CertifiedPoint::Source {
 public:
  PointOfHull(CertifiedPoint point, std::array<AffineMap, 4> maps)
      : point_(std::move(point)), maps_(std::move(maps)) {}

  ParameterBox box(const Rational& width) const override {
    Rational finer = width;
    for (const AffineMap& map : maps_) finer = std::min<Rational>(finer, width / abs(map.factor));
    ParameterBox result = point_.refined_to(finer).box();
    for (std::size_t j = 0; j < 4; ++j) {
      const Rational a = maps_[j](result[j].lower);
      const Rational b = maps_[j](result[j].upper);
      result[j] = {std::min(a, b), std::max(a, b)};
    }
    return result;
  }

 private:
  CertifiedPoint point_;
  std::array<AffineMap, 4> maps_;
};

bool disjoint(const RationalInterval& a, const RationalInterval& b) {
  return a.upper < b.lower || b.upper < a.lower;
}

class Search {
 public:
  Search(const TwoPieces& pieces, const OverlapBoundary& boundary)
      : pieces_(pieces),
        boundary_(boundary),
        to_hull_(maps_to_hull(pieces)),
        from_hull_(pieces.copy, pieces.around) {}

  std::optional<TwoPieceCuts> run() {
    if (!find_cuts()) return std::nullopt;
    return TwoPieceCuts{std::move(cuts_), std::move(point_of_cut_)};
  }

 private:
  /// The boundary points off the diagonal: all that are no ends of arcs on the common surface, nor touch it.
  bool find_cuts() {
    std::vector<bool> diagonal(boundary_.points.size(), false);
    for (const BoundaryArc& arc : boundary_.arcs)
      if (arc.kind != BoundaryArcKind::branch) diagonal[arc.from] = diagonal[arc.to] = true;
    for (std::size_t i = 0; i < diagonal.size(); ++i) {
      if (diagonal[i] || boundary_.points[i].kind == BoundaryPointKind::touch) continue;
      const CertifiedPoint& point = boundary_.points[i].at;
      cuts_.push_back({in_hull(point), {}, [&pieces = pieces_, &point] {
                         return known_zero_tangent(pieces.x, pieces.y, point);
                       }});
      point_of_cut_.push_back(i);
      if (!is_off_diagonal(cuts_.back().at)) return false;
    }
    std::vector<bool> decided(cuts_.size(), false);
    for (std::size_t k = 0; k < cuts_.size(); ++k) {
      if (!find_exchanged(k)) continue;
      decided[k] = true;
      if (cuts_[k].exchanged) {
        cuts_[*cuts_[k].exchanged].exchanged = k;
        decided[*cuts_[k].exchanged] = true;
      }
    }
    return std::ranges::find(decided, false) == decided.end();
  }

  CertifiedPoint in_hull(const CertifiedPoint& point) const {
    std::vector<Side> sides;
    for (const Side& side : point.sides()) {
      const Rational value = to_hull_[index(side.parameter)](side.value);
      if (value == 0 || value == 1) sides.push_back({side.parameter, value == 0 ? 0 : 1});
    }
    return {std::make_shared<PointOfHull>(point, to_hull_), power_of_two(-60), sides, 0, 0};
  }

  static bool is_off_diagonal(const CertifiedPoint& point) {
    for (int bits = 60; bits <= kFinestBits; bits *= 2) {
      const ParameterBox box = point.refined_to(power_of_two(-bits)).box();
      if (disjoint(box[0], box[2]) || disjoint(box[1], box[3])) return true;
    }
    return false;
  }

  /// If the exchanged pair lies on a side of the domain, and inside of no arc along which the patches cross,
  /// it is a boundary point, and found among them; false if that is not decided.
  bool find_exchanged(std::size_t k) {
    const ParameterBox box = exchanged_pair(cuts_[k].at.refined_to(power_of_two(-kFinestBits)).box());
    std::vector<std::size_t> near;
    for (std::size_t i = 0; i < cuts_.size(); ++i)
      if (meet(cuts_[i].at.refined_to(power_of_two(-kFinestBits)).box(), box)) near.push_back(i);
    if (near.empty()) return true;
    std::vector<Side> sides;
    for (const Parameter p : all_parameters) {
      const RationalInterval range = from_hull_(box[index(p)], index(p));
      if (range.lower > 0 && range.upper < 1) continue;
      const int side = range.lower <= 0 ? 0 : 1;
      const std::size_t other = index(p) ^ 2;
      const Rational value = to_hull_[other].inverse(to_hull_[index(p)](side));
      if (!has_value(boundary_.points[point_of_cut_[k]].at, other, value)) return false;
      sides.push_back({p, side});
    }
    if (sides.empty() || is_inside_branch(sides) || near.size() > 1) return false;
    cuts_[k].exchanged = near.front();
    return true;
  }

  /// Whether the point's parameter j is this number, exactly. False also where that is not decided.
  static bool has_value(const CertifiedPoint& point, std::size_t j, const Rational& value) {
    if (point.box()[j].width() == 0) return point.box()[j].lower == value;
    const auto exact = point.exact();
    return exact && sign_at(exact->numerator[j] - exact->denominator[j] * Polynomial(value), exact->at) == 0;
  }

  /// Points inside of an arc are on its sides only: a point on a further one is an event.
  bool is_inside_branch(const std::vector<Side>& sides) const {
    return std::ranges::any_of(boundary_.arcs, [&](const BoundaryArc& arc) {
      return arc.kind == BoundaryArcKind::branch && arc.inside.sides() == sides;
    });
  }

  const TwoPieces& pieces_;
  const OverlapBoundary& boundary_;
  std::array<AffineMap, 4> to_hull_;
  PairMap from_hull_;
  std::vector<PairCut> cuts_;
  std::vector<std::size_t> point_of_cut_;
};

}  // namespace

/// From the parameters of the pieces to those of their hull.
std::array<AffineMap, 4> maps_to_hull(const TwoPieces& pieces) {
  std::array<AffineMap, 4> maps;
  for (std::size_t j = 0; j < 4; ++j)
    maps[j] = quotient(pieces.around[j % 2], j < 2 ? AffineMap{0, 1} : pieces.copy.maps[j - 2]);
  return maps;
}

std::optional<TwoPieceCuts> two_piece_cuts(const TwoPieces& pieces, const OverlapBoundary& boundary) {
  return Search(pieces, boundary).run();
}

}  // namespace exsect
