#include "filter/section_landmarks.h"

#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <cmath>

namespace exsect {
namespace {

constexpr std::size_t kMostSectionCells = 3000;
constexpr double kCellInflation = 1.25;  // of a cell, within which a zero is looked for
constexpr double kLeastSectionCell = 0x1p-20;
constexpr double kLeastEnclosure = 0x1p-44;
/// Of an enclosure.
constexpr double kMostEnclosure = 0x1p-6;

enum class FoundInCell { nothing, zero, unknown };

/// f = 0 along a side, or f = 0 and the derivative by `across` = 0, and the coordinates that are free.
struct SectionSystem {
  std::size_t across;
  bool is_on_side;
  std::array<bool, 2> is_free;
};

using SystemJacobian = std::array<std::array<DoubleBall, 2>, 2>;
using JacobianInverse = std::array<std::array<double, 2>, 2>;

bool enclosures_apart(const SectionBox& a, const SectionBox& b) {
  for (std::size_t i = 0; i < 2; ++i)
    if (std::fabs(a.centre[i] - b.centre[i]) > (a.reach[i] + b.reach[i]) * kSlack + 0x1p-50) return true;
  return false;
}

bool enclosure_within(const SectionBox& a, const SectionBox& b) {
  for (std::size_t i = 0; i < 2; ++i) {
    if (a.reach[i] == 0 && b.reach[i] == 0 && a.centre[i] == b.centre[i]) continue;
    if (!((std::fabs(a.centre[i] - b.centre[i]) + a.reach[i]) * kSlack + 0x1p-50 <= b.reach[i])) return false;
  }
  return true;
}

/// The derivative by one coordinate of that of f of the order (k, l).
DoubleBall derived_over(const LocalForm& f, std::array<std::size_t, 2> order, std::size_t by,
                        const std::array<double, 2>& reach) {
  ++order[by];
  return f.derivative_over(order[0], order[1], reach[0], reach[1]);
}

class SectionSearch {
 public:
  SectionSearch(const SquareForm& f, bool with_second, const StopRequest& stop)
      : f_(f), with_second_(with_second), stop_(stop) {}

  std::optional<std::vector<SectionLandmark>> run() {
    for (const double p : {-1.0, 1.0})
      for (const double q : {-1.0, 1.0})
        if (f_.about(p, q).derivative(0, 0).certain_sign() == 0) return std::nullopt;
    for (const std::size_t fixed : {0, 1})
      for (const int side : {-1, 1}) {
        SectionBox root{{0, 0}, {1, 1}};
        root.centre[fixed] = side;
        root.reach[fixed] = 0;
        if (!search(root, fixed, side)) return std::nullopt;
      }
    if (!search({{0, 0}, {1, 1}}, 0, 0)) return std::nullopt;
    return are_decided() ? std::optional(std::move(landmarks_)) : std::nullopt;
  }

 private:
  /// All in the box; false if it is not decided.
  bool search(const SectionBox& root, std::size_t fixed, int side) {
    std::vector<SectionBox> open = {root};
    while (!open.empty()) {
      const SectionBox cell = open.back();
      open.pop_back();
      if (++cells_ > kMostSectionCells || (stop_ && stop_())) return false;
      if (look_into(cell, fixed, side) != FoundInCell::unknown) continue;
      const std::size_t longer = cell.reach[0] >= cell.reach[1] ? 0 : 1;
      if (cell.reach[longer] < kLeastSectionCell) return false;
      for (const double by : {-0.5, 0.5}) {
        SectionBox half = cell;
        half.centre[longer] += by * cell.reach[longer];
        half.reach[longer] /= 2;
        open.push_back(half);
      }
    }
    return true;
  }

  FoundInCell look_into(const SectionBox& cell, std::size_t fixed, int side) {
    const LocalForm f = f_.about(cell.centre[0], cell.centre[1]);
    const std::array<double, 2>& r = cell.reach;
    if (f.derivative_over(0, 0, r[0], r[1]).certain_sign() != 0) return FoundInCell::nothing;
    if (side != 0) return solve(cell, f, {1 - fixed, true, {fixed != 0, fixed != 1}}, side);
    std::array<bool, 2> may_turn;  // with respect to the coordinate
    for (std::size_t i = 0; i < 2; ++i)
      may_turn[i] = (i == 0 || with_second_) && derived_over(f, {0, 0}, 1 - i, r).certain_sign() == 0;
    if (!may_turn[0] && !may_turn[1]) return FoundInCell::nothing;
    if (may_turn[0] && may_turn[1]) return FoundInCell::unknown;
    return solve(cell, f, {may_turn[0] ? 1U : 0U, false, {true, true}}, 0);
  }

  /// Of (f, f_across) by the coordinates, or of (f, the fixed coordinate).
  static SystemJacobian jacobian_over(const LocalForm& f, const SectionSystem& system,
                                      const std::array<double, 2>& reach) {
    SystemJacobian j;
    std::array<std::size_t, 2> order{};
    if (!system.is_on_side) order[system.across] = 1;
    for (std::size_t i = 0; i < 2; ++i) {
      j[0][i] = system.is_free[i] ? derived_over(f, {0, 0}, i, reach) : DoubleBall(0);
      j[1][i] = system.is_on_side ? DoubleBall(i == system.across ? 0 : 1) : derived_over(f, order, i, reach);
    }
    return j;
  }

  /// About the inverse; not finite where there is none.
  static JacobianInverse inverse_of(const SystemJacobian& j) {
    const double a = j[0][0].approximation(), b = j[0][1].approximation(), c = j[1][0].approximation(),
                 d = j[1][1].approximation();
    const double determinant = a * d - b * c;
    return {{{d / determinant, -b / determinant}, {-c / determinant, a / determinant}}};
  }

  static std::array<DoubleBall, 2> values_at(const LocalForm& f, const SectionSystem& system) {
    return {f.derivative(0, 0),
            system.is_on_side ? DoubleBall(0) : f.derivative(system.across == 0 ? 1 : 0, system.across)};
  }

  /// Krawczyk's operator: -C f in the centre, and the widths of (1 - C J) on the box.
  struct Image {
    std::array<DoubleBall, 2> step;
    std::array<double, 2> spread;
  };
  static Image image_of(const LocalForm& f, const SectionSystem& system, const std::array<double, 2>& reach) {
    const JacobianInverse c = inverse_of(jacobian_over(f, system, {0, 0}));
    const SystemJacobian j = jacobian_over(f, system, reach);
    const std::array<DoubleBall, 2> values = values_at(f, system);
    Image image;
    for (std::size_t i = 0; i < 2; ++i) {
      image.step[i] = -(DoubleBall(c[i][0]) * values[0] + DoubleBall(c[i][1]) * values[1]);
      double spread = 0;
      for (std::size_t k = 0; k < 2; ++k) {
        const DoubleBall entry =
            DoubleBall(i == k ? 1 : 0) - DoubleBall(c[i][0]) * j[0][k] - DoubleBall(c[i][1]) * j[1][k];
        spread += entry.upper_magnitude() * reach[k];
      }
      image.spread[i] = spread * kSlack;
    }
    return image;
  }

  FoundInCell solve(const SectionBox& cell, const LocalForm& f, const SectionSystem& system, int side) {
    SectionBox wide = cell;
    for (double& r : wide.reach) r *= kCellInflation;
    const Image image = image_of(f, system, wide.reach);
    for (std::size_t i = 0; i < 2; ++i) {
      if (!system.is_free[i]) continue;
      if (!(image.spread[i] < wide.reach[i])) return FoundInCell::unknown;
      if (image.step[i].lower_magnitude() > (cell.reach[i] + image.spread[i]) * kSlack)
        return FoundInCell::nothing;
    }
    const std::optional<SectionBox> zero = enclosed(cell.centre, system);
    if (!zero || !enclosure_within(*zero, wide)) return FoundInCell::unknown;
    add({*zero, 1 - system.across, side}, wide);
    return FoundInCell::zero;
  }

  /// A zero near the place, by Newton's method, in a small box.
  std::optional<SectionBox> enclosed(std::array<double, 2> place, const SectionSystem& system) const {
    for (int step = 0; step < 12; ++step) {
      if (!(std::fabs(place[0]) <= SquareForm::reach && std::fabs(place[1]) <= SquareForm::reach)) break;
      const LocalForm f = f_.about(place[0], place[1]);
      const JacobianInverse c = inverse_of(jacobian_over(f, system, {0, 0}));
      const std::array<DoubleBall, 2> values = values_at(f, system);
      std::array<double, 2> move{};
      for (std::size_t i = 0; i < 2; ++i)
        if (system.is_free[i])
          move[i] = -(c[i][0] * values[0].approximation() + c[i][1] * values[1].approximation());
      if (std::max(std::fabs(move[0]), std::fabs(move[1])) < 0x1p-40) return small_box(place, f, system);
      for (std::size_t i = 0; i < 2; ++i) place[i] += move[i];
    }
    return std::nullopt;
  }

  static std::optional<SectionBox> small_box(const std::array<double, 2>& place, const LocalForm& f,
                                             const SectionSystem& system) {
    const Image rough = image_of(f, system, {0, 0});
    SectionBox box{place, {}};
    for (std::size_t i = 0; i < 2; ++i) {
      if (!system.is_free[i]) continue;
      box.reach[i] = 2 * rough.step[i].upper_magnitude() + kLeastEnclosure;
      if (!(box.reach[i] < kMostEnclosure)) return std::nullopt;
    }
    const Image image = image_of(f, system, box.reach);
    for (std::size_t i = 0; i < 2; ++i)
      if (system.is_free[i] && !((image.step[i].upper_magnitude() + image.spread[i]) * kSlack < box.reach[i]))
        return std::nullopt;
    return box;
  }

  /// Unless it is the one of a neighbouring cell: that in `wide` is the only one there.
  void add(const SectionLandmark& zero, const SectionBox& wide) {
    for (const SectionLandmark& other : landmarks_) {
      if (enclosures_apart(zero.box, other.box)) continue;
      const bool is_same =
          zero.coordinate == other.coordinate && zero.side == other.side && enclosure_within(other.box, wide);
      is_ambiguous_ = is_ambiguous_ || !is_same;
      return;
    }
    landmarks_.push_back(zero);
  }

  /// Takes away what is certainly outside of the square; false if that is not certain of one.
  bool are_decided() {
    std::erase_if(landmarks_,
                  [](const SectionLandmark& landmark) { return place_of(landmark) == Place::outside; });
    return !is_ambiguous_ && std::ranges::all_of(landmarks_, [](const SectionLandmark& landmark) {
      return place_of(landmark) == Place::inside;
    });
  }

  enum class Place { inside, outside, unknown };
  /// In the square, but for the coordinate that is fixed on a side.
  static Place place_of(const SectionLandmark& landmark) {
    Place place = Place::inside;
    for (std::size_t i = 0; i < 2; ++i) {
      if (landmark.side != 0 && landmark.coordinate == i) continue;
      const double at = std::fabs(landmark.box.centre[i]), reach = landmark.box.reach[i] * kSlack + 0x1p-50;
      if (at - reach > 1) return Place::outside;
      if (!(at + reach < 1)) place = Place::unknown;
    }
    return place;
  }

  const SquareForm& f_;
  const bool with_second_;
  const StopRequest& stop_;
  std::vector<SectionLandmark> landmarks_;
  std::size_t cells_ = 0;
  bool is_ambiguous_ = false;
};

}  // namespace

std::optional<std::vector<SectionLandmark>> section_landmarks(const SquareForm& f, bool with_second,
                                                              const StopRequest& stop) {
  return SectionSearch(f, with_second, stop).run();
}

}  // namespace exsect
