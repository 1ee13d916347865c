// What results keep of their proofs: how they are drawn at other tolerances. Internal to solver/.
#pragma once

#include <exsect/solver/options.h>
#include <exsect/solver/result.h>

#include <functional>
#include <optional>

#include "answer/run.h"

namespace exsect {

/// Draws what was decided within the tolerance of the run, always the same nodes and arcs; empty where that
/// is too rough for the tolerance. It owns all that it refers to, and is called by several threads.
using Draw = std::function<std::optional<IntersectResult>(const Run&)>;

/// Answers the question of a call again.
using Solve = std::function<IntersectResult(const IntersectOptions&)>;

struct Proof {
  Draw draw;                 // empty where nothing is kept
  IntersectOptions options;  // of the call; nobody is told of progress
  Solve solve;               // empty while the call is under way
};

/// What `draw` draws for this run; the result keeps it.
std::optional<IntersectResult> first_drawn(Draw draw, const Run& run);

/// Turns the answer of a part of the question, or of an equivalent question, into that of the run's question.
using ResultChange = std::function<void(IntersectResult&, const Run&)>;
/// The run in which the other question is asked.
using OtherRun = std::function<Run(const Run&)>;

/// The result of the other question, changed; so will be what is drawn from its proof.
IntersectResult changed(
    IntersectResult other, const Run& run, ResultChange change,
    OtherRun other_run = [](const Run& same) { return same; });

/// The result of a call with these options, which keeps how it was found.
IntersectResult answer_to(const IntersectOptions& options, IntersectResult result, Solve solve);

}  // namespace exsect
