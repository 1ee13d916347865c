// Pages of the commands implicitize, revolve and compare: the same page as report_html.h, other data.
#pragma once

#include <exsect/geometry/bezier_curve.h>
#include <exsect/geometry/patch_file.h>

#include <optional>
#include <string>

#include "output/report/report_html.h"
#include "output/text/comparison.h"
#include "output/text/revolution_output.h"

namespace exsect::cli {

/// What an equation was found for: a planar curve has a picture (SVG), a curve of space both, a patch itself.
struct ImplicitSubject {
  std::string svg;
  std::optional<BezierCurve> curve;  // of space
  std::optional<NamedPatch> patch;
};

/// The page of implicit equations, with the whole "implicit/1" result. Zero sets in space are drawn by the
/// page, in doubles.
std::string implicit_report_html(const Json& result, const ImplicitSubject& subject,
                                 const ReportOrigin& origin);

/// The page of a surface of revolution, with the whole "revolution/1" result.
std::string revolution_report_html(const ShownRevolution& shown, const ReportOrigin& origin);

/// The page of a comparison, with the whole "comparison/1" result and the graph of the sweep as
/// "intersection/1".
std::string comparison_report_html(const Comparison& comparison, const BezierPatch& x, const BezierPatch& y,
                                   const PatchNames& names, const ReportOrigin& origin);

}  // namespace exsect::cli
