// The subdivision of [0,1]^4: every leaf holds no solution, or lies in a tube, in a star or in an overlap.
#pragma once

#include "check_tubes.h"

namespace exsect::checker {

template <class N>
class Cover {
 public:
  explicit Cover(const Replay<N>& replay) : replay_(replay), certificate_(replay.certificate) {
    whole_.box = box_around<double>({0.5, 0.5, 0.5, 0.5}, 0.5);
    for (std::size_t n = 0; n < 2; ++n) {
      const ControlNet net = whole(n);
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
          for (std::size_t d = 0; d < 3; ++d)
            whole_.nets[n][i][j][d] = N(Rational(net[i][j][d] - replay.origin[d]));
    }
  }

  /// Counts the cells that lie in something, and the other leaves.
  void check(std::size_t& covered, std::size_t& excluded) {
    check(whole_);
    if (next_ != certificate_.cover.size())
      throw Rejected("$.cover", "beyond the end of the subdivision", Violation::cover);
    for (const Cell& cell : certificate_.cover) {
      if (cell.kind == Kind::tube || cell.kind == Kind::mirrored || cell.kind == Kind::star ||
          cell.kind == Kind::sheet)
        ++covered;
      else if (cell.kind != Kind::split)
        ++excluded;
    }
  }

 private:
  using Kind = Cell::Kind;
  struct Region {
    std::array<Net<N>, 2> nets;  // control points of both patches over the cell
    Box<double> box;
  };

  void check(const Region& region) {
    if (next_ == certificate_.cover.size())
      throw Rejected("$.cover", "the subdivision is not complete", Violation::cover);
    const Cell& cell = certificate_.cover[next_++];
    if (cell.kind == Kind::split) {
      for (const bool upper : {false, true}) check(half_of(region, cell, upper));
    } else {
      leaf(cell, region);
    }
  }

  void leaf(const Cell& cell, const Region& region) const {
    const auto check = [&] {
      if (cell.kind == Kind::excluded)
        require(separated(region, cell.direction),
                "the direction does not separate the patches over the cell");
      else if (cell.kind == Kind::tube)
        check_in_tube(box_of(region), cell.index);
      else if (cell.kind == Kind::star)
        check_in_star(box_of(region), element(replay_.stars, cell.index, "names no star"));
      else if (cell.kind == Kind::sheet)
        check_on_plane(box_of(region), element(certificate_.overlaps, cell.index, "names no overlap").factor);
      else
        of_one_patch(cell, box_of(region));
    };
    replayed("$.cover", cell.row, check, Violation::cover);
  }

  void of_one_patch(const Cell& cell, const Box<N>& box) const {
    require(certificate_.self, "of one patch only");
    const auto& [u, v, r, s] = box;
    const Vector3<N> n = {cell.direction[0], cell.direction[1], cell.direction[2]};
    if (cell.kind == Kind::mirrored)
      check_in_tube({r, s, u, v}, cell.index);
    else if (cell.kind == Kind::lower)
      require(u.middle + u.radius <= r.middle - r.radius, "not below the diagonal");
    else  // P and Q are independent wherever the pairs of the box are: a P + b Q = 0 for a = b = 0 alone.
      require(volume(n, replay_.equation[1], halves(Chart::first, box)).sign() != 0,
              "different points of the cell may have the same place");
  }

  /// The control points of a patch; where one of its parameters is fixed, of its line.
  ControlNet whole(std::size_t patch) const {
    ControlNet net = certificate_.nets[patch];
    if (!certificate_.fixed || certificate_.fixed->parameter / 2 != patch) return net;
    const Rational& t = certificate_.fixed->value;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t d = 0; d < 3; ++d) {
        const auto at = [&](std::size_t m) -> Rational& {
          return entry(net, certificate_.fixed->parameter, m, i)[d];
        };
        at(0) = (1 - t) * (1 - t) * at(0) + 2 * t * (1 - t) * at(1) + t * t * at(2);
        at(1) = at(2) = at(0);
      }
    }
    return net;
  }

  /// The cell, exactly.
  Box<N> box_of(const Region& region) const {
    Box<N> box = exactly<N>(region.box);
    if (const auto& fixed = certificate_.fixed) box[fixed->parameter] = N(fixed->value);
    return box;
  }

  /// Row m in the direction of the parameter.
  template <class Any>
  static auto& entry(Any& net, std::size_t parameter, std::size_t m, std::size_t i) {
    return parameter % 2 == 0 ? net[m][i] : net[i][m];
  }

  /// The lower or upper half of the region, by de Casteljau's algorithm.
  Region half_of(const Region& region, const Cell& cell, bool upper) const {
    const auto box = [&] {
      require(!certificate_.fixed || certificate_.fixed->parameter != cell.index,
              "halved in the fixed parameter");
      return checker::half_of(region.box, cell.index, upper);
    };
    Region result = {region.nets, replayed("$.cover", cell.row, box, Violation::cover)};
    Net<N>& net = result.nets[cell.index / 2];
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t d = 0; d < 3; ++d) {
        const auto at = [&](std::size_t m) -> N& { return entry(net, cell.index, m, i)[d]; };
        const N a = half(at(0) + at(1));
        const N b = half(at(1) + at(2));
        at(upper ? 0 : 2) = half(a + b);
        at(1) = upper ? b : a;
      }
    }
    return result;
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

  /// All solutions in the cell are on the plane.
  void check_on_plane(const Box<N>& box, std::size_t factor) const {
    require(independent(factor_maps<N>(certificate_.factors[factor]).columns, box),
            "there may be solutions beside the plane");
  }

  static void check_in_star(const Box<N>& box, const StarMaps<N>& star) {
    for (const Ball<N>& e : star.frame.of(box)) require(e.magnitude() <= 1, "the cell is not in the star");
  }

  void check_in_tube(const Box<N>& box, std::size_t i) const {
    const Tube<N>& tube = element(replay_.tubes, i, "names no tube").claim;
    require(tube.chart != Chart::star, "a tube of a star");
    require(tube.contains(tube.chart == Chart::pair
                              ? box
                              : pairs_in_chart(tube, replay_.tubes[i].map, halves(tube.chart, box))),
            "the cell is not in the tube");
  }

  const Replay<N>& replay_;
  const Certificate<N>& certificate_;
  Region whole_;
  std::size_t next_ = 0;
};

}  // namespace exsect::checker
