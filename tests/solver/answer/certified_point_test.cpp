#include <exsect/solver/certified_point.h>

#include <memory>

#include "support/catch.h"

namespace exsect::certified_point_test {

namespace {

/// The point (1/3, 1/2, 0, 1): every box is centred elsewhere, so that boxes are not nested by themselves.
class Thirds : public CertifiedPoint::Source {
 public:
  ParameterBox box(const Rational& width) const override {
    const Rational third(1, 3);
    return {{{third - width, third}, {Rational(1, 2), Rational(1, 2) + width / 3}, {0, 0}, {1 - width, 1}}};
  }
};

}  // namespace

TEST_CASE("a certified point keeps its boxes nested") {
  const CertifiedPoint p(std::make_shared<Thirds>(), Rational(1, 8), {{Parameter::r, 0}, {Parameter::s, 1}},
                         2, 1);
  CHECK(p.box()[0].lower == Rational(1, 3) - Rational(1, 8));
  const CertifiedPoint fine = p.refined_to(Rational(1, 1000));
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(fine.box()[i].width() <= Rational(1, 1000));
    CHECK(fine.box()[i].lower >= p.box()[i].lower);
    CHECK(fine.box()[i].upper <= p.box()[i].upper);
  }
  const CertifiedPoint coarse = fine.refined_to(Rational(1, 2));
  CHECK(coarse.box()[0].lower == fine.box()[0].lower);
  CHECK(coarse.multiplicity() == 2);
  CHECK(coarse.branch() == 1);
  CHECK(coarse.on({Parameter::s, 1}));
  CHECK(!coarse.on({Parameter::s, 0}));
  CHECK(!coarse.on({Parameter::u, 0}));
}

}  // namespace exsect::certified_point_test
