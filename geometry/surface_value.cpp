#include "surface_value.h"

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

  void require_keys(std::initializer_list<std::string_view> keys) const {
    if (value_.has("box"))
      value_.member("box").fail("not supported yet: surfaces given by equations are taken as a whole");
    value_.require_object(keys);
  }

  Point vector(const char* key) const {
    const JsonValue given = value_.member(key);
    given.require_size(3, "coordinates");
    return {number(given.at(0)), number(given.at(1)), number(given.at(2))};
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
  Rational number(const JsonValue& given) const { return read_number(given, read_); }

  const JsonValue& value_;
  NumberReader read_;
};

ImplicitSurface read(const SurfaceReader& entry, const JsonValue& type) {
  const std::string& kind = type.string();
  if (kind == "plane") {
    entry.require_keys({"name", "type", "point", "normal"});
    return ImplicitSurface::plane(entry.vector("point"), entry.vector("normal"));
  }
  if (kind == "cylinder") {
    entry.require_keys({"name", "type", "point", "axis", "radius", "radius_squared"});
    return ImplicitSurface::cylinder(entry.vector("point"), entry.vector("axis"), entry.length("radius"));
  }
  if (kind == "cone") {
    entry.require_keys({"name", "type", "apex", "axis", "slope", "slope_squared", "nappes"});
    return ImplicitSurface::cone(entry.vector("apex"), entry.vector("axis"), entry.length("slope"),
                                 entry.nappes());
  }
  if (kind == "sphere") {
    entry.require_keys({"name", "type", "centre", "radius", "radius_squared"});
    return ImplicitSurface::sphere(entry.vector("centre"), entry.length("radius"));
  }
  if (kind == "torus") {
    entry.require_keys(
        {"name", "type", "centre", "axis", "major", "major_squared", "minor", "minor_squared"});
    return ImplicitSurface::torus(entry.vector("centre"), entry.vector("axis"), entry.length("major"),
                                  entry.length("minor"));
  }
  if (kind == "implicit") {
    entry.require_keys({"name", "type", "terms"});
    return ImplicitSurface::polynomial(entry.polynomial());
  }
  type.fail("must be plane, cylinder, cone, sphere, torus or implicit");
}

}  // namespace

ImplicitSurface read_implicit_surface(const JsonValue& value, NumberReader read_with) {
  try {
    return read(SurfaceReader(value, read_with), value.member("type"));
  } catch (const SurfaceError& error) {
    const std::string squared = error.where() + "_squared";
    value.member((value.has(squared) ? squared : error.where()).c_str()).fail(error.reason());
  }
}

}  // namespace exsect
