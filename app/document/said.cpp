#include "app/document/said.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <algorithm>
#include <iterator>
#include <optional>
#include <vector>

#include "core/mesh/printable.h"

namespace wend {

namespace {

constexpr const char* kContext = "Core";

constexpr const char* kSentences[] = {
    // Reasons for a stop.
    QT_TRANSLATE_NOOP("Core", "at time %1 %2 cannot go on: %3"),
    QT_TRANSLATE_NOOP("Core", "at time %1 the shape snaps to another equilibrium near %2, and %3 times more"),
    QT_TRANSLATE_NOOP("Core", "at time %1 the shape snaps to another equilibrium near %2"),
    QT_TRANSLATE_NOOP("Core",
                      "at time %1 the shape is too stiff to settle further near %2: the steps would be "
                      "too short; allow a larger tolerance"),
    QT_TRANSLATE_NOOP("Core",
                      "the shape would fold over near %1, in cell %2; move it less far or along another "
                      "path, or release what holds the shape there"),
    QT_TRANSLATE_NOOP("Core",
                      "the shape would fold over near %1; move it less far or along another path, or release "
                      "what holds the shape there"),
    QT_TRANSLATE_NOOP("Core",
                      "it moves too fast near %1: the steps would be too short; give its motion more time, "
                      "or allow a larger tolerance"),
    QT_TRANSLATE_NOOP("Core",
                      "the shape near %1 is stretched or squeezed so much that no velocity can be computed; "
                      "move it less far, or make the material or the mesh more even there"),
    QT_TRANSLATE_NOOP(
        "Core",
        "it moves so fast near %1 that numbers overflow; move it less far, or give its motion more time"),
    QT_TRANSLATE_NOOP("Core", "%1 and %2 move the point %3 in different ways at time %4"),
    QT_TRANSLATE_NOOP("Core", "handle \"%1\""),
    QT_TRANSLATE_NOOP("Core", "handle %1"),
    QT_TRANSLATE_NOOP("Core", "the shape"),
    QT_TRANSLATE_NOOP("Core", "point %1 lies outside the shape"),
    // The motion of another project.
    QT_TRANSLATE_NOOP("Core", "pins of the other project without a namesake here, placed in proportion: %1"),
    QT_TRANSLATE_NOOP("Core", "pins of the other project that find no place here and are left out: %1"),
    QT_TRANSLATE_NOOP("Core", "pins without a motion in the other project, which hold still: %1"),
    // Spaces of surfaces.
    QT_TRANSLATE_NOOP("Core", "shells lie one in the other, up to %1 deep; spaces filled: %2, hollow: %3"),
    QT_TRANSLATE_NOOP(
        "Core",
        "shells lie one in the other, up to %1 deep, and bodies touch along shared walls; spaces "
        "filled: %2, hollow: %3"),
    QT_TRANSLATE_NOOP("Core", "bodies touch along shared walls; spaces filled: %1, hollow: %2"),
    QT_TRANSLATE_NOOP(
        "Core", "%1 has %2 × %3 pixels, and the project was made for %4 × %5: pins and paths are scaled"),
    QT_TRANSLATE_NOOP(
        "Core",
        "%1 has %2 × %3 pixels, and the project was made for %4 × %5: pins and paths stay where "
        "they are"),
    // Pictures and outlines.
    // Files.
    QT_TRANSLATE_NOOP("Core", "cannot be read: %1"),
    QT_TRANSLATE_NOOP("Core", "cannot be written: %1"),
    QT_TRANSLATE_NOOP("Core", "the disk may be full"),
    QT_TRANSLATE_NOOP("Core", "is read-only: make it writable first, or choose another name"),
    QT_TRANSLATE_NOOP(
        "Core",
        "is %1. Wend opens PNG, JPEG, TIFF, EXR, WebP, GIF, PSD, OpenRaster, Krita, SVG, HEIC, AVIF, "
        "JPEG 2000, camera raw and other pictures"),
    QT_TRANSLATE_NOOP("Core", "is a model or a mesh of a kind that is not read (%1); these are: %2"),
    QT_TRANSLATE_NOOP("Core", "a JPEG XL picture"),
    QT_TRANSLATE_NOOP("Core", "a GIMP picture (XCF)"),
    QT_TRANSLATE_NOOP("Core", "a PDF document"),
    QT_TRANSLATE_NOOP("Core", "a film"),
    QT_TRANSLATE_NOOP("Core", "a ZIP archive"),
    QT_TRANSLATE_NOOP("Core", "a list of points without a surface"),
    QT_TRANSLATE_NOOP("Core", "a text file"),
    QT_TRANSLATE_NOOP("Core", "not a picture that Wend knows"),
    QT_TRANSLATE_NOOP("Core", "cannot be read as a picture: %1"),
    QT_TRANSLATE_NOOP("Core", "has no pixels"),
    QT_TRANSLATE_NOOP("Core", "is a volume, not a picture"),
    QT_TRANSLATE_NOOP("Core", "has %1 x %2 pixels, more than %3 million"),
    QT_TRANSLATE_NOOP("Core", "is truncated or corrupt"),
    QT_TRANSLATE_NOOP("Core", "has %1 layers: opened flattened"),
    // Drawings.
    QT_TRANSLATE_NOOP("Core", "the part \"%1\" is no SVG drawing: it becomes a picture in the SVG file"),
    QT_TRANSLATE_NOOP("Core", "the part \"%1\" is cut: it becomes a picture in the SVG file"),
    QT_TRANSLATE_NOOP("Core", "its pattern \"%1\" turns and stretches with each shape, but is not bent"),
    QT_TRANSLATE_NOOP("Core", "a picture in it stays one"),
    QT_TRANSLATE_NOOP("Core", "its picture \"%1\" is not in the file: it is left out"),
    QT_TRANSLATE_NOOP("Core", "its text along a path is left out"),
    QT_TRANSLATE_NOOP("Core", "its <%1> is left out"),
    QT_TRANSLATE_NOOP("Core", "holds no picture of all its layers (%1): save it with one"),
    QT_TRANSLATE_NOOP("Core", "has a damaged %1"),
    QT_TRANSLATE_NOOP("Core", "has %1 pictures (pages, frames or parts): the first one is read"),
    QT_TRANSLATE_NOOP("Core", "has channels that are left out: %1"),
    QT_TRANSLATE_NOOP("Core", "has a channel of no declared kind after its colours: it is taken as alpha"),
    QT_TRANSLATE_NOOP("Core",
                      "reaches beyond its display window of %1 x %2 pixels: what lies outside is cut off"),
    QT_TRANSLATE_NOOP("Core", "has a colour profile that does not fit its colours: it is left out"),
    QT_TRANSLATE_NOOP("Core", "has a colour space that is not known (cICP %1): it is not kept"),
    QT_TRANSLATE_NOOP("Core", "1 pixel is not a finite number (NaN or infinity), at x %1, y %2"),
    QT_TRANSLATE_NOOP("Core", "%1 pixels are not finite numbers (NaN or infinity), the first at x %2, y %3"),
    QT_TRANSLATE_NOOP("Core",
                      "%1: its points have four coordinates; only points in space, which have three, are "
                      "read"),
    // Surfaces and volume meshes.
    QT_TRANSLATE_NOOP("Core", "the surface bounds no volume: %1"),
    QT_TRANSLATE_NOOP("Core", "the surface intersects itself"),
    QT_TRANSLATE_NOOP("Core", "the surface has features too small for its size"),
    QT_TRANSLATE_NOOP("Core", "two facets of the surface lie almost on each other"),
    QT_TRANSLATE_NOOP("Core", "the volume mesher ran out of memory"),
    QT_TRANSLATE_NOOP("Core",
                      "the volume mesher did not finish within %1 s of computing; a coarser quality or a "
                      "larger maxVolume may help"),
    QT_TRANSLATE_NOOP(
        "Core",
        "the cage mesher did not finish within %1 s of computing; fewer vertices or larger cells "
        "may help"),
    QT_TRANSLATE_NOOP("Core",
                      "there is no memory for a cage of so many cells; fewer vertices or larger cells may "
                      "help"),
    QT_TRANSLATE_NOOP("Core", "all points lie in one plane"),
    QT_TRANSLATE_NOOP("Core", "%1 open edge (first: %2)"),
    QT_TRANSLATE_NOOP("Core", "%1 open edges (first: %2)"),
    QT_TRANSLATE_NOOP("Core", "%1 edge of more than two triangles (first: %2)"),
    QT_TRANSLATE_NOOP("Core", "%1 edges of more than two triangles (first: %2)"),
    QT_TRANSLATE_NOOP("Core", "%1 pair of triangles that intersect (first: %2)"),
    QT_TRANSLATE_NOOP("Core", "%1 pairs of triangles that intersect (first: %2)"),
    QT_TRANSLATE_NOOP("Core",
                      "bodies %1 and %2 touch along a face whose triangles do not match (near %3): give both "
                      "the same triangles there or leave a gap"),
    QT_TRANSLATE_NOOP("Core",
                      "bodies %1 and %2 touch along an edge or at a point (near %3): give both the same "
                      "triangles there or leave a gap"),
    QT_TRANSLATE_NOOP("Core", "%1 triangle without area (first: %2)"),
    QT_TRANSLATE_NOOP("Core", "%1 triangles without area (first: %2)"),
    QT_TRANSLATE_NOOP("Core", "%1 duplicate triangle (first: %2)"),
    QT_TRANSLATE_NOOP("Core", "%1 duplicate triangles (first: %2)"),
    QT_TRANSLATE_NOOP("Core", "%1 edge where the orientation changes (first: %2)"),
    QT_TRANSLATE_NOOP("Core", "%1 edges where the orientation changes (first: %2)"),
    QT_TRANSLATE_NOOP("Core", "the surface was repaired: %1"),
    QT_TRANSLATE_NOOP("Core", "%1 single step"),
    QT_TRANSLATE_NOOP("Core", "%1 single steps"),
    QT_TRANSLATE_NOOP("Core", "%1 coincident vertex merged"),
    QT_TRANSLATE_NOOP("Core", "%1 coincident vertices merged"),
    QT_TRANSLATE_NOOP("Core", "%1 triangle without area dropped"),
    QT_TRANSLATE_NOOP("Core", "%1 triangles without area dropped"),
    QT_TRANSLATE_NOOP("Core", "%1 duplicate triangle dropped"),
    QT_TRANSLATE_NOOP("Core", "%1 duplicate triangles dropped"),
    QT_TRANSLATE_NOOP("Core", "%1 triangle turned over"),
    QT_TRANSLATE_NOOP("Core", "%1 triangles turned over"),
    QT_TRANSLATE_NOOP("Core", "%1 hole filled"),
    QT_TRANSLATE_NOOP("Core", "%1 holes filled"),
    QT_TRANSLATE_NOOP("Core", "the surface is embedded in a cage of %1 vertices, since %2"),
    QT_TRANSLATE_NOOP("Core", "it cannot be meshed as it is: %1"),
    QT_TRANSLATE_NOOP("Core", "it has %1 vertices, where %2 were aimed at"),
    QT_TRANSLATE_NOOP("Core",
                      "the cage has %1 vertices, where %2 were aimed at: whole cubes allow nothing nearer"),
    QT_TRANSLATE_NOOP("Core",
                      "the cells of the cage are larger than asked for: there is no memory for smaller "
                      "ones"),
    QT_TRANSLATE_NOOP("Core", "sizes are for the exact surface: a cage has cells of one size"),
    QT_TRANSLATE_NOOP("Core",
                      "its %1 parts share cells of the cage and move together as %2: smaller cells keep "
                      "more of them apart"),
    QT_TRANSLATE_NOOP(
        "Core",
        "the cage consists of %1 bodies that are not connected: each needs a handle of its own to follow"),
    QT_TRANSLATE_NOOP("Core",
                      "the cage closes a gap within one part, %1 wide near %2: what lies on both sides moves "
                      "together"),
    QT_TRANSLATE_NOOP("Core",
                      "the cage closes %1 gaps within one part, the narrowest %2 wide near %3: what lies on "
                      "both sides moves together"),
    QT_TRANSLATE_NOOP("Core", "%1; about %2 vertices open the widest"),
    QT_TRANSLATE_NOOP("Core", "%1; cells of at most %2 open the widest"),
    QT_TRANSLATE_NOOP("Core", "%1; a detail of %2 opens the widest"),
    QT_TRANSLATE_NOOP("Core", "%1; a detail of %2 and about %3 vertices open the widest"),
    QT_TRANSLATE_NOOP("Core", "%1; a detail of %2 and cells of at most %3 open the widest"),
    QT_TRANSLATE_NOOP("Core", "%1 of %2 vertices lie outside the solid that carries them"),
    QT_TRANSLATE_NOOP("Core",
                      "the mesh has %1 vertices, where %2 were aimed at: the quality asked for needs them"),
    QT_TRANSLATE_NOOP("Core",
                      "the mesh has %1 vertices, where %2 were aimed at: the surface is kept as it is"),
    QT_TRANSLATE_NOOP("Core", "the mesh has %1 vertices, where %2 were aimed at: its outline needs them"),
    QT_TRANSLATE_NOOP("Core",
                      "the surface's triangles are far larger than the cells inside and are kept as they "
                      "are, which makes uneven cells"),
    QT_TRANSLATE_NOOP("Core",
                      "the worst cell has a ratio of radius to edge of %1, where %2 was asked for (%3 cell "
                      "is above it)"),
    QT_TRANSLATE_NOOP("Core",
                      "the worst cell has a ratio of radius to edge of %1, where %2 was asked for (%3 cells "
                      "are above it)"),
    QT_TRANSLATE_NOOP("Core", "%1: the surface is kept as it is and forces it, at its triangles %2"),
    QT_TRANSLATE_NOOP("Core",
                      "1 vertex of the surface belongs to no tetrahedron: meshes of tetrahedra are written "
                      "without it, so that later vertices have other numbers"),
    QT_TRANSLATE_NOOP("Core",
                      "1 vertex belongs to no cell. It stays in what is written: some solvers want it taken "
                      "out first"),
    QT_TRANSLATE_NOOP("Core",
                      "%1 vertices of the surface belong to no tetrahedron: meshes of tetrahedra are written "
                      "without them, so that later vertices have other numbers"),
    QT_TRANSLATE_NOOP("Core",
                      "%1 vertices belong to no cell. They stay in what is written: some solvers want them "
                      "taken out first"),
    QT_TRANSLATE_NOOP(
        "Core",
        "parts that touch vertex to vertex are connected: %1 vertices move with others at the same place"),
    QT_TRANSLATE_NOOP("Core",
                      "a part of %1 hangs only on %2 near %3: what turns freely there may be flung far away "
                      "unless handles hold it"),
    QT_TRANSLATE_NOOP("Core",
                      "%1 parts hang only on a vertex or an edge, the first, of %2, on %3 near %4: what "
                      "turns freely there may be flung far away unless handles hold it"),
    QT_TRANSLATE_NOOP("Core", "%1 cells"),
    QT_TRANSLATE_NOOP("Core", "%1 cell"),
    QT_TRANSLATE_NOOP("Core", "vertex %1"),
    QT_TRANSLATE_NOOP("Core", "the edge %1"),
};

/// A sentence and its pattern; longer sentences are tried first.
struct Pattern {
    const char* sentence;
    QRegularExpression expression;
    int letters;
};

Pattern patternOf(const char* sentence) {
    static const QRegularExpression place(QStringLiteral("%[1-9]"));
    const QString text = QString::fromUtf8(sentence);
    QString own = text;
    own.remove(place);
    // Arguments of short sentences, such as "%1 cells", are a single word: a number or a name.
    const QString argument = own.size() < 8 ? QStringLiteral("(\\S+)") : QStringLiteral("(.+?)");
    QString expression = QRegularExpression::escape(text);
    expression.replace(QRegularExpression(QStringLiteral("\\\\%[1-9]")), argument);
    return {sentence, QRegularExpression(QRegularExpression::anchoredPattern(expression)),
            static_cast<int>(own.size())};
}

const std::vector<Pattern>& patterns() {
    static const std::vector<Pattern> all = [] {
        std::vector<Pattern> made;
        std::ranges::transform(kSentences, std::back_inserter(made), patternOf);
        std::ranges::stable_sort(made, std::ranges::greater(), &Pattern::letters);
        return made;
    }();
    return all;
}

std::optional<QString> translated(const QString& text);

QString translatedOrNot(const QString& text) {
    return translated(text).value_or(text);
}

/// Returns the translation of a text without arguments, or the text.
QString exactly(const std::string& text) {
    return text.empty() ? QString() : QCoreApplication::translate(kContext, text.c_str());
}

/// Replaces %1, %2 … in the sentence by what was found.
QString filled(const QString& sentence, const QRegularExpressionMatch& match) {
    QString result;
    for (qsizetype i = 0; i < sentence.size(); ++i) {
        const int number = sentence[i] == '%' && i + 1 < sentence.size() ? sentence[i + 1].digitValue() : 0;
        if (number < 1) {
            result += sentence[i];
            continue;
        }
        result += translatedOrNot(match.captured(number));
        ++i;
    }
    return result;
}

std::optional<QString> asSentence(const QString& text) {
    if (QString known = exactly(text.toStdString()); known != text) return known;
    for (const Pattern& pattern : patterns()) {
        const auto match = pattern.expression.match(text);
        if (!match.hasMatch()) continue;
        return filled(QCoreApplication::translate(kContext, pattern.sentence), match);
    }
    return {};
}

/// Several sentences of one kind, all of them known.
std::optional<QString> asList(const QString& text) {
    QStringList parts = text.split(QStringLiteral(", "));
    if (parts.size() < 2) return {};
    for (QString& part : parts) {
        const auto known = asSentence(part);
        if (!known) return {};
        part = *known;
    }
    return parts.join(QStringLiteral(", "));
}

/// Translates a known sentence after its subject, such as a file.
std::optional<QString> afterItsSubject(const QString& text) {
    static const QString colon = QStringLiteral(": ");
    for (qsizetype at = text.indexOf(colon); at >= 0; at = text.indexOf(colon, at + 1))
        if (const auto known = asSentence(text.mid(at + 2)))
            return asSentence(text.left(at)).value_or(text.left(at)) + colon + *known;
    return {};
}

std::optional<QString> translated(const QString& text) {
    if (auto list = asList(text)) return list;
    if (auto sentence = asSentence(text)) return sentence;
    return afterItsSubject(text);
}

}  // namespace

QString said(const Message& message) {
    if (message.sentence().empty()) return translatedOrNot(QString::fromStdString(message.text()));
    std::vector<std::string> arguments;
    for (const Message& argument : message.arguments()) arguments.push_back(said(argument).toStdString());
    return QString::fromStdString(filled(exactly(message.sentence()).toStdString(), arguments));
}

QString said(const std::exception& error) {
    return said(messageOf(error));
}

}  // namespace wend
