// A parameter line of one patch against the other patch: points, exactly and in doubles, and everything about
// it.
#pragma once

#include <exsect/solver/line_intersection.h>
#include <exsect/solver/line_points.h>
#include <exsect/solver/line_points_filtered.h>
