#include "kernels/opencl_distortion.h"

#include <cmath>

#include "core/energy/cell_energy.h"
#include "kernels/opencl_context.h"
#include "kernels/rest_inverses.h"

namespace wend {
namespace {

constexpr int kChunkCells = 1024;  // cells per work item of the sums

/// Returns d! times the rest measures, the weights of the totals.
template <int Dim>
std::vector<double> weightsOf(const SimplicialMesh<Dim>& rest) {
    std::vector<double> weights;
    weights.reserve(rest.cells.size());
    for (const auto& cell : rest.cells)
        weights.push_back(std::abs(edgeMatrix<Dim>(rest.points, cell).determinant()));
    return weights;
}

/// Finds the results that depend on all cells in their order: flips, the least determinant, the worst cell.
void findExtremes(Distortion& result) {
    double worst = -1;
    for (std::size_t c = 0; c < result.ratio.size(); ++c) {
        const double det = result.ratio[c];
        if (!(det > 0)) ++result.flips;
        if (c == 0 || det < result.minDet) result.minDet = det;
        if (result.metric[c] > worst) {
            worst = result.metric[c];
            result.worstCell = static_cast<int>(c);
        }
    }
}

}  // namespace

template <int Dim>
struct OpenClDistortion<Dim>::Device {
    OpenClContext cl;
    int cells;
    int chunks;
    cl::Kernel perCell, sum;
    cl::Buffer corners, pose, restInverse, weights, values, sums;
    double restMeasure = 0;

    Device(const OpenClPlace& info, const SimplicialMesh<Dim>& rest)
        : cl(info), cells(rest.cellCount()), chunks((cells + kChunkCells - 1) / kChunkCells) {
        const cl::Program program = cl.build({"distortion.cl"}, "-cl-std=CL1.2 -DDIM=" + std::to_string(Dim));
        perCell = cl::Kernel(program, "cellDistortion");
        sum = cl::Kernel(program, "sumDistortion");
        std::vector<int> vertices;
        for (const auto& cell : rest.cells) vertices.insert(vertices.end(), cell.begin(), cell.end());
        const std::vector<double> inverses = restInverses<Dim>(rest), weight = weightsOf<Dim>(rest);
        for (double w : weight) restMeasure += w;
        corners = cl.copyOf(vertices.data(), vertices.size());
        restInverse = cl.copyOf(inverses.data(), inverses.size());
        weights = cl.copyOf(weight.data(), weight.size());
        pose = cl.buffer<double>(static_cast<std::size_t>(rest.points.size()));
        values = cl.buffer<double>(4 * static_cast<std::size_t>(cells));
        sums = cl.buffer<double>(3 * static_cast<std::size_t>(chunks));
    }

    void addTotals(Distortion& result) {
        launch(cl.queue(), sum, chunks, cells, kChunkCells, values, weights, sums);
        std::vector<double> parts(3 * static_cast<std::size_t>(chunks));
        cl.read(sums, parts.data(), parts.size());
        for (std::size_t k = 0; k < parts.size(); k += 3) {
            result.totalAngle += parts[k];
            result.totalVolume += parts[k + 1];
            result.totalMetric += parts[k + 2];
        }
        if (!(restMeasure > 0)) return;
        for (double* total : {&result.totalAngle, &result.totalVolume, &result.totalMetric})
            *total /= restMeasure;
    }

    Distortion of(const Points<Dim>& shape) {
        cl.write(pose, shape.data(), static_cast<std::size_t>(shape.size()));
        launch(cl.queue(), perCell, cells, corners, pose, restInverse, values);
        std::vector<double> all(4 * static_cast<std::size_t>(cells));
        cl.read(values, all.data(), all.size());
        Distortion result;
        const auto part = [&](int k) {
            return std::vector<double>(all.begin() + k * cells, all.begin() + (k + 1) * cells);
        };
        result.angle = part(0), result.volume = part(1), result.metric = part(2), result.ratio = part(3);
        addTotals(result);
        findExtremes(result);
        return result;
    }
};

template <int Dim>
OpenClDistortion<Dim>::OpenClDistortion(const OpenClPlace& device, const SimplicialMesh<Dim>& rest)
    : m_device(guarded([&] { return std::make_unique<Device>(device, rest); })) {}

template <int Dim>
OpenClDistortion<Dim>::~OpenClDistortion() = default;

template <int Dim>
Distortion OpenClDistortion<Dim>::of(const Points<Dim>& pose) {
    return guarded([&] { return m_device->of(pose); });
}

template class OpenClDistortion<2>;
template class OpenClDistortion<3>;

}  // namespace wend
