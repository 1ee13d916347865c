#include "output/drawing/scene_vtp.h"

#include <fmt/format.h>

#include "output/text/terminal_text.h"

namespace exsect::cli {
namespace {

/// One cell's values in the order of its arrays. Cells stand in the order of VTK: vertices, lines, polygons.
struct CellValues {
  int piece;  // 0 node, 1 curve, 2 patch
  int id;     // of the node or arc, 0 or 1 for the patches
  int component;
  int overlap;
  unsigned kind;
  int on;
  int contact;
  double bound;
  std::string name;
};

class Vtp {
 public:
  explicit Vtp(const Scene& scene) : scene_(scene) {}

  std::string text() {
    const std::string verts = nodes();
    const std::string lines = curves();
    const std::string polys = meshes();
    return fmt::format(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
        "<!-- exsect: {}. piece: 0 node, 1 arc, 2 patch; kind of a node: sum of 1 boundary, 2 turning, 4 "
        "corner, "
        "8 touch, 16 crossing, 32 cusp, 64 end of overlap; on: 1 along a side of a patch; contact: 1 "
        "tangential; "
        "bound: proved distance from the true curve or surface; -1 stands for none -->\n"
        "<VTKFile type=\"PolyData\" version=\"0.1\" byte_order=\"LittleEndian\">\n<PolyData>\n"
        "<Piece NumberOfPoints=\"{}\" NumberOfVerts=\"{}\" NumberOfLines=\"{}\" NumberOfStrips=\"0\" "
        "NumberOfPolys=\"{}\">\n{}{}<Points>\n{}</Points>\n{}{}{}</Piece>\n</PolyData>\n</VTKFile>\n",
        comment(scene_.title), points_, scene_.nodes.size(), scene_.curves.size(), polygons_, point_data(),
        cell_data(), array("Float64", "Points", coordinates_, 3), verts, lines, polys);
  }

 private:
  static std::string array(const std::string& type, const std::string& name, const std::string& values,
                           int components = 1) {
    return fmt::format(
        "<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"ascii\">\n{}</DataArray>\n",
        type, name, components, values);
  }

  /// Two hyphens would end the comment.
  static std::string comment(const std::string& text) {
    std::string safe = printable(text);
    for (char& c : safe) c = c == '-' ? ' ' : c;
    return safe;
  }

  std::size_t add_point(const PolylineVertex& vertex) {
    coordinates_ += fmt::format("{} {} {}\n", vertex.point[0], vertex.point[1], vertex.point[2]);
    for (std::size_t k = 0; k < 4; ++k) parameters_[k] += fmt::format("{}\n", vertex.parameters[k]);
    return points_++;
  }

  static std::string cells(const std::string& element, const std::string& connectivity,
                           const std::string& offsets) {
    return fmt::format("<{0}>\n{1}{2}</{0}>\n", element, array("Int64", "connectivity", connectivity),
                       array("Int64", "offsets", offsets));
  }

  std::string nodes() {
    std::string connectivity, offsets;
    for (const SceneNode& node : scene_.nodes) {
      connectivity += fmt::format("{}\n", add_point(node.vertex));
      offsets += fmt::format("{}\n", points_);
      cells_.push_back({0, node.id, -1, -1, node.kinds, 0, 0, nothing_proved, node.name});
    }
    return cells("Verts", connectivity, offsets);
  }

  std::string curves() {
    std::string connectivity, offsets;
    std::size_t end = 0;
    for (const SceneCurve& curve : scene_.curves) {
      for (const PolylineVertex& vertex : curve.vertices)
        connectivity += fmt::format("{} ", add_point(vertex));
      connectivity += "\n";
      offsets += fmt::format("{}\n", end += curve.vertices.size());
      cells_.push_back(
          {1, curve.arc, curve.component, curve.overlap, 0, curve.place == ArcPlace::patch_boundary ? 1 : 0,
           curve.contact == Contact::tangential ? 1 : 0, decimal_not_below(curve.error_bound), curve.name});
    }
    return cells("Lines", connectivity, offsets);
  }

  std::string meshes() {
    std::string connectivity, offsets;
    std::size_t end = 0;
    for (std::size_t i = 0; i < scene_.meshes.size(); ++i) {
      const SceneMesh& mesh = scene_.meshes[i];
      const std::size_t first = points_;
      for (const PolylineVertex& vertex : mesh.vertices) add_point(vertex);
      for (const std::vector<std::size_t>& face : mesh.faces) {
        for (std::size_t k : face) connectivity += fmt::format("{} ", first + k);
        connectivity += "\n";
        offsets += fmt::format("{}\n", end += face.size());
        ++polygons_;
        cells_.push_back(
            {2, static_cast<int>(i), -1, -1, 0, 0, 0, decimal_not_below(mesh.error_bound), mesh.name});
      }
    }
    return cells("Polys", connectivity, offsets);
  }

  std::string point_data() const {
    std::string text = "<PointData>\n";
    for (std::size_t k = 0; k < 4; ++k) text += array("Float64", scene_.parameters[k], parameters_[k]);
    return text + "</PointData>\n";
  }

  template <typename Value>
  std::string column(const std::string& type, const std::string& name, Value value) const {
    std::string values;
    for (const CellValues& cell : cells_) values += fmt::format("{}\n", value(cell));
    return array(type, name, values);
  }

  /// A text is its bytes, ended by 0.
  std::string names() const {
    return column("String", "name", [](const CellValues& cell) {
      std::string bytes;
      for (char c : cell.name)
        bytes += fmt::format("{} ", static_cast<unsigned>(static_cast<unsigned char>(c)));
      return bytes + "0";
    });
  }

  std::string cell_data() const {
    return "<CellData>\n" + column("Int32", "piece", [](const CellValues& c) { return c.piece; }) +
           column("Int32", "node", [](const CellValues& c) { return c.piece == 0 ? c.id : -1; }) +
           column("Int32", "arc", [](const CellValues& c) { return c.piece == 1 ? c.id : -1; }) +
           column("Int32", "patch", [](const CellValues& c) { return c.piece == 2 ? c.id : -1; }) +
           column("Int32", "component", [](const CellValues& c) { return c.component; }) +
           column("Int32", "overlap", [](const CellValues& c) { return c.overlap; }) +
           column("Int32", "kind", [](const CellValues& c) { return c.kind; }) +
           column("Int32", "on", [](const CellValues& c) { return c.on; }) +
           column("Int32", "contact", [](const CellValues& c) { return c.contact; }) +
           column("Float64", "bound", [](const CellValues& c) { return c.bound; }) + names() +
           "</CellData>\n";
  }

  const Scene& scene_;
  std::size_t points_ = 0;
  std::size_t polygons_ = 0;
  std::string coordinates_;
  std::array<std::string, 4> parameters_;
  std::vector<CellValues> cells_;
};

}  // namespace

std::string vtp_text(const Scene& scene) { return Vtp(scene).text(); }

}  // namespace exsect::cli
