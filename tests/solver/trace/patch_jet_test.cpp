// Jets of patches against exact derivatives, by the quotient rule, at points of the balls.
#include "trace/patch_jet.h"

#include <random>

#include "support/catch.h"

namespace exsect::patch_jet_test {
namespace {

/// w X_ab - w_ab X at (u,v), exactly.
std::array<Rational, 3> exact(const RationalPatch& patch, int a, int b, const Rational& u,
                              const Rational& v) {
  std::array<Rational, 4> value, derived;
  for (int k = 0; k < 4; ++k) {
    BivariatePolynomial f = patch.component(k);
    value[static_cast<std::size_t>(k)] = f(u, v);
    for (int i = 0; i < a; ++i) f = f.derivative_r();
    for (int i = 0; i < b; ++i) f = f.derivative_s();
    derived[static_cast<std::size_t>(k)] = f(u, v);
  }
  std::array<Rational, 3> result;
  for (std::size_t k = 0; k < 3; ++k) result[k] = value[3] * derived[k] - derived[3] * value[k];
  return result;
}

template <class Ball>
void check_vector(const BallVector<Ball>& found, const std::array<Rational, 3>& expected, double most) {
  for (std::size_t k = 0; k < 3; ++k) {
    const RationalInterval range = found[k].interval();
    CHECK(range.lower <= expected[k]);
    CHECK(range.upper >= expected[k]);
    CHECK(found[k].radius() <= most);
  }
}

template <class Ball>
void check_jets(const RationalPatch& patch, const RationalInterval& u, const RationalInterval& v,
                double most) {
  const PatchNet<Ball> net(patch);
  const Ball in_u = Ball::enclosing(u), in_v = Ball::enclosing(v);
  const PatchJet<Ball> first = net.at(in_u, in_v, 1), second = net.at(in_u, in_v, 2);
  for (const Rational& at_u : {u.lower, u.midpoint(), u.upper})
    for (const Rational& at_v : {v.lower, v.midpoint(), v.upper}) {
      for (const PatchJet<Ball>* jet : {&first, &second}) {
        check_vector(jet->u, exact(patch, 1, 0, at_u, at_v), most);
        check_vector(jet->v, exact(patch, 0, 1, at_u, at_v), most);
      }
      check_vector(second.uu, exact(patch, 2, 0, at_u, at_v), most);
      check_vector(second.uv, exact(patch, 1, 1, at_u, at_v), most);
      check_vector(second.vv, exact(patch, 0, 2, at_u, at_v), most);
    }
}

}  // namespace

TEST_CASE("patch jets hold the exact derivatives, for every degree, with and without weights") {
  const unsigned seed = 9071;
  INFO("seed " << seed);
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> number(-20, 20), weight(3, 9), part(0, 7);
  for (int m = 1; m <= 3; ++m)
    for (int n = 1; n <= 3; ++n)
      for (const bool weighted : {false, true}) {
        INFO("bidegree " << m << "," << n << " weighted " << weighted);
        std::vector<std::vector<Point>> points;
        std::vector<std::vector<Rational>> weights;
        for (int i = 0; i <= m; ++i) {
          points.emplace_back();
          weights.emplace_back();
          for (int j = 0; j <= n; ++j) {
            points.back().push_back(
                {Rational(number(random), 7), Rational(number(random), 3), number(random)});
            weights.back().push_back(Rational(weight(random), 7));
          }
        }
        const RationalPatch patch = weighted ? RationalPatch(points, weights) : RationalPatch(points);
        const Rational u(part(random), 7), v(part(random), 7), e(1, 1000);
        const auto wide = [&](const Rational& t) {
          return RationalInterval{std::max<Rational>(t - e, 0), std::min<Rational>(t + e, 1)};
        };
        check_jets<DoubleBall>(patch, {u, u}, {v, v}, 1e-9);
        check_jets<ArbBall<256>>(patch, {u, u}, {v, v}, 1e-60);
        check_jets<DoubleBall>(patch, wide(u), wide(v), 20);
        check_jets<ArbBall<256>>(patch, wide(u), wide(v), 20);
      }
}

}  // namespace exsect::patch_jet_test
