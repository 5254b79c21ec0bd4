#include <algorithm>

#include "app/cli/commands.h"
#include "app/cli/size_argument.h"
#include "app/cli/terminal.h"
#include "app/output/output_set.h"
#include "app/output/run_options.h"
#include "app/output/shape_file.h"
#include "core/base/error.h"
#include "core/base/file_name.h"
#include "core/base/same_file.h"
#include "core/mesh/mesh_file.h"
#include "core/mesh/mesh_of_file.h"
#include "core/mesh/skin_file.h"
#include "warp/drawn_picture.h"
#include "warp/image_formats.h"

namespace wend {
namespace {

struct Conversion {
    std::string from, to;  // "-": standard output
    MeshWriteOptions options;
    Terminal& terminal;
    DrawnSize drawn{};  // of a drawing

    /// Returns the extension that decides the format of the output.
    std::string extension(const char* standard) const { return to == "-" ? standard : lowerExtension(to); }
    void tell(const std::string& what) const {
        if (!what.empty()) terminal.warn(to + ": " + what);
    }
};

bool isMesh(const std::string& path) {
    return std::ranges::count(readableMeshExtensions(), lowerExtension(path)) > 0;
}

/// Files that exist as names only for now: what is written along with the input or the output.
void requireOtherFiles(const Conversion& conversion) {
    if (conversion.to == "-") return;
    for (const std::string& read : writtenAlong(conversion.from))
        for (const std::string& written : writtenAlong(conversion.to))
            if (sameFile(read, written))
                throw UsageError(conversion.to + ": would replace " + read + ", which is read here");
}

void convertMesh(const Conversion& conversion, OutputSet& files) {
    const std::string extension = conversion.extension(".vtu");
    const bool staysObj = extension == ".obj" && lowerExtension(conversion.from) == ".obj";
    if (extension == ".glb" || staysObj) {
        const Skin skin = readSkin(conversion.from);
        for (const std::string& warning : skin.warnings)
            conversion.terminal.warn(conversion.from + ": " + warning);
        conversion.tell(lostInSkin("mesh" + extension, skin, conversion.options));
        return files.add(conversion.to, extension, [&](const std::string& file) {
            writeSkin(file, skin, skin.points, {}, conversion.options);
        });
    }
    requireShapeFormat(conversion.to, extension, 3);
    const auto mesh = sharedMeshFile(conversion.from);
    if (extension == ".stl" && conversion.options.binary()) conversion.tell(roundingText(pointsOf(*mesh)));
    conversion.tell(lostInFile("mesh" + extension, *mesh, conversion.options));
    files.add(conversion.to, extension,
              [&](const std::string& file) { writeMeshFile(file, *mesh, conversion.options); });
}

/// Names in one line the properties of a picture that its new format cannot hold.
std::string lostInPicture(const std::string& path, const Image& image) {
    std::string lost;
    const auto add = [&](const std::string& what) { lost += (lost.empty() ? "" : "; ") + what; };
    if (image.alpha && !holdsAlpha(path))
        add("the format holds no transparency: the picture is laid over white");
    if (roundsNumbers(path, image.type))
        add("the format does not hold numbers of this depth: they are rounded");
    if (losesNegativeLight(path, image)) add("the format holds no negative light: it becomes 0");
    if (losesProfile(path, image))
        add("the format holds no colour profile: the colours' numbers are kept as they are");
    return lost;
}

void convertPicture(const Conversion& conversion, OutputSet& files) {
    const std::string extension = conversion.extension(".png");
    if (!canWriteImage("picture" + extension))
        throw InputError(conversion.to, "is in no picture format that can be written");
    std::vector<Message> notices;
    const Image image = readImage(conversion.from, conversion.drawn, &notices);
    for (const Message& notice : notices) conversion.terminal.warn(notice);
    conversion.tell(lostInPicture("picture" + extension, image));
    files.add(conversion.to, extension, [&](const std::string& file) { writeImage(file, image); });
}

}  // namespace

ExitCode runConvert(const Arguments& arguments) {
    if (arguments.files().size() != 2)
        throw UsageError("two files are needed, the one to read and the one to write, not " +
                         std::to_string(arguments.files().size()));
    requireFile(arguments.files()[0]);
    Terminal terminal(Terminal::Progress::Automatic, arguments.has("--quiet"));
    Conversion conversion{arguments.files()[0], arguments.files()[1], meshOptionsFrom(arguments.values()),
                          terminal};
    Terminal::setFile(conversion.from);
    conversion.drawn = sizeOfDrawing(arguments, conversion.from);
    requireOtherFiles(conversion);
    requirePlaces({conversion.to});
    OutputSet files;
    if (isMesh(conversion.from))
        convertMesh(conversion, files);
    else if (lowerExtension(conversion.from) == ".wend")
        throw UsageError(conversion.from + ": is a project; `wend run` writes what it makes");
    else
        convertPicture(conversion, files);
    files.commit();
    return ExitCode::Done;
}

}  // namespace wend
