#include "file_form.h"

#include <array>
#include <string_view>

#include "json_tree.h"

namespace exsect {
namespace {

struct Form {
  std::string_view name;
  std::string_view content;
};

constexpr std::array<Form, 17> known_forms = {{{"patches/1", "patches"},
                                               {"curve/1", "a curve"},
                                               {"candidate/1", "curves of another program"},
                                               {"model/1", "a model"},
                                               {"intersection/1", "a result of exsect intersect"},
                                               {"surfaces/1", "a result of exsect intersect"},
                                               {"self/1", "a result of exsect self"},
                                               {"line/1", "a result of exsect line"},
                                               {"ray/1", "a result of exsect ray"},
                                               {"implicit/1", "a result of exsect implicitize"},
                                               {"revolution/1", "a result of exsect revolve"},
                                               {"comparison/1", "a result of exsect compare"},
                                               {"verdict/1", "a result of exsect verify"},
                                               {"check/1", "a result of exsect check"},
                                               {"batch/1", "results of exsect batch"},
                                               {"batch-line/1", "a result of exsect batch"},
                                               {"certificate/1", "a certificate"}}};

}  // namespace

std::string wrong_form(const std::string& stated, const std::string& needed) {
  for (const Form& form : known_forms)
    if (form.name == stated)
      return "holds " + std::string(form.content) + ", " + stated + "; needed is " + needed;
  return "unknown version, must be " + needed;
}

}  // namespace exsect
