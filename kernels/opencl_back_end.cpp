#include "kernels/opencl_back_end.h"

#include <Eigen/LU>
#include <algorithm>
#include <numeric>

#include "core/assembly/cpu_back_end.h"
#include "core/energy/cell_energy.h"
#include "kernels/opencl_context.h"
#include "kernels/opencl_stages.h"
#include "kernels/rest_inverses.h"

namespace wend {
namespace {

constexpr int kChunk = 1024;  // cells per work item of the search for a bad one

template <int Dim>
class OpenClBackEnd final : public BackEnd<Dim> {
  public:
    OpenClBackEnd(const OpenClPlace& device, std::shared_ptr<const AssemblyPlan<Dim>> plan,
                  const SimplicialMesh<Dim>& rest, const Material<Dim>& material, int threads)
        : m_cl(device),
          m_plan(std::move(plan)),
          m_anisotropic(!material.anisotropy.empty()),
          m_paper(material.smoothing.kind == SmoothingKind::Paper),
          m_stages(m_cl, m_plan->vertexCount),
          m_workers(usefulThreads(threads, Dim * rest.vertexCount())) {
        buildKernels();
        uploadPlan();
        uploadMaterial(rest, material);
        allocate();
    }

    std::string name() const override { return "opencl"; }
    std::string device() const override { return m_cl.info().name; }
    WorkerPool& workers() override { return m_workers; }

    void setMassRegularization(std::vector<double> epsilon) override {
        guarded([&] {
            epsilon.resize(static_cast<std::size_t>(cells()), 0.0);
            m_massRegularization = m_cl.copyOf(epsilon.data(), epsilon.size());
        });
    }

    int setShape(const Points<Dim>& shape) override {
        return guarded([&] {
            write(m_shape, shape);
            return computeAt(m_shape);
        });
    }
    StageVectors<Dim>& stages() override { return m_stages; }
    int setStage() override {
        return guarded([&] { return computeAt(m_stages.buffer()); });
    }
    CopiedBytes copied() const override { return m_cl.copied(); }

    void assemble(std::span<double> values) override {
        guarded([&] {
            launch(m_cl.queue(), m_assemble, m_plan->blockCount(), m_ownStart, m_own, m_crossStart, m_cross,
                   m_facetOfCorner, m_facets, m_gradients, m_measure, m_weights, m_beta, m_facetWeight,
                   m_massRegularization, m_B, m_values);
            m_cl.read(m_values, values.data(), values.size());
        });
    }

    void apply(const Points<Dim>& v, Points<Dim>& Av) override {
        guarded([&] {
            forces(v);
            launch(m_cl.queue(), m_vertexForce, m_plan->vertexCount, m_cornerStart, m_corners, m_cells,
                   m_gradients, m_measure, m_massRegularization, m_force, m_field, m_product);
            Av.resize(Dim, v.cols());
            m_cl.read(m_product, Av.data(), static_cast<std::size_t>(Av.size()));
        });
    }

    double energy(const Points<Dim>& v) override {
        return guarded([&] {
            forces(v);
            std::vector<double> perCell(static_cast<std::size_t>(cells()));
            m_cl.read(m_cellEnergy, perCell.data(), perCell.size());
            return std::accumulate(perCell.begin(), perCell.end(), 0.0);
        });
    }

  private:
    int cells() const { return m_plan->cellCount(); }
    int facets() const { return static_cast<int>(m_plan->facets.size()); }

    void write(cl::Buffer& target, const Points<Dim>& values) {
        m_cl.write(target, values.data(), static_cast<std::size_t>(values.size()));
    }

    void buildKernels() {
        std::string options = "-cl-std=CL1.2 -DDIM=" + std::to_string(Dim);
        if (m_anisotropic) options += " -DANISOTROPIC";
        if (m_paper) options += " -DPAPER";
        const cl::Program program = m_cl.build({"matrices.cl", "assembly.cl"}, options);
        m_setCells = cl::Kernel(program, "setCells");
        m_firstBad = cl::Kernel(program, "firstBad");
        m_setFacets = cl::Kernel(program, "setFacets");
        m_setBeta = cl::Kernel(program, "setBeta");
        m_assemble = cl::Kernel(program, "assemble");
        m_cellStress = cl::Kernel(program, "cellStress");
        m_cellForce = cl::Kernel(program, "cellForce");
        m_vertexForce = cl::Kernel(program, "vertexForce");
    }

    template <typename T>
    cl::Buffer upload(const std::vector<T>& values) {
        return m_cl.copyOf(values.data(), values.size());
    }

    void uploadPlan() {
        m_cells = upload(m_plan->cells);
        m_facets = upload(m_plan->facets);
        m_facetOfCorner = upload(m_plan->facetOfCorner);
        m_cornerStart = upload(m_plan->cornerStart);
        m_corners = upload(m_plan->corners);
        m_ownStart = upload(m_plan->ownStart);
        m_own = upload(m_plan->own);
        m_crossStart = upload(m_plan->crossStart);
        m_cross = upload(m_plan->cross);
    }

    void uploadMaterial(const SimplicialMesh<Dim>& rest, const Material<Dim>& material) {
        std::vector<double> measures, weights, B;
        for (int c = 0; c < cells(); ++c) {
            measures.push_back(cellMeasure<Dim>(rest.points, rest.cells[c]));
            const EnergyWeights w = EnergyWeights::of(material.phi[c]);
            weights.insert(weights.end(), {w.q, w.r});
            if (m_anisotropic)
                B.insert(B.end(), material.anisotropy[c].data(), material.anisotropy[c].data() + Dim * Dim);
        }
        m_restMeasure = upload(measures);
        m_weights = upload(weights);
        m_restB = upload(B);
        m_restInverse = m_anisotropic ? upload(restInverses(rest)) : upload(std::vector<double>());
        const Smoothing& smoothing = material.smoothing;
        m_smoothingFactor = m_paper ? smoothing.lambda : smoothing.length * smoothing.length;
    }

    void allocate() {
        const std::size_t count = static_cast<std::size_t>(cells());
        const std::size_t nodal = static_cast<std::size_t>(m_plan->vertexCount) * Dim;
        m_shape = m_cl.buffer<double>(nodal);
        m_field = m_cl.buffer<double>(nodal);
        m_product = m_cl.buffer<double>(nodal);
        m_gradients = m_cl.buffer<double>(count * (Dim + 1) * Dim);
        m_measure = m_cl.buffer<double>(count);
        m_beta = m_cl.buffer<double>(2 * count);
        m_bad = m_cl.buffer<int>(count);
        m_chunks = static_cast<int>((count + kChunk - 1) / kChunk);
        m_first = m_cl.buffer<int>(static_cast<std::size_t>(m_chunks));
        m_B = m_cl.buffer<double>(m_anisotropic ? count * Dim * Dim : 0);
        m_facetWeight = m_cl.buffer<double>(static_cast<std::size_t>(facets()));
        m_values = m_cl.buffer<double>(static_cast<std::size_t>(m_plan->blockCount()) * Dim * Dim);
        m_strain = m_cl.buffer<double>(count * Dim * Dim);
        m_stress = m_cl.buffer<double>(count * Dim * Dim);
        m_force = m_cl.buffer<double>(count * Dim * Dim);
        m_cellEnergy = m_cl.buffer<double>(count);
        m_massRegularization = upload(std::vector<double>(count, 0.0));
    }

    int computeAt(const cl::Buffer& shape) {
        auto& queue = m_cl.queue();
        launch(queue, m_setCells, cells(), m_cells, shape, m_restMeasure, m_restInverse, m_restB, m_gradients,
               m_measure, m_B, m_bad);
        launch(queue, m_setFacets, facets(), m_cells, m_facets, shape, m_smoothingFactor, m_facetWeight);
        launch(queue, m_setBeta, cells(), m_facetOfCorner, m_facets, m_weights, m_facetWeight, m_beta);
        return firstBad();
    }

    /// Returns the first bad cell, or −1.
    int firstBad() {
        // Work items beyond the last chunk must find nothing: the count of items is the count of chunks.
        const std::size_t local = 1;
        m_firstBad.setArg(0, cells());
        m_firstBad.setArg(1, kChunk);
        m_firstBad.setArg(2, m_bad);
        m_firstBad.setArg(3, m_first);
        m_cl.queue().enqueueNDRangeKernel(m_firstBad, cl::NullRange, cl::NDRange(m_chunks),
                                          cl::NDRange(local));
        std::vector<int> first(static_cast<std::size_t>(m_chunks));
        m_cl.read(m_first, first.data(), first.size());
        const int found = *std::min_element(first.begin(), first.end());
        return found == cells() ? -1 : found;
    }

    void forces(const Points<Dim>& v) {
        write(m_field, v);
        auto& queue = m_cl.queue();
        launch(queue, m_cellStress, cells(), m_cells, m_gradients, m_weights, m_B, m_field, m_strain,
               m_stress);
        launch(queue, m_cellForce, cells(), m_facetOfCorner, m_facets, m_facetWeight, m_measure, m_weights,
               m_B, m_strain, m_stress, m_force, m_cellEnergy);
    }

    OpenClContext m_cl;
    std::shared_ptr<const AssemblyPlan<Dim>> m_plan;
    bool m_anisotropic, m_paper;
    OpenClStages<Dim> m_stages;
    WorkerPool m_workers;
    int m_chunks = 0;
    cl_double m_smoothingFactor = 0;
    cl::Kernel m_setCells, m_firstBad, m_setFacets, m_setBeta, m_assemble, m_cellStress, m_cellForce,
        m_vertexForce;
    cl::Buffer m_cells, m_facets, m_facetOfCorner, m_cornerStart, m_corners, m_ownStart, m_own, m_crossStart,
        m_cross;
    cl::Buffer m_restMeasure, m_restInverse, m_restB, m_weights, m_massRegularization;
    cl::Buffer m_shape, m_field, m_product, m_gradients, m_measure, m_beta, m_bad, m_first, m_B,
        m_facetWeight, m_values;
    cl::Buffer m_strain, m_stress, m_force, m_cellEnergy;
};

}  // namespace

template <int Dim>
std::unique_ptr<BackEnd<Dim>> makeOpenClBackEnd(const OpenClPlace& device,
                                                std::shared_ptr<const AssemblyPlan<Dim>> plan,
                                                const SimplicialMesh<Dim>& rest,
                                                const Material<Dim>& material, int threads) {
    return guarded([&] {
        return std::make_unique<OpenClBackEnd<Dim>>(device, std::move(plan), rest, material, threads);
    });
}

#define WEND_INSTANTIATE(Dim)                                                                     \
    template std::unique_ptr<BackEnd<Dim>> makeOpenClBackEnd(                                     \
        const OpenClPlace&, std::shared_ptr<const AssemblyPlan<Dim>>, const SimplicialMesh<Dim>&, \
        const Material<Dim>&, int);
WEND_INSTANTIATE(2)
WEND_INSTANTIATE(3)

}  // namespace wend
