#pragma once

#include <atomic>
#include <memory>
#include <variant>

#include "python/interruptible.h"
#include "wend/flow.h"

namespace wend::python {

/// wend.Flow, a flow of either dimension. While it runs, the interpreter is free; using it then from another
/// thread is an error.
class AnyFlow {
  public:
    template <int Dim>
    explicit AnyFlow(Flow<Dim> flow) : m_flow(std::make_unique<Flow<Dim>>(std::move(flow))) {}

    /// Calls f(Flow<Dim>&). Throws InvalidInput while the flow runs.
    template <typename F>
    decltype(auto) with(F&& f) const {
        if (*m_isRunning) refuse();
        return std::visit([&](const auto& flow) -> decltype(auto) { return f(*flow); }, m_flow);
    }
    /// Does the same in a thread of its own: see runInterruptibly().
    void runWith(const std::function<void(double)>& progress,
                 const std::function<void(Flow<2>*, Flow<3>*, const std::stop_token&, const Report&)>& work);

    int dimension() const { return m_flow.index() == 0 ? 2 : 3; }

  private:
    [[noreturn]] static void refuse();

    std::variant<std::unique_ptr<Flow<2>>, std::unique_ptr<Flow<3>>> m_flow;
    std::unique_ptr<bool> m_isRunning = std::make_unique<bool>(false);  // the interpreter's lock guards it
};

}  // namespace wend::python
