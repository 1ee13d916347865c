// The three methods of chapter 9 on one pair of patches, measured alike.
#pragma once

#include <exsect/implicit/quartic_method.h>
#include <exsect/implicit/resultant_method.h>
#include <exsect/solver/intersect.h>

#include <optional>
#include <string>
#include <vector>

namespace exsect::cli {

/// One row of the table. Nothing: the method does not give this.
struct MethodRow {
  std::string method;
  std::string detail;
  std::string answer;  // "complete", "incomplete: why", "regions"
  std::size_t components;
  std::optional<std::size_t> open;
  std::optional<std::size_t> closed;
  std::optional<std::size_t> phantom_branches;  // met
  std::size_t phantoms_removed;
  std::size_t points;          // exact points on the check lines
  std::size_t certified;       // of them found with a proof
  std::size_t missed;          // of them not found
  std::size_t phantom_points;  // met on the check lines
  std::size_t phantom_points_removed;
  double milliseconds;  // of the processor
  std::optional<long> peak_kib;
};

/// The plane of the resultant's curve: (u,r), or (v,s) with check lines v = const for its row.
enum class ResultantPlane { u_r, v_s };

struct Comparison {
  std::size_t lines;  // check lines
  IntersectResult parameter_lines;
  ResultantMethod resultant;
  ResultantPlane plane;
  std::vector<QuarticMethod> quartics;  // of whole y, and of its pieces
  std::vector<QuarticOptions> quartic_options;
  std::vector<MethodRow> rows;

  bool is_complete() const;
};

struct ComparisonOptions {
  int lines = 64;
  PatchFit fit = PatchFit::conics;
  int pieces = 2;
  ResultantPlane plane = ResultantPlane::u_r;
};

Comparison compare(const BezierPatch& x, const BezierPatch& y, const ComparisonOptions& options);

}  // namespace exsect::cli
