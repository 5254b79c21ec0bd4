#include "app/document/options.h"

#include <array>
#include <charconv>
#include <cmath>
#include <stdexcept>

#include "core/energy/material.h"

// Marks the texts that the window shows, for its translations; nothing here is translated.
#ifndef QT_TRANSLATE_NOOP
#define QT_TRANSLATE_NOOP(context, text) text
#endif

namespace wend {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr Range kAny{};
constexpr Range kOrder{-1000, 1000};
constexpr Range kPositive{0, kInfinity, true, true};
constexpr Range kNotNegative{0, kInfinity, false, true};

constexpr Range kVertices{3, 1e7};
constexpr Range kHundred{0, 100};
constexpr Range kQuality{1.2, 10};
constexpr Range kRatio{1, 1e6};
constexpr Range kTolerance{1e-12, 0.1};
constexpr Range kSteps{0, 1e6};
constexpr Range kSmallestStep{0, 0.1, true, false};
constexpr Range kFrames{2, 1e6};
constexpr Range kThreads{0, 1024};
constexpr Range kRepeats{1, 1000};
constexpr Range kHole{0, 1e6};
constexpr Range kFactor{0.01, 100};
constexpr Range kDetail{0.05, 1000};
constexpr Range kOffset{0, 10};
constexpr Range kOpenUnit{0, 1, true, true};
constexpr Range kUnitAboveZero{0, 1, true, false};

using enum OptionKind;
constexpr std::array kOptions{
    Option{"domain.vertices", "--vertices", Integer, "5000", kVertices, "", "", "mesh",
           "number of vertices to aim at"},
    Option{"domain.edge", "--edge", Number, "", kPositive, "pixels", "", "mesh",
           "length of the edges to aim at, instead of a number of vertices"},
    Option{"domain.outline.from", "--outline", Choice, "frame", kAny, "", "frame|alpha", "mesh",
           "the whole picture, or its opaque parts"},
    Option{"domain.outline.threshold", "--threshold", Number, "0.1", kOpenUnit, "alpha", "", "mesh",
           "alpha from which the picture counts as opaque"},
    Option{"domain.outline.margin", "--margin", Number, "2", kHundred, "pixels", "", "mesh",
           "how far the outline is grown beyond the opaque parts"},
    Option{"domain.outline.gap", "--gap", Number, "2", kHundred, "pixels", "", "mesh",
           "gap that growing leaves open between parts and limbs"},
    Option{"domain.outline.smallest", "--smallest", Number, "64", kNotNegative, "pixels²", "", "mesh",
           "parts and holes of less area are dropped"},
    Option{"domain.outline.simplify", "--simplify", Number, "0.75", kHundred, "pixels", "", "mesh",
           "how far the outline may be off after simplification"},
    Option{"domain.border", "", Choice, "free", kAny, "", "free|fixed|slide", "",
           "what lies on the frame of the picture: moves with the rest, stays, or slides along the frame"},
    Option{"domain.quality", "--quality", Number, "1.414", kQuality, "", "", "mesh",
           "greatest ratio of circumradius to shortest edge of a tetrahedron"},
    Option{"domain.maxVolume", "--max-volume", Number, "", kPositive, "units³", "", "mesh",
           "greatest volume of a tetrahedron"},
    Option{"domain.refineSurface", "--refine-surface", Flag, "", kAny, "", "", "mesh",
           "the surface's triangles may be split where cells are to be smaller; otherwise it stays as it is"},
    Option{"domain.repair", "--repair", Flag, "", kAny, "", "", "mesh",
           "mend the surface first: merge vertices at one place, drop triangles without area and duplicates, "
           "orient, fill small holes"},
    Option{"domain.repair.largestHole", "--largest-hole", Integer, "30", kHole, "edges", "", "mesh",
           "the largest hole that the repair fills"},
    Option{"domain.cage", "--cage", Flag, "", kAny, "", "", "mesh",
           "fill a cage of even cells around the surface, which rides in it, instead of the surface itself; "
           "without either option this is done where the exact surface cannot be meshed or has more than "
           "eight times the vertices aimed at"},
    Option{"", "--no-cage", Flag, "", kAny, "", "", "mesh", "the exact surface or none"},
    Option{
        "domain.cage.detail", "--cage-detail", Number, "", kDetail, "", "", "mesh",
        "gaps and holes narrower than the diagonal / (20 detail) are closed by the cage; without it, those "
        "as narrow as its cells"},
    Option{"domain.cage.offset", "--cage-offset", Number, "1/15", kOffset, "widths", "", "mesh",
           "how far the cage reaches beyond the surface at least, relative to the width of gaps that it "
           "closes"},
    Option{"domain.sizes[].factor", "", Number, "1", kFactor, "", "", "",
           "length of edges in the region, relative to elsewhere"},
    Option{"domain.sizes[].values", "--sizes", File, "", kAny, "", "", "mesh",
           "text file with such a factor for every vertex of the surface"},
    Option{"domain.detail", "", File, "", kAny, "", "", "",
           "a surface that rides in the solid and is what surface formats get"},
    Option{"material.phi", "--phi", Phi, "metr", kAny, "radians", "equia|metr|akvf|conf", "run",
           "what is kept: area (equia), length (metr), rigidity (akvf) or angle (conf), or a number in ]0, "
           "φ_CONF]"},
    Option{"material.smoothing.kind", "", Choice, "invariant", kAny, "", "invariant|paper|none", "",
           "weight of the smoothness term: independent of the mesh, as in the paper, or none"},
    Option{"material.smoothing.length", "", Number, "1/75", kUnitAboveZero, "sizes", "", "",
           "length over which the invariant kind smooths, relative to the size of the shape"},
    Option{"material.smoothing.lambda", "", Number, "0.1", kNotNegative, "", "", "", "λ of the paper's kind"},
    Option{"material.memory", "--memory", Number, "0", kNotNegative, "", "", "run",
           "how strongly the shape is drawn back to its rest while handles move; 0: not at all, 10: much"},
    Option{"material.regions[].feather", "", Number, "0", kNotNegative, "units", "", "",
           "width of a region's smooth edge"},
    Option{"material.regions[].stiffness.ratio", "", Number, "1", kRatio, "", "", "",
           "how many times stiffer the region is along its axis"},
    Option{"depth[].order", "", Number, "0", kOrder, "", "", "",
           "where the shape covers itself: parts of greater order lie in front of those of less"},
    Option{"handles[].motion[].kind", "", Choice, "", kAny, "", "translate|rotate|curve|recorded", "",
           "what the handle's points do"},
    Option{"handles[].motion[].interpolation", "", Choice, "", kAny, "", "bezier|spline|polyline", "",
           "how a curve goes through its points"},
    Option{"handles[].motion[].frame", "", Choice, "none", kAny, "", "none|frenet|minimal", "",
           "how the handle's points turn along a curve: not, with its Frenet frame, or with the one that "
           "turns least"},
    Option{"handles[].motion[].twist", "", Number, "0", kAny, "radians", "", "",
           "turn about the curve, over its whole length (3D only)"},
    Option{"handles[].motion[].scale", "", Number, "1", kPositive, "", "", "",
           "size that the handle's points reach at the end of the curve"},
    Option{"handles[].motion[].ease", "", Choice, "linear", kAny, "", "linear|in|out|inOut", "",
           "how the motion starts and stops"},
    Option{"time.end", "", Number, "1", kPositive, "time", "", "",
           "time at which the deformation is complete"},
    Option{"settle[].time", "", Number, "", kNotNegative, "time", "", "",
           "two times between which the shape relaxes towards its rest, with the handles as they are"},
    Option{"", "--settle", Flag, "", kAny, "", "", "run",
           "let the shape settle after the end: one more unit of time in which it relaxes towards its rest"},
    Option{"integration.method", "--method", Choice, "adams", kAny, "", "dopri5|rk4|midpoint|adams", "run",
           "Dormand–Prince or Adams with error control, or classical Runge–Kutta or midpoint with equal "
           "steps"},
    Option{
        "integration.tolerance", "--tolerance", Number, "0.0001", kTolerance, "sizes", "", "run",
        "error allowed in a step, relative to the size of the shape; over all steps it may come to several "
        "times as much"},
    Option{"integration.steps", "--steps", Integer, "0", kSteps, "", "", "run",
           "number of equal steps over the whole time; 0: chosen by the error"},
    Option{"integration.smallestStep", "", Number, "1e-6", kSmallestStep, "time spans", "", "",
           "length of a step below which the deformation stops"},

    Option{"", "--image", File, "", kAny, "", "", "run",
           "write the warped picture (png, tif, exr, jpg, webp …)"},
    Option{"", "--mesh", File, "", kAny, "", "", "run",
           "write the deformed mesh (obj, ply, off, stl, glb; mesh, msh, vtk, vtu, node); of a solid, the "
           "first five "
           "get its surface"},
    Option{"", "--velocity", File, "", kAny, "", "", "run",
           "write the velocity field at the last time (csv, vtu)"},
    Option{"", "--stmap", File, "", kAny, "", "", "run", "write the ST map of the warp (exr, tif)"},
    Option{"", "--frames", File, "", kAny, "", "", "run",
           "write a sequence of pictures or meshes; #### stands for the frame's number. .vtu: with a .pvd "
           "beside; "
           "a .glb without #### holds all frames of a solid as an animation"},
    Option{"", "--count", Integer, "25", kFrames, "", "", "run",
           QT_TRANSLATE_NOOP("Options", "number of frames, at equal times from the start to the last time")},
    Option{"", "--fps", Number, "24", kPositive, "1/s", "", "run",
           QT_TRANSLATE_NOOP("Options", "frames per second of an animated .glb")},
    Option{
        "", "--fields", Choice, "all", kAny, "", "all|none", "run",
        QT_TRANSLATE_NOOP(
            "Options",
            "whether distortion, φ, directions and velocity go with meshes, in formats that carry values")},
    Option{
        "", "--encoding", Choice, "text", kAny, "", "text|binary|compressed", "run mesh",
        QT_TRANSLATE_NOOP(
            "Options", "how numbers stand in mesh files that know several ways (ply, stl, msh, vtk, vtu)")},
    Option{"", "--msh", Choice, "4.1", kAny, "", "4.1|2.2", "run mesh",
           QT_TRANSLATE_NOOP("Options", "version of .msh files")},
    Option{"", "--border", Flag, "", kAny, "", "", "run mesh",
           QT_TRANSLATE_NOOP("Options",
                             "write the triangles of a solid's border as cells too, with the values of the "
                             "tetrahedra behind them; without it .vtu and .vtk hold tetrahedra only, unless "
                             "the input had such triangles")},
    Option{"", "--report", File, "", kAny, "", "", "run", "write figures about the run (json)"},
    Option{"", "--at", Number, "", kNotNegative, "time", "", "run",
           "stop at this time instead of the project's end"},
    Option{"", "--filter", Choice, "ewa", kAny, "", "nearest|bilinear|bicubic|ewa", "run",
           QT_TRANSLATE_NOOP("Options", "how the picture is sampled")},
    Option{"", "--canvas", Choice, "picture", kAny, "", "picture|fit", "run",
           QT_TRANSLATE_NOOP(
               "Options", "pixels that pictures show: those of the source, or as many as the shape needs")},
    Option{"", "--depth", Choice, "picture", kAny, "", "picture|8|16|half|float", "run",
           QT_TRANSLATE_NOOP("Options",
                             "bits of a channel in pictures: as in the source, 8 or 16, or a half or full "
                             "floating-point number; values stay what they are")},
    Option{"", "--outside", Choice, "transparent", kAny, "", "transparent|clamp|original|white|black", "run",
           QT_TRANSLATE_NOOP("Options",
                             "what pictures show beside the shape: nothing, its border drawn out, the source "
                             "as it was, or a colour")},
    Option{"", "--partial", Flag, "", kAny, "", "", "run",
           "if the deformation stops early, write the last good shape all the same"},
    Option{"", "--backend", Choice, "auto", kAny, "", "auto|opencl|cpu", "run",
           "what assembles the matrices"},
    Option{"", "--threads", Integer, "0", kThreads, "", "", "run", "number of threads; 0: one per core"},
    Option{"", "--output", File, "", kAny, "", "", "mesh bench",
           "the mesh, or the table as JSON, to write; also -o"},
    Option{"", "--repeats", Integer, "5", kRepeats, "", "", "bench",
           "runs that a median is taken of (fewer for what takes seconds)"},
    Option{"", "--keep", File, "", kAny, "", "", "bench",
           "an existing folder for the meshes, projects and deformed shapes of the case paper"},
    Option{"", "--problems", File, "", kAny, "", "", "info",
           "write the cells or triangles that are wrong as a mesh, with the numbers that they have"},
    Option{"", "--json", Flag, "", kAny, "", "", "info mesh",
           "answer as JSON; of `mesh`: counts, quality asked and got, and what was noticed"},
    Option{"", "--progress", Flag, "", kAny, "", "", "run mesh", "show progress even if not on a terminal"},
    Option{"", "--quiet", Flag, "", kAny, "", "", "run mesh", "say nothing but errors"},
};

std::string end(double value) {
    if (std::isinf(value)) return value < 0 ? "−∞" : "∞";
    return shortNumber(value);
}

std::string code(std::string_view text) {
    return text.empty() ? "" : "`" + std::string(text) + "`";
}

std::string allowed(const Option& option) {
    if (option.kind == Flag || option.kind == File || option.kind == Text) return "";
    std::string text;
    for (char c : option.choices) text += c == '|' ? std::string(", ") : std::string(1, c);
    if (option.kind == Phi) text += ", or a number";
    if (option.kind == Choice || option.kind == Phi) return text;
    return std::isinf(option.range.min) ? "any" : option.range.text();
}

}  // namespace

bool Range::contains(double value) const {
    if (std::isnan(value)) return false;
    return (openMin ? value > min : value >= min) && (openMax ? value < max : value <= max);
}

std::string Range::text() const {
    const bool openLeft = openMin || std::isinf(min), openRight = openMax || std::isinf(max);
    return (openLeft ? "]" : "[") + end(min) + ", " + end(max) + (openRight ? "[" : "]");
}

std::span<const Option> options() {
    return kOptions;
}

const Option& option(std::string_view keyOrFlag) {
    for (const Option& one : kOptions)
        if (!keyOrFlag.empty() && (one.key == keyOrFlag || one.flag == keyOrFlag)) return one;
    throw std::logic_error("no such option: " + std::string(keyOrFlag));
}

double defaultOf(std::string_view keyOrFlag) {
    const std::string_view text = option(keyOrFlag).fallback;
    double value = 0;
    const char* const end = text.data() + text.size();
    const auto done = std::from_chars(text.data(), end, value);
    double divisor = 1;  // of a fraction, 1/75
    if (done.ptr != end && *done.ptr == '/') std::from_chars(done.ptr + 1, end, divisor);
    return value / divisor;
}

std::string rangeProblem(const Option& option, double value) {
    if (option.range.contains(value)) return {};
    return shortNumber(value) + " is out of range: it must be in " + option.range.text();
}

bool isChoice(const Option& option, std::string_view value) {
    std::string_view rest = option.choices;
    while (!rest.empty()) {
        const auto bar = rest.find('|');
        if (rest.substr(0, bar) == value) return true;
        rest = bar == std::string_view::npos ? std::string_view{} : rest.substr(bar + 1);
    }
    return false;
}

double phiOfName(std::string_view name, int dim) {
    if (name == "equia") return phi::kEquia;
    if (name == "metr") return phi::kMetr;
    if (name == "akvf") return phi::kAkvf;
    if (name == "conf") return phi::conformal(dim);
    return std::numeric_limits<double>::quiet_NaN();
}

std::string nameOfPhi(double phi, int dim) {
    for (const char* name : {"equia", "metr", "akvf", "conf"})
        if (phiOfName(name, dim) == phi) return name;
    return {};
}

std::string shortNumber(double value) {
    std::array<char, 64> text;
    const auto done = std::to_chars(text.data(), text.data() + text.size(), value);
    std::string result(text.data(), done.ptr);
    for (const char* sign : {"e-0", "e+0", "e+"})  // 1e-05 → 1e-5, 1e+20 → 1e20
        if (const auto at = result.find(sign); at != std::string::npos)
            result.replace(at, std::string_view(sign).size(), sign[1] == '-' ? "e-" : "e");
    return result;
}

std::string referencePage() {
    std::string page =
        "# Reference of the settings\n\n"
        "Written by `wend reference` from the program's own table; do not edit. Keys are those of a project "
        "file,\n"
        "options those of the command line. Numbers are read and written with a point, whatever the "
        "locale.\n\n"
        "| key | option | default | allowed | unit | meaning |\n| --- | --- | --- | --- | --- | --- |\n";
    for (const Option& one : kOptions) {
        std::string flag = code(one.flag);
        if (!one.commands.empty()) flag += " (" + std::string(one.commands) + ")";
        page += "| " + code(one.key) + " | " + flag + " | " + std::string(one.fallback) + " | " +
                allowed(one) + " | " + std::string(one.unit) + " | " + std::string(one.meaning) + " |\n";
    }
    return page;
}

}  // namespace wend
