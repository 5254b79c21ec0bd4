#include "core/meshing/cage_protocol.h"

#include "core/meshing/array_bytes.h"

namespace wend {
namespace {

bool points(ArrayReader& reader, Points3& points) {
    std::vector<double> values;
    if (!reader.array(values) || values.size() % 3 != 0) return false;
    points = Eigen::Map<const Points3>(values.data(), 3, static_cast<Eigen::Index>(values.size() / 3));
    return true;
}

std::vector<double> numbersOf(const std::vector<ClosedGap>& gaps) {
    std::vector<double> numbers;
    for (const ClosedGap& gap : gaps)
        numbers.insert(numbers.end(),
                       {gap.width, gap.place.x(), gap.place.y(), gap.place.z(), gap.cubeAcross});
    return numbers;
}

bool gaps(ArrayReader& reader, std::vector<ClosedGap>& gaps) {
    std::vector<double> numbers;
    if (!reader.array(numbers) || numbers.size() % 5 != 0) return false;
    for (std::size_t i = 0; i < numbers.size(); i += 5)
        gaps.push_back({numbers[i], Vec3(numbers[i + 1], numbers[i + 2], numbers[i + 3]), numbers[i + 4]});
    return true;
}

}  // namespace

std::string pack(const CageRequest& request) {
    const CageOptions& options = request.options;
    ArrayWriter writer;
    writer.array(request.surface.points);
    writer.array(request.surface.triangles);
    writer.array(std::vector<int>{options.vertices});
    writer.array(std::vector<double>{options.maxVolume, options.detail, options.offset});
    return writer.take();
}

bool unpack(const std::string& bytes, CageRequest& request) {
    ArrayReader reader(bytes);
    std::vector<int> counts;
    std::vector<double> numbers;
    if (!points(reader, request.surface.points) || !reader.array(request.surface.triangles) ||
        !reader.array(counts) || !reader.array(numbers) || !reader.done())
        return false;
    if (counts.size() != 1 || numbers.size() != 3) return false;
    request.options = {counts[0], numbers[0], numbers[1], numbers[2], {}};
    return true;
}

std::string pack(const CageReply& reply) {
    const Cage& cage = reply.cage;
    ArrayWriter writer;
    writer.array(packed(reply.error));
    writer.array(cage.mesh.points);
    writer.array(cage.mesh.cells);
    writer.array(std::vector<int>{cage.aimMet ? 1 : 0, cage.bodies, cage.parts, cage.apart});
    writer.array(std::vector<double>{cage.edge, cage.openEdge, cage.openDetail});
    writer.array(numbersOf(cage.gaps));
    return writer.take();
}

bool unpack(const std::string& bytes, CageReply& reply) {
    ArrayReader reader(bytes);
    std::vector<int> counts;
    std::vector<double> numbers;
    Cage& cage = reply.cage;
    std::string error;
    if (!reader.array(error) || !points(reader, cage.mesh.points) || !reader.array(cage.mesh.cells) ||
        !reader.array(counts) || !reader.array(numbers) || !gaps(reader, cage.gaps) || !reader.done())
        return false;
    if (counts.size() != 4 || numbers.size() != 3) return false;
    reply.error = unpackedMessage(error);
    cage.aimMet = counts[0] != 0;
    cage.bodies = counts[1];
    cage.parts = counts[2];
    cage.apart = counts[3];
    cage.edge = numbers[0];
    cage.openEdge = numbers[1];
    cage.openDetail = numbers[2];
    return true;
}

}  // namespace wend
