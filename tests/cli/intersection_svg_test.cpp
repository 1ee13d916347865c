#include "output/drawing/intersection_svg.h"

#include <boost/property_tree/xml_parser.hpp>
#include <cmath>
#include <sstream>

#include "sample_result.h"
#include "support/catch.h"

namespace exsect::cli::intersection_svg_test {
namespace {

/// Throws unless the text is a well-formed XML document.
boost::property_tree::ptree parsed(const std::string& svg) {
  std::istringstream stream(svg);
  boost::property_tree::ptree tree;
  boost::property_tree::read_xml(stream, tree);
  return tree;
}

std::size_t occurrences(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

TEST_CASE("the picture of a result is well-formed and has every kind of mark in its legend") {
  const std::string svg =
      intersection_svg(sample_result(), {"a<b", "c&d"}, "Title with <tags> & \x01 control");
  CHECK_NOTHROW(parsed(svg));
  CHECK(occurrences(svg, "Title with &lt;tags&gt; &amp;   control") == 1);
  CHECK(occurrences(svg, "a&lt;b(u, v)") == 1);
  CHECK(occurrences(svg, "c&amp;d(r, s)") == 1);
  for (const char* entry :
       {"component 0, open", "component 1, closed", "tangential contact", "along a side of a patch",
        "boundary point", "turning point", "turns in the other square", "corner", "crossing", "cusp",
        "end of overlap", "one point of space", "isolated point", "overlap", "not decided"}) {
    INFO(entry);
    CHECK(occurrences(svg, std::string(">") + entry + "</text>") == 1);
  }
}

TEST_CASE("an empty result draws two empty squares") {
  const std::string svg = intersection_svg(IntersectResult{Status::complete, {}, {}, {}}, {"x", "y"}, "");
  CHECK_NOTHROW(parsed(svg));
  CHECK(occurrences(svg, "component") == 0);
}

TEST_CASE("long polylines and many components stay small") {
  IntersectResult result{Status::complete, {}, {}, {}};
  for (int c = 0; c < 12; ++c) {
    Arc long_arc = arc(c, c, 0, 1, {}, 1e-9);
    for (int i = 0; i <= 20000; ++i) {
      const double t = i / 20000.0;
      const double y = (c + 0.5 + 0.4 * std::sin(9 * t)) / 12;
      long_arc.polyline.push_back({{t, y, y, t}, {t, y, 0}});
    }
    result.graph.arcs.push_back(long_arc);
    result.graph.components.push_back({c, ComponentShape::open, {c}});
  }
  const std::string svg = intersection_svg(result, {"x", "y"}, std::string(500, 'W'));
  CHECK_NOTHROW(parsed(svg));
  CHECK(svg.size() < 200000);
  CHECK(occurrences(svg, ">and 4 more</text>") == 1);
}

}  // namespace
}  // namespace exsect::cli::intersection_svg_test
