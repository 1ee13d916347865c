#include "filter/round_landmarks.h"

#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace exsect {
namespace {

constexpr std::size_t kMostCells = 6000;
constexpr double kInflation = 1.25;  // of a cell, within which a zero is looked for
constexpr double kLeastCell = 0x1p-30;
constexpr double kQuickCell = 0x1p-10;    // above it the errors of quick numbers are small
constexpr double kLeastRadius = 0x1p-44;  // above what places err by
/// Of an enclosure: so that it is apart from a tube whose centre is more than 60 degrees away.
constexpr double kMostRadius = 0x1p-4;
/// The circles of a torus; no special place of symmetric pairs.
constexpr RoundCoordinate kSection = {0.8, 0.6};

enum class Found { nothing, zero, unknown };

using Jacobian = std::array<std::array<DoubleBall, 2>, 2>;

/// (f, f_0), or (f, 0) along a circle where the second coordinate is fixed.
class RoundSearch {
 public:
  explicit RoundSearch(const RoundChart& chart) : chart_(chart) {}

  /// All in the box, whose second coordinate is fixed if its reach is 0; false if it is not decided.
  bool run(const RoundBox& root) {
    std::vector<RoundBox> open = {root};
    while (!open.empty()) {
      const RoundBox cell = open.back();
      open.pop_back();
      if (++cells_ > kMostCells) return false;
      const Found found = look_into(cell);
      if (is_ambiguous_) return false;
      if (found != Found::unknown) continue;
      if (!split(cell, open)) return false;
    }
    return true;
  }

  std::vector<RoundBox> take() { return std::move(landmarks_); }
  std::size_t cells() const { return cells_; }

 private:
  Found look_into(const RoundBox& cell) {
    const bool is_fixed = cell.reach[1] == 0;
    const RoundBox wide = {cell.centre, {cell.reach[0] * kInflation, cell.reach[1] * kInflation}};
    const auto& [a, b] = cell.reach;
    const RoundJet at = std::max(a, b) > kQuickCell ? chart_.quick_jet(cell.centre) : chart_.jet(cell.centre);
    const RoundJet over = chart_.jet(wide);
    std::array<double, 3> most;
    for (std::size_t k = 0; k < 3; ++k) most[k] = over.second[k].upper_magnitude();
    const double bound = at.first[0].upper_magnitude() * a + at.first[1].upper_magnitude() * b +
                         (most[0] * a * a + 2 * most[1] * a * b + most[2] * b * b) / 2;
    if (at.value.lower_magnitude() > bound * kSlack) return Found::nothing;
    if (chart_.is_on_other_nappe(wide)) return Found::nothing;
    const std::array<DoubleBall, 2> first = first_over(at, most, wide.reach);
    if (!is_fixed && first[0].certain_sign() != 0) return Found::nothing;
    const Jacobian jacobian = is_fixed ? Jacobian{{{first[0], 0}, {0, 1}}}
                                       : Jacobian{{{first[0], first[1]}, {over.second[0], over.second[1]}}};
    return solve(cell, wide, at, jacobian);
  }

  /// The first derivatives on a box, by their change from the centre.
  static std::array<DoubleBall, 2> first_over(const RoundJet& at, const std::array<double, 3>& most,
                                              const std::array<double, 2>& reach) {
    return {at.first[0].widened((most[0] * reach[0] + most[1] * reach[1]) * kSlack),
            at.first[1].widened((most[1] * reach[0] + most[2] * reach[1]) * kSlack)};
  }

  static Jacobian jacobian_at(const RoundJet& at, bool is_fixed) {
    if (is_fixed) return {{{at.first[0], 0}, {0, 1}}};
    return {{{at.first[0], at.first[1]}, {at.second[0], at.second[1]}}};
  }

  /// About the inverse; not finite where there is none.
  static std::array<std::array<double, 2>, 2> inverse(const Jacobian& j) {
    const double a = j[0][0].approximation(), b = j[0][1].approximation(), c = j[1][0].approximation(),
                 d = j[1][1].approximation();
    const double determinant = a * d - b * c;
    return {{{d / determinant, -b / determinant}, {-c / determinant, a / determinant}}};
  }

  struct Krawczyk {
    std::array<DoubleBall, 2> step;  // -C f at the centre
    std::array<double, 2> spread;    // of |1 - C J| on the box
  };
  static Krawczyk krawczyk(const RoundJet& at, bool is_fixed, const Jacobian& jacobian,
                           const std::array<double, 2>& reach) {
    const auto c = inverse(jacobian_at(at, is_fixed));
    const std::array<DoubleBall, 2> values = {at.value, is_fixed ? DoubleBall(0) : at.first[0]};
    Krawczyk result;
    for (std::size_t i = 0; i < 2; ++i) {
      result.step[i] = -(DoubleBall(c[i][0]) * values[0] + DoubleBall(c[i][1]) * values[1]);
      double spread = 0;
      for (std::size_t k = 0; k < 2; ++k) {
        const DoubleBall entry = DoubleBall(i == k ? 1 : 0) - DoubleBall(c[i][0]) * jacobian[0][k] -
                                 DoubleBall(c[i][1]) * jacobian[1][k];
        spread += entry.upper_magnitude() * reach[k];
      }
      result.spread[i] = spread * kSlack;
    }
    return result;
  }

  Found solve(const RoundBox& cell, const RoundBox& wide, const RoundJet& at, const Jacobian& jacobian) {
    const bool is_fixed = cell.reach[1] == 0;
    const Krawczyk image = krawczyk(at, is_fixed, jacobian, wide.reach);
    for (std::size_t i = 0; i < 2; ++i) {
      if (is_fixed && i == 1) continue;
      if (!(image.spread[i] < wide.reach[i])) return Found::unknown;
      if (image.step[i].lower_magnitude() > (cell.reach[i] + image.spread[i]) * kSlack) return Found::nothing;
    }
    const std::optional<RoundBox> zero = enclosed(cell.centre, is_fixed);
    if (!zero || !is_within(chart_, *zero, wide)) return Found::unknown;
    add(*zero, wide);
    return Found::zero;
  }

  /// A zero near the place, by Newton's method, in a small box.
  std::optional<RoundBox> enclosed(RoundPlace place, bool is_fixed) const {
    for (int step = 0; step < 12; ++step) {
      const RoundJet at = chart_.quick_jet(place);
      const auto c = inverse(jacobian_at(at, is_fixed));
      std::array<double, 2> move;
      for (std::size_t i = 0; i < 2; ++i)
        move[i] =
            -(c[i][0] * at.value.approximation() + (is_fixed ? 0 : c[i][1] * at.first[0].approximation()));
      const double size = std::max(std::fabs(move[0]), std::fabs(move[1]));
      if (!(size < 0.5) || !(std::fabs(move[0] + move[1]) < 1)) return std::nullopt;
      if (size < 0x1p-40) return small_box(place, chart_.jet(place), is_fixed);
      for (std::size_t i = 0; i < (is_fixed ? 1U : 2U); ++i) place = chart_.moved(place, i, move[i]);
    }
    return std::nullopt;
  }

  std::optional<RoundBox> small_box(const RoundPlace& place, const RoundJet& at, bool is_fixed) const {
    const Krawczyk rough = krawczyk(at, is_fixed, jacobian_at(at, is_fixed), {0, 0});
    RoundBox box{place, {}};
    for (std::size_t i = 0; i < 2; ++i) box.reach[i] = 2 * rough.step[i].upper_magnitude() + kLeastRadius;
    if (is_fixed) box.reach[1] = 0;
    if (!(box.reach[0] < kMostRadius && box.reach[1] < kMostRadius)) return std::nullopt;
    const RoundJet over = chart_.jet(box);
    const Jacobian jacobian = jacobian_at(over, is_fixed);
    const Krawczyk image = krawczyk(at, is_fixed, jacobian, box.reach);
    for (std::size_t i = 0; i < (is_fixed ? 1U : 2U); ++i)
      if (!((image.step[i].upper_magnitude() + image.spread[i]) * kSlack < box.reach[i])) return std::nullopt;
    return box;
  }

  /// Unless it is the one of a neighbouring cell: that in `wide` is the only one there.
  void add(const RoundBox& zero, const RoundBox& wide) {
    for (const RoundBox& other : landmarks_) {
      if (are_apart(chart_, zero, other)) continue;
      const bool is_same = zero.reach[1] == 0 ? other.reach[1] == 0 && is_within(chart_, other, wide)
                                              : other.reach[1] != 0 && is_within(chart_, other, wide);
      is_ambiguous_ = is_ambiguous_ || !is_same;
      return;
    }
    landmarks_.push_back(zero);
  }

  /// Into halves of the longer side in space, which cover it.
  bool split(const RoundBox& cell, std::vector<RoundBox>& open) const {
    const std::array<double, 2> speed = chart_.speeds(cell);
    const std::size_t i = speed[0] * cell.reach[0] >= speed[1] * cell.reach[1] ? 0 : 1;
    const std::size_t k = cell.reach[1] == 0 ? 0 : i;
    if (cell.reach[k] < kLeastCell) return false;
    for (const double by : {-0.5, 0.5}) {
      RoundBox half = cell;
      half.centre = chart_.moved(cell.centre, k, by * cell.reach[k]);
      half.reach[k] = cell.reach[k] / 2 + kLeastRadius;
      open.push_back(half);
    }
    return true;
  }

  const RoundChart& chart_;
  std::vector<RoundBox> landmarks_;
  std::size_t cells_ = 0;
  bool is_ambiguous_ = false;
};

/// An eighth of a turn.
constexpr double kEighth = 0x1.921fb54442d18p-1;

}  // namespace

bool are_apart(const RoundChart& chart, const RoundBox& a, const RoundBox& b) {
  for (std::size_t i = 0; i < 2; ++i) {
    const DoubleBall off = chart.difference(i, a.centre, b.centre);
    if (!std::isfinite(off.radius())) {
      if (a.reach[i] + b.reach[i] < 0.5) return true;  // more than 60 degrees apart
      continue;
    }
    if (off.lower_magnitude() > (a.reach[i] + b.reach[i]) * kSlack) return true;
  }
  return false;
}

bool is_within(const RoundChart& chart, const RoundBox& a, const RoundBox& b) {
  for (std::size_t i = 0; i < 2; ++i) {
    // A coordinate that is fixed is the same double.
    if (b.reach[i] == 0 && a.reach[i] == 0 && a.centre.at[i] == b.centre.at[i]) continue;
    if (!((chart.difference(i, a.centre, b.centre).upper_magnitude() + a.reach[i]) * kSlack <= b.reach[i]))
      return false;
  }
  return true;
}

std::optional<std::vector<RoundBox>> round_landmarks(const RoundChart& chart) {
  RoundSearch search(chart);
  const auto search_from = [&](const RoundCoordinate& along, double reach) {
    RoundPlace place{{RoundCoordinate{1, 0}, along}};
    for (int i = 0; i < 8; ++i) {
      if (!search.run({place, {kEighth / 2 + 0x1p-40, reach}})) return false;
      place.at[0] = turned(place.at[0], kEighth);
    }
    return true;
  };
  bool is_decided = true;
  if (chart.is_closed()) {
    RoundCoordinate along = {1, 0};
    for (int i = 0; i < 8 && is_decided; ++i, along = turned(along, kEighth))
      is_decided = search_from(along, kEighth / 2 + 0x1p-40);
    for (const double sign : {1.0, -1.0})
      is_decided = is_decided && search_from({sign * kSection[0], sign * kSection[1]}, 0);
  } else {
    const auto& [from, to] = chart.range();
    is_decided = search_from({from / 2 + to / 2, 0}, (to - from) / 2 * kSlack);
  }
  return is_decided ? std::optional(search.take()) : std::nullopt;
}

}  // namespace exsect
