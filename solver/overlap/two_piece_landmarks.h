// Where the curves of two pieces of one surface start and end, and in which direction. Internal to solver/;
// docs/method.md, section 6.3.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "overlap/pair_map.h"
#include "overlap/two_piece_curves.h"

namespace exsect {

/// Finds the landmarks of a TwoPieceCurves, and knows what is next to them.
template <class Ball>
class TwoPieceLandmarks {
 public:
  /// `found`: its landmarks, near and problems are filled in by run(). All arguments are kept by reference.
  TwoPieceLandmarks(const TwoPieces& pieces, const SelfSystem<Ball>& shared, const PairSystem<Ball>& system,
                    const std::vector<CertifiedPoint>& boundary, const std::vector<CertifiedPoint>& side_ends,
                    const Rational& width, const StopRequest& stop, TwoPieceCurves<Ball>& found)
      : pieces_(pieces),
        shared_(shared),
        system_(system),
        boundary_(boundary),
        side_ends_(side_ends),
        width_(width),
        stop_(stop),
        found_(found),
        from_common_(pieces.copy, pieces.common) {}

  void run();

  /// The direction of the tangent field that enters the domain at a boundary point, or leads away from the
  /// cuspidal point at a gate; 0: none; empty: unknown.
  std::optional<int> direction_at(std::size_t landmark) const;

  /// An end of an arc on a side: through a regular point of it passes nothing else.
  bool is_side_end(std::size_t landmark) const;

  /// The curve runs along a folded line: u or v is constant, and whether that is a side of the common
  /// rectangle.
  struct AlongLine {
    std::size_t fixed;
    bool on_side;
  };
  std::optional<AlongLine> along_line(const Trace<Ball>& trace) const;

 private:
  /// The end of a cuspidal curve's first piece, on a folded side.
  struct SideGate {
    std::size_t landmark;
    int order;
    std::size_t fixed;
  };

  void problem(const ParameterBox& where, const std::string& why);
  void add_cusps();
  void add_side_gate(const CuspArc<Ball>& cusp, int order);
  bool enters(const CuspArc<Ball>& cusp, int order) const;
  std::optional<int> direction_from_boundary(std::size_t landmark, const BallPoint<Ball>& tangent) const;
  const SideGate* side_gate(int landmark) const;

  const TwoPieces& pieces_;
  const SelfSystem<Ball>& shared_;
  const PairSystem<Ball>& system_;
  const std::vector<CertifiedPoint>& boundary_;
  const std::vector<CertifiedPoint>& side_ends_;
  const Rational& width_;
  const StopRequest& stop_;
  TwoPieceCurves<Ball>& found_;
  PairMap from_common_;
  std::vector<SideGate> side_gates_;
};

}  // namespace exsect
