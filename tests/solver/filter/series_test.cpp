// Taylor polynomials of arcs against the points of the tubes, and vector code against scalar code.
#include "filter/series.h"

#include <cmath>
#include <cstring>
#include <limits>

#include "filter/trace.h"
#include "filter/vertex_scalar.h"
#include "support/catch.h"
#include "support/random_pairs.h"

namespace exsect::series_test {
namespace {

using random_pairs::Generator;

/// Calls check(pair, piece) for every piece of every arc of some random pairs.
template <class Check>
void for_pieces(const Check& check) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    INFO("seed " << seed);
    Generator generator(seed);
    const random_pairs::Pair p =
        seed % 2 == 0 ? random_pairs::doubles(generator) : random_pairs::scattered(generator);
    const filter::Pair pair = filter::make_pair(p.x, p.y).value();
    filter::Trees trees{filter::PatchTree(pair.x), filter::PatchTree(pair.y)};
    long boxes = 0;
    const auto points = filter::boundary_points(pair, {}, trees, boxes).value();
    for (std::size_t i = 0; i < points.size(); ++i) {
      const auto trace = filter::trace_arc(pair, points, i);
      REQUIRE(trace);
      for (const filter::Piece& piece : trace->pieces) check(pair, piece);
    }
  }
}

double distance(const filter::Vec4& a, const filter::Vec4& b) {
  double result = 0;
  for (std::size_t j = 0; j < 4; ++j) result = std::max(result, std::fabs(a[j] - b[j]));
  return result;
}

filter::VertexBlock block_at(const filter::Tube& tube, double from, double to) {
  filter::VertexBlock block{};
  for (int l = 0; l < filter::kVertexBlock; ++l) {
    block.tau[l] = from + (to - from) * l / (filter::kVertexBlock - 1);
  }
  CHECK(std::max(std::fabs(from), std::fabs(to)) <= std::max(-tube.lower, tube.upper));
  return block;
}

bool same(const filter::VertexBlock& a, const filter::VertexBlock& b) {
  return std::memcmp(&a, &b, sizeof a) == 0;
}

}  // namespace

TEST_CASE("filter series: the error is of the ninth order") {
  int compared = 0;
  for_pieces([&](const filter::Pair&, const filter::Piece& piece) {
    const filter::Tube& tube = piece.tube;
    const auto error = [&](double tau) {
      filter::Vec4 offset;
      filter::point_at(tube, tau, &offset);
      return distance(filter::arc_offset(tube, tau), offset);
    };
    const double off_centre = filter::largest(filter::premultiplied_value(tube, {0, 0, 0, 0}));
    for (const double end : {tube.lower, tube.upper}) {
      CHECK(error(end) < 0x1p-9 * std::fabs(end));
      if (error(end) > 0x1p-30) {
        ++compared;
        INFO(error(end / 2) << " of " << error(end));
        CHECK(error(end / 2) < 0x1p-7 * error(end) + 2 * off_centre);
      }
    }
  });
  CHECK(compared > 20);
}

TEST_CASE("filter series: the derivative is that of the offset") {
  for_pieces([](const filter::Pair&, const filter::Piece& piece) {
    const filter::Tube& tube = piece.tube;
    const double tau = 0.7 * tube.upper;
    const double step = 0x1p-20;
    filter::Vec4 difference;
    const filter::Vec4 before = filter::arc_offset(tube, tau - step);
    const filter::Vec4 after = filter::arc_offset(tube, tau + step);
    for (std::size_t j = 0; j < 4; ++j) difference[j] = (after[j] - before[j]) / (2 * step);
    CHECK(distance(filter::arc_slope(tube, tau), difference) < 1e-8);
  });
}

TEST_CASE("filter series: vertices without doubt are within the bound of the tube's points") {
  int proved = 0;
  int doubtful = 0;
  for_pieces([&](const filter::Pair& pair, const filter::Piece& piece) {
    const filter::Tube& tube = piece.tube;
    const double greatest = 1e-7;
    filter::VertexBlock block = block_at(tube, piece.range.from(), piece.range.to());
    filter::evaluate_vertices(filter::vertex_forms(pair, tube, greatest), block);
    for (int l = 0; l < filter::kVertexBlock; ++l) {
      const filter::Ball ball = filter::point_at(tube, block.tau[l]);
      (block.doubt[l] == 0 ? proved : doubtful) += 1;
      const double bound =
          (block.doubt[l] == 0 ? greatest : 1e-3) * tube.contraction / (1 - tube.contraction);
      for (std::size_t j = 0; j < 4; ++j) {
        CHECK(std::fabs(block.parameters[j][l] - 0.5 - ball.middle[j]) <= bound + ball.radius + 1e-15);
      }
      const filter::Vec3 x = filter::expand(pair.x, ball.middle[0], ball.middle[1])[0];
      for (std::size_t c = 0; c < 3; ++c) {
        const double exact = pair.frame.origin[c] + std::ldexp(x[c], static_cast<int>(pair.frame.exponent));
        CHECK(std::fabs(block.point[c][l] - exact) <= 40 * (bound + ball.radius) + 1e-13);
      }
    }
  });
  CHECK(proved > 1000);
  CHECK(doubtful > 0);
}

TEST_CASE("filter series: what exceeds its limit, or is no number, is in doubt") {
  for_pieces([](const filter::Pair& pair, const filter::Piece& piece) {
    const filter::Tube& tube = piece.tube;
    const auto doubts = [&](const filter::VertexForms& forms) {
      filter::VertexBlock block = block_at(tube, piece.range.from(), piece.range.to());
      filter::evaluate_vertices_scalar(forms, block);
      int count = 0;
      for (const double doubt : block.doubt) count += doubt == 0 ? 0 : 1;
      return count;
    };
    const filter::VertexForms wide = filter::vertex_forms(pair, tube, 1);
    CHECK(doubts(wide) == 0);
    filter::VertexForms forms = wide;
    forms.greatest = -1;
    CHECK(doubts(forms) == filter::kVertexBlock);
    for (double& far : (forms = wide).farthest) {
      far = -1;
      CHECK(doubts(forms) == filter::kVertexBlock);
      far = 1;
    }
    forms = wide;
    forms.series[3][tube.others[1]] = std::numeric_limits<double>::quiet_NaN();
    CHECK(doubts(forms) == filter::kVertexBlock);
  });
}

TEST_CASE("filter series: vector and scalar code agree in every bit") {
  if (!filter::has_vertex_lanes()) return;
#ifdef __x86_64__
  for_pieces([](const filter::Pair& pair, const filter::Piece& piece) {
    for (const double greatest : {1e-12, 1e-7}) {
      const filter::VertexForms forms = filter::vertex_forms(pair, piece.tube, greatest);
      filter::VertexBlock scalar = block_at(piece.tube, piece.range.from(), piece.range.to());
      filter::VertexBlock lanes = scalar;
      filter::evaluate_vertices_scalar(forms, scalar);
      filter::evaluate_vertices_lanes(forms, lanes);
      CHECK(same(scalar, lanes));
    }
  });
#endif
}

}  // namespace exsect::series_test
