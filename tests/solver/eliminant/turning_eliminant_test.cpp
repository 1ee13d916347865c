#include <exsect/algebra/real_algebraic.h>
#include <exsect/geometry/parameter_line.h>
#include <exsect/geometry/patch_file.h>
#include <exsect/geometry/pull_back.h>
#include <exsect/solver/turning_eliminant.h>

#include <cmath>
#include <string>
#include <vector>

#include "eliminant_pairs.h"
#include "exact_products.h"
#include "support/catch.h"

namespace exsect::turning_eliminant_test {
using namespace exsect::eliminant_pairs;

namespace {

Pair example(const std::string& name) {
  const PatchFile file = read_patches(std::string(EXSECT_EXAMPLES) + "/" + name + ".json");
  return {file.patches.at(0).patch, file.patches.at(1).patch};
}

Polynomial eliminant(const BezierPatch& x, const BezierPatch& y) {
  const TurningEliminant e = turning_eliminant(x, y);
  INFO(e.degenerate);
  REQUIRE(e.polynomial.has_value());
  return *e.polynomial;
}

using VectorField = std::array<BivariatePolynomial, 3>;

BivariatePolynomial determinant(const VectorField& a, const VectorField& b, const VectorField& c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
         a[2] * (b[0] * c[1] - b[1] * c[0]);
}

/// E(u) up to a constant factor that does not depend on u, from its definition: (g_r g_s)^6 times the product
/// of J = x_v . (y_r x y_s) over the fibre, with the orthogonal cylinder and exact resultants.
Rational eliminant_by_definition(const BezierPatch& x, const BezierPatch& y, const Rational& u) {
  const ParameterLine line = line_at_first(x, u);
  const PullBack forms = pull_back(orthogonal_forms(line), y);
  const Rational n = forms.u.coefficient(0, 0);
  const BivariatePolynomial z = forms.cylinder();
  const Polynomial r_s = resultant_r(forms.plane, z);
  const Polynomial r_r = resultant_s(forms.plane, z);
  REQUIRE(r_s.degree() == 16);
  REQUIRE(r_r.degree() == 16);

  VectorField x_v;  // N x_v at v = L/N
  VectorField y_r;
  VectorField y_s;
  const ControlNet c = y.power_basis();
  for (std::size_t k = 0; k < 3; ++k) {
    x_v[k] = BivariatePolynomial::constant(n * line.a[1][k]) + forms.l * Polynomial(2 * line.a[2][k]);
    BivariatePolynomial coordinate;
    for (std::size_t i = 3; i-- > 0;)
      coordinate = coordinate * BivariatePolynomial::r() +
                   BivariatePolynomial({Polynomial({c[i][0][k], c[i][1][k], c[i][2][k]})});
    y_r[k] = coordinate.derivative_r();
    y_s[k] = coordinate.derivative_s();
  }
  const testing::Reduced zeta = testing::reduced(z, forms.plane);
  const testing::Reduced jacobian = testing::reduced(determinant(x_v, y_r, y_s), forms.plane);
  // At a root s_i of R the point has r = -zeta.constant / zeta.linear.
  Rational product =
      testing::product_over_roots(r_s, jacobian.constant * zeta.linear - jacobian.linear * zeta.constant) /
      testing::product_over_roots(r_s, zeta.linear);
  const Rational leads = testing::product_over_roots(r_s, forms.plane.coefficient(2));
  for (int i = 0; i < jacobian.power; ++i) product /= leads;
  // lc R_s = N^4 g_s^2, lc R_r = N^4 g_r^2, and N J stands for J at 16 points.
  const Rational n2 = n * n;
  const Rational n8 = n2 * n2 * n2 * n2;
  const Rational g = r_s.leading_coefficient() * r_r.leading_coefficient() / n8;
  return product / (n8 * n8) * g * g * g;
}

}  // namespace

TEST_CASE("the turning eliminants of the first example have the known roots", "[turning_eliminant]") {
  const auto [x, y] = example("chapter9-first");
  struct Expected {
    Polynomial e;
    std::vector<double> known_roots;
    std::size_t number_of_roots;
  };
  const std::vector<Expected> cases = {
      {eliminant(x, y),
       {0.085669372235892741, 0.553718645192776094, 0.732810238336817004, 0.778671108697450102,
        0.857777133881642341, 0.877304904208122650, 0.895590808255561221, 0.930871957742362816,
        0.945245837945497023, 0.951121491693433599},
       10},
      {eliminant(x.exchanged(), y), {0.118295149600328434, 0.637948116019917867, 0.728742308011040764}, 9},
      {eliminant(y, x), {0.109671004270749403, 0.150500421589620769, 0.821721169754102370}, 5},
      {eliminant(y.exchanged(), x), {0.144948514635495788, 0.732093249358009030}, 4}};
  for (const auto& [e, known_roots, number_of_roots] : cases) {
    CHECK(e.degree() == 128);
    const auto roots = real_roots(e, 0, 1);
    CHECK(roots.size() == number_of_roots);
    for (const double known : known_roots) {
      INFO("root " << known);
      int near = 0;
      for (const RealAlgebraic& root : roots)
        if (std::abs(to_double(root.refined_to(power_of_two(-60)).interval().midpoint()) - known) < 1e-15)
          ++near;
      CHECK(near == 1);
    }
  }
}

TEST_CASE("the turning eliminant of the second example has degree 128", "[turning_eliminant]") {
  const auto [x, y] = example("chapter9-second");
  CHECK(eliminant(x, y).degree() == 128);
}

TEST_CASE("the turning eliminant agrees with its definition at rational u", "[turning_eliminant]") {
  const unsigned seed = 13;
  INFO("seed " << seed);
  Random random(seed);
  for (int repeat = 0; repeat < 2; ++repeat) {
    const BezierPatch x = random_patch(random);
    const BezierPatch y = random_patch(random);
    const Polynomial e = eliminant(x, y);
    const Rational ratio = eliminant_by_definition(x, y, 0) / e(0);
    CHECK(ratio != 0);
    for (const Rational& u : {Rational(1), Rational(-3), Rational(1, 2), Rational(5, 7)})
      CHECK(eliminant_by_definition(x, y, u) == ratio * e(u));
  }
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

TEST_CASE("a turning point is a simple root, a tangency of the patches a multiple one",
          "[turning_eliminant]") {
  const unsigned seed = 14;
  INFO("seed " << seed);
  Random random(seed);
  const BezierPatch y = random_patch(random);
  const Parameters at = {Rational(1, 3), Rational(2, 5), Rational(1, 4), Rational(3, 7)};
  const Point y_r = y.derivative_first(at.r, at.s);
  const Point y_s = y.derivative_second(at.r, at.s);
  const Point along_v = Rational(2, 3) * y_r - Rational(1, 5) * y_s;
  const Point along_u = Rational(1, 2) * y_r + Rational(3) * y_s;

  const BezierPatch turning = osculating(random_patch(random), at.u, at.v, y(at.r, at.s), along_v);
  const Polynomial e = eliminant(turning, y);
  CHECK(e.sign_at(at.u) == 0);
  CHECK(e.derivative().sign_at(at.u) != 0);

  const BezierPatch touching = osculating(random_patch(random), at.u, at.v, y(at.r, at.s), along_v, &along_u);
  const Polynomial f = eliminant(touching, y);
  CHECK(f.degree() == 128);
  CHECK(f.sign_at(at.u) == 0);
  CHECK(f.derivative().sign_at(at.u) == 0);
  CHECK(f.derivative().derivative().sign_at(at.u) != 0);
}

TEST_CASE("the turning eliminant takes doubles of very different exponents", "[turning_eliminant]") {
  const unsigned seed = 15;
  INFO("seed " << seed);
  Random random(seed);
  const auto coordinate = [&] {
    const double mantissa = std::uniform_real_distribution<double>(-1, 1)(random);
    return from_double(std::ldexp(mantissa, std::uniform_int_distribution<int>(-300, 60)(random)));
  };
  const BezierPatch x(net_of(coordinate));
  const BezierPatch y(net_of(coordinate));
  const Polynomial e = eliminant(x, y);
  CHECK(e.degree() == 128);
  CHECK(eliminant_by_definition(x, y, 2) * e(-1) == eliminant_by_definition(x, y, -1) * e(2));
}

TEST_CASE("numbers of thousands of digits are refused at once", "[turning_eliminant]") {
  int count = 0;
  const auto coordinate = [&] { return Rational(1 + ++count, (Integer(1) << 1000) + count); };
  const BezierPatch x(net_of(coordinate));
  const BezierPatch y(net_of(coordinate));
  const TurningEliminant e = turning_eliminant(x, y);
  CHECK_FALSE(e.polynomial.has_value());
  CHECK(e.degenerate.find("too long") != std::string::npos);
}

TEST_CASE("tiny integer nets, where degeneracies are common, end one way or the other",
          "[turning_eliminant]") {
  const unsigned seed = 16;
  INFO("seed " << seed);
  Random random(seed);
  int defined = 0;
  for (int repeat = 0; repeat < 60; ++repeat) {
    const int zeros = repeat % 4;  // more and more coefficients vanish
    const auto coordinate = [&]() -> Rational {
      const int c = std::uniform_int_distribution<int>(-2, 2)(random);
      return std::uniform_int_distribution<int>(0, 4)(random) < zeros ? 0 : c;
    };
    const BezierPatch x = BezierPatch::from_power_basis(net_of(coordinate));
    const BezierPatch y = BezierPatch::from_power_basis(net_of(coordinate));
    const TurningEliminant e = turning_eliminant(x, y);
    CHECK(e.polynomial.has_value() == e.degenerate.empty());
    if (e.polynomial) {
      ++defined;
      CHECK(e.polynomial->degree() >= 0);
      CHECK(turning_eliminant(x, y.exchanged()).polynomial == e.polynomial);
    }
  }
  CHECK(defined >= 30);
}

}  // namespace exsect::turning_eliminant_test
