#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/assembly/assembly_plan.h"
#include "core/assembly/block_source.h"
#include "core/assembly/stage_vectors.h"
#include "core/energy/material.h"
#include "core/factor/worker_pool.h"

namespace wend {

/// Where the matrix is computed. Automatic takes an OpenCL device where there is one, else the CPU.
enum class BackEndKind { Automatic, OpenCl, Cpu };

/// Bytes that went to a device and came from it.
struct CopiedBytes {
    std::size_t toDevice = 0, fromDevice = 0;
};

/// The part of the method that a device does: everything between a shape and the values of a fixed sparse
/// pattern. A is the matrix of the energy, E(v) = vᵀ A v with E = E_φ + E_S (docs/method.md, (13)), plus εM
/// where a mass regularization is set; M is the consistent mass matrix, vᵀ M v = ∫|v|². All lengths are in
/// the frame where the rest shape has size 1. The results have the same bits for any number of threads. One
/// thread uses a back end at a time.
template <int Dim>
class BackEnd {
  public:
    virtual ~BackEnd() = default;

    /// "cpu" or "opencl", and the device's name.
    virtual std::string name() const = 0;
    virtual std::string device() const = 0;

    /// ε of every cell (one each, or empty: none). Takes effect at the next setShape().
    virtual void setMassRegularization(std::vector<double> epsilon) = 0;
    /// Gradients, measures, stress matrices and facet weights at a shape. Returns −1, or the first cell that
    /// is not oriented as it is at rest (inverted, flat or not finite); the other functions may then not be
    /// called.
    virtual int setShape(const Points<Dim>& shape) = 0;

    /// The shapes of an integrator's stages, kept where this back end computes: one object for its life.
    virtual StageVectors<Dim>& stages() {
        if (!m_hostStages) m_hostStages = makeHostStages<Dim>();
        return *m_hostStages;
    }
    /// setShape() at the shape of stages().
    virtual int setStage() { return setShape(*stages().shape()); }
    /// The processor's threads that share the loops of this back end; the factor's take them, too.
    virtual WorkerPool& workers() = 0;
    /// All that was copied so far, plan and material included; nothing without a device.
    virtual CopiedBytes copied() const { return {}; }

    /// The values of A: Dim × Dim blocks (column-major) in the order of the plan's pattern, its lower
    /// triangle.
    virtual void assemble(std::span<double> values) = 0;
    /// Blocks of A at the present shape, until the next setShape(). Null where a device computes.
    virtual std::unique_ptr<BlockSource> blockSource() { return nullptr; }
    /// A v without the matrix; `Av` may not be `v`.
    virtual void apply(const Points<Dim>& v, Points<Dim>& Av) = 0;
    /// E(v) = E_φ + E_S, without the mass regularization.
    virtual double energy(const Points<Dim>& v) = 0;

  private:
    std::unique_ptr<StageVectors<Dim>> m_hostStages;  // where no device has them; made at the first use
};

/// Makes a back end for a plan, the rest mesh that it was made of (normalized) and a valid material; threads
/// = 0: as many as the machine has, where that pays.
template <int Dim>
using BackEndFactory = std::function<std::unique_ptr<BackEnd<Dim>>(std::shared_ptr<const AssemblyPlan<Dim>>,
                                                                   const SimplicialMesh<Dim>& rest,
                                                                   const Material<Dim>&, int threads)>;

}  // namespace wend
