#include "cli/export_files.h"

#include <exsect/geometry/text_file.h>

#include <utility>
#include <vector>

#include "output/drawing/scene_obj.h"
#include "output/drawing/scene_ply.h"
#include "output/drawing/scene_vtp.h"
#include "output/options/implicitize_options.h"

namespace exsect::cli {

int grid_cells(const ExportFiles& files) { return integer_value("--grid", files.grid, 1, 512); }

void write_exports(const ExportFiles& files, const std::function<Scene()>& scene,
                   const std::function<std::string()>& table) {
  std::vector<std::pair<std::string, std::string>> texts;
  if (!files.obj.empty() || !files.ply.empty() || !files.vtp.empty()) {
    const Scene shown = scene();
    if (!files.obj.empty()) texts.emplace_back(files.obj, obj_text(shown));
    if (!files.ply.empty()) texts.emplace_back(files.ply, ply_text(shown));
    if (!files.vtp.empty()) texts.emplace_back(files.vtp, vtp_text(shown));
  }
  if (!files.csv.empty()) texts.emplace_back(files.csv, table());
  for (const auto& [path, text] : texts) write_file_atomically(path, text);
}

}  // namespace exsect::cli
