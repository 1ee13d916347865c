// What is known exactly of a pair of patches, each fact computed at most once. Internal to solver/;
// docs/method.md, section 4.
#pragma once

#include <exsect/geometry/bezier_patch.h>
#include <exsect/solver/certified_point.h>
#include <exsect/solver/line_points.h>

#include <array>
#include <map>
#include <optional>
#include <utility>

#include "answer/stop_request.h"
#include "eliminant/critical_values.h"
#include "shape/exchanging_symmetry.h"

namespace exsect {

/// The facts about a pair that the exact stages of one call of intersect() ask for: lazily, and kept. Both
/// patches must outlive it. References that it returns stay valid. Not to be shared by threads.
class ExactPair {
 public:
  /// After `stop`, turning eliminants that are not known yet are not computed.
  ExactPair(const BezierPatch& x, const BezierPatch& y, StopRequest stop = {})
      : x_(x), y_(y), stop_(std::move(stop)) {}

  const BezierPatch& x() const { return x_; }
  const BezierPatch& y() const { return y_; }
  const StopRequest& stop() const { return stop_; }

  /// choose_sweep of the pair.
  const SweepChoice& choice();
  /// turning_values of the sweep along p; empty also if it is not known and the work must stop.
  const std::optional<TurningValues>& turning(Parameter p);
  /// exact_line_points of the pair.
  const LinePoints& fibre(const LineQuery& query);

  /// coincident_parameters and plane_coordinates of the pair.
  const std::array<std::size_t, 4>& coincident();
  const std::array<std::optional<std::size_t>, 2>& plane();
  /// exchanging_symmetry of the pair.
  const std::optional<ExchangingSymmetry>& symmetry();

  /// Whether the parameter has this value in the point, a solution of the pair: false also if that is not
  /// known.
  bool surely_takes(const CertifiedPoint& point, Parameter p, const Rational& value) const;

 private:
  const BezierPatch& x_;
  const BezierPatch& y_;
  StopRequest stop_;
  std::optional<std::array<std::size_t, 4>> coincident_;
  std::optional<std::array<std::optional<std::size_t>, 2>> plane_;
  std::optional<SweepChoice> choice_;
  std::array<std::optional<std::optional<TurningValues>>, 4> turning_;  // outer: computed
  std::map<std::pair<Parameter, Rational>, LinePoints> fibres_;
  std::optional<std::optional<ExchangingSymmetry>> symmetry_;  // outer: computed
};

}  // namespace exsect
