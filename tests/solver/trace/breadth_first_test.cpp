#include "trace/breadth_first.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

#include "support/catch.h"

namespace exsect::breadth_first_test {
namespace {

/// Intervals of [0,1] that are halved; the other three variables stay 0.
struct Halving {
  struct Cell {
    double lower;
    double width;
  };

  std::function<bool(const Cell&)> is_found;
  std::function<bool(const Cell&)> may_split = [](const Cell&) { return true; };
  std::vector<Cell> done = {};

  bool is_done(const Cell& cell) {
    if (!is_found(cell)) return false;
    done.push_back(cell);
    return true;
  }
  bool split(const Cell& cell, std::deque<Cell>& waiting) const {
    if (!may_split(cell)) return false;
    for (const double i : {0.0, 0.5}) waiting.push_back({cell.lower + i * cell.width, 0.5 * cell.width});
    return true;
  }
  static SearchRegion region_of(const Cell& cell) {
    return {{cell.lower, 0, 0, 0}, {cell.lower + cell.width, 0, 0, 0}};
  }
};

/// The intervals that are done and those that are left are those of a subdivision of [0,1], each once.
void check_cover(const Halving& cover, const SearchOutcome& outcome) {
  std::vector<std::array<double, 2>> all;
  for (const auto& cell : cover.done) all.push_back({cell.lower, cell.lower + cell.width});
  for (const SearchRegion& left : outcome.undecided) all.push_back({left.lower[0], left.upper[0]});
  std::ranges::sort(all);
  double at = 0;
  for (const auto& [lower, upper] : all) {
    CHECK(lower == at);
    at = upper;
  }
  CHECK(at == 1);
}

}  // namespace

TEST_CASE("breadth first: nothing, everything, and one that cannot be split", "[trace]") {
  Halving cover{[](const auto&) { return true; }};
  CHECK(search_breadth_first(cover, {}, {0, 0}, {}).boxes == 0);
  const SearchOutcome all = search_breadth_first(cover, {{0, 1}}, {0, 0}, {});
  CHECK(all.boxes == 1);
  CHECK(all.undecided.empty());

  Halving lone{[](const auto&) { return false; }, [](const auto&) { return false; }};
  const SearchOutcome left = search_breadth_first(lone, {{0, 0.5}, {0.5, 0.5}}, {9, 9}, {});
  CHECK(left.boxes == 2);  // the search goes on after the first one
  check_cover(lone, left);
}

TEST_CASE("breadth first: a number in the interval that is left, and nowhere else", "[trace]") {
  const auto has_no_root = [](const Halving::Cell& cell) {
    const double upper = cell.lower + cell.width;
    return 2 * cell.lower * cell.lower > 1 || 2 * upper * upper < 1;
  };
  Halving cover{has_no_root, [](const Halving::Cell& cell) { return cell.width > 0x1p-20; }};
  const SearchOutcome outcome = search_breadth_first(cover, {{0, 1}}, {1000, 1000}, {});
  REQUIRE(outcome.undecided.size() == 1);
  CHECK(outcome.undecided[0].lower[0] < std::sqrt(0.5));
  CHECK(outcome.undecided[0].upper[0] > std::sqrt(0.5));
  CHECK(outcome.boxes == 41);
  check_cover(cover, outcome);
}

TEST_CASE("breadth first: what limits and requests leave is all that is not done", "[trace]") {
  const unsigned seed = 5;
  INFO("seed " << seed);
  std::mt19937 generator(seed);
  std::uniform_int_distribution<int> any(0, 99);
  int limited = 0, stopped = 0, complete = 0;
  for (int round = 0; round < 500; ++round) {
    Halving cover{[&](const auto&) { return any(generator) < 45; },
                  [&](const Halving::Cell& cell) { return cell.width > 0x1p-30 && any(generator) < 98; }};
    const long most = any(generator);
    const auto most_waiting = static_cast<std::size_t>(any(generator));
    int looks = 0;
    const int last_look = any(generator);
    const SearchOutcome outcome =
        search_breadth_first(cover, {{0, 1}}, {most, most_waiting, 2}, [&] { return ++looks > last_look; });
    check_cover(cover, outcome);
    // Beyond the limit it goes on only as long as boxes are done.
    if (outcome.boxes > most + 1)
      CHECK(cover.done.size() >= static_cast<std::size_t>(outcome.boxes - most - 1));
    CHECK(looks <= last_look + 1);
    limited += outcome.boxes > most ? 1 : 0;
    stopped += looks == last_look + 1 ? 1 : 0;
    complete += outcome.undecided.empty() ? 1 : 0;
  }
  CHECK(limited > 20);
  CHECK(stopped > 8);
  CHECK(complete > 20);
}

}  // namespace exsect::breadth_first_test
