// Points whose parameters are algebraic numbers, for the stars of a certificate.
#pragma once

#include <exsect/checker/certificate.h>
#include <exsect/solver/algebraic_place.h>
#include <exsect/solver/intersection_graph.h>

#include <functional>
#include <memory>
#include <vector>

#include "certificate/events.h"
#include "output/text/json_forms.h"

namespace exsect::cli {

/// Numbers of one field.
struct AlgebraicPoint {
  std::shared_ptr<const checker::Root> root;
  checker::Vector4<checker::Algebraic> parameters;
};

/// F, the parameters that are constant where it vanishes, and a search for a singular solution in a box with
/// parameters in a number field.
struct SingularSearch {
  ExactMap equation;
  std::array<bool, 4> constant;
  std::function<std::optional<AlgebraicPlace>(const ParameterBox&)> place;
};
/// It finds something of polynomial patches of bidegree (2,2) at most.
SingularSearch singular_search(const Patches& patches);
/// Of a surface given by its equation and a patch.
SingularSearch singular_search(const ExactMap& section);

/// Solutions in the node's box, one of which is the node as a rule: that of the shortest rational parameters,
/// if it is one, and what the search finds. Throws NoCertificate if none is found.
std::vector<AlgebraicPoint> points_in_box(const SingularSearch& search, const Node& node);

using AlgebraicMap = checker::Map<checker::Algebraic>;
using AlgebraicColumn = checker::Vector3<checker::Algebraic>;
/// F in the powers of the parameters' differences from the point.
AlgebraicMap about(const ExactMap& equation, const AlgebraicPoint& at);
/// The columns of its derivative there.
std::array<AlgebraicColumn, 4> columns_of_derivative(const AlgebraicMap& local);

/// 1/a, for a number that is not 0. Throws NoCertificate if the modulus is reducible and a divisor of zero is
/// met.
checker::Algebraic reciprocal(const checker::Algebraic& a);

/// Throws NoCertificate if there is none.
checker::Matrix4 inverse(checker::Matrix4 m);
/// A text, or the list of the coefficients.
Json algebraic_claim(const checker::Algebraic& a);

}  // namespace exsect::cli
