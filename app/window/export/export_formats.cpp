#include "app/window/export/export_formats.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <algorithm>

#include "app/engine/shape/shape.h"
#include "core/base/fed_process.h"
#include "core/mesh/mesh_formats.h"
#include "warp/film_format.h"

namespace wend {

namespace {

using Formats = QList<ExportFormat>;

const Formats kPictures{
    {"PNG", ".png"}, {"TIFF", ".tif"}, {"OpenEXR", ".exr"}, {"JPEG", ".jpg"}, {"WebP", ".webp"}};
const Formats kMaps{{"OpenEXR", ".exr"}, {"TIFF", ".tif"}};
Formats rigs() {
    return {{QCoreApplication::translate("ExportFormats", "glTF film"), QStringLiteral(".glb"), true},
            {QCoreApplication::translate("ExportFormats", "Spine skeleton"), QStringLiteral(".json"), true},
            {QCoreApplication::translate("ExportFormats", "DragonBones skeleton"),
             QStringLiteral("_ske.json"), true}};
}

/// Lists surfaces first in the plane, and formats of tetrahedra first in space.
Formats meshFormats(bool solid, bool film) {
    Formats formats, others;
    for (const MeshFormatFacts& format : meshFormatFacts()) {
        if (format.together > 1 && (film || !solid)) continue;  // several files each
        if (format.writesPointsAlone) continue;                 // of its own cases only, by wend run
        const auto& first = format.extensions.front();
        (format.holdsTetrahedra == solid ? formats : others)
            << ExportFormat{QString::fromUtf8(format.name.data(), format.name.size()),
                            QString::fromUtf8(first.data(), first.size())};
    }
    if (solid && film) formats.prepend(rigs().front());
    if (solid && !film) formats.append({QStringLiteral("glTF"), QStringLiteral(".glb")});
    return formats + others;
}

Formats pictureFilms() {
    Formats formats;
    for (const FilmFormatFacts& format : filmFormats())
        formats << ExportFormat{QString::fromUtf8(format.name.data(), format.name.size()),
                                QString::fromUtf8(format.extension.data(), format.extension.size()), true};
    return formats;
}

/// Lists the input's own format first.
void putOwnFirst(Formats& formats, const FrameExport& shape) {
    const auto solid = posed<3>(shape.frame());
    if (!solid || !solid->built->skin) return;
    const QString own = QFileInfo(QString::fromStdString(solid->built->exported().path)).suffix().toLower();
    std::ranges::stable_partition(formats,
                                  [&](const ExportFormat& one) { return one.extension == '.' + own; });
}

}  // namespace

QString missingFilmProgram(const QString& extension) {
    if (extension == QStringLiteral(".webp") || !programInPath("ffmpeg").empty()) return {};
    return QCoreApplication::translate(
        "ExportFormats",
        "This film is made by the program ffmpeg, which is not installed (Debian: sudo apt install ffmpeg). "
        "Animated WebP needs no other program.");
}

QList<ExportFormat> exportFormats(ExportKind kind, const FrameExport& shape) {
    Formats pictures = kPictures;
    if (shape.hasDrawing()) pictures << ExportFormat{QStringLiteral("SVG"), QStringLiteral(".svg")};
    if (kind == ExportKind::Picture && shape.hasParts())
        pictures << ExportFormat{QCoreApplication::translate("ExportFormats", "Layers (OpenRaster)"),
                                 QStringLiteral(".ora")}
                 << ExportFormat{QCoreApplication::translate("ExportFormats", "Layers (Photoshop)"),
                                 QStringLiteral(".psd")};
    if (kind == ExportKind::Picture) return pictures;
    if (kind == ExportKind::StMap) return kMaps;
    if (kind == ExportKind::Film) return pictureFilms();
    const bool solid = shape.dimension() == 3;
    const bool film = kind == ExportKind::Frames;
    Formats meshes = meshFormats(solid, film);
    if (kind == ExportKind::Mesh) putOwnFirst(meshes, shape);
    return film && shape.picture() ? pictures + meshes + rigs() : meshes;
}

}  // namespace wend
