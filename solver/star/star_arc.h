// Arcs of a star from a port to the centre. Internal to solver/.
#pragma once

#include "star/star_neighbourhood.h"

namespace exsect {

/// Of a star with two ports the parameters that turn in its centre: both arcs lie on one side of it. Empty if
/// that is not decided.
std::optional<std::vector<Parameter>> turning_parameters(const StarNeighbourhood& star);

StarArc star_arc(const StarNeighbourhood& star, const Port& port);

}  // namespace exsect
