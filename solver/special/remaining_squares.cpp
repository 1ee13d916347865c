#include "special/remaining_squares.h"

#include <exsect/algebra/bernstein_box.h>

#include <algorithm>
#include <array>
#include <utility>

namespace exsect {
namespace {

constexpr int kMostSquares = 4000;

struct Square {
  Rectangle at;
  std::vector<BernsteinBox> boxes;  // the polynomials on it
};

std::array<Square, 2> halved(const Square& square) {
  const bool by_r = square.at.r.width() >= square.at.s.width();
  const RationalInterval& range = by_r ? square.at.r : square.at.s;
  std::array<Square, 2> halves = {Square{square.at, {}}, Square{square.at, {}}};
  (by_r ? halves[0].at.r : halves[0].at.s).upper = range.midpoint();
  (by_r ? halves[1].at.r : halves[1].at.s).lower = range.midpoint();
  for (const BernsteinBox& box : square.boxes) {
    auto [lower, upper] = by_r ? box.split_r() : box.split_s();
    halves[0].boxes.push_back(std::move(lower));
    halves[1].boxes.push_back(std::move(upper));
  }
  return halves;
}

/// A corner that no division and no test takes away: none of the polynomials is positive there, and a
/// rectangle that holds it is never small.
bool has_lasting_corner(const Square& square, const std::function<bool(const Rectangle&)>& is_small) {
  for (const bool upper_r : {false, true})
    for (const bool upper_s : {false, true}) {
      const bool is_left = std::ranges::none_of(
          square.boxes, [&](const BernsteinBox& box) { return box.sign_at_corner(upper_r, upper_s) > 0; });
      const Rational& r = upper_r ? square.at.r.upper : square.at.r.lower;
      const Rational& s = upper_s ? square.at.s.upper : square.at.s.lower;
      if (is_left && !is_small({{r, r}, {s, s}})) return true;
    }
  return false;
}

}  // namespace

std::optional<std::vector<Rectangle>> remaining_squares(
    const std::vector<BivariatePolynomial>& polynomials,
    const std::function<bool(const Rectangle&)>& is_small) {
  std::vector<Square> open = {{}};
  for (const BivariatePolynomial& f : polynomials)
    if (!f.is_zero()) open[0].boxes.emplace_back(f, RationalInterval{0, 1}, RationalInterval{0, 1});
  std::vector<Rectangle> left;
  for (int count = 0; !open.empty(); ++count) {
    if (count == kMostSquares) return std::nullopt;
    Square square = std::move(open.back());
    open.pop_back();
    if (std::ranges::any_of(square.boxes, [](const BernsteinBox& box) { return box.sign() > 0; })) continue;
    if (is_small(square.at)) {
      left.push_back(square.at);
      continue;
    }
    if (has_lasting_corner(square, is_small)) return std::nullopt;
    for (Square& half : halved(square)) open.push_back(std::move(half));
  }
  return left;
}

}  // namespace exsect
