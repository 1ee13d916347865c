// Files for other tools: which are asked for, and how they are written.
#pragma once

#include <functional>
#include <string>

#include "output/drawing/scene.h"
#include "output/options/output_files.h"

namespace exsect::cli {

/// The number after --grid. Throws UsageError unless it is an integer from 1 to 512.
int grid_cells(const ExportFiles& files);

/// Writes the scene and the table, each made only if a file asks for it and all of them before the first is
/// written. Throws OutputError, and std::invalid_argument where `scene` does.
void write_exports(const ExportFiles& files, const std::function<Scene()>& scene,
                   const std::function<std::string()>& table);

}  // namespace exsect::cli
