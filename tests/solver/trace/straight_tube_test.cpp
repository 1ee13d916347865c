#include "trace/straight_tube.h"

#include <map>
#include <random>

#include "support/ball_checks.h"
#include "support/catch.h"
#include "trace/contact_expansion.h"

namespace exsect::straight_tube_test {
namespace {

using Ball = ArbBall<256>;
using Place = std::array<Rational, 4>;
using Vector = std::array<Rational, 3>;

/// Polynomials with exact coefficients.
struct Exact {
  using Number = Ball;
  std::map<TermExponents, Vector> terms;

  template <class F>
  void for_each_term(const F& f) const {
    for (const auto& [e, c] : terms) f(e, as_balls(c));
  }
  static BallVector<Ball> as_balls(const Vector& c) {
    return {Ball::enclosing(c[0]), Ball::enclosing(c[1]), Ball::enclosing(c[2])};
  }

  Vector operator()(const Place& w) const {
    Vector sum = {0, 0, 0};
    for (const auto& [e, c] : terms) {
      Rational power = 1;
      for (std::size_t v = 0; v < 4; ++v)
        for (std::size_t n = 0; n < e[v]; ++n) power *= w[v];
      for (std::size_t row = 0; row < 3; ++row) sum[row] += c[row] * power;
    }
    return sum;
  }

  Exact derivative(std::size_t j) const {
    Exact result;
    for (const auto& [e, c] : terms) {
      if (e[j] == 0) continue;
      TermExponents lower = e;
      --lower[j];
      for (std::size_t row = 0; row < 3; ++row) result.terms[lower][row] += c[row] * Rational(e[j]);
    }
    return result;
  }

  /// The Taylor polynomial at p, by the derivatives there.
  Exact at(const Place& p) const {
    Exact result;
    for (std::size_t n = 0; n < 256; ++n) {
      const TermExponents e = {n / 64, n / 16 % 4, n / 4 % 4, n % 4};
      Exact derived = *this;
      Rational factorial = 1;
      for (std::size_t v = 0; v < 4; ++v)
        for (std::size_t i = 0; i < e[v]; ++i) {
          derived = derived.derivative(v);
          factorial *= Rational(i + 1);
        }
      const Vector c = derived(p);
      if (c != Vector{0, 0, 0}) result.terms[e] = {c[0] / factorial, c[1] / factorial, c[2] / factorial};
    }
    return result;
  }

  Exact times(const Matrix3& c) const {
    Exact result;
    for (const auto& [e, a] : terms)
      for (std::size_t row = 0; row < 3; ++row)
        for (std::size_t i = 0; i < 3; ++i) result.terms[e][row] += from_double(c[row][i]) * a[i];
    return result;
  }

  std::array<BallVector<Ball>, 4> derivatives() const {
    std::array<BallVector<Ball>, 4> result;
    for (std::size_t j = 0; j < 4; ++j) result[j] = as_balls(derivative(j)({0, 0, 0, 0}));
    return result;
  }
};

/// w1 = t², w2 = t w1 = t³, w3 = w1 w2 = t^5 of (t, w1, w2, w3), in another basis of the equations.
Exact moment_curve() {
  Exact f;
  f.terms[{0, 1, 0, 0}] = {1, 0, 1};
  f.terms[{2, 0, 0, 0}] = {-1, 0, -1};
  f.terms[{0, 0, 1, 0}] = {0, 1, 0};
  f.terms[{1, 1, 0, 0}] = {0, -1, 0};
  f.terms[{0, 0, 0, 1}] = {2, 0, 1};
  f.terms[{0, 1, 1, 0}] = {-2, 0, -1};
  return f;
}
Place on_moment_curve(const Rational& t) { return {t, t * t, t * t * t, t * t * t * t * t}; }

struct RandomNumbers {
  std::mt19937 generator;
  Rational operator()(long size) {
    return Rational(std::uniform_int_distribution<long>(-64, 64)(generator), 64) * Rational(size);
  }
};

/// All terms up to the exponents (2,2,1,3), some of them 0.
Exact random_equations(RandomNumbers& number) {
  Exact f;
  for (std::size_t n = 0; n < 72; ++n) {
    if (n % 7 == 5) continue;
    f.terms[{n / 24, n / 8 % 3, n / 4 % 2, n % 4}] = {number(1), number(1), number(1)};
  }
  return f;
}

Rational ideal(const Linearisation& line, std::size_t row, std::size_t j) {
  const auto others = other_axes(line.axis);
  if (j == line.axis) return -from_double(line.slope[others[row]]);
  return others[row] == j ? 1 : 0;
}

bool is_at_most(const Rational& value, double bound) {
  return (value < 0 ? Rational(-value) : value) <= from_double(bound);
}

}  // namespace

TEST_CASE("straight tube: the Jacobian deviates by at most its bound, whatever the equations", "[trace]") {
  const unsigned seed = 8;
  INFO("seed " << seed);
  RandomNumbers number{std::mt19937(seed)};
  int found = 0;
  for (int round = 0; round < 40; ++round) {
    const Exact f = random_equations(number);
    const std::size_t axis = static_cast<std::size_t>(round % 4);
    const auto line = linearised(f.derivatives(), axis);
    if (!line) continue;
    ++found;
    const Exact g = f.times(line->preconditioner);
    double before = 0;
    for (const double h : {0x1p-20, 0x1p-8, 0x1p-2}) {
      const std::array<double, 4> reach = {h, h / 2, h, h / 4};
      const JacobianDeviation bound = jacobian_deviation(g, axis, line->slope, reach);
      for (std::size_t j = 0; j < 4; ++j) {
        const Exact derivative = g.derivative(j);
        for (int sample = 0; sample < 5; ++sample) {
          Place w;
          for (std::size_t i = 0; i < 4; ++i) w[i] = from_double(reach[i]) * (sample == 0 ? 1 : number(1));
          const Vector there = derivative(w);
          for (std::size_t row = 0; row < 3; ++row)
            CHECK(is_at_most(there[row] - ideal(*line, row, j), bound[j][row]));
        }
      }
      CHECK(largest_of(row_sums(bound, axis)) >= before);
      before = largest_of(row_sums(bound, axis));
    }
    // On the line, too.
    const Row3 residual = residual_on_line(g, axis, line->slope, 0.25);
    for (int sample = 0; sample < 10; ++sample) {
      const Rational tau = number(1) / 4;
      Place w;
      for (std::size_t i = 0; i < 4; ++i) w[i] = from_double(line->slope[i]) * tau;
      const Vector there = g(w);
      for (std::size_t row = 0; row < 3; ++row) CHECK(is_at_most(there[row], residual[row]));
    }
  }
  CHECK(found > 30);
}

TEST_CASE("straight tube: a column that no term has counts, and a line of zeros has no residual", "[trace]") {
  Exact f;  // the line w1 = w2 = w3 = t, twice: (w1 - t) (1 + t), ... without w3
  f.terms[{0, 1, 0, 0}] = {1, 0, 0};
  f.terms[{1, 0, 0, 0}] = {-1, -1, 0};
  f.terms[{2, 0, 0, 0}] = {-1, -1, 0};
  f.terms[{1, 1, 0, 0}] = {1, 0, 0};
  f.terms[{0, 0, 1, 0}] = {0, 1, 0};
  f.terms[{1, 0, 1, 0}] = {0, 1, 0};
  const std::array<double, 4> d = {1, 1, 1, 1};
  CHECK(jacobian_deviation(f, 0, d, {0, 0, 0, 0})[3][2] >= 1);
  CHECK(largest_of(residual_on_line(f, 0, d, 0.5)) == 0);
  CHECK(largest_of(residual_on_line(f, 0, {1, 1, 2, 1}, 0.5)) >= 0.75);
  CHECK_FALSE(linearised(f.derivatives(), 0));
}

TEST_CASE("straight tube: derivatives of an arc, by its formula", "[trace]") {
  const unsigned seed = 9;
  INFO("seed " << seed);
  RandomNumbers number{std::mt19937(seed)};
  for (int round = 0; round < 40; ++round) {
    const Rational t0 = number(1);
    const Exact f = moment_curve().at(on_moment_curve(t0));
    const auto line = linearised(f.derivatives(), 0);
    REQUIRE(line);
    const Exact g = f.times(line->preconditioner);
    const double reach = round % 2 == 0 ? 0x1p-6 : 0x1p-4;
    const std::array<double, 4> h = {reach, 3 * reach, 4 * reach, 7 * reach};
    const JacobianDeviation e = jacobian_deviation(g, 0, line->slope, h);
    const double contraction = largest_of(row_sums(e, 0));
    REQUIRE(contraction < 1);
    const auto error = slope_errors(e, 0, line->slope, contraction);
    const SecondDerivative second = second_derivative(g, 0, line->slope, error, h, e, contraction);
    for (int sample = 0; sample < 8; ++sample) {
      const Rational t = t0 + from_double(reach) * (sample == 0 ? 1 : number(1));
      const Place first = {1, 2 * t, 3 * t * t, 5 * t * t * t * t};
      const Place twice = {0, 2, 6 * t, 20 * t * t * t};
      for (std::size_t j = 0; j < 4; ++j) {
        CHECK(is_at_most(first[j] - from_double(line->slope[j]), error[j]));
        CHECK(is_at_most(twice[j] - from_double(second.middle[j]), second.error[j]));
      }
    }
    // Not idle: t² has the second derivative 2.
    CHECK(error[1] < 16 * reach);
    CHECK(std::fabs(second.middle[1] - 2) < 1e-12);
    CHECK(second.error[1] < 0.5);
  }
}

TEST_CASE("straight tube: derivatives of monomials, by differences", "[trace]") {
  const MonomialsAt monomials({0.5, 0.25, 2, 1});
  CHECK(monomials.derivative({3, 2, 1, 0}, 0) == 3 * 0.25 * 0.0625 * 2);
  CHECK(monomials.derivative({3, 2, 1, 0}, 3) == 0);
  CHECK(monomials.derivative({0, 0, 0, 1}, 3) == 1);
  CHECK(monomials.second({2, 0, 0, 0}, {3, 9, 9, 9}) == 18);
  CHECK(monomials.second({1, 1, 0, 0}, {3, 5, 9, 9}) == 30);
  CHECK(monomials.second({1, 0, 0, 0}, {3, 5, 9, 9}) == 0);
  // (1/2 + 3t)³ (2 + t) = (1/8 + 9/4 t + 27/2 t² + ...) (2 + t).
  CHECK(monomials.second({3, 0, 1, 0}, {3, 0, 1, 0}) == 2 * (3 * 0.5 * 9 * 2 + 3 * 0.25 * 3));
}

TEST_CASE("straight tube: of a box, all has to be near the line", "[trace]") {
  const StraightTube<DoubleBall> tube = {{0.5, 0.25, 0.5, 0.5}, 0, {1, -0.5, 0, 2}, 0x1p-4, 0x1p-6, 0.1};
  const auto place = [](double tau, double off, double radius) {
    BallPoint<DoubleBall> at = {0.5 + tau, 0.25 - 0.5 * tau + off, 0.5 - off, 0.5 + 2 * tau};
    for (DoubleBall& c : at) c = c.widened(radius);
    return at;
  };
  CHECK(contains_within(tube, place(0.05, 0, 0x1p-12), tube.halfwidth));
  CHECK(contains_within(tube, place(-0.0624, 0.0156, 0), tube.halfwidth));
  CHECK_FALSE(contains_within(tube, place(-0.0624, 0.0156, 0), 0x1p-7));
  CHECK_FALSE(contains_within(tube, place(-0.0626, 0, 0), tube.halfwidth));
  CHECK_FALSE(contains_within(tube, place(0, 0.0157, 0), tube.halfwidth));
  CHECK_FALSE(contains_within(tube, place(0, 0, 0x1p-5), tube.halfwidth));
  CHECK(half_widths(tube)[1] >= 0.5 * 0x1p-4 + 0x1p-6);
  CHECK(half_widths(tube)[0] < 0x1p-4 * (1 + 1e-9));
}

TEST_CASE("straight tube: contact equations, over a box", "[trace]") {
  random_pairs::Generator generator(20274);
  std::uniform_real_distribution<double> any(-1, 1);
  int linearised_systems = 0;
  for (int round = 0; round < 20; ++round) {
    const auto pair = random_pairs::small_rationals(generator);
    const PairSystem<Ball> system(pair.x, pair.y, {0, 0, 0}, 0);
    const Place p = testing::random_place(generator);
    const std::size_t axis = static_cast<std::size_t>(round % 4);
    const auto equations = [&](const Place& at) {
      return contact_equations(Expansion<Ball>(system, testing::ball_point<Ball>(at)), {0, 1}, axis);
    };
    const auto line = linearised(linear_part(equations(p)), axis);
    if (!line) continue;
    ++linearised_systems;
    const auto g = preconditioned(line->preconditioner, equations(p));
    const std::array<double, 4> reach = {0x1p-5, 0x1p-6, 0x1p-5, 0x1p-7};
    const JacobianDeviation bound = jacobian_deviation(g, axis, line->slope, reach);
    for (int sample = 0; sample < 5; ++sample) {
      Place at = p;
      for (std::size_t j = 0; j < 4; ++j) at[j] += from_double(reach[j] * any(generator));
      const auto there = linear_part(preconditioned(line->preconditioner, equations(at)));
      for (std::size_t row = 0; row < 3; ++row)
        for (std::size_t j = 0; j < 4; ++j)
          CHECK((there[j][row] - Ball::enclosing(ideal(*line, row, j))).lower_magnitude() <=
                bound[j][row] * (1 + 1e-9) + 1e-13);
    }
  }
  CHECK(linearised_systems > 10);
}

}  // namespace exsect::straight_tube_test
