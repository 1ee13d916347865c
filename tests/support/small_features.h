// Pairs with a feature of any size, down to 2^-300 of the square and less, and answers in closed form.
#pragma once

#include <string>
#include <vector>

#include "support/counted_case.h"

namespace exsect::small_features {

struct Feature {
  random_pairs::Pair pair;
  Numbers numbers;
};

/// x is the graph (u, v, h(u,v)) of a polynomial whose zeros are known, y a plane over it, so that the
/// intersection is h = 0 in both squares. Random are all numbers but the size.
struct Family {
  const char* name;
  Feature (*make)(const Rational& size, random_pairs::Generator& generator);
};
const std::vector<Family>& families();

/// The same intersection in another form: half of the time Z + q(X,Y), q a quadratic form, for Z; then
/// rotated by a rational matrix, moved and scaled; parameters exchanged and reversed, patches exchanged, at
/// random.
Feature disguised(Feature feature, random_pairs::Generator& generator);

/// Of a size of 2^-bits times a random factor in [1, 2), disguised.
Feature example(const Family& family, int bits, std::uint64_t seed);
/// counted_failure() of that example.
std::string failure(const Family& family, int bits, std::uint64_t seed, bool exact);

}  // namespace exsect::small_features
