#include "self/glued_steps.h"

#include <algorithm>

namespace exsect {

template <class Ball>
std::optional<GluedStep> GluedSteps<Ball>::first(const GluedArc& arc) const {
  for (std::size_t k = 0; k < exact_.stars.size(); ++k)
    for (const bool exchanged : {false, true})
      if (is_around(k, exchanged, arc.from)) return from_port(arc, k, exchanged, std::nullopt);
  const BallPoint<Ball> tangent = Expansion<Ball>(system_.pair, found_.landmarks[arc.from]).tangent();
  const int sign = arc.direction * tangent[index(arc.along)].certain_sign();
  return sign == 0 ? std::nullopt : std::optional(GluedStep{arc.from, sign});
}

template <class Ball>
bool GluedSteps<Ball>::is_last(const GluedArc& arc, int landmark) const {
  if (arc.to && landmark == static_cast<int>(*arc.to)) return true;
  const auto* port = found_.port(landmark);
  if (port == nullptr) return false;
  if (arc.to) return is_around(port->star, port->exchanged, *arc.to);
  const SelfStar& star = exact_.stars[port->star];
  const ParameterBox& box = star.star.centre.box();
  return star.cuspidal && box[0].lower == (*arc.cusp)[0] && box[1].lower == (*arc.cusp)[1] &&
         box[0].width() == 0 && box[1].width() == 0;
}

template <class Ball>
std::optional<GluedStep> GluedSteps<Ball>::next(const GluedArc& arc, int landmark) const {
  const auto* port = found_.port(landmark);
  const bool only_one = std::ranges::count(exact_.boundary.arcs, arc.on, &GluedArc::on) == 1;
  if (port == nullptr || !only_one || exact_.stars[port->star].cuspidal) return std::nullopt;
  return from_port(arc, port->star, port->exchanged, static_cast<std::size_t>(landmark));
}

/// The only port of the star on the arc's sides, apart from the one given.
template <class Ball>
std::optional<GluedStep> GluedSteps<Ball>::from_port(const GluedArc& arc, std::size_t star, bool exchanged,
                                                     std::optional<std::size_t> arrived) const {
  std::vector<std::size_t> ports;
  for (std::size_t i = 0; i < found_.ports.size(); ++i)
    if (found_.ports[i].star == star && found_.ports[i].exchanged == exchanged && is_on(arc, i) &&
        found_.boundary_points + i != arrived)
      ports.push_back(found_.boundary_points + i);
  if (ports.size() != 1) return std::nullopt;
  const LeavingDirections directions = directions_.at(ports.front());
  if (!directions.certain) return std::nullopt;
  return GluedStep{ports.front(), directions.signs.front()};
}

template <class Ball>
bool GluedSteps<Ball>::is_on(const GluedArc& arc, std::size_t port) const {
  const auto& at = found_.ports[port];
  const CertifiedPoint& point = exact_.stars[at.star].star.ports[at.port].point;
  return std::ranges::all_of(arc.on, [&](const Side& side) {
    const auto exchanged = static_cast<Parameter>((index(side.parameter) + 2) % 4);
    return point.on({at.exchanged ? exchanged : side.parameter, side.value});
  });
}

/// In the order given the star's centre is this boundary point.
template <class Ball>
bool GluedSteps<Ball>::is_around(std::size_t star, bool exchanged, std::size_t boundary_point) const {
  const auto& centre = exact_.stars[star].landmark;
  return centre && (exchanged ? exact_.boundary.mate[*centre] : *centre) == boundary_point;
}

template class GluedSteps<DoubleBall>;
template class GluedSteps<ArbBall<256>>;

}  // namespace exsect
