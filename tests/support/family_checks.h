// Checks of a family of exact cases: under exchanges and affine maps, and close to special position.
#pragma once

#include <algorithm>
#include <ctime>
#include <functional>

#include "support/catch.h"
#include "support/families.h"

namespace exsect {

/// The exact answer comes out.
inline void check(const ExactCase& c) {
  INFO(c.name);
  CHECK(failure(c) == "");
}

/// The case, and all its images.
inline void check_images(const ExactCase& c, std::uint64_t seed = 1) {
  check(c);
  for (const CaseChange& change : case_changes()) {
    INFO(c.name << ", " << change.name << ", seed " << seed);
    random_pairs::Generator generator(seed);
    CHECK(failure(change.apply(c, generator)) == "");
  }
}

/// The distances from special position: 10^-3, 10^-6, ...
inline const std::vector<Rational>& distances() {
  static const std::vector<Rational> list = {Rational(1, 1000), Rational(1, 1000000), Rational(1, 1000000000),
                                             Rational(1, 1000000000000), Rational(1) / pow(Integer(10), 20)};
  return list;
}

/// Of processor time: other programs may keep this one waiting.
inline double seconds(const ExactCase& c) {
  const std::clock_t start = std::clock();
  check(c);
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

/// The exact answer at every distance, in no more than ten times the time for the first one (times below a
/// fiftieth of a second count as that). `count`: of distances.
inline void check_near(const std::function<ExactCase(const Rational&)>& family, std::size_t count = 5) {
  double first = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const Rational e = distances()[k];
    INFO("distance " << e);
    double time = seconds(family(e));
    if (first == 0) first = std::max(time, 0.02);
    for (int again = 0; time > 10 * first && again < 2; ++again) time = seconds(family(e));
    CHECK(time <= 10 * first);
  }
}

}  // namespace exsect
