// A scene in the file formats of other tools (docs/formats.md).
#pragma once

#include <string>

#include "scene.h"

namespace exsect::cli {

/// Wavefront OBJ: an object for each patch (faces, texture coordinates), curve (line) and node (point).
std::string obj_text(const Scene& scene);
/// Stanford PLY, ascii: vertices with parameters, faces and edges with what they belong to.
std::string ply_text(const Scene& scene);
/// VTK XML PolyData: nodes as vertices, curves as lines, patches as quadrilaterals, with arrays of
/// parameters on points and of ids, kinds and bounds on cells.
std::string vtp_text(const Scene& scene);

}  // namespace exsect::cli
