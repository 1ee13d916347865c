// A proof that fails where it should not. Internal to solver/.
#pragma once

#include <exsect/solver/parameter.h>

#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

namespace exsect {

/// A proof that ought to succeed has failed, or two proofs contradict each other, in this part of [0,1]^4. It
/// does not leave the library: answered() makes it an incomplete result.
class ProofFailure : public std::logic_error {
 public:
  ProofFailure(ParameterBox where, const std::string& why)
      : std::logic_error(why), where_(std::move(where)) {}

  const ParameterBox& where() const { return where_; }

 private:
  ParameterBox where_;
};

/// Why `work` fails, if it throws a std::logic_error other than std::invalid_argument.
template <class Work>
std::optional<std::string> failure_of(const Work& work) {
  try {
    work();
    return std::nullopt;
  } catch (const std::invalid_argument&) {
    throw;
  } catch (const std::logic_error& error) {
    return std::string("a proof failed: ") + error.what();
  }
}

}  // namespace exsect
