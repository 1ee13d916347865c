// Where arcs leave the chart of a node: a cuspidal point of one patch, or a star.
#pragma once

#include <vector>

#include "certificate/chain.h"
#include "certificate/search.h"
#include "certificate/star.h"

namespace exsect::cli {

/// A tube along w of the chart in which the curve's direction is at most 1; w becomes the cuspidal point.
Tube cusp_tube(const NearPair& pair, Parameters& w);
double cusp_radius(const NearPair& pair, const Tube& tube, const Parameters& w);

/// The arc begins at the cuspidal point or star of the tube. Takes off its points before the gate, where it
/// leaves the chart, and returns them; the gate becomes the first one.
std::vector<TracedPoint> leave_diagonal(const NearPair& pair, std::vector<TracedPoint>& points,
                                        const Tube& tube);
/// The same, with more points than vertices: the error is bounded step by step.
std::vector<TracedPoint> leave_star(std::vector<TracedPoint>& points, const FoundStar& star,
                                    const Tube& tube);

/// The square of the distance, in the parameters, between the end of the half branch and the polyline.
double distance_to_half_branch(const FoundStar& star, const Tube& tube,
                               const std::vector<TracedPoint>& points);

}  // namespace exsect::cli
