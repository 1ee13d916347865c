// The subdivision of [0,1]^4: every leaf holds no solution, or lies in a tube.
#include "replay.h"

namespace exsect::checker {
namespace {

template <class N>
struct Box {
  std::array<Net<N>, 2> nets;  // control points of both patches over the cell
  Vector4<N> middle;
  Vector4<N> half;
};

template <class N>
class Cover {
 public:
  explicit Cover(const Replay<N>& replay)
      : cells_(replay.certificate.cover), tubes_(replay.certificate.tubes) {
    for (std::size_t n = 0; n < 2; ++n) {
      const ControlNet net = whole(replay.certificate, n);
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
          for (std::size_t d = 0; d < 3; ++d)
            whole_.nets[n][i][j][d] = N(Rational(net[i][j][d] - replay.origin[d]));
    }
    whole_.middle.fill(half_);
    whole_.half.fill(half_);
    if (const auto& fixed = replay.certificate.fixed) {
      whole_.middle[fixed->parameter] = N(fixed->value);
      whole_.half[fixed->parameter] = 0;
    }
  }

  void check() {
    check(whole_, 0);
    require(next_ == cells_.size(), place("cover", next_), "beyond the end of the subdivision");
  }

 private:
  void check(const Box<N>& box, int depth) {
    const std::string where = place("cover", next_);
    const Cell& cell = element(cells_, next_, where, "the subdivision is not complete");
    ++next_;
    if (cell.kind == Cell::Kind::split) {
      require(depth < 400, where, "deeper than 400 levels");
      check(half_of(box, cell.index, false), depth + 1);
      check(half_of(box, cell.index, true), depth + 1);
    } else if (cell.kind == Cell::Kind::tube) {
      const Tube<N>& tube = element(tubes_, cell.index, where, "names no tube");
      require(tube.contains(box.middle, box.half), where, "the cell is not in the tube");
    } else {
      require(separated(box, cell.direction), where,
              "the direction does not separate the patches over the cell");
    }
  }

  /// The control points of a patch; where one of its parameters is fixed, of its line.
  static ControlNet whole(const Certificate<N>& certificate, std::size_t patch) {
    ControlNet net = certificate.patches[patch].net();
    if (!certificate.fixed || certificate.fixed->parameter / 2 != patch) return net;
    const Rational& t = certificate.fixed->value;
    const bool rows = certificate.fixed->parameter % 2 == 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto at = [&](std::size_t m) -> Point& { return rows ? net[m][i] : net[i][m]; };
      for (std::size_t d = 0; d < 3; ++d)
        at(0)[d] = (1 - t) * (1 - t) * at(0)[d] + 2 * t * (1 - t) * at(1)[d] + t * t * at(2)[d];
      at(1) = at(2) = at(0);
    }
    return net;
  }

  /// The lower or upper half of the box in the parameter.
  Box<N> half_of(Box<N> box, std::size_t parameter, bool upper) const {
    Net<N>& net = box.nets[parameter / 2];
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t d = 0; d < 3; ++d) {
        const auto at = [&](std::size_t m) -> N& { return parameter % 2 == 0 ? net[m][i][d] : net[i][m][d]; };
        const N a = half_ * (at(0) + at(1));
        const N b = half_ * (at(1) + at(2));
        at(upper ? 0 : 2) = half_ * (a + b);
        at(1) = upper ? b : a;
      }
    }
    N& half = box.half[parameter];
    half = half_ * half;
    box.middle[parameter] += upper ? half : N(-half);
    return box;
  }

  /// direction . x > direction . y over the box.
  static bool separated(const Box<N>& box, const std::array<int, 3>& direction) {
    const Vector3<N> n = {direction[0], direction[1], direction[2]};
    N below = -dot(n, box.nets[0][0][0]);  // -min of x
    N above = dot(n, box.nets[1][0][0]);
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        below = larger(below, N(-dot(n, box.nets[0][i][j])));
        above = larger(above, dot(n, box.nets[1][i][j]));
      }
    }
    return below + above < 0;
  }

  const std::vector<Cell>& cells_;
  const std::vector<Tube<N>>& tubes_;
  const N half_ = N(0.5);
  Box<N> whole_;
  std::size_t next_ = 0;
};

}  // namespace

template <class N>
void check_cover(const Replay<N>& replay) {
  Cover<N>(replay).check();
}
template void check_cover(const Replay<Rational>&);
template void check_cover(const Replay<Enclosure>&);

}  // namespace exsect::checker
