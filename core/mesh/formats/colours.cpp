#include "core/mesh/formats/colours.h"

#include <algorithm>
#include <cmath>

#include "core/mesh/mesh_file.h"

namespace wend::formats {
namespace {

constexpr std::array<const char*, 4> kNames = {"red", "green", "blue", "alpha"};

/// Returns the values of a field, one for each vertex or for each of the file's own cells.
const std::vector<double>& valuesOf(const MeshField& field) {
    return field.ofCells.empty() ? field.values : field.ofCells;
}

/// Returns the number that represents full brightness.
double fullOf(const MeshField& field) {
    if (field.type == Scalar::UInt8) return 255;
    if (field.type == Scalar::UInt16) return 65535;
    const auto& values = valuesOf(field);
    return std::ranges::any_of(values, [](double value) { return value > 1; }) ? 255 : 1;
}

/// Returns whether a field holds whole colours: three or four bytes.
bool isWhole(const MeshField& field) {
    return (field.components == 3 || field.components == 4) && field.type == Scalar::UInt8;
}

const MeshField* component(const MeshFile& file, bool perCell, const char* name) {
    for (const MeshField& field : file.fields)
        if (field.perCell == perCell && field.components == 1 && field.name == name) return &field;
    return nullptr;
}

double shown(double value, double full) {
    return std::isfinite(value) ? std::clamp(value / full, 0.0, 1.0) : 0;
}

std::vector<Colour> fromComponents(const MeshFile& file, bool perCell) {
    const MeshField* red = component(file, perCell, kNames[0]);
    if (!red) return {};
    std::vector<Colour> colours(valuesOf(*red).size(), Colour{0, 0, 0, 1});
    for (std::size_t k = 0; k < 4; ++k) {
        const MeshField* field = component(file, perCell, kNames[k]);
        if (!field || valuesOf(*field).size() != colours.size()) {
            if (k < 3) return {};
            continue;
        }
        const double full = fullOf(*field);
        for (std::size_t i = 0; i < colours.size(); ++i) colours[i][k] = shown(valuesOf(*field)[i], full);
    }
    return colours;
}

}  // namespace

std::vector<Colour> coloursOf(const MeshFile& file, bool perCell) {
    std::vector<Colour> colours = fromComponents(file, perCell);
    if (!colours.empty()) return colours;
    const auto whole = std::ranges::find_if(
        file.fields, [&](const MeshField& field) { return field.perCell == perCell && isWhole(field); });
    if (whole == file.fields.end()) return {};
    const auto width = static_cast<std::size_t>(whole->components);
    const auto& values = valuesOf(*whole);
    for (std::size_t i = 0; i + width <= values.size(); i += width) {
        Colour& colour = colours.emplace_back(Colour{0, 0, 0, 1});
        for (std::size_t k = 0; k < width; ++k) colour[k] = shown(values[i + k], 255);
    }
    return colours;
}

bool areBytes(const std::vector<Colour>& colours) {
    return std::ranges::all_of(colours, [](const Colour& colour) {
        return std::ranges::all_of(
            colour, [](double part) { return std::abs(255 * part - std::round(255 * part)) < 1e-3; });
    });
}

void addColours(MeshFile& file, const std::vector<Colour>& colours, bool perCell) {
    const bool opaque = std::ranges::all_of(colours, [](const Colour& colour) { return colour[3] == 1; });
    const bool bytes = areBytes(colours);
    for (std::size_t k = 0; k < (opaque ? 3 : 4); ++k) {
        MeshField field{kNames[k], perCell, 1, {}, {}, bytes ? Scalar::UInt8 : Scalar::Float32};
        for (const Colour& colour : colours)
            field.values.push_back(bytes ? std::round(255 * colour[k]) : colour[k]);
        file.fields.push_back(std::move(field));
    }
}

bool isColour(const MeshField& field, bool perCell) {
    if (field.perCell != perCell) return false;
    return isWhole(field) || (field.components == 1 && std::ranges::count(kNames, field.name) > 0);
}

double lightOf(double shown) {
    return shown <= 0.04045 ? shown / 12.92 : std::pow((shown + 0.055) / 1.055, 2.4);
}

double shownOf(double light) {
    return light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1 / 2.4) - 0.055;
}

}  // namespace wend::formats
