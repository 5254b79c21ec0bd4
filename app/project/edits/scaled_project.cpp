#include "app/project/edits/scaled_project.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "app/project/domain.h"
#include "app/project/edits/carried_motion.h"
#include "app/project/file/named_files.h"
#include "app/project/project.h"
#include "core/base/error.h"
#include "warp/drawn_picture.h"
#include "warp/svg_path.h"

namespace wend {

namespace {

void scale(Outline& outline, double factor) {
    for (auto& loop : outline.loops)
        for (Vec2& p : loop) p *= factor;
}

void scale(AlphaOutlineOptions& options, double factor) {
    constexpr double kMostPixels = 100;  // of the range of these options
    for (double* length : {&options.margin, &options.gap, &options.simplify})
        *length = std::min(*length * factor, std::max(*length, kMostPixels));
    options.smallest *= factor * factor;
}

void scale(PicturePart& part, double factor) {
    scale(part.cut, factor);
    part.feather *= factor;
    if (part.outline) scale(part.outline->alpha, factor), scale(part.outline->polygons, factor);
    if (part.at) *part.at *= factor;
    for (Joint& joint : part.joints) joint.at *= factor, joint.radius *= factor;
}

void scale(Pin& handle, const Carrying& scaling) {
    if (auto* points = std::get_if<std::vector<Vec3>>(&handle.at))
        for (Vec3& p : *points) p = scaling(p);
    if (auto* region = std::get_if<Region<3>>(&handle.at)) *region = carried(*region, scaling);
    for (PinMotion& motion : handle.motions) motion = carried(motion, scaling);
}

/// Reads a positive number and the sign behind it.
std::optional<double> numberBefore(NumberScanner& scanner, char sign) {
    double value = 0;
    if (!scanner.number(value) || !(value > 0) || value > 1e6) return std::nullopt;
    if (sign != 0 && !scanner.skip(sign)) return std::nullopt;
    return value;
}

}  // namespace

void scalePixels(Project& project, double factor) {
    if (factor == 1 || project.dimension() != 2) return;
    const Carrying scaling{Vec3::Zero(), Vec3::Zero(), factor};
    Domain& domain = project.domain;
    domain.edge *= factor;
    scale(domain.alpha, factor);
    scale(domain.polygons, factor);
    for (PicturePart& part : domain.parts) scale(part, factor);
    auto& design = designOf(project);
    const auto scaleAll = [&](auto& layers) {
        for (SoftRegion& region : regionsOf(layers))
            region.shape = carried(region.shape, scaling), region.feather *= factor;
    };
    scaleAll(domain.sizes);
    scaleAll(project.depth);
    scaleAll(design.material.layers);
    for (Pin& handle : design.handles) scale(handle, scaling);
}

double factorBetween(const std::array<int, 2>& from, const std::array<int, 2>& to) {
    if (from[0] <= 0 || from[1] <= 0 || to[0] <= 0 || to[1] <= 0) return 0;
    const double factor = static_cast<double>(to[0]) / from[0];
    const double pixel = std::max(1.0, factor);  // of the smaller picture, by which sizes are rounded
    return std::abs(from[1] * factor - to[1]) <= pixel ? factor : 0;
}

Message fitToPicture(Project& project, const std::string& folder) {
    Domain& domain = project.domain;
    if (domain.kind != DomainKind::Image || domain.size[0] == 0 || domain.path.empty()) return {};
    std::array<int, 2> now{};
    try {
        const Image header = readImageHeader(pathIn(folder, domain.path), domain.size);
        now = {header.width, header.height};
    } catch (const InputError&) {
        return {};
    }
    if (now == domain.size) return {};
    const double factor = factorBetween(domain.size, now);
    const std::string name = std::filesystem::path(domain.path).filename().string();
    const auto notice = [name, now, made = domain.size](const Sentence& what) {
        return Message(what, name, now[0], now[1], made[0], made[1]);
    };
    if (factor == 0)
        return notice(
            sentence("Core",
                     "%1 has %2 × %3 pixels, and the project was made for %4 × %5: pins and paths stay "
                     "where they are"));
    scalePixels(project, factor);
    domain.size = now;
    return notice(sentence(
        "Core", "%1 has %2 × %3 pixels, and the project was made for %4 × %5: pins and paths are scaled"));
}

std::string drawingIn(const Domain& domain, const std::string& folder) {
    std::vector<std::string> files{domain.kind == DomainKind::Mesh ? domain.texture : domain.path};
    for (const PicturePart& part : domain.parts) files.push_back(part.path);
    for (const std::string& file : files)
        if (!file.empty() && isDrawing(pathIn(folder, file))) return pathIn(folder, file);
    return {};
}

std::optional<DrawnSize> drawnSizeOf(const std::string& text, const DrawnSize& now) {
    double factor = 0;
    const auto isAll = [](NumberScanner& scanner, const std::optional<double>& value) {
        return value && scanner.atEnd();
    };
    NumberScanner percent(text), width(text), box(text);
    if (const auto value = numberBefore(percent, '%'); isAll(percent, value)) {
        factor = *value / 100;
    } else if (const auto wide = numberBefore(width, 0); isAll(width, wide)) {
        factor = *wide / now[0];
    } else {
        const auto most = numberBefore(box, 'x');
        const auto high = most ? numberBefore(box, 0) : std::nullopt;
        if (!isAll(box, high)) return std::nullopt;
        factor = std::min(*most / now[0], *high / now[1]);
    }
    const auto scaled = [&](int side) { return std::max(1, static_cast<int>(std::lround(side * factor))); };
    const DrawnSize size{scaled(now[0]), scaled(now[1])};
    if (1e-6 * size[0] * size[1] > kMaxMegapixels) return std::nullopt;
    return size;
}

DrawnSize drawnSize(const Domain& domain, const std::string& folder) {
    const Image header = readImageHeader(drawingIn(domain, folder), domain.size);
    return {header.width, header.height};
}

void drawAt(Project& project, const DrawnSize& before, const DrawnSize& now) {
    scalePixels(project, static_cast<double>(now[0]) / before[0]);
    domainOf(project).size = now;
}

}  // namespace wend
