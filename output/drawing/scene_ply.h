// Scenes as PLY files. Internal to output/.
#pragma once

#include <string>

#include "output/drawing/scene.h"

namespace exsect::cli {

/// Stanford PLY, ascii: vertices with parameters, faces and edges with what they belong to.
std::string ply_text(const Scene& scene);

}  // namespace exsect::cli
