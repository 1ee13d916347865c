// The commands of the program with their options and help texts.
#pragma once

#include <CLI/CLI.hpp>

#include "cli/batch_command.h"
#include "cli/check_command.h"
#include "cli/compare_command.h"
#include "cli/implicitize_command.h"
#include "cli/intersect_command.h"
#include "cli/line_command.h"
#include "cli/ray_command.h"
#include "cli/revolve_command.h"
#include "cli/self_command.h"
#include "cli/verify_command.h"

namespace exsect::cli {

/// What the command line says, for each command.
struct Commands {
  IntersectCommand intersect;
  LineCommand line;
  RayCommand ray;
  SelfCommand self;
  CompareCommand compare;
  VerifyCommand verify;
  ImplicitizeCommand implicitize;
  RevolveCommand revolve;
  BatchCommand batch;
  BatchMergeCommand batch_merge;
  CheckCommand check;
};

/// Gives the application all commands; parsing writes into `commands`, which must outlive it.
void add_commands(CLI::App& app, Commands& commands);

}  // namespace exsect::cli
