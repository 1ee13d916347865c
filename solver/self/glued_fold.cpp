#include "self/glued_fold.h"

#include <exsect/algebra/real_algebraic.h>

#include <algorithm>
#include <utility>

#include "answer/parameter_box.h"
#include "self/star_centres.h"
#include "trace/pair_system.h"

namespace exsect {
namespace {

constexpr double kLeastFoldSurroundings = 0x1p-12;

/// Zero at the values of v for which the line v = constant begins and ends in one point.
Polynomial closed_lines(const BezierPatch& x) {
  const ControlNet c = x.power_basis();
  Polynomial common;
  for (std::size_t k = 0; k < 3; ++k) {
    std::vector<Rational> gap;
    for (std::size_t j = 0; j < 3; ++j) gap.push_back(c[1][j][k] + c[2][j][k]);
    common = gcd(common, Polynomial(std::move(gap)));
  }
  return common;
}

std::optional<GluedFold> glued_fold(const BezierPatch& x, const Rational& c) {
  const ControlNet d = x.restricted_to(0, 1, c, c + 1).power_basis();
  const Point& first = d[0][1];
  if (is_zero(first)) return std::nullopt;
  const Point last = first + d[1][1] + d[2][1];
  const Rational ratio = dot(last, first) / dot(first, first);
  const Point bend = d[0][2] + d[1][2] + d[2][2];
  if (ratio == 0 || ratio == 1 || !(last == ratio * first) || !(bend == ratio * ratio * d[0][2]))
    return std::nullopt;
  return GluedFold{false, c, ratio, d};
}

template <class T>
std::array<T, 4> in_patch(const GluedFold& fold, std::array<T, 4> p) {
  if (fold.exchanged) {
    std::swap(p[0], p[1]);
    std::swap(p[2], p[3]);
  }
  return p;
}

bool in_unit(const Rational& value) { return value >= 0 && value <= 1; }

RationalInterval clipped(const Rational& lower, const Rational& upper) {
  return {std::max<Rational>(0, lower), std::min<Rational>(1, upper)};
}

/// The determinant of (7.16) has one sign over the pairs of a box of (a, v1, b, v2).
bool factors_are_independent(const GluedFold& fold, const ParameterBox& box) {
  std::array<std::array<DoubleBall, 3>, 9> d;
  for (std::size_t i = 0; i < 9; ++i)
    for (std::size_t k = 0; k < 3; ++k) d[i][k] = DoubleBall::enclosing(fold.d[i / 3][i % 3][k]);
  const auto offset = [&](const RationalInterval& v) {
    return DoubleBall::enclosing(RationalInterval{v.lower - fold.constant, v.upper - fold.constant});
  };
  const auto m = glued_fold_factors(d, DoubleBall::enclosing(fold.ratio), DoubleBall::enclosing(box[0]),
                                    DoubleBall::enclosing(box[2]), offset(box[1]), offset(box[3]));
  return dot(m[0], cross(m[1], m[2])).certain_sign() != 0;
}

/// (a, v1, 1 - b, v2) for (a, v1, b, v2).
ParameterBox pairs_of(const ParameterBox& box) { return {box[0], box[1], reversed(box[2]), box[3]}; }

/// With double ends, and as large as can be proved.
std::optional<ParameterBox> surroundings(const GluedFold& fold) {
  const double middle = to_double(fold.constant);
  for (double width = 0.25; width >= kLeastFoldSurroundings; width *= 0.5) {
    const RationalInterval across = {0, from_double(width)};
    const RationalInterval along = clipped(from_double(middle - width), from_double(middle + width));
    const ParameterBox box = {across, along, across, along};
    if (factors_are_independent(fold, box)) return pairs_of(box);
  }
  return std::nullopt;
}

class GluedFoldStar {
 public:
  GluedFoldStar(const SelfStarProblem& problem, const GluedFold& fold, const Rational& halfwidth)
      : problem_(problem), fold_(fold), halfwidth_(halfwidth) {}

  /// The box ends where the arc on the sides leaves it, in both parameters along them.
  SelfStar run(const ParameterBox& around) {
    const Rational& c = fold_.constant;
    const std::array<RealAlgebraic, 4> centre = in_patch<RealAlgebraic>(fold_, {0, c, 1, c});
    const Rational second = halfwidth_ / std::max<Rational>(1, abs(fold_.ratio));
    const Rational first = abs(fold_.ratio) * second;
    const ParameterBox box = {{{0, halfwidth_},
                               clipped(c - first, c + first),
                               {1 - halfwidth_, 1},
                               clipped(c - second, c + second)}};
    const auto sweep = static_cast<Parameter>(along());
    result_ = SelfStar{{certified_pair(centre), sweep, in_patch(fold_, box), {}, {}},
                       in_patch(fold_, around),
                       {},
                       false,
                       boundary_point(problem_.boundary, centre)};
    std::optional<int> side;
    for (const int value : {0, 1})
      if (c == value) side = value;
    add({halfwidth_, c, 1 - halfwidth_, c}, static_cast<Parameter>(1 - along()), 1,
        SelfStar::FoldedArc{along(), c, side});
    for (const int sign : {-1, 1}) {
      const Rational v1 = c + sign * fold_.ratio * second;
      const Rational v2 = c + sign * second;
      if (in_unit(v1) && in_unit(v2)) add({0, v1, 1, v2}, sweep, v1 > c ? 1 : -1, std::nullopt);
    }
    return std::move(*result_);
  }

 private:
  /// The parameter along the sides: u (0) or v (1).
  std::size_t along() const { return fold_.exchanged ? 0 : 1; }

  void add(const std::array<Rational, 4>& pair, Parameter across, int side,
           const std::optional<SelfStar::FoldedArc>& folded) {
    const auto at = in_patch<RealAlgebraic>(fold_, {pair[0], pair[1], pair[2], pair[3]});
    result_->star.ports.push_back({certified_pair(at), across, side});
    result_->folded.push_back(folded);
  }

  const SelfStarProblem& problem_;
  const GluedFold& fold_;
  const Rational& halfwidth_;
  std::optional<SelfStar> result_;
};

}  // namespace

std::vector<GluedFold> glued_folds(const BezierPatch& x) {
  std::vector<GluedFold> result;
  for (const bool exchanged : {false, true}) {
    const BezierPatch patch = exchanged ? x.exchanged() : x;
    const Polynomial closed = closed_lines(patch);
    if (closed.degree() < 1) continue;
    for (const PolynomialPower& power : irreducible_factors(closed)) {
      if (power.factor.degree() > 1) continue;
      const Rational c = -power.factor.coefficient(0) / power.factor.coefficient(1);
      auto fold = in_unit(c) ? glued_fold(patch, c) : std::nullopt;
      if (!fold) continue;
      fold->exchanged = exchanged;
      result.push_back(*std::move(fold));
    }
  }
  return result;
}

std::optional<SelfStar> glued_fold_star(const SelfStarProblem& problem, const GluedFold& fold,
                                        const Rational& halfwidth) {
  const auto around = surroundings(fold);
  if (!around) return std::nullopt;
  SelfStar star = GluedFoldStar(problem, fold, halfwidth).run(*around);
  if (!lies_in(star.star.box, star.surroundings)) return std::nullopt;
  return star;
}

}  // namespace exsect
