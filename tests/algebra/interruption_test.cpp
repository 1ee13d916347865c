#include <exsect/algebra/interruption.h>
#include <exsect/algebra/real_algebraic.h>
#include <exsect/algebra/resultant.h>

#include "support/catch.h"

namespace exsect::interruption_test {

namespace {

/// How often the work asks whether it is to end.
template <class Work>
int asked_by(const Work& work) {
  int asked = 0;
  const InterruptionScope scope([&] {
    ++asked;
    return false;
  });
  work();
  return asked;
}

/// Whether the work is given up when it is asked for the n-th time, n = 1, 2, ...
template <class Work>
bool ends_at(int n, const Work& work) {
  const InterruptionScope scope([&] { return --n <= 0; });
  try {
    work();
    return false;
  } catch (const Interrupted&) {
    return true;
  }
}

/// Roots at 2/5, at 2/5 + 2^-3000, and at 1/3: bisection takes thousands of steps.
Polynomial close_roots() {
  const Rational tiny = Rational(1) / Rational(Integer(1) << 3000);
  const Polynomial t = Polynomial::variable();
  const Rational at(2, 5);
  return (t - Polynomial(at)) * (t - Polynomial(at + tiny)) * (t - Polynomial(Rational(1, 3)));
}

}  // namespace

TEST_CASE("without a scope, or in an empty one, nothing is interrupted") {
  CHECK_NOTHROW(interruption_point());
  const InterruptionScope scope({});
  CHECK_NOTHROW(interruption_point());
}

TEST_CASE("the innermost scope is asked, and the outer one again when it is left") {
  const InterruptionScope outer([] { return true; });
  CHECK_THROWS_AS(interruption_point(), Interrupted);
  {
    const InterruptionScope inner([] { return false; });
    CHECK_NOTHROW(interruption_point());
  }
  CHECK_THROWS_AS(interruption_point(), Interrupted);
}

TEST_CASE("a scope that an exception leaves is asked no more") {
  CHECK(ends_at(1, [] { interruption_point(); }));
  CHECK_NOTHROW(interruption_point());
}

TEST_CASE(
    "isolation of roots, refinement and resultants end at any step, and do the same when called again") {
  const Polynomial f = close_roots();
  const std::vector<RealAlgebraic> roots = real_roots(f, 0, 1);
  REQUIRE(roots.size() == 3);
  const auto isolate = [&] { real_roots(f, 0, 1); };
  const auto refine = [&] {
    RealAlgebraic::root_of(Polynomial::variable() * Polynomial::variable() - Polynomial(Rational(1, 2)),
                           {0, 1})
        .refined_to(Rational(1) / Rational(Integer(1) << 5000));
  };
  const BivariatePolynomial power = BivariatePolynomial::r() + BivariatePolynomial::s();
  const BivariatePolynomial g = power * power * power * power * power + BivariatePolynomial::s();
  const Polynomial eliminant = discriminant_r(g);
  const auto eliminate = [&] { discriminant_r(g); };
  CHECK(asked_by(isolate) > 1000);
  CHECK(asked_by(refine) > 5);
  CHECK(asked_by(eliminate) > 0);
  for (const int n : {1, 2, 3, 100, 1000}) CHECK(ends_at(n, isolate));
  for (const int n : {1, 2, 5}) CHECK(ends_at(n, refine));
  CHECK(ends_at(1, eliminate));
  CHECK(real_roots(f, 0, 1) == roots);
  CHECK(discriminant_r(g) == eliminant);
}

}  // namespace exsect::interruption_test
