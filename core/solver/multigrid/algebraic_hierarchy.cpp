#include "core/solver/multigrid/algebraic_hierarchy.h"

#include <dlfcn.h>

#include "core/mesh/child_process.h"
#include "core/mesh/error.h"

namespace wend {
namespace {

using Entry = AlgebraicHierarchy* (*)();

struct Module {
    Entry entry = nullptr;
    std::string problem;
};

Module load() {
    void* const module = dlopen(siblingProgram("wend-multigrid.so").c_str(), RTLD_LAZY | RTLD_LOCAL);
    void* const entry = module ? dlsym(module, "wendAlgebraicHierarchy") : nullptr;
    if (entry) return {reinterpret_cast<Entry>(entry), {}};
    return {nullptr, dlerror()};
}

const Module& loaded() {
    static const Module module = load();
    return module;
}

}  // namespace

std::unique_ptr<AlgebraicHierarchy> makeAlgebraicHierarchy() {
    const Module& module = loaded();
    if (!module.entry)
        throw InputError("the module of the multigrid solver is missing (PETSc): " + module.problem +
                         "; use --solver direct");
    return std::unique_ptr<AlgebraicHierarchy>(module.entry());
}

bool hasAlgebraicHierarchy() {
    return loaded().entry != nullptr;
}

}  // namespace wend
