#include "cli/command_line.h"

#include <string>

namespace exsect::cli {
namespace {

constexpr const char* about =
    "exsect: the exact, complete, proved intersection of two biquadratic Bezier patches x(u,v) and y(r,s).\n"
    "exsect COMMAND --help explains a command. Start with:\n"
    "  exsect intersect examples/chapter9-first.json --svg picture.svg\n"
    "  exsect line examples/chapter9-first.json --u 1/2 --svg line.svg\n"
    "  exsect self examples/chapter9-second.json --patch y --svg self.svg";

constexpr const char* statuses =
    "Exit status: 0 complete; 1 a candidate disagrees; 2 bad input or usage, or output that cannot be "
    "written (message on the "
    "standard\n"
    "error, nothing on the standard output); 3 incomplete, the result says where and why.";

constexpr const char* intersect_footer =
    "FILE holds control points as exact numbers (form patches/1):\n"
    "  {\"exsect\": \"patches/1\",\n"
    "   \"patches\": [{\"name\": \"x\", \"degree\": [1,1], \"points\": [[[\"0\",\"0\",\"0\"], "
    "[\"0\",\"1\",\"0\"]],\n"
    "                                                     [[\"1\",\"0\",\"0\"], [\"1\",\"1\",\"1/2\"]]]}, "
    "...]}\n"
    "The two patches are x(u,v) and y(r,s), in the order of the file or as chosen by --first and --second.\n"
    "One of them may be a surface given by its equation (exsect ray --help).\n"
    "A node is a point where the curve meets a side of a parameter square or turns in one of the parameters; "
    "an\n"
    "arc joins two nodes; a component is open, closed, or branched.\n"
    "Examples:\n"
    "  exsect intersect examples/chapter9-first.json\n"
    "  exsect intersect examples/chapter9-first.json --tolerance 1e-9 --json result.json --svg picture.svg\n"
    "  exsect intersect examples/chapter9-first.json --turning none --json -";

constexpr const char* line_footer =
    "Exactly one of --u, --v (a line of the first patch), --r, --s (a line of the second patch) is needed. "
    "Shows\n"
    "plane and cylinder through the line, the eliminant, the feasible intervals and the certified points.\n"
    "Numbers are exact: 1/2, 0.5 and 0x1p-1 are the same. Examples:\n"
    "  exsect line examples/chapter9-first.json --u 1/2\n"
    "  exsect line examples/chapter9-first.json --s 0.7 --json - --svg line.svg";

constexpr const char* ray_footer =
    "All points origin + t direction, t >= 0, on the surfaces of FILE, in their exact order along the ray, "
    "with\n"
    "multiplicities; points in which the ray touches, and the parts of it that lie on a surface, are named. "
    "Beside\n"
    "patches FILE may hold planes, cylinders, cones, spheres, tori and polynomials by their equations:\n"
    "  {\"name\": \"c\", \"type\": \"cylinder\", \"point\": [0,0,0], \"axis\": [1,1,1], \"radius\": "
    "\"1/2\"}\n"
    "Examples:\n"
    "  exsect ray examples/surfaces.json --origin=-5,0,0 --direction 1,0,0\n"
    "  exsect ray examples/surfaces.json --origin 1/3,0.1,-5 --direction 0,0,1 --surface torus --json -";

constexpr const char* self_footer =
    "All pairs x(u1,v1) = x(u2,v2) of different parameters of one patch, each curve once, and the cuspidal "
    "points\n"
    "where such curves end. Examples:\n"
    "  exsect self examples/chapter9-second.json --patch y\n"
    "  exsect self examples/chapter9-second.json --patch y --json - --svg self.svg";

constexpr const char* implicitize_footer =
    "FILE holds a curve of the plane or of space, form curve/1:\n"
    "  {\"exsect\": \"curve/1\", \"degree\": 2, \"points\": [[1,0], [1,1], [0,1]], \"weights\": [1, 1, 2]}\n"
    "or patches, form patches/1. Without --degree the equation is exact: of a planar curve by Bezout's "
    "determinant,\n"
    "of a patch by Dixon's. Methods with --degree: least-squares, bernstein, legendre, chebyshev, lagrange "
    "for a\n"
    "planar curve; dokken, conics for a patch. A curve of space gets two surfaces: cylinders over "
    "projections,\n"
    "orthogonal (nearly so), or root-free (orthogonal on the curve). Coefficients are short rationals; the\n"
    "distance is proved for them.\n"
    "Examples:\n"
    "  exsect implicitize examples/profile.json --variables r,z\n"
    "  exsect implicitize examples/profile.json --degree 2 --svg fit.svg\n"
    "  exsect implicitize examples/chapter9-first.json --patch x --degree 4 --json -";

constexpr const char* line_about = "Intersect one parameter line of a patch with the other patch";

void add_output(CLI::App& app, OutputFiles& output, bool& quiet) {
  app.add_option("--json", output.json, "Write the result as JSON; - for standard output")->type_name("FILE");
  app.add_option("--svg", output.svg, "Draw a picture")->type_name("FILE");
  app.add_option("--report", output.report, "Write a web page that shows the result")->type_name("FILE");
  app.add_flag("--quiet", quiet, "No summary, no progress");
}

void add_verbose(CLI::App& app, bool& verbose) {
  app.add_flag("--verbose", verbose, "A summary with more digits, all proved, and with what the work was");
}

void add_exports(CLI::App& app, ExportFiles& files, const std::string& table) {
  app.add_option("--obj", files.obj, "Write patches, curves and points as Wavefront OBJ")->type_name("FILE");
  app.add_option("--ply", files.ply, "The same as PLY")->type_name("FILE");
  app.add_option("--vtp", files.vtp, "The same as VTK XML PolyData, with ids, kinds and bounds as arrays")
      ->type_name("FILE");
  app.add_option("--csv", files.csv, table)->type_name("FILE");
  app.add_option("--grid", files.grid, "Cells of the patches in these files along each side")
      ->type_name("N")
      ->capture_default_str();
}

void add_common(CLI::App& app, std::string& file, std::string& first, std::string& second,
                OutputFiles& output, bool& quiet) {
  app.add_option("FILE", file, "Patch file, or - for the standard input")->required()->type_name("");
  app.add_option("--first", first, "Patch of (u,v), if FILE holds more than two")->type_name("NAME");
  app.add_option("--second", second, "Patch of (r,s)")->type_name("NAME");
  add_output(app, output, quiet);
}

void add_curve_options(CLI::App& sub, std::string& turning, std::string& tolerance,
                       std::string& max_seconds) {
  sub.add_option("--turning", turning, "Parameters whose turning points become nodes, or none")
      ->type_name("LIST")
      ->capture_default_str();
  sub.add_option("--tolerance", tolerance,
                 "Proved distance of polylines from the true curve, relative to the model")
      ->type_name("NUMBER")
      ->capture_default_str();
  sub.add_option("--max-seconds", max_seconds, "Stop with an incomplete result after this time")
      ->type_name("NUMBER");
}

void add_certificate(CLI::App& sub, OutputFiles& output) {
  sub.add_option("--certificate", output.certificate, "Write a proof of the result that exsect check replays")
      ->type_name("FILE");
}

void add_intersect(CLI::App& app, IntersectCommand& command) {
  CLI::App* sub = app.add_subcommand("intersect", "Intersect two patches completely");
  add_common(*sub, command.file, command.first, command.second, command.output, command.quiet);
  add_verbose(*sub, command.verbose);
  add_exports(*sub, command.output.exports, "Write the nodes as a table");
  add_curve_options(*sub, command.turning, command.tolerance, command.max_seconds);
  sub->add_flag("--exact", command.exact, "Prove completeness in exact arithmetic as well");
  add_certificate(*sub, command.output);
  sub->footer(intersect_footer);
}

void add_line(CLI::App& app, LineCommand& command) {
  CLI::App* sub = app.add_subcommand("line", line_about);
  add_common(*sub, command.file, command.first, command.second, command.output, command.quiet);
  add_verbose(*sub, command.verbose);
  add_exports(*sub, command.output.exports, "Write the points as a table");
  for (Parameter p : all_parameters) {
    const std::string parameter = name(p);
    sub->add_option("--" + parameter, command.fixed[index(p)],
                    "The line " + parameter + " = NUMBER, in [0,1]")
        ->type_name("NUMBER");
  }
  add_certificate(*sub, command.output);
  sub->footer(line_footer);
}

void add_ray(CLI::App& app, RayCommand& command) {
  CLI::App* sub = app.add_subcommand("ray", "Find where a ray meets patches and surfaces given by equations");
  sub->add_option("FILE", command.file, "Patch file, or - for the standard input")->required()->type_name("");
  sub->add_option("--origin", command.origin, "Where the ray starts: x,y,z")->required()->type_name("POINT");
  sub->add_option("--direction", command.direction, "Its direction x,y,z, of any length but 0")
      ->required()
      ->type_name("VECTOR");
  sub->add_option("--surface", command.surface, "Only this one of FILE; all of them if not given")
      ->type_name("NAME");
  sub->add_option("--json", command.output.json, "Write the result as JSON; - for standard output")
      ->type_name("FILE");
  sub->add_flag("--quiet", command.quiet, "No summary");
  add_verbose(*sub, command.verbose);
  sub->footer(ray_footer);
}

void add_self(CLI::App& app, SelfCommand& command) {
  CLI::App* sub = app.add_subcommand("self", "Find where a patch meets itself");
  sub->add_option("FILE", command.file, "Patch file, or - for the standard input")->required()->type_name("");
  sub->add_option("--patch", command.patch, "The patch, if FILE holds more than one")->type_name("NAME");
  add_output(*sub, command.output, command.quiet);
  add_verbose(*sub, command.verbose);
  add_exports(*sub, command.output.exports, "Write the nodes as a table");
  add_curve_options(*sub, command.turning, command.tolerance, command.max_seconds);
  add_certificate(*sub, command.output);
  sub->footer(self_footer);
}

constexpr const char* compare_footer =
    "Solves the intersection by the sweep along parameter lines, by elimination of v and s (a curve in (u,r) "
    "whose\n"
    "phantom branches are removed exactly), and by quartics that approximate the second patch, whole and in "
    "pieces.\n"
    "Examples:\n"
    "  exsect compare examples/chapter9-first.json\n"
    "  exsect compare examples/chapter9-second.json --fit dokken --pieces 3 --json - --svg compare.svg";

void add_compare(CLI::App& app, CompareCommand& command) {
  CLI::App* sub = app.add_subcommand("compare", "Solve one intersection by three methods");
  add_common(*sub, command.file, command.first, command.second, command.output, command.quiet);
  sub->add_option("--lines", command.lines, "Number of lines u = const that the methods are checked on")
      ->type_name("N")
      ->capture_default_str();
  sub->add_option("--fit", command.fit, "Construction of the quartics: conics or dokken")
      ->type_name("NAME")
      ->capture_default_str();
  sub->add_option("--pieces", command.pieces,
                  "Quartics also for 2^K by 2^K pieces of the second patch, K from 0 to 3")
      ->type_name("K")
      ->capture_default_str();
  sub->add_option("--plane", command.plane, "Plane of the resultant's curve: u,r or v,s")
      ->type_name("NAMES")
      ->capture_default_str();
  sub->footer(compare_footer);
}

constexpr const char* verify_footer =
    "CANDIDATE is what another program computed: curves and isolated points in space or in a parameter "
    "square, as\n"
    ".json (form candidate/1), .csv, .obj or .g2. It agrees if its curves and points are those of the exact\n"
    "intersection, one to one, joined in the same way, and nowhere farther from them than the tolerance.\n"
    "Exit status: 0 agrees; 1 disagrees; 3 not decided. Examples:\n"
    "  exsect verify examples/candidates/sisl-right.candidate.json examples/candidates/sisl-right.json "
    "--tolerance 1e-4\n"
    "  exsect verify curves.g2 model.json --json - --report page.html";

void add_verify(CLI::App& app, VerifyCommand& command) {
  CLI::App* sub = app.add_subcommand("verify", "Check an intersection that another program computed");
  sub->add_option("CANDIDATE", command.candidate,
                  "Curves and points of the other program; - for JSON on the standard input")
      ->required()
      ->type_name("");
  add_common(*sub, command.file, command.first, command.second, command.output, command.quiet);
  sub->add_option("--tolerance", command.tolerance,
                  "Largest distance from the true curve, relative to the model")
      ->type_name("NUMBER")
      ->capture_default_str();
  sub->add_option("--max-seconds", command.max_seconds, "Stop undecided after this time")
      ->type_name("NUMBER");
  sub->footer(verify_footer);
}

void add_implicitize(CLI::App& app, ImplicitizeCommand& command) {
  CLI::App* sub = app.add_subcommand("implicitize", "Find implicit equations of a curve or a patch");
  sub->add_option("FILE", command.file, "Curve file or patch file, or - for the standard input")
      ->required()
      ->type_name("");
  sub->add_option("--patch", command.patch, "The patch, if FILE holds more than one")->type_name("NAME");
  sub->add_option("--method", command.method, "How the equation is found; exact without --degree")
      ->type_name("NAME");
  sub->add_option("--degree", command.degree, "Degree of an approximate equation")->type_name("NUMBER");
  sub->add_option("--space", command.space, "monomial, bernstein (of the box) or b-spline")
      ->type_name("NAME");
  sub->add_option("--cells", command.cells, "Cells of splines along the box's longer side")
      ->type_name("NUMBER");
  sub->add_option("--samples", command.samples, "Points and normals of least squares")->type_name("NUMBER");
  sub->add_option("--w1", command.w1, "Weight of the normals, > 0")->type_name("NUMBER");
  sub->add_option("--w2", command.w2, "Weight of the tension, >= 0")->type_name("NUMBER");
  sub->add_option("--digits", command.digits, "Decimals to which coefficients are rounded")
      ->type_name("NUMBER");
  sub->add_option("--box", command.box, "Region: x0,x1,y0,y1, in space z0,z1 too")->type_name("LIST");
  sub->add_option("--axis", command.axis, "Common coordinate x, y or z of both projections of a space curve")
      ->type_name("NAME");
  sub->add_option("--factor-degree", command.factor_degree, "Degree of the norms of the method orthogonal")
      ->type_name("NUMBER");
  sub->add_option("--epsilon", command.epsilon, "Weight 1/(f^2 + epsilon) of these norms, > 0")
      ->type_name("NUMBER");
  sub->add_option("--variables", command.variables, "Names of the variables, as r,z")->type_name("LIST");
  sub->add_flag("--exact-arithmetic", command.exact_arithmetic, "Solve over the rational numbers");
  add_output(*sub, command.output, command.quiet);
  sub->footer(implicitize_footer);
}

constexpr const char* revolve_footer =
    "PROFILE holds a planar curve (r,z) in the half plane r >= 0, form curve/1; it is revolved about the z "
    "axis.\n"
    "Without --degree elimination and product take its exact equation. A degree MxN is one in r and one in "
    "z;\n"
    "substitution fits in (r^2,z). Examples:\n"
    "  exsect revolve examples/profile.json --method product --degree 3 --region 2,0,2 --svg rz.svg\n"
    "  exsect revolve examples/profile.json --method substitution --degree 3 --mesh surface.obj\n"
    "  exsect revolve examples/profile.json --method elimination --patch-file examples/chapter9-first.json "
    "\\\n"
    "    --patch x --u 1/2";

void add_revolve(CLI::App& app, RevolveCommand& command) {
  CLI::App* sub = app.add_subcommand("revolve", "Find implicit surfaces of revolution of a profile");
  sub->add_option("PROFILE", command.file, "Curve file, or - for the standard input")
      ->required()
      ->type_name("");
  sub->add_option("--method", command.method, "elimination, product or substitution")->type_name("NAME");
  sub->add_option("--degree", command.degree, "Fit a profile of this degree by points and normals")
      ->type_name("D|MxN");
  sub->add_option("--cells", command.cells, "Fit splines on so many cells of the region (substitution)")
      ->type_name("K|KxL");
  sub->add_option("--samples", command.samples, "Number of points")->type_name("N")->capture_default_str();
  sub->add_option("--w1", command.w1, "Weight of the normals")->type_name("NUMBER")->capture_default_str();
  sub->add_option("--w2", command.w2, "Weight of the tension")->type_name("NUMBER")->capture_default_str();
  sub->add_option("--region", command.region, "Look for rings and branches in 0 < r < B, C < z < D")
      ->type_name("B,C,D");
  sub->add_option("--mesh", command.mesh, "Write the surface as a mesh (OBJ)")->type_name("FILE");
  sub->add_option("--ply", command.output.exports.ply, "The same as PLY")->type_name("FILE");
  sub->add_option("--vtp", command.output.exports.vtp, "The same as VTK XML PolyData")->type_name("FILE");
  sub->add_option("--mesh-size", command.mesh_size, "Chords along the profile, sectors around the axis")
      ->type_name("M,N")
      ->capture_default_str();
  sub->add_option("--patch-file", command.patch_file, "Intersect the surface with a patch")
      ->type_name("FILE");
  sub->add_option("--patch", command.patch, "The patch, if the file holds more than one")->type_name("NAME");
  sub->add_option("--u", command.lines, "Show the exact points on this parameter line of the patch")
      ->type_name("NUMBER");
  add_output(*sub, command.output, command.quiet);
  sub->footer(revolve_footer);
}

constexpr const char* batch_footer =
    "INPUT is a model (a file of patches, form model/1 or patches/1): all its pairs whose exact bounding "
    "boxes meet are\n"
    "intersected. Or it is a list, a text file with the path of a patch file of two patches on each line; or "
    "such patch\n"
    "files themselves, two or more. Results are lines of JSON, always in the same order. While it runs they "
    "are in\n"
    "FILE.partial; --resume goes on with an interrupted run, and begins where there is none.\n"
    "Exit status as above; 3 also if a pair failed (its line says why); 128 + N after signal N.\n"
    "Examples:\n"
    "  exsect batch examples/chapter9-first.json\n"
    "  exsect batch pairs.txt --output results.ndjson --jobs 8 --max-seconds 60 --max-memory 1000 --resume\n"
    "  exsect batch model.ndjson --output part-3.ndjson --shard 3/16";

void add_batch(CLI::App& app, BatchCommand& command) {
  CLI::App* sub = app.add_subcommand("batch", "Intersect all pairs of a model or of a list of files");
  sub->add_option("INPUT", command.inputs, "Model, list, or patch files")->required()->type_name("");
  sub->add_option("-o,--output", command.output,
                  "Write the lines here; otherwise to the standard output in the end")
      ->type_name("FILE");
  sub->add_flag("--resume", command.resume, "Go on with an interrupted run of the same command");
  sub->add_flag("--self", command.self, "Also each patch with itself");
  sub->add_flag("--full", command.full, "Lines hold whole results, not only what they sum up to");
  sub->add_option("--jobs", command.jobs, "Worker processes; one for each processor if not given")
      ->type_name("N");
  sub->add_option("--shard", command.shard, "Only part I of N; batch-merge joins the parts")
      ->type_name("I/N")
      ->capture_default_str();
  add_curve_options(*sub, command.turning, command.tolerance, command.max_seconds);
  sub->add_option("--max-memory", command.max_memory, "Give a pair up that needs more, in MiB")
      ->type_name("NUMBER");
  sub->add_flag("--exact", command.exact, "Prove completeness in exact arithmetic as well");
  sub->add_flag("--quiet", command.quiet, "No summary, no progress");
  sub->footer(batch_footer);
}

void add_batch_merge(CLI::App& app, BatchMergeCommand& command) {
  CLI::App* sub = app.add_subcommand("batch-merge", "Join the shards of a batch into what one run writes");
  sub->add_option("SHARD", command.shards, "Finished outputs of all shards, in any order")
      ->required()
      ->type_name("");
  sub->add_option("-o,--output", command.output, "Write the lines here; otherwise to the standard output")
      ->type_name("FILE");
  sub->add_flag("--quiet", command.quiet, "No summary");
  sub->footer("Example:\n  exsect batch-merge part-*.ndjson --output all.ndjson");
}

constexpr const char* check_footer =
    "CERTIFICATE is a file of form certificate/1, written by exsect intersect, self or line with "
    "--certificate.\n"
    "Every polynomial is computed anew from the control points in it, every claim is replayed, by a program "
    "that\n"
    "shares nothing with the solver. Exit status 1: rejected, with place and reason. Example:\n"
    "  exsect check proof.json";

void add_check(CLI::App& app, CheckCommand& command) {
  CLI::App* sub = app.add_subcommand("check", "Replay the proof in a certificate");
  sub->add_option("CERTIFICATE", command.file, "Certificate file, or - for the standard input")
      ->required()
      ->type_name("");
  sub->add_option("--json", command.json, "Write the verdict as JSON; - for standard output")
      ->type_name("FILE");
  sub->add_flag("--quiet", command.quiet, "No summary");
  sub->footer(check_footer);
}

}  // namespace

void add_commands(CLI::App& app, Commands& commands) {
  app.description(about);
  app.set_version_flag("--version", "exsect " EXSECT_VERSION, "Print the version");
  app.require_subcommand(0, 1);
  app.footer(statuses);
  add_intersect(app, commands.intersect);
  add_line(app, commands.line);
  add_ray(app, commands.ray);
  add_self(app, commands.self);
  add_compare(app, commands.compare);
  add_verify(app, commands.verify);
  add_implicitize(app, commands.implicitize);
  add_revolve(app, commands.revolve);
  add_batch(app, commands.batch);
  add_batch_merge(app, commands.batch_merge);
  add_check(app, commands.check);
}

}  // namespace exsect::cli
