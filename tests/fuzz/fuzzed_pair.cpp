#include "fuzz/fuzzed_pair.h"

#include <exsect/solver/intersect.h>
#include <exsect/solver/self_intersect.h>

#include <algorithm>
#include <ctime>
#include <optional>
#include <stdexcept>

#include "support/graph_checks.h"
#include "support/graph_isomorphism.h"
#include "support/self_locus.h"

namespace exsect::fuzz {
namespace {

class Bytes {
 public:
  explicit Bytes(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  /// 0 to n - 1.
  int below(int n) { return next_ < bytes_.size() ? bytes_[next_++] % n : -1; }
  Rational coordinate(int largest) {
    const int value = below(2 * largest + 1);
    return value < 0 ? 0 : value - largest;
  }
  Point point(int largest) {
    const Rational a = coordinate(largest);
    const Rational b = coordinate(largest);
    return {a, b, coordinate(largest)};
  }
  ControlNet net(int largest) {
    ControlNet result;
    for (auto& row : result) {
      for (Point& p : row) p = point(largest);
    }
    return result;
  }

 private:
  std::span<const std::uint8_t> bytes_;
  std::size_t next_ = 0;
};

BezierPatch bilinear(Bytes& bytes) {
  std::vector<std::vector<Point>> points(2);
  for (auto& row : points) row = {bytes.point(2), bytes.point(2)};
  return BezierPatch::elevated(points);
}

BezierPatch graph(Bytes& bytes, bool flat) {
  ControlNet net = bytes.net(2);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      net[i][j][0] = static_cast<long>(i);
      net[i][j][1] = static_cast<long>(j);
      if (flat) net[i][j][2] = 0;
    }
  }
  return BezierPatch(net);
}

}  // namespace

random_pairs::Pair pair(std::span<const std::uint8_t> bytes_given) {
  Bytes bytes(bytes_given);
  const int kind = bytes.below(10);
  if (kind == 6) {
    const BezierPatch x = bilinear(bytes);
    return {x, BezierPatch(bytes.net(2))};
  }
  if (kind == 9) {
    const BezierPatch x = graph(bytes, false);
    return {x, graph(bytes, true)};
  }
  ControlNet x = bytes.net(kind == 1 ? 1 : 2);
  ControlNet y = kind == 4 || kind == 5 ? x : bytes.net(kind == 1 ? 1 : 2);
  if (kind == 2) y[0] = x[0];
  if (kind == 3) y[0] = {x[0][2], x[0][1], x[0][0]};
  if (kind == 4) {
    const int place = std::max(bytes.below(9), 0);
    y[static_cast<std::size_t>(place / 3)][static_cast<std::size_t>(place % 3)] = bytes.point(2);
  }
  if (kind == 5) {
    const auto ends = [&] {
      const Rational lower = bytes.coordinate(1) / 2;
      return std::array<Rational, 2>{lower, lower + 1 + bytes.coordinate(1) / 2};
    };
    const auto u = ends();
    const auto v = ends();
    y = BezierPatch(x).restricted_to(u[0], u[1], v[0], v[1]).net();
  }
  if (kind == 7) {
    for (auto& row : y) {
      for (Point& p : row) p[2] = 0;
    }
  }
  if (kind == 8) x[0] = {x[0][0], x[0][0], x[0][0]};
  return {BezierPatch(x), BezierPatch(y)};
}

namespace {

/// Of processor time: other programs may keep this one waiting.
double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

bool reached_cap(const IntersectResult& result) {
  return std::ranges::any_of(result.incomplete,
                             [](const Incomplete& i) { return i.why.find("work cap") != std::string::npos; });
}

std::string cap_violation(double seconds, int runs, double max_seconds) {
  if (seconds <= runs * (1.1 * max_seconds + 0.5)) return "";
  return "the work cap was passed: " + std::to_string(seconds) + " s";
}

/// Crossings of parameter lines against their exact fibres; a finer polyline decides where they disagree.
void compare_fibres(const BezierPatch& x, const IntersectOptions& options, Verdict& verdict) {
  IntersectOptions fine = options;
  fine.tolerance = 1e-7;
  std::optional<IntersectResult> finer;
  for (const std::size_t parameter : {0U, 1U})
    for (const Rational& value : {Rational(2, 13), Rational(27, 61), Rational(34, 41)}) {
      const auto expected = static_cast<int>(testing::self_fibre(x, parameter, value).size());
      ++verdict.compared_lines;
      if (testing::polyline_crossings(verdict.result.graph, parameter, to_double(value)) == expected)
        continue;
      if (!finer) finer = self_intersect(x, fine);
      const int crossings = testing::polyline_crossings(finer->graph, parameter, to_double(value));
      if (crossings != expected)
        verdict.violation = "the line " + std::string(parameter == 0 ? "u = " : "v = ") + value.str() +
                            " has " + std::to_string(expected) + " pairs and not " +
                            std::to_string(crossings);
    }
}

}  // namespace

Verdict check_self(const BezierPatch& x, double max_seconds) {
  IntersectOptions options;
  options.tolerance = 1e-3;
  options.max_seconds = max_seconds;
  const double start = processor_seconds();
  Verdict verdict{"", self_intersect(x, options)};
  const IntersectResult exchanged = self_intersect(x.exchanged(), options);
  const double seconds = processor_seconds() - start;
  verdict.violation = unsound(x, x, verdict.result);
  if (verdict.violation.empty()) verdict.violation = unsound(x.exchanged(), x.exchanged(), exchanged);
  if (verdict.violation.empty()) verdict.violation = cap_violation(seconds, 2, max_seconds);
  const auto counts = [](const IntersectResult& result) {
    return std::array<std::size_t, 3>{result.graph.components.size(), result.graph.arcs.size(),
                                      result.graph.isolated_points.size()};
  };
  const bool capped = reached_cap(verdict.result) || reached_cap(exchanged);
  if (verdict.violation.empty() && !capped &&
      (verdict.result.status != exchanged.status ||
       (exchanged.status == Status::complete && counts(verdict.result) != counts(exchanged))))
    verdict.violation = "exchanging the parameters changes the answer";
  if (verdict.violation.empty() && verdict.result.status == Status::complete &&
      verdict.result.graph.overlaps.empty())
    compare_fibres(x, options, verdict);
  return verdict;
}

Verdict check(const random_pairs::Pair& pair, double max_seconds) {
  IntersectOptions options;
  options.tolerance = 1e-3;
  options.max_seconds = max_seconds;
  const double start = processor_seconds();
  Verdict verdict{"", intersect(pair.x, pair.y, options)};
  const IntersectResult exchanged = intersect(pair.y, pair.x, options);
  const double seconds = processor_seconds() - start;
  const IntersectResult& result = verdict.result;
  verdict.violation = unsound(pair.x, pair.y, result);
  if (verdict.violation.empty()) verdict.violation = unsound(pair.y, pair.x, exchanged);
  if (verdict.violation.empty()) verdict.violation = cap_violation(seconds, 2, max_seconds);
  const bool capped = reached_cap(result) || reached_cap(exchanged);
  if (verdict.violation.empty() && result.status != exchanged.status && !capped) {
    verdict.violation = "exchanging the patches changes the status";
  }
  if (!verdict.violation.empty() || result.status != Status::complete || capped) return verdict;
  verdict.violation = difference(result.graph, exchanged.graph, {{2, 3, 0, 1}, {}}, 2e-2);
  if (!verdict.violation.empty()) return verdict;
  const Comparison comparison = compare_with_oracle(pair.x, pair.y, result.graph);
  verdict.violation = comparison.difference;
  verdict.compared_lines = comparison.lines;
  return verdict;
}

}  // namespace exsect::fuzz
