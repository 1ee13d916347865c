// Which part of a tube's arc a trace uses, and in which direction. Internal to solver/.
#pragma once

#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <cmath>
#include <compare>
#include <optional>

namespace exsect {

/// An end of a piece: the offset on the tube, rounded to a double. Two of them can be neither compared nor
/// subtracted: the ends of a piece that is shorter than the rounding are the same double, so that their order
/// says nothing. The direction of a piece is PieceRange::direction().
class PieceEnd {
 public:
  constexpr explicit PieceEnd(double tau) : tau_(tau) {}
  constexpr operator double() const { return tau_; }

  friend bool operator==(PieceEnd, PieceEnd) = delete;
  friend std::partial_ordering operator<=>(PieceEnd, PieceEnd) = delete;
  friend double operator-(PieceEnd, PieceEnd) = delete;

 private:
  double tau_;
};

/// The offsets that a piece of a trace runs through. Invariant: direction() is the sign of the difference of
/// the true ends, last minus first, which is not 0; from() and to() are within doubt() of the true ends, and
/// direction() * (to() - from()) >= 0, where equality is possible.
class PieceRange {
 public:
  /// No length, at 0, forwards.
  PieceRange() = default;

  /// Between two enclosed offsets; empty if their order is not certain.
  template <class Ball>
  static std::optional<PieceRange> between(const Ball& from, const Ball& to) {
    const int direction = (to - from).certain_sign();
    const double first = from.approximation();
    const double last = to.approximation();
    if (direction == 0 || !(direction * last >= direction * first)) return std::nullopt;
    const double doubt =
        larger_bound((from - Ball(first)).upper_magnitude(), (to - Ball(last)).upper_magnitude());
    return PieceRange(first, last, doubt, direction);
  }

  /// Between two offsets in doubles, each within `doubt` of the true one; empty if their order is not
  /// certain.
  static std::optional<PieceRange> between(double from, double to, double doubt = 0) {
    if (!(std::fabs(to - from) > 2 * doubt * kSlack)) return std::nullopt;
    return PieceRange(from, to, doubt, to > from ? 1 : -1);
  }

  PieceEnd from() const { return PieceEnd(from_); }
  PieceEnd to() const { return PieceEnd(to_); }
  double doubt() const { return doubt_; }
  /// +1 if offsets grow along the trace, -1 if they shrink.
  int direction() const { return direction_; }

  double least() const { return direction_ > 0 ? from_ : to_; }
  double greatest() const { return direction_ > 0 ? to_ : from_; }
  double length() const { return std::fabs(to_ - from_); }
  /// The offset at this part of the way, rounded: 0 at from(), 1 at to().
  double at(double part) const { return from_ + part * (to_ - from_); }
  /// True if the trace comes to offset a before it comes to offset b.
  bool precedes(double a, double b) const { return direction_ > 0 ? a < b : a > b; }
  /// The offset `distance` further along the trace than tau, as far as it is on the piece.
  double ahead_of(double tau, double distance) const { return clamped(tau + direction_ * distance); }
  double clamped(double tau) const { return std::clamp(tau, least(), greatest()); }

  PieceRange reversed() const { return PieceRange(to_, from_, doubt_, -direction_); }

 private:
  PieceRange(double from, double to, double doubt, int direction)
      : from_(from), to_(to), doubt_(doubt), direction_(direction) {}

  double from_ = 0;
  double to_ = 0;
  double doubt_ = 0;
  int direction_ = 1;
};

}  // namespace exsect
