#include "trace/tube.h"

#include <exsect/algebra/rounding_bounds.h>

#include <algorithm>
#include <cmath>

#include "trace/tube_derivatives.h"
#include "trace/tube_evaluation.h"
#include "trace/tube_line_bounds.h"
#include "trace/tube_prediction.h"

namespace exsect {

namespace {

using namespace tubes;

/// Tubes are wide enough to contain the boxes of landmarks and fibre points, of widths 2^-50, 2^-100, 2^-200
/// and 2^-700.
template <class Ball>
constexpr double kLeastHalfwidth = 0x1p-49;
template <>
inline constexpr double kLeastHalfwidth<DoubleDoubleBall> = 0x1p-99;
template <long Bits>
inline constexpr double kLeastHalfwidth<ArbBall<Bits>> = Bits > 256 ? 0x1p-699 : 0x1p-199;

/// Half widths that are tried, each time this much wider than the image of the last ones.
constexpr int kMostWidths = 5;
constexpr double kWidening = 1.5;
/// Tubes are wider than their points are uncertain, by this factor, so that these are known to be inside.
constexpr double kRoom = 8;

/// The longer one of the two normal vectors, of length about 1, and two axes of space: an invertible matrix,
/// or the identity where both normal vectors vanish.
template <class Ball>
BallMatrix<Ball> normal_basis(const Expansion<Ball>& at) {
  const BallVector<Ball> nx = cross(at.x[3], at.x[1]);
  const BallVector<Ball> ny = cross(at.y[3], at.y[1]);
  const BallVector<Ball>& n = largest_magnitude(nx) > largest_magnitude(ny) ? nx : ny;
  std::size_t largest = 0;
  for (std::size_t k = 1; k < 3; ++k) {
    if (std::fabs(n[k].approximation()) > std::fabs(n[largest].approximation())) {
      largest = k;
    }
  }
  BallMatrix<Ball> basis;
  for (std::size_t k = 0; k < 3; ++k) {
    basis[k][k] = Ball(1);
  }
  const double length = std::fabs(n[largest].approximation());
  if (length > 0x1p-900) {
    const Ball scale(std::ldexp(1.0, -std::ilogb(length)));
    basis[largest] = {(scale * n[0]).midpoint(), (scale * n[1]).midpoint(), (scale * n[2]).midpoint()};
  }
  return basis;
}

/// About how well points of the curve on the tube can be enclosed.
template <class Ball>
double uncertainty(const Tube<Ball>& tube) {
  double largest = 0;
  for (const double tau : {0.0, tube.reach}) {
    const Ball sigma(tau / tube.scale);
    BallPoint<Ball> at;
    for (std::size_t j = 0; j < 4; ++j) {
      at[j] = on_line(tube, j, sigma).midpoint();
    }
    const BallVector<Ball> f = premultiplied_value(tube, preconditioner_at(tube, sigma), at);
    largest = larger_bound(largest, f[0].radius(), f[1].radius(), f[2].radius());
  }
  return largest;
}

/// The image f + E Z of Krawczyk's operator by rows, whether it lies strictly inside Z, and the largest row
/// sum of E.
struct Image {
  Row3 bound;
  bool inside;
  double contraction;
};
template <class Ball>
Image krawczyk_image(const Tube<Ball>& tube, const std::array<std::size_t, 3>& others, const Row3& f,
                     const std::array<Row3, 4>& e) {
  Image image{{}, true, 0};
  for (std::size_t row = 0; row < 3; ++row) {
    double sum = 0;
    double reached = f[row];
    for (const std::size_t j : others) {
      sum += e[j][row];
      reached += e[j][row] * tube.halfwidth[j];
    }
    image.bound[row] = kSlack * reached;
    image.inside = image.inside && image.bound[row] < tube.halfwidth[others[row]];
    image.contraction = larger_bound(image.contraction, kSlack * sum);
  }
  return image;
}

/// Proves the tube around its line over its reach, if the bounds allow it.
template <class Ball>
bool certify(Tube<Ball>& tube, const AlongLine& along, double least_halfwidth) {
  const auto others = other_axes(tube.axis);
  const double least = std::max({least_halfwidth, kLeastHalfwidth<Ball>, kRoom * uncertainty(tube)});
  Row3 f{};
  tube.halfwidth = {};
  for (std::size_t row = 0; row < 3; ++row) {
    f[row] = kSlack * along.residual[row].value;
    tube.halfwidth[others[row]] = std::max(2 * f[row], least);
  }
  for (int attempt = 0; attempt < kMostWidths; ++attempt) {
    const auto e = column_bounds(tube, along, &SeriesBound::value);
    const Image image = krawczyk_image(tube, others, f, e);
    tube.contraction = image.contraction;
    if (!(image.contraction < 1)) {
      return false;
    }
    if (image.inside) {
      tube.deviation = e;
      return true;
    }
    for (std::size_t row = 0; row < 3; ++row) {
      double& z = tube.halfwidth[others[row]];
      z = std::max(z, kWidening * image.bound[row]);
    }
  }
  return false;
}

/// The coefficients of a line that is far too long for the curve, up to the power 60, are no doubles.
bool overflows(const AlongLine& along) {
  return std::any_of(along.residual.begin(), along.residual.end(),
                     [](const SeriesBound& bound) { return !std::isfinite(bound.value); });
}
constexpr double kShorter = 0x1p10;

/// A tube's line and what is left along it, before anything is proved.
template <class Ball>
struct FittedTube {
  Tube<Ball> tube;
  LineRemainder<Ball> left;
};

/// A tube with nothing but its place and its nets.
template <class Ball>
std::optional<Tube<Ball>> tube_without_line(const PairSystem<Ball>& system, const BallPoint<Ball>& centre,
                                            std::size_t axis, double reach) {
  Tube<Ball> tube;
  tube.axis = axis;
  tube.reach = reach;
  for (std::size_t j = 0; j < 4; ++j) {
    tube.centre[j] = centre[j].midpoint();
  }
  const Expansion<Ball> at(system, tube.centre);
  tube.orientation = at.tangent()[axis].certain_sign();
  if (tube.orientation == 0) {
    return std::nullopt;
  }
  const BallMatrix<Ball> basis = normal_basis(at);
  tube.space = at.x;
  for (std::size_t i = 0; i < 9; ++i) {
    tube.nets[0][i] = preconditioned(basis, at.x[i]);
    tube.nets[1][i] = preconditioned(basis, BallVector<Ball>{-at.y[i][0], -at.y[i][1], -at.y[i][2]});
  }
  return tube;
}

template <class Ball>
std::optional<FittedTube<Ball>> fit_tube(const PairSystem<Ball>& system, const BallPoint<Ball>& centre,
                                         std::size_t axis, double reach) {
  auto tube = tube_without_line(system, centre, axis, reach);
  auto left = tube ? fit_line(*tube) : std::nullopt;
  return left ? std::optional(FittedTube<Ball>{std::move(*tube), std::move(*left)}) : std::nullopt;
}

}  // namespace

template <class Ball>
std::optional<Tube<Ball>> certify_tube(const PairSystem<Ball>& system, const BallPoint<Ball>& centre,
                                       std::size_t axis, double reach, double least_halfwidth) {
  auto fitted = fit_tube(system, centre, axis, reach);
  if (!fitted) {
    return std::nullopt;
  }
  const AlongLine along = along_line(fitted->tube, fitted->left);
  if (!certify(fitted->tube, along, least_halfwidth)) {
    return std::nullopt;
  }
  bound_derivatives(fitted->tube, along);
  return std::move(fitted->tube);
}

template <class Ball>
double largest_reach(const PairSystem<Ball>& system, const BallPoint<Ball>& centre, std::size_t axis,
                     double least, double most, double least_halfwidth, double worst_contraction) {
  auto fitted = fit_tube(system, centre, axis, most);
  if (!fitted) {
    return 0;
  }
  fitted->left.underflow = 0;  // the answer is an estimate
  const auto certified = [&](int halvings) {
    fitted->tube.reach = std::ldexp(most, -halvings);
    return certify(fitted->tube, along_line(fitted->tube, fitted->left), least_halfwidth) &&
           fitted->tube.contraction <= worst_contraction;
  };
  int good = std::ilogb(most / least);
  if (!certified(good)) {
    return most > kShorter * least && overflows(along_line(fitted->tube, fitted->left))
               ? largest_reach(system, centre, axis, least, most / kShorter, least_halfwidth,
                               worst_contraction)
               : 0;
  }
  for (int bad = -1; good - bad > 1;) {
    const int middle = (good + bad) / 2;
    (certified(middle) ? good : bad) = middle;
  }
  return std::ldexp(most, -good);
}

template <class Ball>
std::optional<BallPoint<Ball>> predicted(const PairSystem<Ball>& system, const BallPoint<Ball>& from,
                                         std::size_t axis, double tau) {
  auto tube = tube_without_line(system, from, axis, std::fabs(tau));
  if (!tube || !fit_line_alone(*tube)) {
    return std::nullopt;
  }
  BallPoint<Ball> point;
  for (std::size_t j = 0; j < 4; ++j) {
    point[j] = (tube->centre[j] + on_line(*tube, j, Ball(tau / tube->scale))).midpoint();
  }
  return point;
}

template <class Ball>
std::optional<BallPoint<Ball>> newton_corrected(const PairSystem<Ball>& system, const BallPoint<Ball>& start,
                                                std::size_t axis, int steps) {
  const auto others = other_axes(axis);
  return newton_steps<Ball>(start, axis, steps, [&](const BallPoint<Ball>& p) {
    const Expansion<Ball> at(system, p);
    const auto c =
        approximate_inverse<Ball>({at.column(others[0]), at.column(others[1]), at.column(others[2])});
    return c ? std::optional(preconditioned(*c, at.value())) : std::nullopt;
  });
}

#define EXSECT_INSTANTIATE_TUBE(Ball)                                                                       \
  template std::optional<Tube<Ball>> certify_tube(const PairSystem<Ball>&, const BallPoint<Ball>&,          \
                                                  std::size_t, double, double);                             \
  template double largest_reach(const PairSystem<Ball>&, const BallPoint<Ball>&, std::size_t, double,       \
                                double, double, double);                                                    \
  template std::optional<BallPoint<Ball>> predicted(const PairSystem<Ball>&, const BallPoint<Ball>&,        \
                                                    std::size_t, double);                                   \
  template std::optional<BallPoint<Ball>> newton_corrected(const PairSystem<Ball>&, const BallPoint<Ball>&, \
                                                           std::size_t, int);

EXSECT_INSTANTIATE_TUBE(DoubleBall)
EXSECT_INSTANTIATE_TUBE(DoubleDoubleBall)
EXSECT_INSTANTIATE_TUBE(ArbBall<256>)
EXSECT_INSTANTIATE_TUBE(ArbBall<1024>)
#undef EXSECT_INSTANTIATE_TUBE

}  // namespace exsect
