#include "surface_value.h"

#include <exsect/geometry/surface_box.h>

#include <array>
#include <optional>
#include <string>

namespace exsect {
namespace {

constexpr int max_surface_degree = 4;

/// The members of one entry, and what its lengths are called in it.
class SurfaceReader {
 public:
  SurfaceReader(const JsonValue& value, NumberReader read) : value_(value), read_(read) {}

  void require_keys(std::initializer_list<std::string_view> keys) const { value_.require_object(keys); }

  Point vector(const char* key) const { return vector(value_.member(key)); }

  /// Of "box"; empty where there is none.
  std::optional<SurfaceBox> box() const {
    if (!value_.has("box")) return std::nullopt;
    const JsonValue given = value_.member("box");
    given.require_object({"axis", "sector", "height", "tube", "sides"});
    SurfaceBox box;
    if (given.has("axis")) box.axis = vector(given.member("axis"));
    if (given.has("sector")) {
      const auto [from, to] = ends(given.member("sector"));
      box.sector = AxisSector{vector(from), vector(to)};
    }
    if (given.has("height")) {
      const auto [from, to] = pair(given.member("height"), "heights");
      box.height = HeightRange{from, to};
    }
    if (given.has("tube")) {
      const auto [from, to] = ends(given.member("tube"));
      box.tube = TubeSector{pair(from, "numbers: outwards and along the axis"),
                            pair(to, "numbers: outwards and along the axis")};
    }
    if (given.has("sides")) {
      const JsonValue sides = given.member("sides");
      sides.require_size(2, "sides");
      box.sides = {vector(sides.at(0)), vector(sides.at(1))};
    }
    return box;
  }

  /// From the key, or its square from the key with "_squared" behind it.
  Length length(const std::string& key) const {
    const std::string squared = key + "_squared";
    if (!value_.has(squared)) return number(value_.member(key.c_str()));
    if (value_.has(key)) value_.member(squared.c_str()).fail("\"" + key + "\" is given as well");
    return Length::of_squared(number(value_.member(squared.c_str())));
  }

  SpacePolynomial polynomial() const {
    const JsonValue given = value_.member("terms");
    SpacePolynomial::Terms terms;
    for (std::size_t i = 0; i < given.size(); ++i) {
      const JsonValue term = given.at(i);
      term.require_size(2, "entries: the coefficient and the exponents of x, y, z");
      const JsonValue powers = term.at(1);
      powers.require_size(3, "exponents");
      Exponents exponents{};
      for (std::size_t k = 0; k < 3; ++k)
        exponents[k] = powers.at(k).small_integer(0, max_surface_degree, "an exponent");
      if (!terms.emplace(exponents, number(term.at(0))).second)
        powers.fail("these exponents are given to two terms");
    }
    return SpacePolynomial(terms);
  }

  int nappes() const {
    return value_.has("nappes") ? value_.member("nappes").small_integer(1, 2, "nappes") : 1;
  }

 private:
  static std::array<JsonValue, 2> ends(const JsonValue& sector) {
    sector.require_object({"from", "to"});
    return {sector.member("from"), sector.member("to")};
  }
  Point vector(const JsonValue& given) const {
    given.require_size(3, "coordinates");
    return {number(given.at(0)), number(given.at(1)), number(given.at(2))};
  }
  std::array<Rational, 2> pair(const JsonValue& given, const char* what) const {
    given.require_size(2, what);
    return {number(given.at(0)), number(given.at(1))};
  }
  Rational number(const JsonValue& given) const { return read_number(given, read_); }

  const JsonValue& value_;
  NumberReader read_;
};

ImplicitSurface read(const SurfaceReader& entry, const JsonValue& type) {
  const std::string& kind = type.string();
  if (kind == "plane") {
    entry.require_keys({"name", "type", "point", "normal", "box"});
    return ImplicitSurface::plane(entry.vector("point"), entry.vector("normal"));
  }
  if (kind == "cylinder") {
    entry.require_keys({"name", "type", "point", "axis", "radius", "radius_squared", "box"});
    return ImplicitSurface::cylinder(entry.vector("point"), entry.vector("axis"), entry.length("radius"));
  }
  if (kind == "cone") {
    entry.require_keys({"name", "type", "apex", "axis", "slope", "slope_squared", "nappes", "box"});
    return ImplicitSurface::cone(entry.vector("apex"), entry.vector("axis"), entry.length("slope"),
                                 entry.nappes());
  }
  if (kind == "sphere") {
    entry.require_keys({"name", "type", "centre", "radius", "radius_squared", "box"});
    return ImplicitSurface::sphere(entry.vector("centre"), entry.length("radius"));
  }
  if (kind == "torus") {
    entry.require_keys(
        {"name", "type", "centre", "axis", "major", "major_squared", "minor", "minor_squared", "box"});
    return ImplicitSurface::torus(entry.vector("centre"), entry.vector("axis"), entry.length("major"),
                                  entry.length("minor"));
  }
  if (kind == "implicit") {
    entry.require_keys({"name", "type", "terms", "box"});
    return ImplicitSurface::polynomial(entry.polynomial());
  }
  type.fail("must be plane, cylinder, cone, sphere, torus or implicit");
}

/// Fails at a place as "radius" or "box.sector.from", or the square that is given for it.
[[noreturn]] void fail_at(const JsonValue& value, const std::string& place, const std::string& reason) {
  if (const std::size_t dot = place.find('.'); dot != std::string::npos)
    fail_at(value.member(place.substr(0, dot).c_str()), place.substr(dot + 1), reason);
  if (const std::size_t bracket = place.find('['); bracket != std::string::npos)
    value.member(place.substr(0, bracket).c_str()).at(std::stoul(place.substr(bracket + 1))).fail(reason);
  const std::string squared = place + "_squared";
  value.member((value.has(squared) ? squared : place).c_str()).fail(reason);
}

}  // namespace

ImplicitSurface read_implicit_surface(const JsonValue& value, NumberReader read_with) {
  try {
    const SurfaceReader entry(value, read_with);
    const ImplicitSurface whole = read(entry, value.member("type"));
    const std::optional<SurfaceBox> box = entry.box();
    return box ? boxed(whole, *box) : whole;
  } catch (const SurfaceError& error) {
    fail_at(value, error.where(), error.reason());
  }
}

}  // namespace exsect
