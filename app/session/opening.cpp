#include "app/session/opening.h"

#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>
#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "app/base/program_files.h"
#include "app/base/said.h"
#include "app/engine/shape/flat_shape.h"
#include "app/engine/shape/part_pictures.h"
#include "app/project/design.h"
#include "app/project/domain.h"
#include "app/project/edits/free_name.h"
#include "app/project/edits/scaled_project.h"
#include "app/project/file/project_reader.h"
#include "app/project/file/project_writer.h"
#include "app/project/part.h"
#include "core/base/error.h"
#include "core/base/input_file.h"
#include "core/base/message.h"
#include "core/base/printable.h"
#include "core/mesh/mesh_of_file.h"
#include "core/mesh/plane_frame.h"
#include "core/mesh/segments.h"
#include "warp/convert.h"
#include "warp/drawn_picture.h"
#include "warp/image.h"
#include "warp/layer_merging.h"
#include "warp/layered_file.h"
#include "warp/outline.h"
#include "warp/picture_format.h"
#include "warp/picture_metadata.h"
#include "warp/vector_drawing.h"

namespace wend {

namespace {

bool hasOutline(const Image& picture) {
    try {
        outlineFromAlpha(picture);
        return true;
    } catch (const InputError&) {
        return false;
    }
}

/// Returns what is shown of the layers that can be read, from front to back.
std::vector<ShownLayer> layersOf(const std::string& path, const Image& picture,
                                 std::vector<Message>& notices) {
    std::vector<PictureLayer> layers =
        fromTheFront(fileMetadata(picture)->layers, pictureFormat(InputFile(path)));
    for (const PictureLayer& layer : layers)
        if (!layer.unread.empty())
            notices.push_back(path + ": the layer \"" + layer.name + "\" " + layer.unread +
                              ": it is left out");
    std::vector<ShownLayer> shown = shownLayers(layers);
    std::erase_if(shown, [](const ShownLayer& one) { return one.layer.width < 1 || one.layer.height < 1; });
    return shown;
}

/// Attaches layers without an outline to the next one below that has one; at the back they are left out.
void letSmallOnesRide(std::vector<PicturePart>& parts, const PartPictures& pictures) {
    std::string below;
    for (std::size_t i = parts.size(); i-- > 0;) {
        const Image& picture = *pictures.sheets[i].picture;
        if (!picture.alpha) parts[i].outline = PartOutline{};
        if (!picture.alpha || hasOutline(picture)) {
            below = parts[i].name;
            continue;
        }
        parts[i].outline = PartOutline{};
        parts[i].ridesOn = below;
        if (below.empty()) parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(i));
    }
}

/// Returns the layers of an OpenRaster or Photoshop file as parts, from front to back; none if fewer than two
/// layers have visible content, or if they cannot be read. Hidden layers become hidden parts. A layer that is
/// too small for an outline of its own is attached to the next one below it. `picture` is that of all layers.
/// `notices` receives the reason if a file with layers has no parts. A drawing is drawn in the size `drawn`.
std::vector<PicturePart> partsOfLayers(const std::string& path, const Image& picture, const DrawnSize& drawn,
                                       std::vector<Message>& notices) try {
    if (fileMetadata(picture)->layers.size() < 2) return {};
    std::vector<Message> ofLayers;
    const std::vector<ShownLayer> layers = layersOf(path, picture, ofLayers);
    if (layers.size() < 2) return {};
    std::vector<PicturePart> parts;
    std::vector<std::string*> names;
    parts.reserve(layers.size());
    for (const auto& [layer, name, merges] : layers) {
        PicturePart& part = parts.emplace_back();
        part.layer = layer.name;
        part.name = name;
        names.push_back(&part.name);
        part.path = path;
        part.hidden = !layer.visible;
        const auto blend = blendNamed(layer.blend);
        if (blend && *blend != BlendMode::Normal) part.blend = blend;
    }
    giveOwnNames(names);
    letSmallOnesRide(parts, loadParts(parts, {}, {}, &ofLayers, drawn));
    if (parts.size() < 2) return {};
    notices = std::move(ofLayers);  // instead of that it was flattened
    return parts;
} catch (const InputError& error) {
    notices.push_back(messageOf(error));
    return {};
}

bool hasExtension(const QString& path, const QString& patterns) {
    return patterns.split(' ').contains(QStringLiteral("*.") + QFileInfo(path).suffix().toLower());
}

std::string absolute(const QString& folder, const std::string& file) {
    return file.empty() ? file : QDir(folder).absoluteFilePath(QString::fromStdString(file)).toStdString();
}

OpenedFile openProject(const QString& path, const QMap<QString, QString>& found = {}) {
    OpenedFile file;
    LoadedProject loaded = readProject(path.toStdString());
    Project& project = *loaded.project;
    const QString folder = QFileInfo(path).absolutePath();
    if (const Message notice = fitToPicture(project, folder.toStdString()); !notice.isEmpty())
        loaded.warnings.push_back(said(notice).toStdString());
    for (std::string* own : filesOf(project)) {
        const QString name = QString::fromStdString(absolute(folder, *own));
        *own = found.value(name, name).toStdString();
    }
    for (const std::string& warning : loaded.warnings) file.warnings << QString::fromStdString(warning);
    std::vector<Message> notices;
    if (domainOf(project).kind == DomainKind::Image)
        file.picture = loadPicture(domainOf(project), folder.toStdString(), &notices);
    for (const Message& notice : notices) file.warnings << said(notice);
    file.project = std::move(loaded.project);
    file.path = path;
    return file;
}

/// Returns whether the picture is cut out and should be taken by its outline.
bool hasTransparency(const Image& image) {
    if (!image.alpha) return false;
    try {
        const Outline outline = outlineFromAlpha(image, {});
        double area = 0;
        for (const auto& loop : outline.loops) area += loopArea(loop);
        return std::abs(area) < 0.995 * image.width * image.height;
    } catch (const InputError&) {
        return false;
    }
}

/// Returns whether no pixel shows more than a trace of colour.
bool isBlank(const Image& image) {
    constexpr float kTrace = 1.5F / 255;
    if (!image.alpha) return false;
    const auto channels = static_cast<std::size_t>(image.channels);
    std::vector<float> row(static_cast<std::size_t>(image.width) * channels);
    for (int y = 0; y < image.height; ++y) {
        loadRow(image, y, row.data());
        for (std::size_t i = channels - 1; i < row.size(); i += channels)
            if (row[i] > kTrace) return false;
    }
    return true;
}

/// Returns the file of a picture that represents the project: of parts, that of the first one that has a
/// file.
std::string shownFile(const Domain& domain) {
    const auto part =
        std::ranges::find_if(domain.parts, [](const PicturePart& one) { return !one.path.empty(); });
    return part == domain.parts.end() ? domain.path : part->path;
}

/// Makes a new picture elastic, in which it differs from the project file's defaults.
void beginElastic(Project& project) {
    designOf(project).material.memory = std::numeric_limits<double>::infinity();
}

OpenedFile openPicture(const QString& path, bool evenIfBlank, const DrawnSize& drawn) {
    OpenedFile file;
    std::vector<Message> notices;
    auto picture = std::make_shared<const Image>(readImage(path.toStdString(), drawn, &notices));
    const bool isSized = isDrawing(path.toStdString());
    const DrawnSize size = isSized ? DrawnSize{picture->width, picture->height} : DrawnSize{};
    std::vector<PicturePart> parts = partsOfLayers(path.toStdString(), *picture, size, notices);
    for (const Message& notice : notices) file.warnings << said(notice);
    if (!evenIfBlank && isBlank(*picture))
        throw NothingToSee(path.toStdString(), sentence("Core", "is transparent everywhere"));
    auto project = newProject();
    Domain& domain = domainOf(*project);
    domain.kind = DomainKind::Image;
    domain.path = path.toStdString();
    domain.size = {picture->width, picture->height};
    domain.outline = hasTransparency(*picture) ? OutlineKind::Alpha : OutlineKind::Frame;
    if (!parts.empty()) {
        domain.path.clear();
        domain.size = size;
        domain.parts = std::move(parts);
        domain.outline = OutlineKind::Alpha;
    }
    beginElastic(*project);
    file.picture = std::move(picture);
    file.project = std::move(project);
    return file;
}

bool isFlat(const MeshFile& mesh) {
    return !isVolume(mesh) && planeOf(pointsOf(mesh), trianglesOf(mesh)).has_value();
}

OpenedFile openMesh(const QString& path) {
    const auto mesh = sharedMeshFile(path.toStdString());
    const bool flat = isFlat(*mesh);
    auto project = newProject();
    domainOf(*project).kind = flat || isVolume(*mesh) ? DomainKind::Mesh : DomainKind::Surface;
    domainOf(*project).path = path.toStdString();
    if (!flat) designOf(*project).dimension = 3;
    OpenedFile file;
    file.project = std::move(project);
    return file;
}

QString patternsOf(const std::vector<std::string>& extensions) {
    QStringList patterns;
    for (const std::string& extension : extensions) patterns << '*' + QString::fromStdString(extension);
    return patterns.join(' ');
}

}  // namespace

QString pictureExtensions() {
    return patternsOf(pictureFileExtensions());
}

QString meshExtensions() {
    return patternsOf(readableMeshExtensions());
}

bool mayBeOpened(const QString& path) {
    if (!QFileInfo(path).isFile()) return false;
    if (hasExtension(path, QStringLiteral("*.wend ") + meshExtensions() + ' ' + pictureExtensions()))
        return true;
    try {
        pictureFormat(InputFile(path.toStdString()));
        return true;
    } catch (const std::exception&) {
        return false;
    }
}

OpenedFile openFile(const QString& path, bool evenIfBlank, const DrawnSize& drawn) {
    const QString absolutePath = QFileInfo(path).absoluteFilePath();
    OpenedFile file;
    if (hasExtension(path, QStringLiteral("*.wend")))
        file = openProject(absolutePath);
    else if (hasExtension(path, meshExtensions()))
        file = openMesh(absolutePath);
    else
        file = openPicture(absolutePath, evenIfBlank, drawn);
    file.source = absolutePath;
    if (samplePaths().contains(absolutePath)) file.path.clear();  // samples are there to be changed and kept
    return file;
}

OpenedFile openTogether(const QStringList& paths) {
    OpenedFile file;
    auto project = newProject();
    Domain& domain = domainOf(*project);
    domain.outline = OutlineKind::Alpha;
    for (const QString& path : paths) {
        if (hasExtension(path, QStringLiteral("*.wend ") + meshExtensions()))
            throw InputError(path.toStdString(), "is no picture: only pictures are opened together");
        const QFileInfo info(path);
        PicturePart& part = domain.parts.emplace_back();
        part.path = info.absoluteFilePath().toStdString();
        std::vector<Message> notices;
        const Image picture = readImage(part.path, kMaxMegapixels, &notices);
        for (const Message& notice : notices) file.warnings << said(notice);
        if (!hasTransparency(picture)) part.outline = PartOutline{};
        const std::string name = info.completeBaseName().toStdString();
        const std::vector<std::string> taken = namesOf(domain.parts);
        part.name = std::ranges::find(taken, name) == taken.end() ? name : freeName(taken, name, 2);
    }
    beginElastic(*project);
    file.picture = loadPicture(domain, {});
    file.project = std::move(project);
    file.source = QFileInfo(paths.first()).absoluteFilePath();
    return file;
}

QStringList missingFiles(const QString& project) {
    QStringList missing;
    try {
        const auto read = readProject(project.toStdString()).project;
        const QString folder = QFileInfo(project).absolutePath();
        for (const std::string* own : filesOf(*read)) {
            const QString file = QString::fromStdString(absolute(folder, *own));
            if (!file.isEmpty() && !QFileInfo::exists(file)) missing << file;
        }
    } catch (const InputError&) {
        return {};  // reading reports the error
    }
    return missing;
}

OpenedFile openMoved(const QString& project, const QMap<QString, QString>& found) {
    const QString path = QFileInfo(project).absoluteFilePath();
    OpenedFile file = openProject(path, found);
    file.source = path;
    if (samplePaths().contains(path)) file.path.clear();
    return file;
}

OpenedFile openLost(const LostWork& work) {
    OpenedFile file = openProject(work.copy);
    file.path = work.path;
    file.source = work.source;
    file.recoveredFrom = work.copy;
    return file;
}

QStringList samplePaths() {
    QStringList pictures, solids;
    const QDir folder(sampleFolder());
    if (sampleFolder().isEmpty()) return pictures;
    for (const QFileInfo& info : folder.entryInfoList({QStringLiteral("*.wend")}, QDir::Files, QDir::Name)) {
        const QString path = info.absoluteFilePath();
        (lookOf(path).isSolid ? solids : pictures) << path;
    }
    return pictures + solids;
}

ProjectLook lookOf(const QString& project) {
    try {
        const auto read = readProject(project.toStdString()).project;
        const QFileInfo info(project);
        const QFileInfo own(info.absoluteDir(), info.completeBaseName() + QStringLiteral(".png"));
        ProjectLook look;
        look.isSolid = dimensionOf(*read) == 3;
        if (look.isSolid && own.exists())
            look.picture = own.absoluteFilePath();
        else if (domainOf(*read).kind == DomainKind::Image)
            look.picture =
                info.absoluteDir().absoluteFilePath(QString::fromStdString(shownFile(domainOf(*read))));
        return look;
    } catch (const std::exception&) {
        return {};
    }
}

QString proposedFolder(const Document& document) {
    const bool isSample =
        document.path().isEmpty() && QFileInfo(document.source()).absolutePath() == sampleFolder();
    return isSample ? QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation) : document.folder();
}

}  // namespace wend
