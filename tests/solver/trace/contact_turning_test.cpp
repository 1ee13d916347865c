#include "trace/contact_turning.h"

#include "support/bent_contact.h"

namespace exsect::contact_turning_test {

using namespace exsect::testing;  // NOLINT(google-build-using-namespace): the bent contact

TEST_CASE("contact turning: one parameter turns once along the contact, where the formula says", "[trace]") {
  BentContact contact;
  const auto arc = contact.traced();
  const auto found = find_contact_turns(contact.system, arc, contact.pair, {});
  REQUIRE(std::holds_alternative<TurningPoints<DoubleBall>>(found));
  const auto& turns = std::get<TurningPoints<DoubleBall>>(found);
  REQUIRE(turns.size() == 1);
  CHECK(turns[0].parameters == std::vector{index(Parameter::r)});
  const std::array<Rational, 4> at = BentContact::at(q(3, 4));
  for (std::size_t j = 0; j < 4; ++j) CHECK(encloses(turns[0].box[j], at[j]));
  CHECK(turns[0].box[0].radius() < 1e-4);
}

TEST_CASE("contact turning: parameters known to be constant are not looked at", "[trace]") {
  BentContact contact;
  const auto arc = contact.traced();
  const auto found = find_contact_turns(contact.system, arc, contact.pair, {false, false, true, false});
  REQUIRE(std::holds_alternative<TurningPoints<DoubleBall>>(found));
  CHECK(std::get<TurningPoints<DoubleBall>>(found).empty());
  for (std::size_t j = 0; j < 4; ++j) CHECK_FALSE(may_be_constant(contact.system, arc, j));
}

TEST_CASE("contact turning: without exact values an unknown sign is not decided", "[trace]") {
  BentContact contact;
  const auto arc = contact.traced();
  ExactPair stopped(contact.x, contact.y, [] { return true; });
  const auto found = find_contact_turns(contact.system, arc, stopped, {});
  CHECK(std::holds_alternative<TraceFailure>(found));
}

}  // namespace exsect::contact_turning_test
