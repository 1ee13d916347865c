// The subdivision of [0,1]^4: every leaf holds no solution, or lies in a tube.
#include <algorithm>

#include "replay.h"

namespace exsect::checker {
namespace {

using IntegerNet = std::array<std::array<std::array<Integer, 3>, 3>, 3>;

/// Control points of both patches over the cell, times scale * 4^levels[patch].
struct Box {
  std::array<IntegerNet, 2> nets;
  std::array<unsigned, 2> levels = {0, 0};
  Vector4<Rational> middle;
  Vector4<Rational> half;
};

std::array<IntegerNet, 2> integer_nets(const std::array<BezierPatch, 2>& patches) {
  Integer scale = 1;
  for (const BezierPatch& patch : patches)
    for (const auto& row : patch.net())
      for (const Point& p : row)
        for (const Rational& q : p) scale = lcm(scale, denominator(q));
  std::array<IntegerNet, 2> nets;
  for (std::size_t n = 0; n < 2; ++n)
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        for (std::size_t d = 0; d < 3; ++d)
          nets[n][i][j][d] = numerator(Rational(scale * patches[n].net()[i][j][d]));
  return nets;
}

/// The half of the net with the smaller or greater values of its first (0) or second (1) parameter, times 4.
IntegerNet half_of(const IntegerNet& net, std::size_t parameter, bool upper) {
  IntegerNet result;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto at = [&](std::size_t m) -> const std::array<Integer, 3>& {
      return parameter == 0 ? net[m][i] : net[i][m];
    };
    const auto to = [&](std::size_t m) -> std::array<Integer, 3>& {
      return parameter == 0 ? result[m][i] : result[i][m];
    };
    const std::size_t first = upper ? 2 : 0;
    for (std::size_t d = 0; d < 3; ++d) {
      to(first)[d] = 4 * at(first)[d];
      to(1)[d] = 2 * (at(first)[d] + at(1)[d]);
      to(2 - first)[d] = at(0)[d] + 2 * at(1)[d] + at(2)[d];
    }
  }
  return result;
}

Box half_of(const Box& box, std::size_t parameter, bool upper) {
  Box result = box;
  const std::size_t patch = parameter / 2;
  result.nets[patch] = half_of(box.nets[patch], parameter % 2, upper);
  ++result.levels[patch];
  result.half[parameter] = box.half[parameter] / 2;
  result.middle[parameter] += (upper ? 1 : -1) * result.half[parameter];
  return result;
}

/// direction . x > direction . y over the box.
bool separated(const Box& box, const std::array<Integer, 3>& direction) {
  const auto product = [&](const std::array<Integer, 3>& p) {
    return Integer(direction[0] * p[0] + direction[1] * p[1] + direction[2] * p[2]);
  };
  Integer least = product(box.nets[0][0][0]);
  Integer most = product(box.nets[1][0][0]);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      least = std::min(least, product(box.nets[0][i][j]));
      most = std::max(most, product(box.nets[1][i][j]));
    }
  }
  return (least << (2 * box.levels[1])) > (most << (2 * box.levels[0]));
}

class Cover {
 public:
  explicit Cover(const Certificate& certificate) : certificate_(certificate) {}

  void check() {
    const Rational half(1, 2);
    check({integer_nets(certificate_.patches), {}, {half, half, half, half}, {half, half, half, half}}, 0);
    require(next_ == certificate_.cover.size(), place("cover", next_), "beyond the end of the subdivision");
  }

 private:
  void check(const Box& box, int depth) {
    const std::string where = place("cover", next_);
    const Cell& cell = element(certificate_.cover, next_, where, "the subdivision is not complete");
    ++next_;
    if (cell.kind == Cell::Kind::split) {
      require(depth < 400, where, "deeper than 400 levels");
      check(half_of(box, cell.index, false), depth + 1);
      check(half_of(box, cell.index, true), depth + 1);
    } else if (cell.kind == Cell::Kind::tube) {
      const auto& tube = element(certificate_.tubes, cell.index, where, "names no tube");
      require(tube.contains(box.middle, box.half), where, "the cell is not in the tube");
    } else {
      require(separated(box, cell.direction), where,
              "the direction does not separate the patches over the cell");
    }
  }

  const Certificate& certificate_;
  std::size_t next_ = 0;
};

}  // namespace

void check_cover(const Certificate& certificate) { Cover(certificate).check(); }

}  // namespace exsect::checker
