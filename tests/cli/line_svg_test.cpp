#include "output/drawing/line_svg.h"

#include <exsect/geometry/patch_file.h>

#include <boost/property_tree/xml_parser.hpp>
#include <sstream>

#include "run_program.h"
#include "support/catch.h"

namespace exsect::cli::line_svg_test {
namespace {

bool shows(const std::string& svg, const std::string& text) {
  return svg.find(">" + text + "</text>") != std::string::npos;
}

void check_well_formed(const std::string& svg) {
  std::istringstream stream(svg);
  boost::property_tree::ptree tree;
  CHECK_NOTHROW(boost::property_tree::read_xml(stream, tree));
}

BezierPatch plane_patch(const char* height) {
  const Rational z(height);
  return BezierPatch::elevated({{{0, 0, z}, {0, 1, z}}, {{1, 0, z}, {1, 1, z}}});
}

TEST_CASE("the picture of a conic line names what it shows") {
  const PatchFile file = read_patches(example("chapter9-first.json"));
  const BezierPatch& x = file.patches[0].patch;
  const BezierPatch& y = file.patches[1].patch;
  const std::string svg = line_svg(intersect_line(x, y, {Parameter::u, Rational("1/2")}), x, "A & B");
  check_well_formed(svg);
  CHECK(svg.size() < 200000);
  for (const char* text : {"A &amp; B", "u = 1/2: 2 points", "plane P = 0, branch 1", "cylinder Z = 0",
                           "v = 0", "v = 1", "feasible s, branch 1", "intersection point"}) {
    INFO(text);
    CHECK(shows(svg, text));
  }
  CHECK_FALSE(shows(svg, "plane P = 0, branch 2"));
  const std::string other = line_svg(intersect_line(x, y, {Parameter::r, Rational("1/2")}), x, "");
  check_well_formed(other);
  CHECK(shows(other, "s = 0"));
  CHECK(shows(other, "feasible v, branch 2"));
}

TEST_CASE("lines of every shape and special position have a picture") {
  const BezierPatch flat = plane_patch("0");
  const BezierPatch wall = BezierPatch::elevated({{{0, Rational("1/2"), -1}, {0, Rational("1/2"), 1}},
                                                  {{1, Rational("1/2"), -1}, {1, Rational("1/2"), 1}}});
  const LineQuery query{Parameter::u, Rational("1/3")};
  const std::string straight = line_svg(intersect_line(flat, wall, query), flat, "");
  check_well_formed(straight);
  CHECK(shows(straight, "u = 1/3: 1 point"));
  CHECK(shows(straight, "second plane"));
  const std::string apart = line_svg(intersect_line(flat, plane_patch("1"), query), flat, "");
  check_well_formed(apart);
  CHECK(shows(apart, "u = 1/3: 0 points"));
  const std::string on = line_svg(intersect_line(flat, flat, query), flat, "");
  check_well_formed(on);
  CHECK(shows(on, "u = 1/3: 0 points, 1 piece on the other patch"));
  const Point corner = {Rational("1/4"), Rational("1/4"), 0};
  const BezierPatch collapsed = BezierPatch::elevated({{corner, corner}, {{1, 0, 1}, {1, 1, 1}}});
  const std::string point = line_svg(intersect_line(collapsed, flat, {Parameter::u, 0}), collapsed, "");
  check_well_formed(point);
}

}  // namespace
}  // namespace exsect::cli::line_svg_test
