#include "output/text/node_place.h"

#include <exsect/geometry/bounding_box.h>

#include <algorithm>

#include "output/text/proved_decimal.h"

namespace exsect::cli {
namespace {

/// The part of a box of solutions that lies in the parameters' domain.
RationalInterval in_domain(const RationalInterval& t) {
  return {std::max<Rational>(t.lower, 0), std::min<Rational>(t.upper, 1)};
}

BoundingBox piece_box(const RationalPatch& patch, const RationalInterval& first,
                      const RationalInterval& second) {
  const RationalInterval a = in_domain(first), b = in_domain(second);
  return bounding_box(patch.restricted_to(a.lower, a.upper, b.lower, b.upper));
}

/// The power of ten that the largest coordinate reaches; 0 if all of them are zero.
long scale_of(const std::vector<SpaceBox>& places) {
  Rational largest = 0;
  for (const SpaceBox& place : places)
    for (const RationalInterval& side : place)
      largest = std::max({largest, Rational(abs(side.lower)), Rational(abs(side.upper))});
  return largest == 0 ? 0 : decimal_exponent(largest);
}

}  // namespace

SpaceBox space_box(const ParameterBox& box, const RationalPatch& x, const RationalPatch& y) {
  const BoundingBox a = piece_box(x, box[index(Parameter::u)], box[index(Parameter::v)]);
  const BoundingBox b = piece_box(y, box[index(Parameter::r)], box[index(Parameter::s)]);
  SpaceBox place;
  for (std::size_t k = 0; k < 3; ++k)
    place[k] = {std::max(a.lower[k], b.lower[k]), std::min(a.upper[k], b.upper[k])};
  return place;
}

SpaceBox space_box(const ParameterBox& box, const RationalPatch& x) {
  const BoundingBox a = piece_box(x, box[index(Parameter::u)], box[index(Parameter::v)]);
  SpaceBox place;
  for (std::size_t k = 0; k < 3; ++k) place[k] = {a.lower[k], a.upper[k]};
  return place;
}

namespace {

/// Of the first `count` parameters.
std::vector<std::vector<std::string>> rows_of_places(const std::vector<ParameterBox>& boxes,
                                                     const std::vector<SpaceBox>& places, std::size_t count,
                                                     int decimals) {
  const long scale = scale_of(places);
  std::vector<std::vector<std::string>> rows;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    std::vector<std::string> row;
    for (std::size_t k = 0; k < count; ++k) row.push_back(proved_decimal(boxes[i][k], -decimals));
    for (const RationalInterval& side : places[i])
      row.push_back(proved_decimal(side, scale - decimals, scale));
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace

std::vector<std::vector<std::string>> place_rows(const std::vector<ParameterBox>& boxes,
                                                 const RationalPatch& x, const RationalPatch& y,
                                                 int decimals) {
  std::vector<SpaceBox> places;
  places.reserve(boxes.size());
  for (const ParameterBox& box : boxes) places.push_back(space_box(box, x, y));
  return rows_of_places(boxes, places, 4, decimals);
}

std::vector<std::vector<std::string>> place_rows(const std::vector<ParameterBox>& boxes,
                                                 const RationalPatch& x, int decimals) {
  std::vector<SpaceBox> places;
  places.reserve(boxes.size());
  for (const ParameterBox& box : boxes) places.push_back(space_box(box, x));
  return rows_of_places(boxes, places, 2, decimals);
}

}  // namespace exsect::cli
