#include <exsect/geometry/patch_file.h>
#include <exsect/solver/turning_eliminant.h>

#include <random>
#include <string>
#include <vector>

#include "support/catch.h"

using namespace exsect;

namespace {

struct Pair {
  BezierPatch x;
  BezierPatch y;
};

Pair example(const std::string& name) {
  const PatchFile file = read_patches(std::string(EXSECT_EXAMPLES) + "/" + name + ".json");
  return {file.patches.at(0).patch, file.patches.at(1).patch};
}

using Random = std::mt19937_64;

template <class Coordinate>
BezierPatch patch_of(const Coordinate& coordinate) {
  ControlNet net;
  for (auto& row : net)
    for (auto& point : row)
      for (auto& c : point) c = coordinate();
  return BezierPatch(net);
}

Rational small_rational(Random& random) {
  const int denominator = std::uniform_int_distribution<int>(1, 16)(random);
  return Rational(std::uniform_int_distribution<int>(0, denominator)(random), denominator);
}

BezierPatch random_patch(Random& random) {
  return patch_of([&] { return small_rational(random); });
}

/// E has opposite signs at the ends of an interval of width 2^-49 around the decimal value.
bool changes_sign_near(const Polynomial& e, double value) {
  const Rational radius = power_of_two(-50);
  return e.sign_at(from_double(value) - radius) * e.sign_at(from_double(value) + radius) < 0;
}

Polynomial eliminant(const BezierPatch& x, const BezierPatch& y) {
  const TurningEliminant e = turning_eliminant(x, y);
  INFO(e.degenerate);
  REQUIRE(e.polynomial.has_value());
  return *e.polynomial;
}

}  // namespace

TEST_CASE("the turning eliminants of the first example have the known roots", "[turning_eliminant]") {
  const auto [x, y] = example("chapter9-first");
  struct Expected {
    Polynomial e;
    std::vector<double> roots;
  };
  const std::vector<Expected> cases = {
      {eliminant(x, y),
       {0.085669372235892741, 0.553718645192776094, 0.732810238336817004, 0.778671108697450102,
        0.857777133881642341, 0.877304904208122650, 0.895590808255561221, 0.930871957742362816,
        0.945245837945497023, 0.951121491693433599}},
      {eliminant(x.exchanged(), y), {0.118295149600328434, 0.637948116019917867, 0.728742308011040764}},
      {eliminant(y, x), {0.109671004270749403, 0.150500421589620769, 0.821721169754102370}},
      {eliminant(y.exchanged(), x), {0.144948514635495788, 0.732093249358009030}}};
  for (const auto& [e, roots] : cases) {
    CHECK(e.degree() == 128);
    for (const double root : roots) {
      INFO("root " << root);
      CHECK(changes_sign_near(e, root));
    }
  }
}

TEST_CASE("the turning eliminant of the second example has degree 128", "[turning_eliminant]") {
  const auto [x, y] = example("chapter9-second");
  CHECK(eliminant(x, y).degree() == 128);
}

TEST_CASE("the turning eliminant does not depend on coordinates", "[turning_eliminant]") {
  const unsigned seed = 11;
  INFO("seed " << seed);
  Random random(seed);
  const BezierPatch x = random_patch(random);
  const BezierPatch y = random_patch(random);
  const Polynomial e = eliminant(x, y);
  CHECK(e.degree() == 128);
  CHECK(e == e.primitive());
  CHECK(sign(e.leading_coefficient()) > 0);

  const auto mapped = [](const BezierPatch& patch, const auto& map) {
    ControlNet net = patch.net();
    for (auto& row : net)
      for (auto& point : row) point = map(point);
    return BezierPatch(net);
  };
  const auto check = [&](const auto& map) { CHECK(eliminant(mapped(x, map), mapped(y, map)) == e); };
  check([](const Point& p) { return p + Point{Rational(7, 3), Rational(-1000), Rational(1, 64)}; });
  check([](const Point& p) { return Rational(-5, 7) * p; });
  check([](const Point& p) { return Point{p[2], p[0], p[1]}; });
  check([](const Point& p) { return Point{p[1], p[0], p[2]}; });
  check([](const Point& p) { return Point{p[0] + 2 * p[1], p[1] / 3 - p[2], p[2] + 5 * p[0]}; });
}

TEST_CASE("reversing and exchanging parameters changes the turning eliminant as it must",
          "[turning_eliminant]") {
  const unsigned seed = 12;
  INFO("seed " << seed);
  Random random(seed);
  const BezierPatch x = random_patch(random);
  const BezierPatch y = random_patch(random);
  const Polynomial e = eliminant(x, y);
  CHECK(eliminant(x, y.exchanged()) == e);
  CHECK(eliminant(x, y.reversed_first()) == e);
  CHECK(eliminant(x.reversed_second(), y.reversed_second()) == e);
  const Polynomial reversed = e.compose(Polynomial(1) - Polynomial::variable());
  CHECK(eliminant(x.reversed_first(), y) ==
        (sign(reversed.leading_coefficient()) < 0 ? -reversed : reversed));
}
