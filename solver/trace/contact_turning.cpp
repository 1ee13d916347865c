#include "trace/contact_turning.h"

#include <algorithm>
#include <cmath>

#include "answer/parameter_box.h"
#include "trace/tangential_enclosure.h"

namespace exsect {

namespace {

constexpr int kMostHalvings = 24;
constexpr double kNarrow = 0x1p-20;
constexpr int kFewHalvings = 4;  // of every piece, however many spans there are
constexpr std::size_t kManySpans = 4096;

/// A part of a piece and the sign of the derivative of one parameter there, 0 if not known.
struct Span {
  std::size_t piece;
  double from;
  double to;
  int sign;
};

template <class Ball>
class SpanList {
 public:
  SpanList(const PairSystem<Ball>& system, const TangentialArc<Ball>& curve, std::size_t parameter)
      : system_(system), curve_(curve), parameter_(parameter) {
    for (std::size_t i = 0; i < curve.pieces.size(); ++i) {
      const PieceRange& range = curve.pieces[i].range;
      const double beyond = range.direction() * range.doubt();
      divide(i, range.from() - beyond, range.to() + beyond, 0);
    }
  }
  const std::vector<Span>& spans() const { return spans_; }

 private:
  void divide(std::size_t piece, double from, double to, int depth) {
    const TangentialTube<Ball>& tube = curve_.pieces[piece].tube;
    const int sign = enclosure_between(system_, tube, from, to).slope[parameter_].certain_sign() *
                     curve_.pieces[piece].range.direction();
    // Where to stop halving is a matter of work only: a span of unknown sign is decided by exact turning
    // values.
    const bool many = depth >= kFewHalvings && spans_.size() > kManySpans;
    if (sign != 0 || depth >= kMostHalvings || many || std::fabs(to - from) < kNarrow) {
      spans_.push_back({piece, from, to, sign});
      return;
    }
    const double middle = 0.4921875 * from + 0.5078125 * to;  // a special position is rarely a joint
    divide(piece, from, middle, depth + 1);
    divide(piece, middle, to, depth + 1);
  }

  const PairSystem<Ball>& system_;
  const TangentialArc<Ball>& curve_;
  std::size_t parameter_;
  std::vector<Span> spans_;
};

/// The number of turning values in the closed interval.
std::ptrdiff_t values_in(const TurningValues& turning, const RationalInterval& at) {
  return std::count_if(turning.values.begin(), turning.values.end(), [&](const TurningValue& value) {
    return value.value.compare(at.lower) >= 0 && value.value.compare(at.upper) <= 0;
  });
}

template <class Ball>
TraceFailure undecided(const BallPoint<Ball>& at) {
  return {{at[0].approximation(), at[1].approximation(), at[2].approximation(), at[3].approximation()},
          "a turning point on a curve along which the patches touch is not decided"};
}

template <class Ball>
class TurnSearch {
 public:
  TurnSearch(const PairSystem<Ball>& system, const TangentialArc<Ball>& curve, Parameter parameter,
             const std::optional<TurningValues>& turning)
      : system_(system), curve_(curve), parameter_(parameter), turning_(turning) {}

  std::optional<TraceFailure> append_to(TurningPoints<Ball>& turns) {
    std::vector<Span> spans = SpanList<Ball>(system_, curve_, index(parameter_)).spans();
    const bool closed = curve_.start < 0;
    const auto known = std::find_if(spans.begin(), spans.end(), [](const Span& s) { return s.sign != 0; });
    if (known == spans.end()) {
      return undecided(enclose(spans.front()).at);
    }
    if (closed) {
      std::rotate(spans.begin(), known, spans.end());
      spans.push_back(spans.front());
    }
    for (std::size_t i = 0; i < spans.size();) {
      if (spans[i].sign != 0) {
        const bool turns_here = i > 0 && spans[i - 1].sign == -spans[i].sign;
        if (turns_here) {  // at a joint
          return undecided(enclose(spans[i]).at);
        }
        ++i;
        continue;
      }
      std::size_t end = i;
      while (end < spans.size() && spans[end].sign == 0) {
        ++end;
      }
      if (auto failure = decide(spans, i, end, turns)) {
        return failure;
      }
      i = end;
      if (end < spans.size()) {
        ++i;
      }
    }
    return std::nullopt;
  }

 private:
  ArcEnclosure<Ball> enclose(const Span& span) const {
    return enclosure_between(system_, curve_.pieces[span.piece].tube, span.from, span.to);
  }

  /// The spans begin .. end - 1 of unknown sign.
  std::optional<TraceFailure> decide(const std::vector<Span>& spans, std::size_t begin, std::size_t end,
                                     TurningPoints<Ball>& turns) const {
    const BallPoint<Ball> first = enclose(spans[begin]).at;
    RationalInterval range = first[index(parameter_)].interval();
    for (std::size_t i = begin; i < end; ++i) {
      range = hull(range, enclose(spans[i]).at[index(parameter_)].interval());
    }
    const std::ptrdiff_t count = turning_ ? values_in(*turning_, range) : 2;
    if (count == 0) {
      return std::nullopt;
    }
    if (count > 1 || begin == 0 || end == spans.size()) {
      return undecided(first);
    }
    if (spans[begin - 1].sign == spans[end].sign) {
      return std::nullopt;
    }
    if (spans[begin].piece != spans[end - 1].piece) {
      return undecided(first);
    }
    const Span whole = {spans[begin].piece, spans[begin].from, spans[end - 1].to, 0};
    turns.push_back({{index(parameter_)}, whole.piece, whole.from, whole.to, enclose(whole).at});
    return std::nullopt;
  }

  const PairSystem<Ball>& system_;
  const TangentialArc<Ball>& curve_;
  Parameter parameter_;
  const std::optional<TurningValues>& turning_;
};

}  // namespace

template <class Ball>
std::variant<TurningPoints<Ball>, TraceFailure> find_contact_turns(const PairSystem<Ball>& system,
                                                                   const TangentialArc<Ball>& curve,
                                                                   ExactPair& pair,
                                                                   const std::array<bool, 4>& constant) {
  TurningPoints<Ball> turns;
  for (const Parameter p : all_parameters) {
    if (constant[index(p)]) {
      continue;
    }
    if (auto failure = TurnSearch<Ball>(system, curve, p, pair.turning(p)).append_to(turns)) {
      return *failure;
    }
  }
  const auto along = [&](const TurningPoint<Ball>& turn) {
    const auto& piece = curve.pieces[turn.piece];
    return std::pair(turn.piece, turn.from * piece.range.direction());
  };
  std::sort(turns.begin(), turns.end(),
            [&](const TurningPoint<Ball>& a, const TurningPoint<Ball>& b) { return along(a) < along(b); });
  return turns;
}

template <class Ball>
bool may_be_constant(const PairSystem<Ball>& system, const TangentialArc<Ball>& curve,
                     std::size_t parameter) {
  return std::all_of(curve.pieces.begin(), curve.pieces.end(), [&](const TangentialPiece<Ball>& piece) {
    return enclosure_between(system, piece.tube, piece.range.from(), piece.range.to())
               .slope[parameter]
               .certain_sign() == 0;
  });
}

#define EXSECT_INSTANTIATE_CONTACT(Ball)                                                            \
  template std::variant<TurningPoints<Ball>, TraceFailure> find_contact_turns(                      \
      const PairSystem<Ball>&, const TangentialArc<Ball>&, ExactPair&, const std::array<bool, 4>&); \
  template bool may_be_constant(const PairSystem<Ball>&, const TangentialArc<Ball>&, std::size_t);

EXSECT_INSTANTIATE_CONTACT(DoubleBall)
EXSECT_INSTANTIATE_CONTACT(DoubleDoubleBall)
EXSECT_INSTANTIATE_CONTACT(ArbBall<256>)
EXSECT_INSTANTIATE_CONTACT(ArbBall<1024>)
#undef EXSECT_INSTANTIATE_CONTACT

}  // namespace exsect
