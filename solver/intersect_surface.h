// The exact, complete, certified intersection of a surface given by its equation with a patch.
#pragma once

#include <exsect/geometry/implicit_surface.h>
#include <exsect/geometry/rational_patch.h>
#include <exsect/solver/options.h>
#include <exsect/solver/result.h>

namespace exsect {

/// Every point (u,v) of [0,1]^2 with x(u,v) on the surface, or on its part in a box (method, section 17): for
/// every patch, of every degree and with weights or without, whatever meets there. Points on the rim of a box
/// are nodes, of kind `boundary`, and `bounds` names what they lie on. The surface has no parameters: r and s
/// are 0 in every box and vertex, and say nothing. The tolerance is relative to the extent of the patch. Arcs
/// along which the patch touches the surface, or which belong to a multiple factor of its equation, are
/// `tangential`. A node where an arc begins in a singular point alone (the apex of one nappe) is a `cusp`.
/// Turning points with respect to u are always nodes. A patch that lies on the surface is one Overlap, whose
/// chain is its four sides; where a box or one nappe cuts it, there is one for each connected part, with the
/// region to the left of its chains, and what has no inner points is arcs and isolated points. Arcs have the
/// equation's signs beside them, isolated points the sign around them, but not the apex of a cone of one
/// nappe, where there may be both. The work cap, progress and errors are those of intersect() for two
/// patches.
IntersectResult intersect(const ImplicitSurface& surface, const RationalPatch& x,
                          const IntersectOptions& options = {});

}  // namespace exsect
