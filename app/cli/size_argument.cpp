#include "app/cli/size_argument.h"

#include "app/project/domain.h"
#include "app/project/edits/scaled_project.h"
#include "app/project/file/named_files.h"
#include "core/base/error.h"

namespace wend {
namespace {

DrawnSize askedSize(const Arguments& arguments, const DrawnSize& now) {
    const std::string text = arguments.text("--size");
    if (const auto size = drawnSizeOf(text, now)) return *size;
    throw UsageError("--size: \"" + text +
                     "\" is no size that pictures may have: a WIDTH, WIDTHxHEIGHT or PERCENT%");
}

void requireADrawing(const Domain& domain, const std::string& folder) {
    if (!drawingIn(domain, folder).empty()) return;
    std::string file = domain.path;
    for (const PicturePart& part : domain.parts)
        if (file.empty()) file = part.path;
    throw InputError(pathIn(folder, file), "is no SVG drawing: --size is for these");
}

}  // namespace

void drawInSize(const Arguments& arguments, const std::string& folder, Project& project) {
    if (!arguments.has("--size")) return;
    requireADrawing(domainOf(project), folder);
    const DrawnSize now = drawnSize(domainOf(project), folder);
    Domain other = domainOf(project);
    other.size = {askedSize(arguments, now)[0], 0};  // the height follows, more exactly than from `now`
    drawAt(project, now, drawnSize(other, folder));
}

DrawnSize sizeOfDrawing(const Arguments& arguments, const std::string& path) {
    if (!arguments.has("--size")) return {};
    Domain domain;
    domain.path = path;
    requireADrawing(domain, {});
    return {askedSize(arguments, drawnSize(domain, {}))[0], 0};
}

}  // namespace wend
