#include "bench/paper.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "app/output/run.h"
#include "app/project/file/json_text.h"
#include "app/project/file/named_files.h"
#include "app/project/file/project_reader.h"
#include "app/project/file/text_file.h"
#include "bench/body.h"
#include "bench/flow_rows.h"
#include "bench/paper_scenes.h"
#include "core/base/error.h"
#include "core/base/temporary_folder.h"
#include "core/energy/distortion.h"
#include "core/integration/deformer.h"
#include "core/mesh/mesh_of_file.h"

namespace wend {
namespace {

using Figures = std::vector<std::pair<std::string, double>>;

std::string quoted(std::string text) {
    std::ranges::replace(text, '\'', '"');
    return text;
}

/// Returns a name for the file of a scene and a material.
std::string plain(std::string name) {
    std::erase(name, '\'');
    std::ranges::replace(name, ' ', '-');
    return name;
}

/// Returns the share of the worst hundredth of the cells in the metric error.
template <int Dim>
double worstShare(const SimplicialMesh<Dim>& rest, const Distortion& distortion) {
    std::vector<double> errors;
    double sum = 0;
    for (std::size_t c = 0; c < rest.cells.size(); ++c) {
        errors.push_back(cellMeasure<Dim>(rest.points, rest.cells[c]) * distortion.metric[c]);
        sum += errors.back();
    }
    std::ranges::sort(errors, std::greater());
    double worst = 0;
    for (std::size_t i = 0; i < std::max<std::size_t>(1, errors.size() / 100); ++i) worst += errors[i];
    return sum > 0 ? worst / sum : 0;
}

template <int Dim>
double measureOf(const Points<Dim>& points, const std::vector<Cell<Dim>>& cells) {
    double sum = 0;
    for (const Cell<Dim>& cell : cells) sum += cellMeasure<Dim>(points, cell);
    return sum;
}

/// Returns the distortion of the middle third of the shape's length at rest.
template <int Dim>
Distortion ofMiddleThird(const SimplicialMesh<Dim>& rest, const Points<Dim>& pose) {
    const double low = rest.points.row(0).minCoeff(), length = rest.points.row(0).maxCoeff() - low;
    SimplicialMesh<Dim> middle{rest.points, {}};
    for (const Cell<Dim>& cell : rest.cells) {
        double x = 0;
        for (const int vertex : cell) x += (rest.points(0, vertex) - low) / (Dim + 1);
        if (x > length / 3 && x < 2 * length / 3) middle.cells.push_back(cell);
    }
    return distortion<Dim>(middle, pose);
}

template <int Dim>
Figures figuresOf(const SimplicialMesh<Dim>& rest, const Points<Dim>& pose) {
    const Distortion all = distortion<Dim>(rest, pose);
    const double change = measureOf<Dim>(pose, rest.cells) / measureOf<Dim>(rest.points, rest.cells) - 1;
    return {{"angle", all.totalAngle},          {"volume", all.totalVolume},
            {"metric", all.totalMetric},        {"worst 1 %", worstShare<Dim>(rest, all)},
            {"whole measure's change", change}, {"inverted", all.flips}};
}

/// Writes meshes and projects into a folder and runs these.
class Figurist {
  public:
    Figurist(const PaperOptions& options, std::string folder, BenchRecorder& recorder)
        : m_options(options), m_folder(std::move(folder)), m_recorder(recorder) {}

    void add(const PaperScene& scene) { scene.dimension == 2 ? addIn<2>(scene) : addIn<3>(scene); }
    const std::map<std::string, Figures>& results() const { return m_results; }

  private:
    template <int Dim>
    void addIn(const PaperScene& scene) {
        const std::string extension = Dim == 2 ? ".obj" : ".mesh";
        const std::string meshName = plain(scene.shape) + extension;
        const SimplicialMesh<Dim>& rest = shape<Dim>(scene.shape, pathIn(m_folder, meshName));
        m_recorder.begin({scene.figure + ": " + scene.name, Dim, rest.vertexCount(), rest.cellCount(), {}});
        for (const PaperScene::Variant& variant : scene.variants) {
            const std::string name = plain(scene.name + "-" + variant.name);
            const std::string project = pathIn(m_folder, name + ".wend");
            writeTextFile(project, "{\"format\": \"wend\", \"version\": 1, \"domain\": {\"mesh\": \"" +
                                       meshName + "\"}, \"material\": " + quoted(variant.material) +
                                       ", \"handles\": " + quoted(scene.handles) + "}\n");
            const std::string posed = pathIn(m_folder, name + "-deformed" + extension);
            Figures figures = addRun<Dim>(variant.name, rest, project, posed, scene.middle);
            m_results[scene.name + "/" + variant.name] = std::move(figures);
        }
    }

    template <int Dim>
    const SimplicialMesh<Dim>& shape(const std::string& name, const std::string& file) {
        auto& meshes = std::get<std::map<std::string, SimplicialMesh<Dim>>>(m_meshes);
        if (const auto known = meshes.find(name); known != meshes.end()) return known->second;
        SimplicialMesh<Dim> made;
        if constexpr (Dim == 2)
            made = flatShape(name, m_options.flatVertices);
        else
            made = solidShape(name, m_options.solidVertices);
        writeMesh<Dim>(file, made);
        return meshes[name] = made;
    }

    template <int Dim>
    Figures addRun(const std::string& what, const SimplicialMesh<Dim>& rest, const std::string& projectFile,
                   const std::string& poseFile, bool middle) {
        const auto project = readProject(projectFile).project;
        RunOptions options;
        options.fields = false;
        options.outputs.mesh = {poseFile};
        const std::string reportFile = poseFile + ".json";
        options.outputs.report = {reportFile};
        RunWatch watch;
        watch.stop = m_recorder.stop();
        AdvanceResult result;
        const Timing time = measureOnce([&] { result = runProject(*project, projectFile, options, watch); });
        if (result.outcome != Outcome::Done) throw InputError(projectFile, result.message);
        const Points<Dim> pose = readMesh<Dim>(poseFile).points;
        Figures figures = figuresOf<Dim>(rest, pose);
        if (middle) figures.push_back({"metric, middle third", ofMiddleThird<Dim>(rest, pose).totalMetric});
        const auto report = parseJson(readTextFile(reportFile), reportFile);
        figures.push_back({"off its path", report["constraintError"].get<double>()});
        m_recorder.add({what, 0, time, figures});
        return figures;
    }

    const PaperOptions& m_options;
    std::string m_folder;
    BenchRecorder& m_recorder;
    std::tuple<std::map<std::string, SimplicialMesh<2>>, std::map<std::string, SimplicialMesh<3>>> m_meshes;
    std::map<std::string, Figures> m_results;
};

double figure(const Figures& figures, const std::string& name) {
    const auto found = std::ranges::find(figures, name, &Figures::value_type::first);
    return found == figures.end() ? NAN : found->second;
}

BenchClaim judged(const PaperClaim& claim, const std::map<std::string, Figures>& results) {
    BenchClaim judged{claim.what + ": " + claim.figure, true, {}};
    for (const std::string& key : claim.rising) {
        const double value = std::abs(figure(results.at(key), claim.figure));
        if (!judged.values.empty() && !(value > judged.values.back().second)) judged.holds = false;
        judged.values.push_back({key, value});
    }
    return judged;
}

/// Returns a claim that holds for every row.
BenchClaim below(const std::string& what, const std::string& name, double bound,
                 const std::map<std::string, Figures>& results) {
    BenchClaim claim{what, true, {}};
    double maximum = 0;
    for (const auto& [key, figures] : results) maximum = std::max(maximum, figure(figures, name));
    claim.holds = maximum <= bound;
    claim.values = {{name, maximum}};
    return claim;
}

template <int Dim>
void addTimings(int vertices, BenchRecorder& recorder) {
    const Body<Dim> body = makeBody<Dim>(vertices);
    recorder.begin({"the paper's times", Dim, body.rest->vertexCount(), body.rest->cellCount(), {}});
    addPaperFlow(body, recorder);
}

}  // namespace

std::vector<BenchClaim> addPaperCases(const PaperOptions& options, BenchRecorder& recorder) {
    std::optional<TemporaryFolder> own;
    if (options.folder.empty()) own.emplace(scratchFolder());
    Figurist figurist(options, own ? own->path() : options.folder, recorder);
    for (const PaperScene& scene : paperScenes()) figurist.add(scene);
    if (options.timings) {
        for (const int vertices : {5600, 11000}) addTimings<2>(vertices, recorder);
        for (const int vertices : {1500, 5000}) addTimings<3>(vertices, recorder);
    }
    std::vector<BenchClaim> claims;
    for (const PaperClaim& claim : paperClaims()) claims.push_back(judged(claim, figurist.results()));
    claims.push_back(below("no cell is turned over", "inverted", 0, figurist.results()));
    claims.push_back(below("handles are where they should be", "off its path", 1e-12, figurist.results()));
    return claims;
}

}  // namespace wend
