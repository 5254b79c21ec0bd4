#include "app/project/edits/drawing_size.h"

#include <algorithm>
#include <cmath>

#include "app/project/domain.h"
#include "app/project/edits/scaled_project.h"
#include "app/project/file/named_files.h"
#include "core/base/error.h"
#include "warp/drawn_picture.h"
#include "warp/svg_path.h"

namespace wend {
namespace {

/// Reads a positive number and the sign behind it.
std::optional<double> numberBefore(NumberScanner& scanner, char sign) {
    double value = 0;
    if (!scanner.number(value) || !(value > 0) || value > 1e6) return std::nullopt;
    if (sign != 0 && !scanner.skip(sign)) return std::nullopt;
    return value;
}

}  // namespace

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
