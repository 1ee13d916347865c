// Every public function of the solver, and those of geometry and the checker's numbers, called in all
// floating-point environments: the same answer to the last bit, and the caller's environment afterwards.
#include <exsect/algebra/nearest_rounding.h>
#include <exsect/geometry/approximate_implicit_patch.h>
#include <exsect/geometry/broad_phase.h>
#include <exsect/geometry/candidate_file.h>
#include <exsect/geometry/curve_file.h>
#include <exsect/geometry/patch_file.h>
#include <exsect/solver/check_lines.h>
#include <exsect/solver/curve_arcs.h>
#include <exsect/solver/implicitize_curve.h>
#include <exsect/solver/implicitize_space_curve.h>
#include <exsect/solver/intersect_all.h>
#include <exsect/solver/line_patch.h>
#include <exsect/solver/quartic_method.h>
#include <exsect/solver/resultant_method.h>
#include <exsect/solver/revolution_mesh.h>
#include <exsect/solver/revolve.h>
#include <exsect/solver/self_intersect.h>
#include <exsect/solver/turning_eliminant.h>
#include <exsect/solver/verify.h>

#include <functional>

#include "support/catch.h"
#include "support/families.h"
#include "support/float_environments.h"
#include "support/random_pairs.h"

namespace exsect::every_entry_test {
namespace {

using random_pairs::Generator;
using random_pairs::Pair;

/// Text of results in which equal text means equal bits, made without arithmetic on doubles.
class Bits {
 public:
  Bits& operator<<(double x) { return add(bits_of(x)); }
  Bits& operator<<(const std::string& text) { return add(text); }
  Bits& operator<<(const char* text) { return add(text); }
  Bits& operator<<(long n) { return add(std::to_string(n)); }
  Bits& operator<<(int n) { return add(std::to_string(n)); }
  Bits& operator<<(std::size_t n) { return add(std::to_string(n)); }
  Bits& operator<<(const Rational& q) { return add(q.str()); }
  Bits& operator<<(const RationalInterval& i) { return *this << i.lower << i.upper; }
  Bits& operator<<(const ParameterBox& box) {
    for (const RationalInterval& i : box) *this << i;
    return *this;
  }
  Bits& operator<<(const Polynomial& f) {
    for (const Rational& c : f.coefficients()) *this << c;
    return *this;
  }
  Bits& operator<<(const Arc& arc) {
    *this << arc.from << arc.to << arc.component << static_cast<int>(arc.place)
          << static_cast<int>(arc.contact) << arc.error_bound;
    for (const PolylineVertex& vertex : arc.polyline) {
      for (const double t : vertex.parameters) *this << t;
      for (const double t : vertex.point) *this << t;
    }
    return *this;
  }
  Bits& operator<<(const IntersectResult& result) {
    *this << static_cast<int>(result.status);
    for (const Node& node : result.graph.nodes) {
      *this << "node" << node.box;
      for (const NodeKind kind : node.kinds) *this << static_cast<int>(kind);
      for (const double t : node.approx) *this << t;
      for (const double t : node.point) *this << t;
    }
    for (const Arc& arc : result.graph.arcs) *this << arc;
    for (const Component& component : result.graph.components) *this << static_cast<int>(component.shape);
    for (const Overlap& overlap : result.graph.overlaps) {
      for (const auto& chain : overlap.chains) {
        for (const Arc& arc : chain) *this << arc;
      }
    }
    for (const Incomplete& incomplete : result.incomplete) *this << incomplete.why << incomplete.where;
    return *this;
  }
  Bits& operator<<(const LinePoints& points) {
    for (const CertifiedPoint& point : points.points) {
      *this << point.box() << point.multiplicity() << point.branch()
            << point.refined_to(power_of_two(-90)).box();
    }
    return *this;
  }
  Bits& operator<<(const DistanceEnclosure& d) { return *this << d.lower << d.upper; }
  Bits& operator<<(const Verdict& verdict) {
    *this << static_cast<int>(verdict.agreement) << verdict.tolerance;
    for (const Difference& difference : verdict.differences) *this << difference.text;
    for (const ArcFinding& arc : verdict.arcs) *this << arc.distance << static_cast<int>(arc.coverage);
    for (const CurveFinding& curve : verdict.curves) *this << curve.distance << curve.true_distance;
    return *this;
  }
  Bits& operator<<(const BivariatePolynomial& f) {
    for (int i = 0; i <= f.degree_r(); ++i) *this << f.coefficient(i);
    return *this;
  }
  Bits& operator<<(const DistanceBounds& bounds) {
    if (bounds.one_sided.distance) *this << *bounds.one_sided.distance;
    if (bounds.one_sided.residual) *this << *bounds.one_sided.residual;
    if (bounds.two_sided.strip) *this << bounds.two_sided.strip->distance;
    return *this;
  }

  std::string text() const { return text_; }

 private:
  Bits& add(const std::string& text) {
    text_ += text + " ";
    return *this;
  }
  std::string text_;
};

/// The text of what `work` appends, in every environment or, if it takes long, in every fifth one: each mode,
/// each switch.
void check_everywhere(const std::function<void(Bits&)>& work, std::size_t step = 1) {
  Bits expected;
  work(expected);
  const std::vector<FloatEnvironment> environments = float_environments();
  for (std::size_t i = step / 2; i < environments.size(); i += step) {
    const FloatEnvironment& environment = environments[i];
    INFO(text(environment));
    Bits result;
    enter(environment);
    work(result);
    const FloatEnvironment after = current_environment();
    enter({});
    CHECK(result.text() == expected.text());
    CHECK(after == environment);
  }
}

Pair read_pair(const std::string& path) {
  const auto patches = read_patches(path).patches;
  return {patches.at(0).patch, patches.at(1).patch};
}

const std::string cases = EXSECT_CASES "/";
const std::string examples = EXSECT_EXAMPLES "/";

}  // namespace

TEST_CASE("nearest rounding: intersections of pairs of every kind") {
  for (const char* name :
       {"shared-side", "overlap", "crossing", "cap", "tangent-curve", "found/underflow-subnormal"}) {
    INFO(name);
    const Pair pair = read_pair(cases + name + ".json");
    check_everywhere([&](Bits& bits) { bits << intersect(pair.x, pair.y); });
  }
}

TEST_CASE("nearest rounding: generic pairs, and pairs that share a side") {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    INFO("seed " << seed);
    Generator generator(seed);
    const Pair pair =
        seed % 2 == 0 ? random_pairs::doubles(generator) : random_pairs::small_rationals(generator);
    check_everywhere([&](Bits& bits) { bits << intersect(pair.x, pair.y); });
    // A neighbour: the side v = 1 of x is its side v = 0.
    ControlNet net = pair.y.net();
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        net[i][j] = pair.x.net()[i][2] + Rational(static_cast<long>(j), 2) *
                                             Point{0, 1, Rational(static_cast<long>(j * (i + seed % 3)), 8)};
      }
    }
    const BezierPatch neighbour(net);
    check_everywhere([&](Bits& bits) { bits << intersect(pair.x, neighbour); });
  }
}

TEST_CASE("nearest rounding: exact mode, several threads, self-intersections") {
  const Pair pair = read_pair(examples + "chapter9-first.json");
  IntersectOptions exact;
  exact.exact = true;
  check_everywhere([&](Bits& bits) { bits << intersect(pair.x, pair.y, exact); }, 5);
  const std::vector<PatchPair> pairs(4, PatchPair{pair.x, pair.y});
  check_everywhere(
      [&](Bits& bits) {
        for (const IntersectResult& result : intersect_all(pairs, {}, 2)) bits << result;
      },
      5);
  const auto patches = read_patches(examples + "chapter9-second.json").patches;
  check_everywhere([&](Bits& bits) { bits << self_intersect(patches.at(1).patch); }, 5);
}

TEST_CASE("nearest rounding: parameter lines") {
  const Pair pair = read_pair(examples + "chapter9-first.json");
  for (const Rational& value : {Rational(1, 2), Rational(1, 3), Rational(0)}) {
    const LineQuery query = {Parameter::u, value};
    check_everywhere([&](Bits& bits) { bits << line_points_filtered(pair.x, pair.y, query); });
    check_everywhere([&](Bits& bits) {
      const LineIntersection line = intersect_line(pair.x, pair.y, query);
      bits << line.eliminant << line.solution;
    });
  }
  check_everywhere([&](Bits& bits) {
    const auto roots = enclosed_turning_roots(pair.x, pair.y);
    if (roots) {
      for (const RationalInterval& root : *roots) bits << root;
    }
    bits << turning_eliminant(pair.x, pair.y).polynomial.value();
  });
}

TEST_CASE("nearest rounding: candidates") {
  for (const char* name : {"sisl-right", "occt-loop-lost"}) {
    INFO(name);
    const std::string path = examples + "candidates/" + name;
    const Pair pair = read_pair(path + ".json");
    VerifyOptions options;
    options.tolerance = 1e-4;
    check_everywhere(
        [&](Bits& bits) {
          const Candidate candidate = read_candidate(path + ".candidate.json");
          const Verification verification = verify(candidate, pair.x, pair.y, options);
          bits << verification.verdict << verification.exact;
        },
        5);
  }
}

TEST_CASE("nearest rounding: implicit equations, surfaces of revolution") {
  const BezierCurve profile = read_curve(examples + "profile.json").curve;
  check_everywhere(
      [&](Bits& bits) {
        PlanarOptions options;
        options.method = PlanarMethod::least_squares;
        const PlanarImplicit fit = implicitize(profile, options);
        bits << fit.function.polynomial() << fit.bounds << fit.possibly_singular.size();
        options.method = PlanarMethod::bernstein;
        const PlanarImplicit null_space = implicitize(profile, options);
        bits << null_space.function.polynomial() << null_space.bounds
             << null_space.singular_value.value_or(0);
      },
      5);
  check_everywhere(
      [&](Bits& bits) {
        RevolveOptions options;
        options.degree = 3;
        const Revolution revolution = revolve(profile, options);
        bits << revolution.profile.polynomial() << revolution.bounds;
        bits << obj_text(revolution_mesh(profile, 4, 5), {"mesh"});
      },
      5);
  const BezierCurve cubic = read_curve(examples + "space-cubic.json").curve;
  check_everywhere(
      [&](Bits& bits) {
        SpaceOptions options;
        options.method = SpaceMethod::orthogonal;
        const SpaceImplicit space = implicitize_space(cubic, options);
        bits << space.axis << static_cast<int>(space.norms_are_positive);
        if (space.norms) bits << (*space.norms)[0] << (*space.norms)[1];
      },
      5);
}

TEST_CASE("nearest rounding: resultant and quartics") {
  const Pair pair = read_pair(examples + "chapter9-first.json");
  check_everywhere(
      [&](Bits& bits) {
        const auto equation = approximate_equation(pair.x, 4, PatchFit::conics);
        bits << equation.singular_value;
        const QuarticMethod quartics =
            intersect_by_quartics(pair.x, pair.y, {PatchFit::conics, 1, 4}, check_lines(pair.x, pair.y, 2));
        bits << quartics.regions.size() << quartics.check.points << quartics.check.largest_deviation;
      },
      5);
}

TEST_CASE("nearest rounding: boxes of subnormal size") {
  const auto box = [](long from) {
    const Rational lower = from * power_of_two(-1070);
    return BoundingBox{{lower, lower, lower},
                       {lower + power_of_two(-1074), lower + power_of_two(-1074), lower}};
  };
  check_everywhere([&](Bits& bits) {
    const std::vector<RoundedBox> boxes = {rounded_outwards(box(0)), rounded_outwards(box(1)),
                                           rounded_outwards(box(1))};
    bits << static_cast<int>(certainly_meet(boxes[0], boxes[1]))
         << static_cast<int>(certainly_meet(boxes[1], boxes[2]));
    visit_meeting_boxes(boxes, [&](std::uint32_t i, const std::vector<std::uint32_t>& others) {
      bits << static_cast<long>(i) << others.size();
    });
  });
}

}  // namespace exsect::every_entry_test
