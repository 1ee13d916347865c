// The families of the comparison: the same pairs for the same seed, in doubles where that is promised.
#include "pair_families.h"

#include <exsect/geometry/number.h>
#include <exsect/geometry/surface_file.h>

#include "support/catch.h"

using namespace peers;

namespace {

/// Whether every number is: they are the strings of arrays, and those of the lengths of round surfaces.
bool in_doubles(const nlohmann::ordered_json& value, const std::string& key = "") {
  if (value.is_string()) {
    if (key == "name" || key == "type") return true;
    const exsect::Rational q = exsect::parse_number(value.get<std::string>());
    return exsect::from_double(exsect::to_double(q)) == q;
  }
  bool all = true;
  if (value.is_object())
    for (const auto& [name, member] : value.items()) all = all && in_doubles(member, name);
  if (value.is_array())
    for (const auto& member : value) all = all && in_doubles(member, key);
  return all;
}

exsect::SurfaceFile read(const nlohmann::ordered_json& entries) {
  const nlohmann::ordered_json file = {{"exsect", "patches/1"}, {"patches", entries}};
  return exsect::parse_surfaces(file.dump(), "family");
}

const Family& family(const std::string& name) {
  for (const Family& one : families())
    if (one.name == name) return one;
  throw std::invalid_argument(name);
}

}  // namespace

TEST_CASE("families are reproducible and, but one, in doubles") {
  for (const Family& family : families()) {
    INFO(family.name);
    Generator a(1);
    Generator b(1);
    bool all = true;
    for (int i = 0; i < 20; ++i) {
      const nlohmann::ordered_json first = family.member(a);
      CHECK(first == family.member(b));
      CHECK(read(first).surfaces.size() == 2);
      all = all && in_doubles(first);
    }
    CHECK(all == (family.name != "random-rational"));
  }
}

TEST_CASE("families are of the kinds that their names say") {
  const auto kinds = [](const std::string& name) {
    Generator generator(2);
    std::string result;
    for (const exsect::NamedSurface& surface : read(family(name).member(generator)).surfaces)
      result +=
          (result.empty() ? "" : ", ") +
          (surface.patch() != nullptr ? kind_of(*surface.patch()) : exsect::name(surface.equation()->kind()));
    return result;
  };
  CHECK(kinds("random-double") == "bidegree (2,2), bidegree (2,2)");
  CHECK(kinds("bicubic") == "bidegree (3,3), bidegree (3,3)");
  CHECK(kinds("weighted") == "bidegree (2,2) with weights, bidegree (2,2) with weights");
  CHECK(kinds("weighted-bicubic") == "bidegree (3,3) with weights, bidegree (3,3) with weights");
  CHECK(kinds("plane-cone") == "plane, cone");
  CHECK(kinds("torus-cylinder") == "torus, cylinder");
  CHECK(kinds("torus-biquadratic") == "bidegree (2,2), torus");
}
