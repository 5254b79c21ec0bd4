#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "app/cli/commands.h"
#include "app/cli/interrupt.h"
#include "app/cli/size_argument.h"
#include "app/cli/terminal.h"
#include "app/engine/shape/flat_shape.h"
#include "app/engine/shape/mesh_rest.h"
#include "app/engine/shape/shape_builder.h"
#include "app/output/output_set.h"
#include "app/output/overwriting.h"
#include "app/output/report.h"
#include "app/output/run_options.h"
#include "app/output/shape_file.h"
#include "app/project/design.h"
#include "app/project/domain.h"
#include "app/project/edits/scaled_project.h"
#include "app/project/file/json_text.h"
#include "app/project/file/named_files.h"
#include "app/project/file/project_reader.h"
#include "core/base/error.h"
#include "core/base/file_name.h"
#include "core/mesh/mesh_file.h"

namespace wend {
namespace {

bool isMeshName(const std::string& path) {
    return std::ranges::count(readableMeshExtensions(), lowerExtension(path)) > 0;
}

/// Refuses options that contradict each other.
void requireConsistent(const Arguments& arguments) {
    for (const char* other : {"--edge", "--max-volume"})
        if (arguments.has("--vertices") && arguments.has(other))
            throw UsageError(std::string("--vertices and ") + other + " cannot both be given");
    if (arguments.has("--largest-hole") && !arguments.has("--repair"))
        throw UsageError("--largest-hole is for --repair");
    for (const char* other : {"--cage", "--cage-detail", "--cage-offset"})
        if (arguments.has("--no-cage") && arguments.has(other))
            throw UsageError("--cage and --no-cage cannot both be given");
}

void readDomain(const Arguments& arguments, Project& project) {
    requireConsistent(arguments);
    takeSettings(project, arguments);
    Domain& domain = domainOf(project);
    for (const char* flag : {"--cage", "--cage-detail", "--cage-offset"})
        if (arguments.has(flag)) domain.fit = Fit::Cage;
    if (arguments.has("--no-cage")) domain.fit = Fit::Exact;
    // Named from where the command runs, not from the project.
    if (arguments.has("--sizes"))
        domain.sizesFile = std::filesystem::absolute(arguments.text("--sizes")).string();
    requireFitting(project, arguments);
}

/// Returns a project with this domain and default values for everything else.
std::shared_ptr<Project> domainOnly(DomainKind kind, const std::string& path) {
    auto project = newProject();
    domainOf(*project).kind = kind;
    domainOf(*project).path = path;
    if (kind == DomainKind::Surface) designOf(*project).dimension = 3;
    return project;
}

struct Input {
    std::shared_ptr<Project> project;
    std::string folder;  // that its paths are relative to
};

/// Reads the domain from a project, a surface or a picture; the outline of a picture with alpha follows the
/// alpha.
Input inputFrom(const std::string& path, Terminal& terminal) {
    if (lowerExtension(path) == ".wend") {
        LoadedProject loaded = readProject(path);
        for (const std::string& warning : loaded.warnings) terminal.warn(path + ": " + warning);
        if (const std::string text = fitToPicture(*loaded.project, folderOf(path)); !text.empty())
            terminal.warn(path + ": " + text);
        return {std::move(loaded.project), folderOf(path)};
    }
    if (isMeshName(path)) return {domainOnly(DomainKind::Surface, path), ""};
    Input input{domainOnly(DomainKind::Image, path), ""};
    if (lowerExtension(path) == ".json") {
        domainOf(*input.project).outline = OutlineKind::Polygons;
        domainOf(*input.project).polygons = readOutlineFile(path);
    } else if (readImageHeader(path).alpha) {
        domainOf(*input.project).outline = OutlineKind::Alpha;
    }
    return input;
}

struct Meshed {
    MeshFile file;
    std::vector<Message> notices;
    std::optional<MeshVerdict> verdict;
    std::optional<CageFacts> cage;
};

Meshed meshOf(const Input& input, const std::string& path, std::stop_token stop) {
    const Project& project = *input.project;
    if (lowerExtension(path) == ".json") {
        Meshed meshed;
        const Domain& domain = domainOf(project);
        const auto rest = meshPicture(domain, designOf(project), domain.polygons, stop);
        tellOfAim(domain, *rest, meshed.notices);
        tellOfHanging<2>(*rest, meshed.notices);
        meshed.file = toMeshFile<2>(*rest);
        return meshed;
    }
    const AnyShape any = loadShape(project, input.folder, stop);
    return std::visit(
        []<int Dim>(const Shape<Dim>& shape) {
            return Meshed{poseFile<Dim>(shape, shape.rest->points), shape.notices, shape.verdict, shape.cage};
        },
        any);
}

void printJson(const Meshed& meshed) {
    using Json = nlohmann::ordered_json;
    const MeshFile& file = meshed.file;
    Json json{{"vertices", file.points.cols()},
              {"cells", isVolume(file) ? file.tetrahedra.size() : file.triangles.size()},
              {"notices", textsOf(meshed.notices)}};
    if (meshed.cage) json["cage"] = Json::parse(cageJson(*meshed.cage));
    if (meshed.verdict) json["quality"] = Json::parse(verdictJson(*meshed.verdict));
    print(prettyJson(json));
}

}  // namespace

ExitCode runMesh(const Arguments& arguments) try {
    const std::string path = onlyFile(arguments, "picture, outline, project or surface");
    requireFile(path);
    if (!arguments.has("--output")) throw UsageError("no output is named (-o FILE)");
    const std::string output = arguments.text("--output");
    if (output == "-" && arguments.has("--json"))
        throw UsageError("the mesh and --json cannot both go to standard output (-)");
    Terminal terminal(arguments.has("--progress") ? Terminal::Progress::Shown : Terminal::Progress::Automatic,
                      arguments.has("--quiet"));
    Input input = inputFrom(path, terminal);
    if (lowerExtension(path) == ".json" && arguments.has("--outline"))
        throw UsageError("--outline is for pictures");
    drawInSize(arguments, input.folder, *input.project);
    readDomain(arguments, *input.project);
    RunOutputs outputs;
    outputs.mesh = {output};
    const std::vector<OwnInput> inputs = inputsOf(*input.project, path, input.folder);
    if (const std::string clash = overwriting(inputs, outputs); !clash.empty()) throw UsageError(clash);
    requirePossible(*input.project, outputs);

    Interrupt interrupt([&] { terminal.end(kCancelled); });
    terminal.progress("meshing", 0);
    const Meshed meshed = meshOf(input, path, interrupt.token());
    for (const std::string& notice : meshed.notices) terminal.warn(path + ": " + notice);
    // A quality that is given by number is reported as missed even if the difference is small.
    if (arguments.has("--quality") && meshed.verdict && meshed.verdict->missed() &&
        meshed.verdict->text().isEmpty())
        terminal.warn(path + ": the worst cell has a ratio of radius to edge of " +
                      shortNumber(meshed.verdict->got) + ", where " + shortNumber(meshed.verdict->asked) +
                      " was asked for");
    if (output != "-")
        if (const std::string lost = lostInFile(output, meshed.file, meshOptionsFrom(arguments.values()));
            !lost.empty())
            terminal.warn(output + ": " + lost);
    OutputSet files;
    files.add(output, ".vtu", [&](const std::string& file) {
        writeMeshFile(file, meshed.file, meshOptionsFrom(arguments.values()));
    });
    files.commit();
    if (arguments.has("--json")) printJson(meshed);
    return ExitCode::Done;
} catch (const InputError& error) {
    if (!error.file().empty()) throw;
    throw error.named(arguments.files().front());
}

}  // namespace wend
