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

/// Says where the matrix is computed. Automatic takes an OpenCL device if there is one, else the CPU.
enum class BackEndKind { Automatic, OpenCl, Cpu };

/// Counts the bytes copied to and from a device.
struct CopiedBytes {
    std::size_t toDevice = 0, fromDevice = 0;
};

/// Computes the part of the method that a device can do: everything between a shape and the values of a fixed
/// sparse pattern. A is the matrix of the energy, E(v) = vᵀ A v with E = E_φ + E_S (docs/method.md, (13)),
/// plus εM if a mass regularization is set; M is the consistent mass matrix, vᵀ M v = ∫|v|². All lengths are
/// in the frame where the rest shape has size 1. The results have the same bits for any number of threads.
/// One thread uses a back end at a time.
template <int Dim>
class BackEnd {
  public:
    virtual ~BackEnd() = default;

    /// Return "cpu" or "opencl", and the name of the device.
    virtual std::string name() const = 0;
    virtual std::string device() const = 0;

    /// Sets ε of every cell (one each, or none if empty) from the next setShape() on.
    virtual void setMassRegularization(std::vector<double> epsilon) = 0;
    /// Computes gradients, measures, stress matrices and facet weights at a shape (Dim × n). Returns −1, or
    /// the first cell that is not oriented as at rest (inverted, flat or not finite); the other functions may
    /// then not be called.
    virtual int setShape(const Points<Dim>& shape) = 0;

    /// Returns the shapes of an integrator's stages, kept where this back end computes. It is the same object
    /// for the whole life of the back end.
    virtual StageVectors<Dim>& stages() {
        if (!m_hostStages) m_hostStages = makeHostStages<Dim>();
        return *m_hostStages;
    }
    /// Calls setShape() with the shape of stages().
    virtual int setStage() { return setShape(*stages().shape()); }
    /// Returns the threads that share the loops of this back end; the factorization uses them as well.
    virtual WorkerPool& workers() = 0;
    /// Returns all bytes copied so far, including plan and material; zero without a device.
    virtual CopiedBytes copied() const { return {}; }

    /// Computes the values of A: Dim × Dim blocks (column-major) of the lower triangle, in the order of the
    /// plan's pattern.
    virtual void assemble(std::span<double> values) = 0;
    /// Returns a source of blocks of A at the current shape, valid until the next setShape(); null if a
    /// device computes.
    virtual std::unique_ptr<BlockSource> blockSource() { return nullptr; }
    /// Computes Av = A v without the matrix, both Dim × n; `Av` must not be `v`. It includes the mass
    /// regularization, as assemble() does, takes time linear in the cells, and needs no list of
    /// contributions.
    virtual void apply(const Points<Dim>& v, Points<Dim>& Av) = 0;
    /// Returns E(v) = E_φ + E_S, without the mass regularization. It is ½ of ⟨v, ∇E(v)⟩ and scales with the
    /// square of v.
    virtual double energy(const Points<Dim>& v) = 0;

  private:
    std::unique_ptr<StageVectors<Dim>> m_hostStages;  // used if no device has them; made at first use
};

/// Makes a back end for a plan, the normalized rest mesh that it was made of, and a valid material. With
/// threads = 0 it uses as many as the machine has, where that pays.
template <int Dim>
using BackEndFactory = std::function<std::unique_ptr<BackEnd<Dim>>(std::shared_ptr<const AssemblyPlan<Dim>>,
                                                                   const SimplicialMesh<Dim>& rest,
                                                                   const Material<Dim>&, int threads)>;

}  // namespace wend
