// Scenes as OBJ files. Internal to output/.
#pragma once

#include <string>

#include "output/drawing/scene.h"

namespace exsect::cli {

/// Wavefront OBJ: an object for each patch (faces, texture coordinates), curve (line) and node (point).
std::string obj_text(const Scene& scene);

}  // namespace exsect::cli
