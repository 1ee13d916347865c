// Every shipped pair has a certificate that is accepted, or none for a reason that is named.
#include <exsect/geometry/patch_file.h>
#include <exsect/geometry/rational_patch_file.h>

#include <filesystem>
#include <map>

#include "certificate_changes.h"
#include "support/families.h"

namespace exsect::certificate_families_test {
namespace {

using namespace certificates;

/// Nothing if there is one, otherwise the reason why not.
template <class Patch>
std::string refusal(const Patch& x, const Patch& y) {
  const IntersectResult result = intersect(x, y, coarse());
  try {
    const std::string text = cli::certificate_text(x, y, names, result);
    const checker::Report report = check_certificate(text);
    // A point with a free parameter is the arc of its solutions.
    CHECK(report.summary.components + report.summary.isolated ==
          result.graph.components.size() + result.graph.isolated_points.size());
    return "";
  } catch (const cli::NoCertificate& reason) {
    return reason.what();
  }
}

}  // namespace

TEST_CASE("each shipped pair has a certificate, or a named event is in the way") {
  std::map<std::string, std::vector<std::string>> refused;  // names by reason
  std::size_t accepted = 0;
  const auto add = [&](const std::string& name, const BezierPatch& x, const BezierPatch& y) {
    const std::string reason = refusal(x, y);
    INFO(name << ": " << reason);
    reason.empty() ? void(++accepted) : refused[reason].push_back(name);
  };
  for (const ExactCase& c : families::specimens()) add(c.name, c.x, c.y);
  for (const char* name : {"chapter9-first", "chapter9-second", "touching-curve"}) {
    const auto patches = read_patches(std::string(EXSECT_EXAMPLES "/") + name + ".json").patches;
    add(name, patches[0].patch, patches[1].patch);
  }
  CHECK(accepted == 17);
  CHECK(refused.empty());
}

TEST_CASE("each case of one pair has a certificate, or a named event is in the way") {
  const std::map<std::string, std::string> expected = {
      {"arcs-side-by-side-on-one-side", "a special point with parameters in no number field that is found"},
      {"fold-at-an-irrational-place", "a point where no tube was found"},
      {"pieces-of-a-torus", "an overlap of patches whose parameters do not depend on each other linearly"}};
  std::map<std::string, std::string> refused;
  std::size_t pairs = 0;
  for (const auto& file : std::filesystem::directory_iterator(EXSECT_CASES)) {
    const std::string name = file.path().stem().string();
    if (file.path().extension() != ".json" || name.ends_with(".expected")) continue;
    const auto patches = read_rational_patches(file.path().string()).patches;
    if (patches.size() != 2) continue;
    ++pairs;
    const std::string reason = refusal(patches[0].patch, patches[1].patch);
    if (!reason.empty()) refused[name] = reason;
  }
  CHECK(pairs == 22);
  CHECK(refused == expected);
}

namespace {

/// Each kind of event with each plane.
std::vector<std::pair<std::string, ExactCase>> planar_members() {
  using namespace families;
  std::vector<std::pair<std::string, ExactCase>> result;
  const Rational small(1, 100);
  for (const Plane p : regular_planes)
    for (const ExactCase& c : {cap(0, p), cap(small, p), crossing(p), near_crossing(small, p),
                               quarter_circle(p), tangent_curve(Rational(1, 3), p), near_sheets(small, p),
                               tangent_and_transversal(p), curve_cusp(p), tangent_branches(p)})
      result.push_back({c.graph.arcs.empty() ? c.name + ", a point" : c.name, c});
  return result;
}

}  // namespace

TEST_CASE("every specimen has a certificate in any coordinates and order", "[.slow]") {
  random_pairs::Generator generator(7);
  INFO("seed 7");
  for (const ExactCase& c : families::specimens()) {
    for (const CaseChange& change : case_changes()) {
      const ExactCase changed = change.apply(c, generator);
      INFO(c.name << ", " << change.name);
      CHECK(refusal(changed.x, changed.y) == "");
    }
  }
}

TEST_CASE("every member of the families has a certificate with each regular plane") {
  for (const auto& [name, c] : planar_members()) {
    INFO(name);
    CHECK(refusal(c.x, c.y) == "");
  }
}

}  // namespace exsect::certificate_families_test
