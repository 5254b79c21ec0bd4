#include "app/cli/run_preparation.h"

#include <algorithm>
#include <charconv>
#include <filesystem>

#include "app/cli/size_argument.h"
#include "app/engine/shape/material_picture.h"
#include "app/output/output_set.h"
#include "app/output/overwriting.h"
#include "app/output/run_options.h"
#include "app/project/edits/material_edits.h"
#include "app/project/file/named_files.h"
#include "app/project/project.h"
#include "core/base/error.h"
#include "core/base/same_file.h"

namespace wend {
namespace {

RunOutputs outputsFrom(const Arguments& arguments) {
    RunOutputs outputs;
    outputs.image = arguments.texts("--image");
    outputs.mesh = arguments.texts("--mesh");
    outputs.velocity = arguments.texts("--velocity");
    outputs.stMap = arguments.texts("--stmap");
    outputs.frames = arguments.texts("--frames");
    outputs.report = arguments.texts("--report");
    outputs.states = arguments.texts("--states");
    outputs.material = {arguments.texts("--phi-picture"), arguments.texts("--stiffness-picture"),
                        arguments.texts("--direction-picture")};
    const std::vector<std::string> pairs = arguments.texts("--points");
    for (std::size_t k = 0; k + 1 < pairs.size(); k += 2) outputs.points.push_back({pairs[k], pairs[k + 1]});
    outputs.count = arguments.integer("--count");
    outputs.films = arguments.texts("--film");
    outputs.loop = arguments.has("--loop");
    for (const char* flag : {"--states", "--frames", "--film"})
        if (std::ranges::count(arguments.texts(flag), "-") > 0)
            throw UsageError(std::string(flag) + " cannot go to standard output (-)");
    if (std::ranges::count(outputs.singleFiles(), "-") > 1)
        throw UsageError("only one output can go to standard output (-)");
    if (arguments.has("--inverse") && outputs.points.empty()) throw UsageError("--inverse is for --points");
    for (const char* flag : {"--count", "--loop"})
        if (arguments.has(flag) && !outputs.hasFrames())
            throw UsageError(std::string(flag) + " is for --frames and --film");
    if (arguments.has("--fps") && outputs.films.empty() && std::ranges::none_of(outputs.frames, isAnimation))
        throw UsageError("--fps is for --film, and for --frames with a .webp or .glb without ####");
    if (!outputs.films.empty() && !arguments.has("--count")) outputs.count = 0;
    if (arguments.has("--scale") && arguments.has("--width"))
        throw UsageError("--scale and --width both say how large pictures are");
    return outputs;
}

/// Standard input is read once.
void requireOneStandardInput(const std::string& project, const std::string& motion,
                             const RunOutputs& outputs) {
    const auto points = std::ranges::count(outputs.points, "-", &PointsOutput::in);
    if (points + (project == "-" ? 1 : 0) + (motion == "-" ? 1 : 0) > 1)
        throw UsageError("only one input can come from standard input (-)");
}

/// Parses "3/8".
Shard shardFrom(const std::string& text) {
    Shard shard;
    const char *first = text.data(), *last = first + text.size();
    const auto index = std::from_chars(first, last, shard.index);
    const bool divided = index.ec == std::errc() && index.ptr != last && *index.ptr == '/';
    const auto count = divided ? std::from_chars(index.ptr + 1, last, shard.count) : index;
    if (!divided || count.ec != std::errc() || count.ptr != last || shard.index < 1 ||
        shard.index > shard.count)
        throw UsageError("--shard: \"" + text + "\" is not I/N with I from 1 to N");
    return shard;
}

/// Throws UsageError unless a shard is asked of frames alone, which are painted from states.
void requireShardOfFrames(const RunOptions& options) {
    const RunOutputs& outputs = options.outputs;
    if (options.from.empty()) throw UsageError("--shard needs states (--from FILE)");
    if (outputs.frames.empty() || std::ranges::any_of(outputs.frames, isAnimation))
        throw UsageError("--shard is for --frames with #### in the name");
    RunOutputs others = outputs;
    others.frames.clear();
    if (others.any()) throw UsageError("with --shard nothing but --frames is written");
}

/// Adds paint as the topmost layer. The line's files are relative to the current folder.
void paint(Project& project, const std::string& folder, const Arguments& arguments) {
    MaterialPictures pictures;
    for (const auto& [flag, file] : {std::pair{"--paint-phi", &pictures.phi},
                                     {"--paint-stiffness", &pictures.stiffness},
                                     {"--paint-direction", &pictures.direction}})
        if (arguments.has(flag)) *file = std::filesystem::absolute(arguments.text(flag)).string();
    if (!pictures.any()) return;
    if (project.dimension() != 2)
        throw InputError(pathIn(folder, project.domain.path),
                         "is a solid: its material is read from a mesh file (material.cells)");
    const PictureFrame frame = pictureFrame(project.domain, folder);
    pictures.up = frame.up;
    project.design = withPictures(project.design, "painted", frame.box, pictures);
}

/// Applies the command line's settings, which take precedence over the project's.
void override(Project& project, const Arguments& arguments) {
    takeSettings(project, arguments);
    IntegrationOptions& integration = project.integration;
    integration.threads = arguments.integer("--threads");
    if (integration.solver == SolverKind::Multigrid &&
        arguments.values().choice<BackEndKind>("--backend") == BackEndKind::OpenCl)
        throw UsageError("--solver multigrid computes on the processor: leave --backend opencl out");
    const bool given = arguments.has("--method") || arguments.has("--steps") || arguments.has("--tolerance");
    if (const std::string problem = integration.problem(); given && !problem.empty())
        throw UsageError(problem + (integration.steps == 0 ? " (--steps N)" : ""));
    if (arguments.has("--settle")) appendSettling(project, project.end);
}

/// Multigrid alone is divided, and every process takes one thread unless the line says otherwise.
void divide(IntegrationOptions& integration) {
    if (integration.solver == SolverKind::Direct)
        throw UsageError("only multigrid is divided among processes: take wend run for --solver direct");
    integration.solver = SolverKind::Multigrid;
    if (integration.threads == 0) integration.threads = 1;
}

/// Sets the frame rate to the project's, which already includes the options of the line, and the number of
/// frames, unless it is given, to as many as the motion needs.
void takeFrameRate(const Project& project, double at, RunOutputs& outputs) {
    outputs.framesPerSecond = project.frameRate;
    if (outputs.count == 0)
        outputs.count = frameCount(frameSpan(project, at, outputs), outputs.framesPerSecond, outputs.loop);
}

}  // namespace

RunOptions runOptionsOf(const Arguments& arguments) {
    RunOptions options = runOptionsFrom(arguments.values());
    options.outputs = outputsFrom(arguments);
    options.at = arguments.given("--at");
    options.from = arguments.text("--from");
    options.inverse = arguments.has("--inverse");
    if (arguments.has("--shard")) {
        options.shard = shardFrom(arguments.text("--shard"));
        requireShardOfFrames(options);
    }
    options.backEnd = arguments.values().choice<BackEndKind>("--backend");
    return options;
}

std::vector<std::string> takeLine(const Arguments& arguments, const std::string& path, RunOptions& options,
                                  Project& project) {
    drawInSize(arguments, folderOf(path), project);
    override(project, arguments);
    if (options.solvers.space) divide(project.integration);
    paint(project, folderOf(path), arguments);
    takeFrameRate(project, options.at.value_or(project.end), options.outputs);
    std::vector<OwnInput> inputs = inputsOf(project, path, folderOf(path));
    // A file of states that is continued may be its own output.
    if (!options.from.empty() && std::ranges::none_of(options.outputs.states, [&](const std::string& file) {
            return sameFile(options.from, file);
        }))
        inputs.push_back({OwnFile::States, options.from});
    for (const PointsOutput& one : options.outputs.points)
        for (const std::string& file : writtenAlong(one.in)) inputs.push_back({OwnFile::Points, file});
    const std::string motion = arguments.text("--motion-of");
    if (!motion.empty()) inputs.push_back({OwnFile::Project, motion});
    requireOneStandardInput(path, motion, options.outputs);
    if (const std::string clash = overwriting(inputs, options.outputs); !clash.empty())
        throw UsageError(clash);
    std::vector<std::string> notices;
    if (!options.outputs.any()) notices.push_back("no output was asked for; nothing will be written");
    const double standsFrom = std::max(project.end, endOfMotions(project));
    if (options.at && *options.at > standsFrom)
        notices.push_back("nothing moves after its end at time " + shortNumber(standsFrom));
    return notices;
}

}  // namespace wend
