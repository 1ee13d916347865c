// The search for factors of F: polynomials that vanish where F does, along an arc or on a plane.
#pragma once

#include <exsect/solver/intersection_graph.h>

#include <optional>
#include <vector>

#include "certificate/coordinates.h"
#include "certificate/search.h"

namespace exsect::cli {

/// The factors of F that the certificate claims.
class Factors {
 public:
  Factors(const Patches& patches, bool self);
  /// Those of a surface given by its equation and a patch: of F_1, if it has multiple ones.
  explicit Factors(const ExactMap& section);

  /// The number of the factor for the arc, with what is needed to prove it: that the patches touch along it,
  /// that it stays on a side, that a parameter is constant on it; -1 for F itself. Throws NoCertificate.
  int along(const Arc& arc, const Node& from, const Node& to);
  /// Finds that of the curve through the place along which these parameters are constant, if there is one: of
  /// two parameters, or of one where a patch is in a plane.
  void add_at(const Place& at, const std::array<bool, 4>& constant);
  /// That of the plane through `at` with these directions, independent in u and v. Throws NoCertificate if it
  /// is no plane of solutions.
  int of_plane(const Place& at, const Direction& first, const Direction& second);

  const std::vector<NearFactor>& found() const { return found_; }
  Json claims() const;

 private:
  /// F = part^power rest in the direction that is normal to a patch in a plane; of an equation F_1.
  struct Part {
    Scalar polynomial;
    std::size_t power;
    Scalar rest;
  };

  int add(checker::Factor factor);
  static bool is_claimable(const Part& part);
  void find_parts();
  std::optional<checker::Factor> in_plane(const std::vector<Parameters>& near) const;
  std::optional<checker::Factor> on_line(const Arc& arc, const Node& from, const Node& to) const;
  std::optional<checker::Factor> of_constants(const Arc& arc, const std::array<bool, 4>& constant,
                                              const Node& from, const Node& to) const;

  ExactMap equation_;  // F
  std::vector<NearFactor> found_;
  int related_ = -1;      // with F in rows each of few parameters
  std::size_t free_ = 4;  // parameters that need not be constant
  std::array<Point, 3> rows_;
  std::vector<Part> parts_;
};

}  // namespace exsect::cli
