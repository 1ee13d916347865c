// Scenes as VTP files. Internal to output/.
#pragma once

#include <string>

#include "output/drawing/scene.h"

namespace exsect::cli {

/// VTK XML PolyData: nodes as vertices, curves as lines, patches as quadrilaterals, with arrays of
/// parameters on points and of ids, kinds and bounds on cells.
std::string vtp_text(const Scene& scene);

}  // namespace exsect::cli
