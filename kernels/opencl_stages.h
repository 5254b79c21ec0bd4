#pragma once

#include <array>

#include "core/assembly/stage_vectors.h"
#include "kernels/opencl_context.h"

namespace wend {

/// Keeps the stages of a step on an OpenCL device: every vector is copied there once, sums and norms are
/// computed there, and a sum is copied back only on request. Vectors are identified by their address: as many
/// as a step needs, and some more, stay on the device until others need the space. `cl` must outlive it.
/// Throws DeviceFailure from every call.
template <int Dim>
class OpenClStages final : public StageVectors<Dim> {
    using typename StageVectors<Dim>::Terms;

  public:
    OpenClStages(OpenClContext& cl, int vertices);

    void combine(const Nodal<Dim>& y, Terms terms) override;
    Nodal<Dim> shape() override;
    double distance(const Nodal<Dim>& other) override;
    double maximum(Terms terms) override;

    /// Returns the buffer of the stage's shape.
    const cl::Buffer& buffer() const { return m_shape; }

    static constexpr int kChunk = 256;  // vertices per work item of a norm
    int chunks() const { return (m_vertices + kChunk - 1) / kChunk; }

  private:
    struct Slot {
        Nodal<Dim> vector;  // held, so that its address is that of no other
        long used = 0;
    };
    struct Arguments {
        cl_int count = 0;
        cl_int8 slot{};
        cl_double8 weights{};
    };
    int numbers() const { return Dim * m_vertices; }
    std::size_t bytes() const { return static_cast<std::size_t>(numbers()) * sizeof(double); }
    int freeSlot(const Nodal<Dim>& vector);
    int slotOf(const Nodal<Dim>& vector);
    Arguments argumentsOf(Terms terms);
    double maxPart();

    OpenClContext& m_cl;
    int m_vertices;
    long m_uses = 0;
    std::array<Slot, StageVectors<Dim>::kMostTerms + 4> m_slots;
    Nodal<Dim> m_onHost;  // the stage's shape, once it was asked for
    cl::Kernel m_combine, m_maximum, m_farthest;
    cl::Buffer m_vectors, m_shape, m_parts;
};

}  // namespace wend
