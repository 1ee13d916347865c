// The subdivision of [0,1]^4: every leaf holds no solution, or lies in a tube's box, in a star or in an
// overlap.
#pragma once

#include "check_tubes.h"

namespace exsect::checker {

template <class N>
class Cover {
 public:
  explicit Cover(const Replay<N>& replay) : replay_(replay), certificate_(replay.certificate) {
    whole_.box = box_around<double>({0.5, 0.5, 0.5, 0.5}, 0.5);
    if (certificate_.equation) start_section();
    for (std::size_t n = 0; n < 2 && !certificate_.equation; ++n) {
      WeightedNet<Rational> net = whole(n);
      net.move_by_minus(replay.origin);
      nets_[n] = {in_numbers(net.points), in_numbers(net.weights)};
      whole_.nets[n] = &nets_[n];
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
  /// A cell with its nets, which others share.
  struct Region {
    std::array<const WeightedNet<N>*, 2> nets = {};  // control points of both patches over the cell
    Box<double> box;
    const SectionNet<N>* section = nullptr;  // of an equation instead: Bernstein coefficients of F_1
  };

  /// The square where r = s = 1/2.
  void start_section() {
    whole_.box[2].radius = whole_.box[3].radius = 0;
    const Net<Rational>& net = certificate_.nets[0].points;
    const auto d = static_cast<std::size_t>(degree(*certificate_.equation));
    const Polynomial section = component(replay_.exact, 0);
    section_ = in_numbers(section_net(section, d * net.degree(0), d * net.degree(1)));
    whole_.section = &*section_;
  }

  void check(const Region& region) {
    if (next_ == certificate_.cover.size())
      throw Rejected("$.cover", "the subdivision is not complete", Violation::cover);
    const Cell& cell = certificate_.cover[next_++];
    if (cell.kind != Kind::split) return leaf(cell, region);
    const std::size_t patch = cell.index / 2;
    if (region.section)
      check_halves(
          region, cell, cell.index, *region.section, [](Region & half) -> auto& { return half.section; });
    else
      check_halves(
          region, cell, cell.index % 2,
          *region.nets[patch], [&](Region & half) -> auto& { return half.nets[patch]; });
  }
  /// The lower half, then the upper one: `net`, that of the region, is halved in the direction p, and goes to
  /// place(half).
  template <class Net, class Place>
  void check_halves(const Region& region, const Cell& cell, std::size_t p, Net net, const Place& place) {
    std::array<Region, 2> halves = {region, region};
    const auto boxes = [&] {
      require(!certificate_.fixed || certificate_.fixed->parameter != cell.index,
              "halved in the fixed parameter");
      for (const std::size_t upper : {0, 1}) halves[upper].box = half_of(region.box, cell.index, upper == 1);
    };
    replayed("$.cover", cell.row, boxes, Violation::cover);
    const Net lower = net.split(p);
    place(halves[0]) = &lower;
    place(halves[1]) = &net;
    for (const Region& half : halves) check(half);
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
        of_one_patch(cell, region.box);
    };
    replayed("$.cover", cell.row, check, Violation::cover);
  }

  /// The box's numbers are multiples of 2^-52 up to 1: their sums are exact in doubles.
  void of_one_patch(const Cell& cell, const Box<double>& region) const {
    require(certificate_.self, "of one patch only");
    const Box<N> box = exactly<N>(region);
    const Vector3<N> n = {cell.direction[0], cell.direction[1], cell.direction[2]};
    if (cell.kind == Kind::mirrored)
      check_in_tube({box[2], box[3], box[0], box[1]}, cell.index);
    else if (cell.kind == Kind::lower)
      require(region[0].middle + region[0].radius <= region[2].middle - region[2].radius,
              "not below the diagonal");
    else  // P and Q are independent wherever the pairs of the box are: a P + b Q = 0 for a = b = 0 alone.
      require(volume(n, replay_.divided[0], halves(Chart::first, box)).sign() != 0,
              "different points of the cell may have the same place");
  }

  /// The control points of a patch; where one of its parameters is fixed, of its line.
  WeightedNet<Rational> whole(std::size_t patch) const {
    WeightedNet<Rational> net = certificate_.nets[patch];
    const auto& fixed = certificate_.fixed;
    if (fixed && fixed->parameter / 2 == patch) net.restrict_to(fixed->parameter % 2, fixed->value);
    return net;
  }

  /// The cell, exactly.
  Box<N> box_of(const Region& region) const {
    Box<N> box = exactly<N>(region.box);
    if (const auto& fixed = certificate_.fixed) box[fixed->parameter] = N(fixed->value);
    return box;
  }

  template <std::size_t dimension, std::size_t most>
  static Grid<N, dimension, most> in_numbers(const Grid<Rational, dimension, most>& grid) {
    Grid<N, dimension, most> result(grid.degree(0), grid.degree(1));
    grid.each([&](std::size_t i, std::size_t j) {
      for (std::size_t d = 0; d < dimension; ++d) result[i][j][d] = N(grid[i][j][d]);
    });
    return result;
  }

  /// direction . F > 0 over the region: all its Bernstein coefficients are positive.
  static bool separated(const Region& region, const std::array<int, 3>& direction) {
    const Vector3<N> n = {direction[0], direction[1], direction[2]};
    if (region.section) return positive(*region.section, n[0]);
    const WeightedNet<N>& x = *region.nets[0];
    const WeightedNet<N>& y = *region.nets[1];
    if (x.has_weights() || y.has_weights()) return separated_with_weights(x, y, n);
    N below = -dot(n, x.points[0][0]);  // -min of x
    N above = dot(n, y.points[0][0]);
    x.points.each([&](std::size_t i, std::size_t j) { below = larger(below, N(-dot(n, x.points[i][j]))); });
    y.points.each([&](std::size_t i, std::size_t j) { above = larger(above, dot(n, y.points[i][j])); });
    return below + above < 0;
  }
  /// factor F_1 > 0; both other components of F are 0.
  static bool positive(const SectionNet<N>& section, const N& factor) {
    bool result = true;
    section.each([&](std::size_t i, std::size_t j) { result = result && factor * section[i][j][0] > 0; });
    return result;
  }
  static bool separated_with_weights(const WeightedNet<N>& x, const WeightedNet<N>& y, const Vector3<N>& n) {
    bool result = true;
    x.points.each([&](std::size_t i, std::size_t j) {
      const N a = dot(n, x.points[i][j]);
      y.points.each([&](std::size_t k, std::size_t l) {
        result = result && a * y.weight(k, l) > dot(n, y.points[k][l]) * x.weight(i, j);
      });
    });
    return result;
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
    require(tube.surrounds(tube.chart == Chart::pair
                               ? box
                               : pairs_in_chart(tube, replay_.divided[tube.chart == Chart::first ? 0 : 1],
                                                halves(tube.chart, box))),
            "the cell is not in the tube's box");
  }

  const Replay<N>& replay_;
  const Certificate<N>& certificate_;
  std::array<WeightedNet<N>, 2> nets_;
  std::optional<SectionNet<N>> section_;
  Region whole_;
  std::size_t next_ = 0;
};

}  // namespace exsect::checker
