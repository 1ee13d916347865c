#include "trace/subdivision_cell.h"

#include "support/ball_checks.h"
#include "support/catch.h"

namespace exsect::subdivision_cell_test {
namespace {

using testing::encloses;

/// The net of the cell against the exact restriction of the patch, box and derivatives against its points.
template <class Ball>
void check_cell(const subdivision::Cell<Ball>& cell, const BezierPatch& patch) {
  const std::array<Rational, 2> lower = {from_double(cell.lower[0]), from_double(cell.lower[1])};
  const std::array<Rational, 2> upper = {from_double(cell.upper[0]), from_double(cell.upper[1])};
  const ControlNet net = patch.restricted_to(lower[0], upper[0], lower[1], upper[1]).net();
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      CHECK(encloses(cell.net[3 * i + j], net[i][j]));
      for (std::size_t c = 0; c < 3; ++c) {
        CHECK(from_double(cell.box[c].lower) <= net[i][j][c]);
        CHECK(net[i][j][c] <= from_double(cell.box[c].upper));
      }
    }
  for (const Rational& a : {Rational(0), Rational(2, 5), Rational(1)}) {
    const Rational u = lower[0] + a * (upper[0] - lower[0]);
    const Rational v = lower[1] + (1 - a) * (upper[1] - lower[1]);
    const Point first = (upper[0] - lower[0]) / 2 * patch.derivative_first(u, v);
    const Point second = (upper[1] - lower[1]) / 2 * patch.derivative_second(u, v);
    for (std::size_t c = 0; c < 3; ++c) {
      CHECK(encloses(cell.derivative[0][c], first[c]));
      CHECK(encloses(cell.derivative[1][c], second[c]));
    }
  }
}

template <class Ball>
void check_tree(const BezierPatch& patch) {
  const std::array<double, 2> lower = {0.25, 0};
  const std::array<double, 2> upper = {1, 0.5};
  const PairSystem<Ball> system(patch, patch, {0, 0, 0}, 0);
  subdivision::CellTree<Ball> tree(system.taylor_x({Ball(lower[0]), Ball(lower[1]), Ball(0.0), Ball(0.0)}),
                                   lower, upper);
  subdivision::Cell<Ball>* cell = &tree.root();
  check_cell(*cell, patch);
  for (std::size_t level = 0; level < 12; ++level) {
    REQUIRE(tree.split(*cell));
    subdivision::Cell<Ball>* next = nullptr;
    double area = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      subdivision::Cell<Ball>* child = cell->children[(k + level) % 4];
      if (child == nullptr) continue;
      next = child;
      area += (child->upper[0] - child->lower[0]) * (child->upper[1] - child->lower[1]);
      CHECK(child->depth == cell->depth + 1);
    }
    CHECK(area == (cell->upper[0] - cell->lower[0]) * (cell->upper[1] - cell->lower[1]));
    cell = next;
    check_cell(*cell, patch);
  }
}

}  // namespace

TEST_CASE("subdivision cells: nets are those of the exact sub-patches", "[trace]") {
  random_pairs::Generator generator(20267);
  for (int i = 0; i < 3; ++i) {
    check_tree<DoubleBall>(random_pairs::doubles(generator).x);
    check_tree<ArbBall<256>>(random_pairs::scattered(generator).x);
  }
}

TEST_CASE("subdivision cells: a thin cell is halved across its length", "[trace]") {
  // 16 times as long in u as in v.
  ControlNet c{};
  c[1][0][0] = 16;
  c[0][1][1] = 1;
  const BezierPatch patch = BezierPatch::from_power_basis(c);
  const PairSystem<DoubleBall> system(patch, patch, {0, 0, 0}, 0);
  subdivision::CellTree<DoubleBall> tree(system.taylor_x({}), {0, 0}, {1, 1});
  REQUIRE(tree.split(tree.root()));
  const auto& children = tree.root().children;
  REQUIRE(children[0] != nullptr);
  REQUIRE(children[2] != nullptr);
  CHECK(children[1] == nullptr);
  CHECK(children[3] == nullptr);
  CHECK(children[0]->upper == std::array<double, 2>{0.5, 1});
}

TEST_CASE("subdivision cells: not split where the middle is no double", "[trace]") {
  const BezierPatch patch = BezierPatch::from_power_basis({});
  const PairSystem<DoubleBall> system(patch, patch, {0, 0, 0}, 0);
  const double next = std::nextafter(0.5, 1.0);
  subdivision::CellTree<DoubleBall> tree(system.taylor_x({DoubleBall(0.5), DoubleBall(0.5), {}, {}}),
                                         {0.5, 0.5}, {next, next});
  CHECK_FALSE(tree.split(tree.root()));
}

}  // namespace exsect::subdivision_cell_test
