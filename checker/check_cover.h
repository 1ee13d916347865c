// The subdivision of [0,1]^4: every leaf holds no solution, or lies in a tube or in a star.
#pragma once

#include "replay.h"

namespace exsect::checker {

template <class N>
class Cover {
 public:
  explicit Cover(const Replay<N>& replay) : replay_(replay), certificate_(replay.certificate) {
    for (std::size_t n = 0; n < 2; ++n) {
      const ControlNet net = whole(n);
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
          for (std::size_t d = 0; d < 3; ++d)
            whole_.nets[n][i][j][d] = N(Rational(net[i][j][d] - replay.origin[d]));
    }
  }

  void check() {
    check(whole_);
    require(next_ == certificate_.cover.size(), "$.cover", "beyond the end of the subdivision");
  }

 private:
  struct Region {
    std::array<Net<N>, 2> nets;  // control points of both patches over the cell
    Vector4<double> middle = {0.5, 0.5, 0.5, 0.5};
    Vector4<double> half = {0.5, 0.5, 0.5, 0.5};
  };

  void check(const Region& region) {
    const Cell& cell = element(certificate_.cover, next_, "$.cover", "the subdivision is not complete");
    const std::string where = place("cover", cell.row);
    ++next_;
    const Box<N> box = box_of(region);
    const auto& [u, v, r, s] = box;
    if (cell.kind == Cell::Kind::split) {
      require(region.half[cell.index] > 0x1p-50, where, "halved more than 50 times");
      check(half_of(region, cell.index, false));
      check(half_of(region, cell.index, true));
    } else if (cell.kind == Cell::Kind::excluded) {
      require(separated(region, cell.direction), where,
              "the direction does not separate the patches over the cell");
    } else if (cell.kind == Cell::Kind::star) {
      check_in_star(box, element(certificate_.stars, cell.index, where, "names no star"), where);
    } else if (cell.kind == Cell::Kind::sheet) {
      const auto& overlaps = certificate_.overlaps;
      require(
          std::any_of(overlaps.begin(), overlaps.end(), [&](const auto& o) { return o.seam == cell.index; }),
          where, "names no overlap");
      check_in_star(box, certificate_.seams[cell.index], where);
    } else if (cell.kind == Cell::Kind::tube) {
      check_in_tube(box, cell.index, where);
    } else {
      require(certificate_.self, where, "of one patch only");
      if (cell.kind == Cell::Kind::mirrored)
        check_in_tube({r, s, u, v}, cell.index, where);
      else if (cell.kind == Cell::Kind::lower)
        require(region.middle[0] + region.half[0] <= region.middle[2] - region.half[2], where,
                "not below the diagonal");
      else
        check_injective(box, cell.direction, where);
    }
  }

  /// The control points of a patch; where one of its parameters is fixed, of its line.
  ControlNet whole(std::size_t patch) const {
    ControlNet net = certificate_.patches[patch].net();
    if (!certificate_.fixed || certificate_.fixed->parameter / 2 != patch) return net;
    const Rational& t = certificate_.fixed->value;
    const bool rows = certificate_.fixed->parameter % 2 == 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto at = [&](std::size_t m) -> Point& { return rows ? net[m][i] : net[i][m]; };
      for (std::size_t d = 0; d < 3; ++d)
        at(0)[d] = (1 - t) * (1 - t) * at(0)[d] + 2 * t * (1 - t) * at(1)[d] + t * t * at(2)[d];
      at(1) = at(2) = at(0);
    }
    return net;
  }

  /// The cell, exactly: its numbers are multiples of 2^-51.
  Box<N> box_of(const Region& region) const {
    Box<N> box;
    for (std::size_t i = 0; i < 4; ++i) box[i] = {N(region.middle[i]), N(region.half[i])};
    if (const auto& fixed = certificate_.fixed) box[fixed->parameter] = {N(fixed->value), N(0)};
    return box;
  }

  /// The lower or upper half of the region in the parameter.
  Region half_of(Region region, std::size_t parameter, bool upper) const {
    Net<N>& net = region.nets[parameter / 2];
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t d = 0; d < 3; ++d) {
        const auto at = [&](std::size_t m) -> N& { return parameter % 2 == 0 ? net[m][i][d] : net[i][m][d]; };
        const N a = half_ * (at(0) + at(1));
        const N b = half_ * (at(1) + at(2));
        at(upper ? 0 : 2) = half_ * (a + b);
        at(1) = upper ? b : a;
      }
    }
    double& half = region.half[parameter];
    half /= 2;
    region.middle[parameter] += upper ? half : -half;
    return region;
  }

  /// direction . x > direction . y over the region.
  static bool separated(const Region& region, const std::array<int, 3>& direction) {
    const Vector3<N> n = {direction[0], direction[1], direction[2]};
    N below = -dot(n, region.nets[0][0][0]);  // -min of x
    N above = dot(n, region.nets[1][0][0]);
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        below = larger(below, N(-dot(n, region.nets[0][i][j])));
        above = larger(above, dot(n, region.nets[1][i][j]));
      }
    }
    return below + above < 0;
  }

  static void check_in_star(const Box<N>& box, const Star& star, const std::string& where) {
    for (std::size_t j = 0; j < 4; ++j) {
      Ball<N> e;
      for (std::size_t i = 0; i < 4; ++i)
        if (star.coordinates[j][i] != 0)
          e = e + Ball<N>{N(star.coordinates[j][i]), N(0)} * (box[i] - Ball<N>{N(star.at[i]), N(0)});
      require(e.magnitude() <= 1, where, "the cell is not in the star");
    }
  }

  void check_in_tube(const Box<N>& box, std::size_t i, const std::string& where) const {
    const Tube<N>& tube = element(replay_.tubes, i, where, "names no tube").claim;
    Box<N> w = box;
    require(tube.chart != Chart::star, where, "a tube of a star");
    if (tube.chart != Chart::pair) w = pairs_in_chart(tube, replay_.map(tube), halves(tube.chart, box));
    require(tube.contains(w), where, "the cell is not in the tube");
  }

  /// P and Q are independent wherever the pairs of the box are: a P + b Q = 0 for a = b = 0 alone.
  void check_injective(const Box<N>& box, const std::array<int, 3>& direction,
                       const std::string& where) const {
    const Vector3<N> n = {direction[0], direction[1], direction[2]};
    require(volume(n, replay_.equation[1], halves(Chart::first, box)).sign() != 0, where,
            "different points of the cell may have the same place");
  }

  const Replay<N>& replay_;
  const Certificate<N>& certificate_;
  const N half_ = N(0.5);
  Region whole_;
  std::size_t next_ = 0;
};

}  // namespace exsect::checker
