// The search's decisions alone, on a curve that needs no proof: u = tau and (v,r,s) = (tau - a_j)².
#include "trace/turning_search.h"

#include <array>
#include <string>

#include "support/catch.h"

namespace exsect::turning_search_test {
namespace {

template <class Ball>
struct Parabolas {
  std::array<double, 4> zeros;  // a_j; that of u is not used
  double reach = 1;
  std::array<double, 4> slope = {2, 2, 2, 2};
  std::array<double, 4> slope_error = {};
};

template <class Ball>
BallPoint<Ball> point_at(const Parabolas<Ball>& tube, double tau) {
  BallPoint<Ball> p = {Ball(tau), Ball(0), Ball(0), Ball(0)};
  for (std::size_t j = 1; j < 4; ++j)
    p[j] = (Ball(tau) - Ball(tube.zeros[j])) * (Ball(tau) - Ball(tube.zeros[j]));
  return p;
}

/// Tells no sign within `doubt` of a zero, on pieces longer than `fine`.
struct Course {
  using Number = DoubleBall;
  using Piece = TubePiece<Parabolas<DoubleBall>>;
  static constexpr std::size_t most_pieces = 100;

  std::vector<Piece>* pieces;
  double doubt = 0x1p-40;
  double fine = 0;
  bool is_one = false;
  bool ends_are_known = false;
  double longest = 1;

  bool is_simple(const Piece& piece) const { return piece.range.length() <= longest; }
  static std::optional<Piece> part(const Piece& piece, double from, double to) {
    return Piece{piece.tube, *PieceRange::between(from, to)};
  }
  static bool may_turn(const Piece&, std::size_t j) { return j > 0; }
  static double slope_at(const Piece& piece, double tau, std::size_t j) {
    return 2 * (tau - piece.tube.zeros[j]);
  }
  int sign_at(const Piece& piece, double tau, std::size_t j) const {
    const double slope = slope_at(piece, tau, j);
    if (piece.range.length() > fine && std::fabs(slope) <= 2 * doubt) return 0;
    return slope > 0 ? 1 : slope < 0 ? -1 : 0;
  }
  std::optional<int> end_sign(std::size_t k, std::size_t j, bool at_end) const {
    const PieceRange& range = (*pieces)[k].range;
    const int sign = sign_at((*pieces)[k], at_end ? range.to() : range.from(), j);
    return sign == 0 ? std::nullopt : std::optional(sign);
  }
  bool knows_end(std::size_t, std::size_t, bool) const { return ends_are_known; }
  static double unit(const Piece&) { return 0x1p-50; }
  bool are_one(const TurningPoint<DoubleBall>&, const TurningPoint<DoubleBall>&) const { return is_one; }
  /// Cuts the piece in three, the middle one of the length `fine`.
  bool magnify(std::size_t k, double at) const {
    const Piece piece = (*pieces)[k];
    if (piece.range.length() <= fine || fine == 0) return false;
    const double from = piece.range.ahead_of(at, -fine / 2), to = piece.range.ahead_of(at, fine / 2);
    pieces->erase(pieces->begin() + static_cast<std::ptrdiff_t>(k));
    const std::array<double, 4> cuts = {piece.range.to(), to, from, piece.range.from()};
    for (std::size_t i = 0; i < 3; ++i)
      if (cuts[i + 1] != cuts[i])
        pieces->insert(pieces->begin() + static_cast<std::ptrdiff_t>(k), *part(piece, cuts[i + 1], cuts[i]));
    return true;
  }
  static BallPoint<DoubleBall> pair(const Piece&, const BallPoint<DoubleBall>& at) { return at; }
};
using Outcome = std::variant<TurningPoints<DoubleBall>, TraceFailure>;

constexpr std::array<std::size_t, 4> kNone = {0, 1, 2, 3};

struct Search {
  std::vector<Course::Piece> pieces;
  Course course = {};

  explicit Search(const std::array<double, 4>& zeros, double from = 0, double to = 1)
      : pieces{{{zeros}, *PieceRange::between(from, to)}} {}

  Outcome run(const std::array<std::size_t, 4>& coincident = kNone, const StopRequest& stop = {}) {
    course.pieces = &pieces;
    return TurningSearch<Course>(course, pieces, coincident, stop).run();
  }
  TurningPoints<DoubleBall> points(const std::array<std::size_t, 4>& coincident = kNone) {
    const Outcome outcome = run(coincident);
    REQUIRE(std::holds_alternative<TurningPoints<DoubleBall>>(outcome));
    return std::get<TurningPoints<DoubleBall>>(outcome);
  }
  std::string failure(const StopRequest& stop = {}) {
    const Outcome outcome = run(kNone, stop);
    REQUIRE(std::holds_alternative<TraceFailure>(outcome));
    return std::get<TraceFailure>(outcome).why;
  }
};

}  // namespace

TEST_CASE("turning search: each zero once, in the order of the trace", "[turning]") {
  const std::array<double, 4> zeros = {0, 1.0 / 3, 0.7, 0.1};
  for (const bool backwards : {false, true}) {
    for (const double longest : {1.0, 0.3}) {
      Search search(zeros, backwards ? 1 : 0, backwards ? 0 : 1);
      search.course.longest = longest;
      const auto points = search.points();
      REQUIRE(points.size() == 3);
      CHECK((search.pieces.size() > 1) == (longest < 1));
      const std::array<std::size_t, 3> order =
          backwards ? std::array<std::size_t, 3>{2, 1, 3} : std::array<std::size_t, 3>{3, 1, 2};
      for (std::size_t i = 0; i < 3; ++i) {
        const double zero = zeros[order[i]];
        CHECK(points[i].parameters == std::vector<std::size_t>{order[i]});
        CHECK(std::min(points[i].from, points[i].to) < zero);
        CHECK(std::max(points[i].from, points[i].to) > zero);
        CHECK(std::fabs(points[i].from - points[i].to) < 0x1p-36);
        CHECK((points[i].box[0] - DoubleBall(zero)).certain_sign() == 0);
        CHECK((points[i].from > points[i].to) == backwards);
      }
    }
  }
}

TEST_CASE("turning search: coincident parameters share their points", "[turning]") {
  const auto points = Search({0, 0.25, 2, 0.25}).points({0, 3, 2, 1});
  REQUIRE(points.size() == 1);
  CHECK(points[0].parameters == std::vector<std::size_t>{1, 3});
}

TEST_CASE(
    "turning search: two zeros with one bracket are one point, a failure, or told apart by a shorter piece",
    "[turning]") {
  const std::array<double, 4> zeros = {0, 0.5, 0.5 + 0x1p-42, 2};
  CHECK(Search(zeros).failure().find("two parameters") != std::string::npos);

  Search one(zeros);
  one.course.is_one = true;
  const auto merged = one.points();
  REQUIRE(merged.size() == 1);
  CHECK(merged[0].parameters == std::vector<std::size_t>{1, 2});
  const auto first = Search({0, zeros[1], 2, 2}).points().front();
  const auto second = Search({0, 2, zeros[2], 2}).points().front();
  REQUIRE(first.to < second.to);
  CHECK(merged[0].from == first.from);
  CHECK(merged[0].to == second.to);

  Search magnified(zeros);
  magnified.course.fine = 0x1p-30;
  CHECK(magnified.points().size() == 2);
  CHECK(magnified.pieces.size() == 3);
}

TEST_CASE("turning search: a zero at an end is left to a shorter piece if the end is known", "[turning]") {
  Search search({0, 0, 2, 2}, -0x1p-45, 0.5);
  search.course.fine = 0x1p-20;
  CHECK(search.failure().find("the end of a step") != std::string::npos);
  CHECK(search.pieces.size() == 1);

  search.course.ends_are_known = true;
  CHECK(search.points().size() == 1);
  CHECK(search.pieces.size() > 1);
}

TEST_CASE("turning search: stops when it must", "[turning]") {
  CHECK(Search({0, 0.5, 2, 2}).failure([] { return true; }).find("work cap") != std::string::npos);
}

}  // namespace exsect::turning_search_test
