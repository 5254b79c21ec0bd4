#include "app/output/run_states.h"

#include <array>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <span>

#include "app/project/design.h"
#include "app/project/domain.h"
#include "app/project/file/project_writer.h"
#include "app/project/project_fwd.h"

namespace wend {
namespace {

using SortedJson = nlohmann::json;

/// Computes FNV-1a over 64 bits, which distinguishes two runs of one user, nothing more.
class Digest {
  public:
    template <class Number>
    void add(std::span<const Number> numbers) {
        const std::span<const std::byte> bytes = std::as_bytes(numbers);
        for (const std::byte byte : bytes)
            m_sum = (m_sum ^ std::to_integer<std::uint64_t>(byte)) * 0x100000001b3;
    }
    void add(const std::string& text) { add(std::span<const char>(text)); }
    std::string text() const { return std::to_string(m_sum); }

  private:
    std::uint64_t m_sum = 0xcbf29ce484222325;
};

template <int Dim>
std::string meshDigest(const SimplicialMesh<Dim>& rest) {
    Digest digest;
    digest.add(std::span<const double>(rest.points.data(), static_cast<std::size_t>(rest.points.size())));
    for (const Cell<Dim>& cell : rest.cells) digest.add(std::span<const int>(cell));
    for (const Weld& weld : rest.welds)
        for (const auto& [vertex, weight] : weld.terms) {
            digest.add(std::span<const int>(&vertex, 1));
            digest.add(std::span<const double>(&weight, 1));
        }
    return digest.text();
}

template <int Dim>
std::string materialDigest(const Material<Dim>& material) {
    Digest digest;
    digest.add(std::span<const double>(material.phi));
    for (const Mat<Dim>& B : material.anisotropy)
        digest.add(std::span<const double>(B.data(), static_cast<std::size_t>(B.size())));
    const Smoothing& smoothing = material.smoothing;
    const std::array<double, 4> settings{static_cast<double>(smoothing.kind), smoothing.length,
                                         smoothing.lambda, material.memory};
    digest.add(std::span<const double>(settings));
    return digest.text();
}

void addSurfaces(const Design& design, Digest& digest) {
    for (const Pin& handle : design.handles) {
        if (!handle.slide || !handle.slide->mesh) continue;
        const GuideMesh<3>& mesh = *handle.slide->mesh;
        const Eigen::MatrixXd points = mesh.points.topRows(design.dimension);
        digest.add(std::span<const double>(points.data(), static_cast<std::size_t>(points.size())));
        for (const auto& triangle : mesh.triangles) digest.add(std::span<const int>(triangle));
        for (const auto& segment : mesh.segments) digest.add(std::span<const int>(segment));
    }
}

/// Adds the contents of the files that motions are read from.
void addMotionFiles(const Design& design, Digest& digest) {
    const auto d = static_cast<std::size_t>(design.dimension);
    for (const Pin& handle : design.handles)
        for (const PinMotion& motion : handle.motions) {
            if (const auto* field = std::get_if<FieldMotion<3>>(&motion.kind))
                for (const auto& [vertex, displacement] : *field->values) {
                    digest.add(std::span<const int>(&vertex, 1));
                    digest.add(std::span<const double>(displacement.data(), d));
                }
            if (const auto* poses = std::get_if<PoseMotion<3>>(&motion.kind)) {
                digest.add(std::span<const double>(poses->times));
                for (const RigidPose<3>& pose : poses->poses) {
                    digest.add(std::span<const double>(pose.position.data(), d));
                    digest.add(d == 2 ? std::span<const double>(&pose.rotation[2], 1)
                                      : std::span<const double>(pose.rotation.data(), 3));
                }
            }
        }
}

std::string handlesDigest(const Project& project, const SortedJson& json) {
    SortedJson handles = json.value("handles", SortedJson::array());
    for (SortedJson& handle : handles)
        for (const char* seen : {"name", "locked", "hidden", "group", "link", "colour"}) handle.erase(seen);
    Digest digest;
    digest.add(handles.dump() + std::to_string(static_cast<int>(domainOf(project).border)));
    addMotionFiles(designOf(project), digest);
    addSurfaces(designOf(project), digest);
    return digest.text();
}

std::string settingsDigest(const SortedJson& json) {
    Digest digest;
    for (const char* key : {"integration", "time", "settle"})
        digest.add(json.value(key, SortedJson()).dump() + "\n");
    return digest.text();
}

}  // namespace

template <int Dim>
StatesHeader statesHeader(const Project& project, const Shape<Dim>& shape, double end) {
    const SortedJson json = SortedJson::parse(toJson(project));
    return {Dim,
            end,
            {{"mesh", meshDigest<Dim>(*shape.rest)},
             {"material", materialDigest<Dim>(*shape.material)},
             {"handles", handlesDigest(project, json)},
             {"settings", settingsDigest(json)}}};
}

template StatesHeader statesHeader<2>(const Project&, const Shape<2>&, double);
template StatesHeader statesHeader<3>(const Project&, const Shape<3>&, double);

}  // namespace wend
