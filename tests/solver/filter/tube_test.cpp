// The certificates in doubles against the curve in 256 bits: Newton's method there is an independent route.
#include "filter/tube.h"

#include <cmath>
#include <optional>

#include "filter/boundary.h"
#include "filter/exact_patch.h"
#include "filter/trace.h"
#include "filter/turning.h"
#include "support/catch.h"
#include "support/random_nets.h"
#include "support/random_pairs.h"
#include "trace/tube.h"

namespace exsect::tube_test {
namespace {

using Fine = ArbBall<256>;
using random_pairs::Generator;

struct Problem {
  filter::Pair pair;
  PairSystem<Fine> system;
  std::vector<filter::BoundaryPoint> points;

  explicit Problem(const random_pairs::Pair& p)
      : pair(filter::make_pair(p.x, p.y).value()),
        system(p.x, p.y, origin(pair.frame), pair.frame.exponent),
        points(boundary(pair)) {}

 private:
  static Point origin(const ModelFrame& frame) {
    return {from_double(frame.origin[0]), from_double(frame.origin[1]), from_double(frame.origin[2])};
  }
  static std::vector<filter::BoundaryPoint> boundary(const filter::Pair& pair) {
    filter::Trees trees{filter::PatchTree(pair.x), filter::PatchTree(pair.y)};
    long boxes = 0;
    return filter::boundary_points(pair, {}, trees, boxes).value();
  }
};

/// The solution near w with the same coordinate `axis`, to some 60 digits.
BallPoint<Fine> solution(const PairSystem<Fine>& system, const filter::Vec4& w, std::size_t axis) {
  BallPoint<Fine> start;
  for (std::size_t j = 0; j < 4; ++j) start[j] = Fine::enclosing(from_double(w[j]) + Rational(1, 2));
  return newton_corrected(system, start, axis, 6).value();
}

double distance(const BallPoint<Fine>& a, const filter::Vec4& b) {
  double result = 0;
  for (std::size_t j = 0; j < 4; ++j) {
    result = std::max(result, (a[j] - Fine::enclosing(from_double(b[j]) + Rational(1, 2))).upper_magnitude());
  }
  return result;
}

/// w' and, by differences over 2^-60, w''.
filter::Vec4 slope(const PairSystem<Fine>& system, const BallPoint<Fine>& w, std::size_t axis) {
  const BallPoint<Fine> t = Expansion<Fine>(system, w).tangent();
  filter::Vec4 result;
  for (std::size_t j = 0; j < 4; ++j) result[j] = t[j].approximation() / t[axis].approximation();
  return result;
}

void check_piece(const Problem& problem, const filter::Piece& piece, Generator& generator) {
  const filter::Tube& tube = piece.tube;
  for (int i = 0; i < 4; ++i) {
    const double t = i == 0 ? 0 : i == 1 ? 1 : static_cast<double>(generator() % 1000) / 1000;
    const double tau = tube.lower + t * (tube.upper - tube.lower);
    const filter::Ball ball = filter::point_at(tube, tau);
    CHECK(ball.radius < 1e-9);
    filter::Vec4 start = ball.middle;
    start[tube.axis] = tube.centre[tube.axis] + tau;
    const BallPoint<Fine> w = solution(problem.system, start, tube.axis);
    CHECK(distance(w, ball.middle) <= ball.radius);
    const filter::Vec4 d = slope(problem.system, w, tube.axis);
    const double step = 0x1p-20;
    start[tube.axis] += step;
    const filter::Vec4 next = slope(problem.system, solution(problem.system, start, tube.axis), tube.axis);
    for (std::size_t j = 0; j < 4; ++j) {
      CHECK(std::fabs(d[j] - tube.slope[j]) <= tube.slope_error[j] + 1e-12);
      CHECK(std::fabs(ball.middle[j] - tube.centre[j] - tau * tube.slope[j]) <=
            tube.inner[j] + 2 * ball.radius);
      const double second = (next[j] - d[j]) / step;
      CHECK(std::fabs(second - tube.second[j]) <= tube.second_error[j] * (1 + 1e-3) + 1e-6);
    }
  }
}

}  // namespace

TEST_CASE("filter tube: enclosures of points and derivatives hold the curve") {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    INFO("seed " << seed);
    Generator generator(seed);
    const Problem problem(seed % 2 == 0 ? random_pairs::doubles(generator)
                                        : random_pairs::scattered(generator));
    for (std::size_t i = 0; i < problem.points.size(); ++i) {
      const auto trace = filter::trace_arc(problem.pair, problem.points, i);
      REQUIRE(trace);
      for (const filter::Piece& piece : trace->pieces) check_piece(problem, piece, generator);
    }
  }
}

TEST_CASE("filter tube: the scale is the quotient of the weights, relative to the centre's") {
  using K = filter::WeightedBiquadratic;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    INFO("seed " << seed);
    Generator generator(seed);
    const random_nets::Nets nets = random_nets::scattered(generator, {2, 2, 2, 2});
    const RationalPatch x = random_nets::weighted(generator, nets.x);
    const RationalPatch y = random_nets::weighted(generator, nets.y);
    const auto pair = filter::make_pair_of<K>(filter::elevated<K>(x), filter::elevated<K>(y));
    REQUIRE(pair);
    filter::TreesOf<K> trees{filter::PatchTreeOf<K>(pair->x, pair->net_error),
                             filter::PatchTreeOf<K>(pair->y, pair->net_error)};
    long boxes = 0;
    const auto points = filter::boundary_points<K>(*pair, {}, trees, boxes);
    REQUIRE(points);
    for (std::size_t i = 0; i < points->size(); ++i) {
      const auto trace = filter::trace_arc<K>(*pair, *points, i, nullptr);
      REQUIRE(trace);
      for (const auto& piece : trace->pieces) {
        const auto& tube = piece.tube;
        const double tau = piece.range.to();
        const auto ball = filter::point_at(tube, tau);
        const auto& w = ball.middle;
        const double weight = filter::value_at<K>(pair->x.power, w[0], w[1])[3];
        const double other = filter::value_at<K>(pair->y.power, w[2], w[3])[3];
        CHECK(std::fabs(w[4] - weight / (filter::kScaleUnit * other)) <= 64 * ball.radius);
        CHECK(std::fabs(w[4] / tube.centre[4] - 1 - tau * tube.slope[4]) <= tube.inner[4] + 64 * ball.radius);
        CHECK(filter::contains(tube, ball));
        CHECK_FALSE(filter::excludes(tube, ball));
        auto beside = ball;
        beside.middle[4] += 1.5 * tube.centre[4] * tube.halfwidth[4];
        beside.middle[4] += std::fabs(tube.centre[4] * tube.inner[4]);
        CHECK_FALSE(filter::contains(tube, beside));
        CHECK(filter::excludes(tube, beside));
      }
    }
  }
}

TEST_CASE("filter boundary: every ball holds a solution on its side") {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    INFO("seed " << seed);
    Generator generator(seed);
    const Problem problem(random_pairs::scattered(generator));
    for (const filter::BoundaryPoint& point : problem.points) {
      CHECK(point.ball.middle[point.parameter] == point.side);
      CHECK(distance(solution(problem.system, point.ball.middle, point.parameter), point.ball.middle) <=
            point.ball.radius);
    }
  }
}

TEST_CASE("filter turning: the component of the tangent changes its sign between the offsets") {
  int found = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    INFO("seed " << seed);
    Generator generator(seed);
    const Problem problem(random_pairs::scattered(generator));
    for (std::size_t i = 0; i < problem.points.size(); ++i) {
      auto trace = filter::trace_arc(problem.pair, problem.points, i);
      REQUIRE(trace);
      std::vector<filter::Turn> turns;
      REQUIRE(filter::find_turns(problem.pair, *trace, {0, 1, 2, 3}, turns) == filter::TurnSearch::done);
      for (const filter::Turn& turn : turns) {
        ++found;
        const filter::Tube& tube = trace->pieces[turn.piece].tube;
        const auto component = [&](double tau) {
          filter::Vec4 w = turn.ball.middle;
          w[tube.axis] = tube.centre[tube.axis] + tau;
          const BallPoint<Fine> exact = solution(problem.system, w, tube.axis);
          CHECK(distance(exact, turn.ball.middle) <= turn.ball.radius);
          const BallPoint<Fine> t = Expansion<Fine>(problem.system, exact).tangent();
          return t[turn.parameter].certain_sign() * t[tube.axis].certain_sign();
        };
        CHECK(component(turn.from) * component(turn.to) == -1);
      }
    }
  }
  CHECK(found > 30);
}

TEST_CASE("filter tube: a certificate fails where the curve is not alone or not there") {
  // Two sheets of height a² = e over the plane: at e = 2^-20 no region that holds both.
  ControlNet c{};
  c[1][0] = Point{1, 0, -1};
  c[2][0] = Point{0, 0, 1};
  c[0][1] = Point{0, 1, 0};
  c[0][0] = Point{0, 0, Rational(1, 4) - power_of_two(-20)};
  ControlNet plane{};
  plane[1][0] = Point{1, 0, 0};
  plane[0][1] = Point{0, 1, 0};
  const auto pair =
      filter::make_pair(BezierPatch::from_power_basis(c), BezierPatch::from_power_basis(plane)).value();
  filter::Tube tube;
  const filter::Vec4 on_one = {0x1p-10, 0, 0x1p-10, 0};
  REQUIRE(filter::prepare(pair, on_one, 1, tube));
  const auto certified = [&](double width) {
    return filter::certify(pair, tube, -0.25, 0.25, {width, width, width, width});
  };
  CHECK(certified(0x1p-12));
  CHECK_FALSE(certified(0x1p-9));
  CHECK_FALSE(certified(1));
  // Beside the curve by more than the half width, and with no half width at all.
  REQUIRE(filter::prepare(pair, {0x1p-10 + 0x1p-12, 0, 0x1p-10 + 0x1p-12, 0}, 1, tube));
  CHECK_FALSE(certified(0x1p-14));
  CHECK_FALSE(certified(0));
}

}  // namespace exsect::tube_test
