#include "core/energy/material.h"

#include <sstream>

#include "core/base/error.h"
#include "core/mesh/decompositions.h"

namespace wend {

double phi::conformal(int dim) {
    return std::numbers::pi - std::atan(dim / 4.0);
}

namespace {

// φ_CONF itself is allowed, also after a round trip through 16 digits of text.
constexpr double kPhiAllowance = 1e-14;

std::string number(double x) {
    std::ostringstream text;
    text.imbue(std::locale::classic());
    text.precision(10);
    text << x;
    return text.str();
}

std::string cellName(std::size_t cell) {
    return "cell " + std::to_string(cell);
}

void requireCount(const char* what, std::size_t count, int cellCount) {
    if (count != static_cast<std::size_t>(cellCount))
        throw InputError("the material has " + std::to_string(count) + " values of " + what + " for " +
                         std::to_string(cellCount) + " cells");
}

template <int Dim>
void requirePositiveDefinite(const Mat<Dim>& B, std::size_t cell) {
    if (!B.allFinite()) throw InputError(cellName(cell) + ": B has an entry that is not a finite number");
    if ((B - B.transpose()).norm() > 1e-9 * B.norm())
        throw InputError(cellName(cell) + ": B is not symmetric");
    const Vec<Dim> eigenvalues = symmetricEigenvalues<Dim>(0.5 * (B + B.transpose()));
    if (!(eigenvalues[0] > 1e-12 * eigenvalues[Dim - 1]))
        throw InputError(cellName(cell) + ": B is not positive definite (least eigenvalue " +
                         number(eigenvalues[0]) + ")");
}

void requireSmoothing(const Smoothing& smoothing) {
    if (smoothing.kind == SmoothingKind::Invariant &&
        !(std::isfinite(smoothing.length) && smoothing.length >= 0))
        throw InputError("the smoothing length " + number(smoothing.length) + " is not a number ≥ 0");
    if (smoothing.kind == SmoothingKind::Paper && !(std::isfinite(smoothing.lambda) && smoothing.lambda >= 0))
        throw InputError("the smoothing's lambda " + number(smoothing.lambda) + " is not a number ≥ 0");
}

}  // namespace

std::string phi::problem(double phi, int dim) {
    if (phi > 0 && phi <= conformal(dim) + kPhiAllowance) return {};
    return "phi = " + number(phi) + " is outside ]0, " + number(conformal(dim)) + "]; equia is " +
           number(kEquia) + ", metr " + number(kMetr) + ", akvf " + number(kAkvf) + ", conf the upper end";
}

template <int Dim>
Material<Dim> Material<Dim>::uniform(int cellCount, double phi, Smoothing smoothing) {
    return {std::vector<double>(cellCount, phi), {}, smoothing, 0};
}

/// Checks the counts first, then φ of every cell, and then that every B₀ is symmetric and positive definite.
template <int Dim>
void requireValid(const Material<Dim>& material, int cellCount) {
    requireCount("phi", material.phi.size(), cellCount);
    for (std::size_t c = 0; c < material.phi.size(); ++c)
        if (const auto problem = phi::problem(material.phi[c], Dim); !problem.empty())
            throw InputError(cellName(c) + ": " + problem);
    if (!material.anisotropy.empty()) requireCount("B", material.anisotropy.size(), cellCount);
    for (std::size_t c = 0; c < material.anisotropy.size(); ++c)
        requirePositiveDefinite<Dim>(material.anisotropy[c], c);
    requireSmoothing(material.smoothing);
    if (!(material.memory >= 0))  // infinite: elastic
        throw InputError("the memory " + number(material.memory) + " is not a number ≥ 0");
}

#define WEND_INSTANTIATE(Dim)                                              \
    template Material<Dim> Material<Dim>::uniform(int, double, Smoothing); \
    template void requireValid<Dim>(const Material<Dim>&, int);
WEND_INSTANTIATE(2)
WEND_INSTANTIATE(3)

}  // namespace wend
