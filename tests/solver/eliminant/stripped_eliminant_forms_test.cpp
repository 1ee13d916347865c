// The eliminant without fixed factors, fast and slowly.
#include "eliminant/stripped_eliminant_forms.h"

#include <optional>

#include "eliminant/stripped_eliminant.h"
#include "eliminant/turning_eliminant_modular.h"
#include "eliminant/vector_eliminant.h"
#include "eliminant/weighted_eliminant_height.h"
#include "solver/filter/round_patches.h"
#include "support/catch.h"
#include "support/random_nets.h"
#include "weighted_pairs.h"

namespace exsect::stripped_eliminant_forms_test {
using namespace exsect::weighted_pairs;

TEST_CASE("stripped forms: vectors and scalars", "[stripped_eliminant_forms]") {
  if (!has_vector_eliminant()) return;
  random_nets::Generator generator(4);
  const HomogeneousPoint apex = {1, 2, 3, 1};
  Random random(4);
  const auto some = [&] {
    return HomogeneousPoint{small_rational(random), small_rational(random), small_rational(random), 1};
  };
  for (const auto& [m, n] : {std::array{2, 2}, std::array{2, 1}, std::array{3, 1}}) {
    CAPTURE(m, n);
    const RationalPatch x = random_nets::weighted(generator, random_nets::small(generator, m, n)),
                        torus = testing::torus(2, 1);
    std::vector<std::vector<HomogeneousPoint>> pole(3);
    for (std::vector<HomogeneousPoint>& row : pole) row = {apex, some(), some()};
    for (const RationalPatch& y : {torus, RationalPatch::from_homogeneous(pole)}) {
      StrippedPair pair{weighted_pair(x, y), {}};
      for (const Rational& c : point_lines(pair.y).coefficients()) pair.factor.emplace_back(numerator(c));
      const std::size_t bound = eliminant_height_bound(pair);
      const auto by_vectors = vector_eliminant(pair, bound);
      REQUIRE(by_vectors);
      const auto by_scalars = by_kind(pair, [&]<class Kind>(Kind) -> std::optional<ModularIntegers> {
        return interpolate_modular_polynomial(Kind::degree(pair.x.size() - 1), bound + 200,
                                              [&](const PrimeField& field, Residue u, std::size_t count) {
                                                const WeightedModularEliminant<Kind> e(field, pair);
                                                std::vector<ResidueFraction> values;
                                                for (; values.size() < count; u = field.add(u, field.one()))
                                                  values.push_back(e.value(u));
                                                return values;
                                              });
      });
      REQUIRE(by_scalars);
      CHECK(chinese_remainder(*by_vectors) == chinese_remainder(*by_scalars));
    }
  }
}

}  // namespace exsect::stripped_eliminant_forms_test
