#include <limits>
#include <type_traits>

#include "app/project/options/options.h"
#include "app/project/project.h"

#ifndef Q_DECLARE_TR_FUNCTIONS
#define Q_DECLARE_TR_FUNCTIONS(context)
#endif

namespace wend {
namespace {

// --- Accessors ---

/// Accesses what `At` finds in a project.
template <class At>
constexpr Accessor at(At) {
    return {[](const Project& project) { return static_cast<double>(At{}(project)); },
            [](Project& project, double value) {
                auto& found = At{}(project);
                found = static_cast<std::remove_cvref_t<decltype(found)>>(value);
            }};
}

/// Accesses what `At` finds in the material of the whole shape.
template <class At>
constexpr Accessor inMaterial(At) {
    return at([](auto& project) -> auto& { return At{}(project.design.material); });
}

#define AT(member) at([](auto& project) -> auto& { return project.member; })
#define IN_MATERIAL(member) inMaterial([](auto& material) -> auto& { return material.member; })

/// A cut-out whose holes are filled is a choice of its own in the window.
constexpr Accessor kOutline{
    [](const Project& project) {
        const Domain& domain = project.domain;
        const bool isFilled =
            domain.outline == OutlineKind::Alpha && domain.alpha.holes == OutlineHoles::Filled;
        return isFilled ? double(kFilledCutOut) : static_cast<double>(domain.outline);
    },
    [](Project& project, double value) {
        const bool isFilled = value == kFilledCutOut;
        project.domain.outline = isFilled ? OutlineKind::Alpha : static_cast<OutlineKind>(value);
        project.domain.alpha.holes = isFilled ? OutlineHoles::Filled : OutlineHoles::Kept;
    }};

/// Accesses the aimed number of vertices. Setting it clears the edge length.
constexpr Accessor kAim{[](const Project& project) { return static_cast<double>(project.domain.vertices); },
                        [](Project& project, double value) {
                            project.domain.vertices = static_cast<int>(value);
                            project.domain.edge = project.domain.maxVolume = 0;
                        }};

/// Accesses the length of smoothing, which 0 turns off.
constexpr Accessor kSmoothing{[](const Project& project) {
                                  const Smoothing& smoothing = project.design.material.smoothing;
                                  return smoothing.kind == SmoothingKind::None ? 0 : smoothing.length;
                              },
                              [](Project& project, double value) {
                                  Smoothing& smoothing = project.design.material.smoothing;
                                  smoothing.kind = value > 0 ? SmoothingKind::Invariant : SmoothingKind::None;
                                  if (value > 0) smoothing.length = value;
                              }};

// --- Which projects have them ---

template <DomainKind... Kinds>
constexpr bool hasDomain(const Project& project) {
    return ((project.domain.kind == Kinds) || ...);
}

template <SmoothingKind Kind>
bool smooths(const Project& project) {
    return project.design.material.smoothing.kind == Kind;
}

constexpr Scope kPicture{hasDomain<DomainKind::Image>, "pictures"};
constexpr Scope kFlat{hasDomain<DomainKind::Image>, "pictures and outlines"};
constexpr Scope kSurface{hasDomain<DomainKind::Surface>, "closed surfaces"};
constexpr Scope kAnySurface{hasDomain<DomainKind::Surface>, "surfaces"};
constexpr Scope kMeshed{hasDomain<DomainKind::Image, DomainKind::Surface>,
                        "pictures, outlines and closed surfaces"};
constexpr Scope kCutOut{[](const Project& project) {
                            return hasDomain<DomainKind::Image>(project) &&
                                   project.domain.outline == OutlineKind::Alpha;
                        },
                        "pictures with --outline alpha"};
constexpr Scope kSolid{[](const Project& project) { return project.dimension() == 3; }, "solids"};
constexpr Scope kInvariant{smooths<SmoothingKind::Invariant>, "smoothing of the invariant kind"};
constexpr Scope kPaper{smooths<SmoothingKind::Paper>, "smoothing as in the paper"};

// --- What they may be ---

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr Range kAny{}, kPart{0, 1}, kOrder{-1000, 1000}, kLink{1, 1e6}, kPositive{0, kInfinity, true, true},
    kNotNegative{0, kInfinity, false, true}, kVertices{3, 1e7}, kHundred{0, 100}, kQuality{1.2, 10},
    kRatio{1, 1e6}, kTolerance{1e-12, 0.1}, kSteps{0, 1e6}, kSmallestStep{0, 0.1, true, false},
    kFrames{2, 1e6}, kThreads{0, 1024}, kRepeats{1, 1000}, kHole{0, 1e6}, kFactor{0.01, 100},
    kPercent{1, 1000}, kWidth{1, 1e5}, kDetail{0.05, 1000}, kOffset{0, 10}, kOpenUnit{0, 1, true, true},
    kUnitAboveZero{0, 1, true, false};

/// Marks the texts that the window shows, for its translations; nothing here is translated.
struct Options {
    Q_DECLARE_TR_FUNCTIONS(Options)
    static constexpr const char* tr(const char* text) { return text; }
};

using enum OptionKind;
using enum InFile;
constexpr std::array kOptions{
    Option{"domain.vertices", "--vertices", Integer, "", kVertices, "", "", "mesh",
           "number of vertices to aim at", Field{kAim, &kMeshed, Makes::Mesh, ByHand},
           Row{.label = Options::tr("Det&ail, in vertices"),
               .name = Options::tr("Vertices"),
               .help = Options::tr("How fine the mesh is. More vertices bend more smoothly and take longer."),
               .undo = Options::tr("Change detail"),
               .step = 500}},
    Option{"", "--size", Text, "", kAny, "", "", "run mesh convert",
           "size at which an SVG drawing is drawn: a WIDTH, WIDTHxHEIGHT that it fits into, or PERCENT% of "
           "its size "
           "otherwise; what is in pixels is scaled with it"},
    Option{"domain.edge", "--edge", Number, "", kPositive, "pixels", "", "mesh",
           "length of the edges to aim at, instead of a number of vertices",
           Field{AT(domain.edge), &kFlat, Makes::Mesh}},
    Option{"domain.outline.from", "--outline", Choice, "", kAny, "", "frame|alpha", "mesh",
           "the whole picture, or its opaque parts", Field{kOutline, &kPicture, Makes::Outline, ByHand},
           Row{.label = Options::tr("&Outline"),
               .help = Options::tr(
                   "What bends: only what is opaque in the picture, this with what its lines enclose, "
                   "or the picture as a whole."),
               .undo = Options::tr("Change outline"),
               .words = {{Options::tr("Whole picture"), Options::tr("Cut-out"), Options::tr("Drawn polygons"),
                          Options::tr("Cut-out, holes filled")}}}},
    Option{"domain.outline.holes", "--holes", Choice, "", kAny, "", "kept|filled", "mesh",
           "holes in the opaque parts stay open, or belong to the shape, as in line art without fill",
           Field{AT(domain.alpha.holes), &kCutOut, Makes::Outline}},
    Option{"domain.outline.threshold", "--threshold", Number, "", kOpenUnit, "alpha", "", "mesh",
           "alpha from which the picture counts as opaque",
           Field{AT(domain.alpha.threshold), &kCutOut, Makes::Outline, Always},
           Row{.label = Options::tr("Opa&que from"),
               .help = Options::tr("Pixels that are more opaque than this belong to the shape."),
               .undo = Options::tr("Change what counts as solid"),
               .unit = Options::tr(" %"),
               .factor = 100}},
    Option{"domain.outline.margin", "--margin", Number, "", kHundred, "pixels", "", "mesh",
           "how far the outline is grown beyond the opaque parts",
           Field{AT(domain.alpha.margin), &kCutOut, Makes::Outline, Always},
           Row{.label = Options::tr("Ma&rgin"),
               .help = Options::tr("The outline grows by this much, so that soft edges are kept whole."),
               .undo = Options::tr("Change margin"),
               .unit = Options::tr(" px"),
               .decimals = 1}},
    Option{
        "domain.outline.gap", "--gap", Number, "", kHundred, "pixels", "", "mesh",
        "gap that growing leaves open between parts and limbs",
        Field{AT(domain.alpha.gap), &kCutOut, Makes::Outline, Always},
        Row{.label = Options::tr("&Gap"),
            .help = Options::tr(
                "How far apart growing the outline keeps parts and limbs, so that they do not become one."),
            .undo = Options::tr("Change gap"),
            .unit = Options::tr(" px"),
            .decimals = 1}},
    Option{"domain.outline.smallest", "--smallest", Number, "", kNotNegative, "pixels²", "", "mesh",
           "parts and holes of less area are dropped",
           Field{AT(domain.alpha.smallest), &kCutOut, Makes::Outline, Always},
           Row{.label = Options::tr("Drop &below"),
               .help = Options::tr("Parts and holes of fewer pixels, such as dust around a drawing, are left "
                                   "out."),
               .undo = Options::tr("Change what is left out"),
               .unit = Options::tr(" px"),
               .step = 10}},
    Option{"domain.outline.simplify", "--simplify", Number, "", kHundred, "pixels", "", "mesh",
           "how far the outline may be off after simplification",
           Field{AT(domain.alpha.simplify), &kCutOut, Makes::Outline}},
    Option{
        "domain.border", "", Choice, "", kAny, "", "free|fixed|slide", "",
        "what lies on the frame of the picture: moves with the rest, stays, or slides along the frame",
        Field{AT(domain.border), &kPicture, Makes::Motion},
        Row{.label = Options::tr("&Border"),
            .name = Options::tr("Picture's border"),
            .help = Options::tr("Holds the frame of a photograph, so that no gap opens at its edge: it stays "
                                "where it is, or its sides slide along themselves. Pins on it still move."),
            .undo = Options::tr("Hold the border"),
            .words = {{Options::tr("Moves freely"), Options::tr("Stays in place"),
                       Options::tr("Slides along itself")}}}},
    Option{"domain.quality", "--quality", Number, "", kQuality, "", "", "mesh",
           "maximum ratio of circumradius to shortest edge of a tetrahedron",
           Field{AT(domain.quality), &kSurface, Makes::Mesh, Always},
           Row{.label = Options::tr("Radius–edge rati&o"),
               .help = Options::tr("How flat the tetrahedra may be: the maximum ratio of circumradius to "
                                   "shortest edge. Smaller is rounder and takes more of them."),
               .undo = Options::tr("Change radius–edge ratio"),
               .decimals = 2,
               .step = 0.1}},
    Option{"domain.maxVolume", "--max-volume", Number, "", kPositive, "units³", "", "mesh",
           "maximum volume of a tetrahedron", Field{AT(domain.maxVolume), &kSurface, Makes::Mesh},
           Row{.label = Options::tr("Ma&ximum volume"),
               .help =
                   Options::tr("Larger tetrahedra are split; in the file's units, cubed. Half the volume "
                               "makes about twice as many. At a surface that is kept, some may stay larger."),
               .undo = Options::tr("Change maximum volume"),
               .anySize = true}},
    Option{"domain.refineSurface", "--refine-surface", Flag, "", kAny, "", "", "mesh",
           "the surface's triangles may be split where cells are to be smaller; otherwise it stays as it is",
           Field{AT(domain.refineSurface), &kSurface, Makes::Mesh},
           Row{.label = Options::tr("Refine s&urface"),
               .help = Options::tr("Allows the surface's triangles to be split where they are larger than "
                                   "the tetrahedra inside. If off, the surface is kept exactly as it is."),
               .undo = Options::tr("Refine surface")}},
    Option{
        "domain.shells", "--shells", Choice, "", kAny, "", "auto|holes|regions", "run mesh",
        "what is inside of shells of a surface that lie one in the other: holes leaves every second space "
        "hollow, regions fills all and labels the cells of each; auto is as holes and says so. Bodies that "
        "share walls are all filled and labelled",
        Field{AT(domain.shells), &kSurface, Makes::Mesh},
        Row{.label = Options::tr("Inner she&lls"),
            .help = Options::tr("What is inside of shells that lie one in the other: holes, or regions of "
                                "their own, whose cells are labelled. Bodies that share walls are all "
                                "filled and labelled."),
            .undo = Options::tr("Change inner shells"),
            .words = {{Options::tr("Holes, and say so"), Options::tr("Holes"), Options::tr("Regions")}}}},
    Option{
        "domain.repair", "--repair", Flag, "", kAny, "", "", "mesh",
        "repair the surface first: merge vertices at one place, drop triangles without area and duplicates, "
        "orient, fill small holes",
        Field{AT(domain.repair), &kSurface, Makes::Mesh, ByHand}},
    Option{"domain.repair.largestHole", "--largest-hole", Integer, "", kHole, "edges", "", "mesh",
           "the largest hole that the repair fills", Field{AT(domain.largestHole), &kSurface, Makes::Mesh},
           Row{.label = Options::tr("Fill holes up to (edges)"),
               .name = Options::tr("Largest hole"),
               .help = Options::tr("“Repair” fills holes of at most this many edges.")}},
    Option{"domain.cage", "", Flag, "", kAny, "", "", "", "true: as with --cage, false: as with --no-cage",
           Field{AT(domain.fit), &kAnySurface, Makes::Mesh, ByHand},
           Row{.label = Options::tr("F&it"),
               .help = Options::tr(
                   "What is filled: the surface itself, or a cage of even cells around it, in which it is "
                   "embedded. Automatic takes the cage where the surface cannot be filled or has far too "
                   "many vertices."),
               .undo = Options::tr("Change fit"),
               .words = {{Options::tr("Automatic"), Options::tr("Exact surface"), Options::tr("Cage")}}}},
    Option{"", "--cage", Flag, "", kAny, "", "", "mesh",
           "fill a cage of even cells around the surface, which is embedded in it, instead of the surface "
           "itself; without either option this is done where the exact surface cannot be meshed or has more "
           "than "
           "eight times the vertices aimed at",
           Field{{}, &kAnySurface}},
    Option{"", "--no-cage", Flag, "", kAny, "", "", "mesh", "the exact surface or none",
           Field{{}, &kAnySurface}},
    Option{"domain.cage.detail", "--cage-detail", Number, "", kDetail, "", "", "mesh",
           "gaps and holes narrower than the diagonal / (20 detail) are closed by the cage; without it, "
           "those as narrow as its cells",
           Field{AT(domain.cageDetail), &kAnySurface, Makes::Mesh}},
    Option{
        "domain.cage.offset", "--cage-offset", Number, "", kOffset, "widths", "", "mesh",
        "how far the cage reaches beyond the surface at least, relative to the width of gaps that it closes",
        Field{AT(domain.cageOffset), &kAnySurface, Makes::Mesh}},
    Option{"domain.sizes[].factor", "", Number, "1", kFactor, "", "", "",
           "length of edges in the region, relative to elsewhere"},
    Option{"domain.sizes[].values", "--sizes", File, "", kAny, "", "", "mesh",
           "text file with such a factor for every vertex of the surface", Field{{}, &kSurface}},
    Option{"domain.detail", "", File, "", kAny, "", "", "",
           "a surface, points or polylines embedded in the solid, which are what surface formats get"},
    Option{"material.phi", "--phi", Phi, "", kAny, "radians", "equia|metr|akvf|conf", "run",
           "what is kept: area (equia), length (metr), rigidity (akvf) or angle (conf), or a number in ]0, "
           "φ_CONF]",
           Field{IN_MATERIAL(phi), nullptr, Makes::Material, Always},
           Row{.label = Options::tr("Exact &balance"),
               .help = Options::tr(
                   "Keep as a number φ, as in the project file: 0.002 keeps area or volume, 0.464 "
                   "length, 1.571 is rigid, 2.678 keeps angles (2.498 in a solid)."),
               .undo = Options::tr("Change energy"),
               .unit = Options::tr(" rad"),
               .decimals = 3,
               .step = 0.05}},
    Option{"material.smoothing.kind", "", Choice, "", kAny, "", "invariant|paper|none", "",
           "weight of the smoothness term: independent of the mesh, as in the paper, or none",
           Field{IN_MATERIAL(smoothing.kind), nullptr, Makes::Material, Always}},
    Option{"material.smoothing.length", "", Number, "", kUnitAboveZero, "sizes", "", "",
           "length over which the invariant kind smooths, relative to the size of the shape",
           Field{kSmoothing, &kInvariant, Makes::Material, Always},
           Row{.label = Options::tr("Smoothi&ng length"),
               .help = Options::tr("How far a pin's pull spreads, as a fraction of the shape's size. Small: "
                                   "close to the pin, sharp. Large: soft and wide."),
               .undo = Options::tr("Change smoothing"),
               .zero = Options::tr("none"),
               .decimals = 4,
               .step = 0.005}},
    Option{"material.smoothing.lambda", "", Number, "", kNotNegative, "", "", "", "λ of the paper's kind",
           Field{IN_MATERIAL(smoothing.lambda), &kPaper, Makes::Material, Always}},
    Option{"material.memory", "--memory", Unbounded, "", kNotNegative, "", "elastic", "run",
           "how strongly the shape is drawn back to its rest while handles move; 0: not at all, 10: much, "
           "elastic: fully, so that it depends on where the handles are, not on their way",
           Field{IN_MATERIAL(memory), nullptr, Makes::Material},
           Row{.label = Options::tr("Springs back"),
               .help = Options::tr("Lead a pin around and back: how far does the shape come back, too? Not "
                                   "at all: where it ends depends on the path. Fully: it is as it was."),
               .undo = Options::tr("Change springing back")}},
    Option{"material.regions[].feather", "", Number, "0", kNotNegative, "units", "", "",
           "width of a region's smooth edge"},
    Option{"material.regions[].stiffness.ratio", "", Number, "1", kRatio, "", "", "",
           "how many times stiffer the region is along its axis"},
    Option{"material.regions[].pictures.phi", "", File, "", kAny, "", "", "",
           "grey picture of what is kept, over the region's box: black keeps area, white keeps angles, by "
           "the slider"},
    Option{"material.regions[].pictures.stiffness", "", File, "", kAny, "", "", "",
           "grey picture of the stiffness: black 1, white 1000 times, logarithmic"},
    Option{"material.regions[].pictures.direction", "", File, "", kAny, "", "", "",
           "grey picture of the stiff direction: black 0°, white 180° against the horizontal"},
    Option{"material.regions[].pictures.up", "", Flag, "", kAny, "", "", "",
           "the pictures' first row lies where y is largest"},
    Option{"material.regions[].hidden", "", Flag, "", kAny, "", "", "",
           "the region changes nothing, as if it were not there"},
    Option{
        "material.regions[].leaves", "", Number, "1", kPart, "", "", "",
        "less than 1: the region erases what earlier regions of its name paint there, except for that part"},
    Option{"depth[].order", "", Number, "0", kOrder, "", "", "",
           "where the shape covers itself: parts of greater order lie in front of those of less"},
    Option{"handles[].locked", "", Flag, "", kAny, "", "", "",
           "the handle is neither moved nor removed in the window"},
    Option{"handles[].hidden", "", Flag, "", kAny, "", "", "",
           "the window neither draws nor picks the handle, which still holds"},
    Option{"handles[].group", "", Text, "", kAny, "", "", "",
           "handles of one group stand under its name in the window's list"},
    Option{"handles[].link", "", Integer, "", kLink, "", "", "",
           "handles of one number move together when one of them is dragged in the window"},
    Option{"handles[].colour", "", Text, "", kAny, "", "", "",
           "the handle's colour in the window, as in #d9822b"},
    Option{"handles[].motion[].kind", "", Choice, "", kAny, "", "translate|rotate|curve|recorded|field|poses",
           "", "what the handle's points do"},
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
    Option{"time.end", "", Number, "", kPositive, "time", "", "", "time at which the deformation is complete",
           Field{AT(end), nullptr, Makes::Nothing, Always}},
    Option{"time.frameRate", "--fps", Number, "", kPositive, "1/s", "", "run",
           Options::tr("frames per second of a film; a unit of time is a second"), Field{AT(frameRate)},
           Row{.label = Options::tr("R&ate"),
               .undo = Options::tr("Change frame rate"),
               .unit = Options::tr(" fps"),
               .decimals = 2}},
    Option{"time.cycle", "", Number, "", kNotNegative, "time", "", "",
           "two times, at which the shape is the same: what a loop shows (--loop)"},
    Option{"time.markers[].at", "", Number, "", kNotNegative, "time", "", "",
           "time of a marker in the window; the motion does not depend on it"},
    Option{"time.markers[].name", "", Text, "", kAny, "", "", "", "its name"},
    Option{"time.audio", "", File, "", kAny, "", "", "",
           "a file with sound, which begins with the motion and goes into films (mp4, webm, mov)"},
    Option{"view.up", "", Choice, "", kAny, "", "x|y|z", "", "axis that points up in the view",
           Field{AT(view.up), &kSolid}, Row{.undo = Options::tr("Change up axis")}},
    Option{"settle[].time", "", Number, "", kNotNegative, "time", "", "",
           "two times between which the shape relaxes towards its rest, with the handles as they are"},
    Option{"", "--settle", Flag, "", kAny, "", "", "run",
           "let the shape settle after the end: one more unit of time in which it relaxes towards its rest"},
    Option{
        "integration.method", "--method", Choice, "", kAny, "", "dopri5|rk4|midpoint|adams", "run",
        "Dormand–Prince or Adams with error control, or classical Runge–Kutta or midpoint with equal steps",
        Field{AT(integration.method), nullptr, Makes::Motion, Always}},
    Option{"integration.tolerance", "--tolerance", Number, "", kTolerance, "sizes", "", "run",
           "error allowed in a step, relative to the size of the shape; over all steps it may add up to "
           "several times as much",
           Field{AT(integration.tolerance), nullptr, Makes::Motion, Always}},
    Option{"integration.steps", "--steps", Integer, "", kSteps, "", "", "run",
           "number of equal steps over the whole time; 0: chosen by the error",
           Field{AT(integration.steps), nullptr, Makes::Motion}},
    Option{"integration.smallestStep", "", Number, "", kSmallestStep, "time spans", "", "",
           "length of a step below which the deformation stops",
           Field{AT(integration.smallestStep), nullptr, Makes::Motion}},
    Option{"integration.solver", "--solver", Choice, "", kAny, "", "auto|direct|multigrid", "run",
           "how velocities are solved for: by factors, or by iterations with multigrid, whose memory grows "
           "with the number of vertices only; auto: by size and the machine's memory",
           Field{AT(integration.solver), nullptr, Makes::Motion}, Row{.undo = Options::tr("Change solver")}},
    Option{"", "--image", Output, "", kAny, "", "", "run",
           "write the warped picture (png, tif, exr, jpg, webp …); ora, psd, exr: every part as a layer, "
           "too"},
    Option{
        "", "--mesh", Output, "", kAny, "", "", "run",
        "write the deformed mesh ({surfaces}, glb; {volumes}); for a solid, those before the semicolon get "
        "its surface"},
    Option{"", "--velocity", Output, "", kAny, "", "", "run",
           "write the velocity field at the last time (csv, vtu)"},
    Option{"", "--points", FilePair, "", kAny, "", "", "run",
           "map the points of the file IN (csv, txt, xyz, or the vertices of a mesh) by the deformation, and "
           "write them to OUT"},
    Option{"", "--inverse", Flag, "", kAny, "", "", "run",
           "map the points of --points from the deformed shape back to the rest"},
    Option{"", "--stmap", Output, "", kAny, "", "", "run",
           "write the ST map of the warp (exr, tif); exr: that of each part, too"},
    Option{"", "--phi-picture", Output, "", kAny, "", "", "run",
           "write what is kept at rest as a grey picture: black keeps area, white keeps angles"},
    Option{"", "--stiffness-picture", Output, "", kAny, "", "", "run",
           "write how stiff the shape is as a grey picture: black 1, white 1000 times, logarithmic"},
    Option{"", "--direction-picture", Output, "", kAny, "", "", "run",
           "write the stiff direction as a grey picture: black 0°, white 180° against the horizontal"},
    Option{"", "--paint-phi", File, "", kAny, "", "", "run",
           "lay such a picture of what is kept over the material; where it is transparent nothing changes"},
    Option{"", "--paint-stiffness", File, "", kAny, "", "", "run", "the same with one of the stiffness"},
    Option{"", "--paint-direction", File, "", kAny, "", "", "run", "the same with one of the direction"},
    Option{"", "--frames", Output, "", kAny, "", "", "run",
           "write a sequence of pictures or meshes; #### stands for the frame's number. .vtu: with a .pvd "
           "beside; without #### one file holds all frames: .webp as a film, .glb as morph targets, and of "
           "pictures NAME_ske.json as a DragonBones skeleton and another .json as a Spine skeleton"},
    Option{"", "--count", Integer, "25", kFrames, "", "", "run",
           Options::tr("number of frames, evenly spaced from the start to the last time"), Field{},
           Row{.label = Options::tr("F&rames")}},
    Option{"", "--film", Output, "", kAny, "", "", "run",
           "write a film of the pictures (mp4, webm, mov, gif, png, webp), which lasts as long as the motion "
           "unless --count is given"},
    Option{
        "", "--loop", Flag, "", kAny, "", "", "run",
        Options::tr("leave the last frame out, which is the first one again: for films that repeat; if the "
                    "project has a cycle, show that"),
        Field{}, Row{.label = Options::tr("Loop: no fra&me twice")}},
    Option{"", "--shard", Text, "", kAny, "", "", "run",
           "of N parts of the frames write the I-th only (I/N), from states that are there (--from)"},
    Option{"", "--states", Output, "", kAny, "", "", "run",
           "keep the states of the deformation in this file, from which a run goes on that was stopped, and "
           "frames are made without computing the deformation again"},
    Option{"", "--from", File, "", kAny, "", "", "run",
           "go on from the states in this file instead of from the start"},
    Option{"", "--motion-of", File, "", kAny, "", "", "run",
           "move the shape as this other project moves its own: pins go by their names, lengths by the sizes "
           "of both shapes"},
    Option{"", "--fields", Choice, "all", kAny, "", "all|none", "run",
           Options::tr("whether distortion, φ, directions and velocity are written with meshes, in formats "
                       "that carry values"),
           Field{},
           Row{.label = Options::tr("&Values"),
               .words = {{Options::tr("Errors, material, velocity"), Options::tr("The shape alone")}}}},
    Option{
        "", "--encoding", Choice, "text", kAny, "", "text|binary|compressed", "run mesh convert",
        Options::tr("how numbers are stored in mesh files that offer a choice (ply, stl, msh, vtk, vtu)"),
        Field{},
        Row{.label = Options::tr("&Numbers"),
            .words = {{Options::tr("As text"), Options::tr("Binary"), Options::tr("Binary, compressed")}}}},
    Option{"", "--msh", Choice, "4.1", kAny, "", "4.1|2.2", "run mesh convert",
           Options::tr("version of .msh files"), Field{},
           Row{.label = Options::tr("&Gmsh version"), .words = {{"4.1", "2.2"}}}},
    Option{"", "--border", Flag, "", kAny, "", "", "run mesh convert",
           Options::tr("write the triangles of a solid's border as cells too, with the values of the "
                       "tetrahedra behind them; without it .vtu and .vtk hold tetrahedra only, unless "
                       "the input had such triangles"),
           Field{}, Row{.label = Options::tr("&Border triangles")}},
    Option{"", "--report", Output, "", kAny, "", "", "run", "write figures about the run (json)"},
    Option{"", "--at", Number, "", kNotNegative, "time", "", "run",
           "stop at this time instead of the project's end"},
    Option{"", "--filter", Choice, "ewa", kAny, "", "nearest|bilinear|bicubic|ewa", "run",
           Options::tr("how the picture is sampled"), Field{},
           Row{.label = Options::tr("Fil&ter"),
               .words = {{Options::tr("Nearest – hard pixels"), Options::tr("Bilinear – quick"),
                          Options::tr("Bicubic – sharp"), Options::tr("EWA – best")}}}},
    Option{"", "--canvas", OptionKind::Canvas, "picture", kAny, "", "picture|fit", "run",
           Options::tr(
               "pixels that pictures show: those of the source, as many as the shape needs, or those of a "
               "rectangle X,Y,WIDTH,HEIGHT of the source, which may reach beyond it"),
           Field{},
           Row{.label = Options::tr("&Canvas"),
               .words = {{Options::tr("As large as the picture"), Options::tr("Fit to the shape")}}}},
    Option{"", "--scale", Number, "100", kPercent, "%", "", "run",
           Options::tr("size of pictures in percent of the canvas; that of frames becomes even"), Field{},
           Row{.label = Options::tr("&Size"), .unit = Options::tr(" %"), .decimals = 1, .step = 10}},
    Option{"", "--width", Integer, "", kWidth, "pixels", "", "run",
           Options::tr("width of pictures, instead of a size in percent"), Field{},
           Row{.label = Options::tr("&Width"), .unit = Options::tr(" px")}},
    Option{
        "", "--depth", Choice, "picture", kAny, "", "picture|8|16|half|float", "run",
        Options::tr("bits per channel in pictures: as in the source, 8 or 16, or half or full floating "
                    "point; values stay what they are"),
        Field{},
        Row{.label = Options::tr("&Depth"),
            .words = {{Options::tr("As in the picture"), Options::tr("8 bit"), Options::tr("16 bit"),
                       Options::tr("16 bit floating point (half)"), Options::tr("32 bit floating point")}}}},
    Option{"", "--outside", Colour, "transparent", kAny, "", "transparent|clamp|original|white|black", "run",
           Options::tr("what pictures show around the shape: nothing, its border drawn outwards, the source "
                       "as it was, or a colour"),
           Field{},
           Row{.label = Options::tr("&Background"),
               .words = {{Options::tr("Transparent"), Options::tr("The border, drawn outwards"),
                          Options::tr("The picture as it was"), Options::tr("White"), Options::tr("Black"),
                          Options::tr("Another colour …")}}}},
    Option{"", "--webp", Choice, "lossless", kAny, "", "lossless|lossy", "run",
           Options::tr("whether WebP pictures and films keep every pixel, or are a fraction of the size with "
                       "hardly visible losses"),
           Field{},
           Row{.label = Options::tr("&Quality"),
               .words = {{Options::tr("Every pixel – lossless"), Options::tr("Smaller file – lossy")}}}},
    Option{"", "--partial", Flag, "", kAny, "", "", "run",
           "if the deformation stops early, write the last good shape anyway"},
    Option{
        "", "--strict", Flag, "", kAny, "", "", "run",
        "end with an error where there would be a notice: exit code 3 if the input or what is asked for is "
        "the reason, 4 if the deformed shape is"},
    Option{"", "--backend", Choice, "auto", kAny, "", "auto|opencl|cpu", "run",
           "what assembles the matrices"},
    Option{"", "--threads", Integer, "0", kThreads, "", "", "run", "number of threads; 0: one per core"},
    Option{"", "--output", File, "", kAny, "", "", "mesh bench",
           "the mesh, or the table as JSON, to write; also -o"},
    Option{"", "--repeats", Integer, "5", kRepeats, "", "", "bench",
           "runs of which the median is taken (fewer for what takes seconds)"},
    Option{"", "--keep", File, "", kAny, "", "", "bench",
           "an existing folder for the meshes, projects and deformed shapes of the case paper"},
    Option{"", "--problems", File, "", kAny, "", "", "info",
           "write the cells or triangles that are wrong as a mesh, with their numbers"},
    Option{"", "--json", Flag, "", kAny, "", "", "info mesh",
           "answer as JSON; for `mesh`: counts, quality asked for and reached, and what was noticed"},
    Option{"", "--man", File, "", kAny, "", "", "reference",
           "write the manual pages, wend.1 and one for each command, into this folder"},
    Option{"", "--completion", Choice, "", kAny, "", "bash|zsh|fish", "reference",
           "print what completes the command line in that shell"},
    Option{"", "--progress", Flag, "", kAny, "", "", "run mesh", "show progress even if not on a terminal"},
    Option{"", "--quiet", Flag, "", kAny, "", "", "run mesh convert", "say nothing but errors"},
};

}  // namespace

std::span<const Option> options() {
    return kOptions;
}

}  // namespace wend
