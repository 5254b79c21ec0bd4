#include "kernels/opencl_stages.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace wend {

template <int Dim>
OpenClStages<Dim>::OpenClStages(OpenClContext& cl, int vertices) : m_cl(cl), m_vertices(vertices) {
    const cl::Program program = m_cl.build({"stages.cl"}, "-cl-std=CL1.2 -DDIM=" + std::to_string(Dim));
    m_combine = cl::Kernel(program, "combine");
    m_maximum = cl::Kernel(program, "maximum");
    m_farthest = cl::Kernel(program, "farthest");
    const auto count = static_cast<std::size_t>(numbers());
    m_vectors = m_cl.buffer<double>(count * m_slots.size());
    m_shape = m_cl.buffer<double>(count);
    m_parts = m_cl.buffer<double>(static_cast<std::size_t>(chunks()));
}

/// Gives the vector the least recently used slot.
template <int Dim>
int OpenClStages<Dim>::freeSlot(const Nodal<Dim>& vector) {
    const auto oldest = std::min_element(m_slots.begin(), m_slots.end(),
                                         [](const Slot& a, const Slot& b) { return a.used < b.used; });
    *oldest = {vector, ++m_uses};
    return static_cast<int>(oldest - m_slots.begin());
}

/// Returns the slot of a vector on the device, to which it is copied if it is not there yet.
template <int Dim>
int OpenClStages<Dim>::slotOf(const Nodal<Dim>& vector) {
    const auto known =
        std::find_if(m_slots.begin(), m_slots.end(), [&](const Slot& slot) { return slot.vector == vector; });
    if (known != m_slots.end()) {
        known->used = ++m_uses;
        return static_cast<int>(known - m_slots.begin());
    }
    const int slot = freeSlot(vector);
    const auto count = static_cast<std::size_t>(numbers());
    try {
        m_cl.write(m_vectors, vector->data(), count, count * static_cast<std::size_t>(slot));
    } catch (...) {
        m_slots[static_cast<std::size_t>(slot)] = {};
        throw;
    }
    return slot;
}

template <int Dim>
typename OpenClStages<Dim>::Arguments OpenClStages<Dim>::argumentsOf(Terms terms) {
    Arguments arguments;
    for (const auto& [weight, field] : terms) {
        arguments.slot.s[arguments.count] = slotOf(field);
        arguments.weights.s[arguments.count++] = weight;
    }
    return arguments;
}

template <int Dim>
void OpenClStages<Dim>::combine(const Nodal<Dim>& y, Terms terms) {
    guarded([&] {
        const cl_int start = slotOf(y);
        const Arguments sum = argumentsOf(terms);
        launch(m_cl.queue(), m_combine, numbers(), sum.count, m_vectors, start, sum.slot, sum.weights,
               m_shape);
        m_onHost = terms.empty() ? y : nullptr;
    });
}

/// Copies the shape to the host. It gets a slot at once, because a later sum may name it.
template <int Dim>
Nodal<Dim> OpenClStages<Dim>::shape() {
    if (m_onHost) return m_onHost;
    guarded([&] {
        auto shape = std::make_shared<Points<Dim>>(Dim, m_vertices);
        m_cl.read(m_shape, shape->data(), static_cast<std::size_t>(numbers()));
        const auto slot = static_cast<std::size_t>(freeSlot(shape));
        m_cl.queue().enqueueCopyBuffer(m_shape, m_vectors, 0, slot * bytes(), bytes());
        m_onHost = std::move(shape);
    });
    return m_onHost;
}

template <int Dim>
double OpenClStages<Dim>::distance(const Nodal<Dim>& other) {
    return guarded([&] {
        const cl_int slot = slotOf(other);
        launch(m_cl.queue(), m_farthest, chunks(), numbers(), kChunk, m_shape, m_vectors, slot, m_parts);
        return maxPart();
    });
}

template <int Dim>
double OpenClStages<Dim>::maximum(Terms terms) {
    return guarded([&] {
        const Arguments sum = argumentsOf(terms);
        launch(m_cl.queue(), m_maximum, chunks(), numbers(), kChunk, sum.count, m_vectors, sum.slot,
               sum.weights, m_parts);
        return std::sqrt(maxPart());
    });
}

template <int Dim>
double OpenClStages<Dim>::maxPart() {
    std::vector<double> parts(static_cast<std::size_t>(chunks()));
    m_cl.read(m_parts, parts.data(), parts.size());
    double most = 0;
    for (double part : parts) {
        if (std::isnan(part)) return part;
        most = std::max(most, part);
    }
    return most;
}

template class OpenClStages<2>;
template class OpenClStages<3>;

}  // namespace wend
