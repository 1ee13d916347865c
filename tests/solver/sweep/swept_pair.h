// What the exact part of a sweep knows of a pair without singular points, as intersect_by_sweep() finds it.
#pragma once

#include "answer/model_scale.h"
#include "eliminant/exact_pair.h"
#include "side/boundary_lines.h"
#include "support/catch.h"
#include "sweep/sweep_data.h"
#include "trace/enclose.h"

namespace exsect::testing {

class SweptPair {
 public:
  SweptPair(BezierPatch x, BezierPatch y)
      : x_(std::move(x)), y_(std::move(y)), pair_(x_, y_), data{pair_}, system(x_, y_, Point{0, 0, 0}, 0) {
    data.turning = pair_.choice().turning;
    REQUIRE(data.turning);
    const BoundaryLines sides = boundary_lines(x_, y_, model_scale(x_, y_), 1e-6, {});
    REQUIRE(sides.incomplete.empty());
    for (const CertifiedPoint& point : sides.points)
      data.landmarks.push_back({point, std::nullopt, 0, Parameter::u, false});
    data.samples = sweep_samples(*data.turning, sides.points);
    for (const Rational& sample : data.samples)
      data.fibres.push_back(pair_.fibre({data.turning->sweep, sample}).points);
    for (const LandmarkPoint& landmark : data.landmarks)
      landmarks.push_back(enclose<DoubleBall>(landmark.point, width));
  }
  SweptPair(const SweptPair&) = delete;
  SweptPair& operator=(const SweptPair&) = delete;

 private:
  BezierPatch x_, y_;
  ExactPair pair_;

 public:
  const Rational width = power_of_two(-50);
  SweepData data;
  PairSystem<DoubleBall> system;
  Landmarks<DoubleBall> landmarks;
};

}  // namespace exsect::testing
