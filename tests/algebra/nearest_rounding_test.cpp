#include <exsect/algebra/ball_roots.h>
#include <exsect/algebra/nearest_double.h>
#include <exsect/algebra/nearest_rounding.h>
#include <exsect/algebra/real_algebraic.h>

#include <cfenv>
#include <limits>
#include <stdexcept>

#include "algebra/random_numbers.h"
#include "support/catch.h"
#include "support/float_environments.h"

namespace exsect::nearest_rounding_test {

namespace {

/// The numbers are read from memory, so that they are added at run time.
struct Sums {
  volatile double one = 1;
  volatile double little = 0x1p-53;
  volatile double least = std::numeric_limits<double>::min();
  volatile double half = 0.5;
  volatile double three = 3;

  /// 1 + 2^-53, 1 + 3/2 2^-52, 2^-1023 and 2^-1074 + 2^-1074, 1/3.
  std::string operator()() const {
    const double subnormal = least * half;
    const volatile double last = std::numeric_limits<double>::denorm_min();
    return bits_of(one + little) + bits_of(one + three * little) + bits_of(subnormal) + bits_of(last + last) +
           bits_of(one / three);
  }
};

const std::string to_nearest =
    bits_of(1.0) + bits_of(1 + 0x1p-51) + bits_of(0x1p-1023) + bits_of(0x1p-1073) + bits_of(1.0 / 3);

}  // namespace

TEST_CASE("nearest rounding: in every environment, which comes back") {
  const Sums sums;
  for (const FloatEnvironment& environment : float_environments()) {
    INFO(text(environment));
    enter(environment);
    const std::string outside = sums();
    const std::string inside = in_nearest_rounding([&] { return sums(); });
    const FloatEnvironment after = current_environment();
    const std::string again = sums();
    enter({});
    CHECK(inside == to_nearest);
    CHECK((outside == to_nearest) == (environment == FloatEnvironment{}));
    CHECK(after == environment);
    CHECK(again == outside);
  }
}

TEST_CASE("nearest rounding: an exception passes and the environment comes back") {
  for (const FloatEnvironment& environment : float_environments()) {
    INFO(text(environment));
    enter(environment);
    bool caught = false;
    try {
      in_nearest_rounding([&]() -> int { throw std::runtime_error("here"); });
    } catch (const std::runtime_error&) {
      caught = true;
    }
    const FloatEnvironment after = current_environment();
    enter({});
    CHECK(caught);
    CHECK(after == environment);
  }
}

TEST_CASE("nearest rounding: guards in guards") {
  const Sums sums;
  const FloatEnvironment outer = float_environments().back();
  enter(outer);
  const std::string inside = in_nearest_rounding([&] {
    const std::string first = in_nearest_rounding([&] { return sums(); });
    return first == sums() ? first : "the environment of the outer guard was lost";
  });
  const FloatEnvironment after = current_environment();
  enter({});
  CHECK(inside == to_nearest);
  CHECK(after == outer);
}

#if defined(__x86_64__) && defined(__GLIBC__)
TEST_CASE("nearest rounding: no trap for a caller who traps exceptions") {
  const volatile double zero = 0;
  const volatile double one = 1;
  std::fenv_t before;
  std::fegetenv(&before);
  feenableexcept(FE_DIVBYZERO | FE_OVERFLOW | FE_INVALID);
  const bool infinite = in_nearest_rounding([&] { return one / zero > 1; });
  const int enabled = fegetexcept();
  std::fesetenv(&before);
  CHECK(infinite);
  CHECK(enabled == (FE_DIVBYZERO | FE_OVERFLOW | FE_INVALID));
}
#endif

TEST_CASE("nearest rounding: numbers and roots are the same in every environment") {
  const std::vector<Rational> numbers = {Rational(1) / 3,         Rational(-1) / 10,
                                         power_of_two(-1074),     3 * power_of_two(-1075),
                                         -power_of_two(-1030),    power_of_two(1023) * 3 / 2,
                                         power_of_two(-1022) / 3, Rational(1) / (Integer(1) << 1080)};
  const Polynomial t = Polynomial::variable();
  const Polynomial f = t * t * t * t * t - Rational(7) / 5 * t + Rational(1) / 9;
  const std::vector<DoubleDoubleBall> balls = {0.125, -1.0, 0.0, 0.25};
  const auto all = [&] {
    std::string result;
    for (const Rational& q : numbers) {
      const double x = to_double(q);
      result += bits_of(x) + " " + from_double(x).str() + " " + bits_of(nearest_double(q).value) + "\n";
    }
    for (const RealAlgebraic& root : real_roots(f, -2, 2)) {
      result += bits_of(root.to_double()) + (root.compare(Rational(1) / 12) > 0 ? "+" : "-");
    }
    const auto roots = isolate_ball_roots(balls);
    for (const DoubleDoubleBall& root : roots.value())
      result += bits_of(root.approximation()) + bits_of(root.radius());
    return result;
  };
  const std::string expected = all();
  for (const FloatEnvironment& environment : float_environments()) {
    INFO(text(environment));
    enter(environment);
    const std::string result = all();
    const FloatEnvironment after = current_environment();
    enter({});
    CHECK(result == expected);
    CHECK(after == environment);
  }
}

}  // namespace exsect::nearest_rounding_test
