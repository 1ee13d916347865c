// What one call shares between its stages.
#include "answer/run.h"

#include <exsect/solver/intersect.h>

#include <algorithm>
#include <limits>
#include <thread>

#include "support/catch.h"
#include "support/families.h"

namespace exsect::run_test {
namespace {

using namespace std::chrono_literals;

TEST_CASE("run: options out of range are refused") {
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double tolerance : {0.0, -1e-6, infinity, std::numeric_limits<double>::quiet_NaN()}) {
    IntersectOptions options;
    options.tolerance = tolerance;
    CHECK_THROWS_AS(Run(options), std::invalid_argument);
  }
  for (const double seconds : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
    IntersectOptions options;
    options.max_seconds = seconds;
    CHECK_THROWS_AS(Run(options), std::invalid_argument);
  }
}

TEST_CASE("run: its parts share one clock and one record") {
  IntersectOptions options;
  options.max_seconds = 0.02;
  options.tolerance = 1e-3;
  const Run run(options);
  const Run part = run.with_tolerance(1e-4).with_turning({Parameter::s});
  const StopRequest stop = part.stop();
  CHECK_FALSE(stop());
  CHECK(run.tolerance(2) == 2e-3);
  CHECK(part.tolerance(2) == 2e-4);
  CHECK(part.turning() == std::vector{Parameter::s});
  CHECK(run.turning().size() == 4);
  part.timed("nap", [] { std::this_thread::sleep_for(30ms); });
  part.count("naps", 1);
  run.count("naps", 1);
  CHECK(run.out_of_time());
  CHECK(part.out_of_time());
  CHECK(stop());
  const IntersectResult result = run.finished({});
  CHECK(result.work.steps.at("naps") == 2);
  CHECK(result.work.steps.at("nap ms") >= 30);
  CHECK(result.work.milliseconds >= result.work.steps.at("nap ms"));
}

TEST_CASE("run: the status says whether anything is left") {
  CHECK(Run().finished({}).status == Status::complete);
  IntersectResult open{};
  open.incomplete.push_back({{}, "something"});
  CHECK(Run().finished(open).status == Status::incomplete);
}

TEST_CASE("run: progress grows to 1, through all stages of a call") {
  for (const ExactCase& c : families::specimens()) {
    INFO(c.name);
    IntersectOptions options;
    std::vector<double> seen;
    options.progress = [&](double fraction, const char*) { seen.push_back(fraction); };
    intersect(c.x, c.y, options);
    REQUIRE_FALSE(seen.empty());
    CHECK(seen.front() > 0);
    CHECK(std::ranges::is_sorted(seen));
    CHECK(std::ranges::count(seen, 1.0) == 1);
  }
}

}  // namespace
}  // namespace exsect::run_test
