#include "warp/picture_format.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "core/base/error.h"
#include "core/base/file_name.h"
#include "core/mesh/mesh_of_file.h"
#include "warp/tga_check.h"

namespace wend {
namespace {

using namespace std::string_view_literals;

/// A signature: bytes at an offset.
template <class What>
struct Mark {
    std::size_t at;
    std::string_view bytes;
    What what;
};

constexpr std::array kRead{
    Mark<PictureFormat>{0, "\x89PNG\r\n\x1a\n"sv, PictureFormat::Png},
    Mark<PictureFormat>{0, "\xff\xd8\xff"sv, PictureFormat::Jpeg},
    Mark<PictureFormat>{0, "II*\0"sv, PictureFormat::Tiff},
    Mark<PictureFormat>{0, "MM\0*"sv, PictureFormat::Tiff},
    Mark<PictureFormat>{0, "II+\0"sv, PictureFormat::Tiff},
    Mark<PictureFormat>{0, "MM\0+"sv, PictureFormat::Tiff},
    Mark<PictureFormat>{0, "\x76\x2f\x31\x01"sv, PictureFormat::Exr},
    Mark<PictureFormat>{8, "WEBP"sv, PictureFormat::Webp},
    Mark<PictureFormat>{0, "#?RADIANCE"sv, PictureFormat::Hdr},
    Mark<PictureFormat>{0, "#?RGBE"sv, PictureFormat::Hdr},
    Mark<PictureFormat>{4, "jP  \r\n"sv, PictureFormat::Jpeg2000},
    Mark<PictureFormat>{0, "\xff\x4f\xff\x51"sv, PictureFormat::Jpeg2000},
    Mark<PictureFormat>{0, "GIF8"sv, PictureFormat::Gif},
    Mark<PictureFormat>{0, "8BPS"sv, PictureFormat::Psd},
    Mark<PictureFormat>{4, "ftyphei"sv, PictureFormat::Heif},
    Mark<PictureFormat>{4, "ftyphev"sv, PictureFormat::Heif},
    Mark<PictureFormat>{4, "ftypmif1"sv, PictureFormat::Heif},
    Mark<PictureFormat>{4, "ftypmsf1"sv, PictureFormat::Heif},
    Mark<PictureFormat>{4, "ftypavi"sv, PictureFormat::Heif},
    Mark<PictureFormat>{4, "ftypcrx "sv, PictureFormat::Raw},  // of Canon, Fujifilm, Olympus, Panasonic …
    Mark<PictureFormat>{0, "FUJIFILMCCD-RAW"sv, PictureFormat::Raw},
    Mark<PictureFormat>{0, "IIRO"sv, PictureFormat::Raw},
    Mark<PictureFormat>{0, "IIRS"sv, PictureFormat::Raw},
    Mark<PictureFormat>{0, "MMOR"sv, PictureFormat::Raw},
    Mark<PictureFormat>{0, "IIU\0"sv, PictureFormat::Raw},
    Mark<PictureFormat>{0, "\0MRM"sv, PictureFormat::Raw},
    Mark<PictureFormat>{0, "FOVb"sv, PictureFormat::Raw},
    Mark<PictureFormat>{6, "HEAPCCDR"sv, PictureFormat::Raw},
    Mark<PictureFormat>{0, "DDS "sv, PictureFormat::Dds},
    Mark<PictureFormat>{0, "SDPX"sv, PictureFormat::Dpx},
    Mark<PictureFormat>{0, "XPDS"sv, PictureFormat::Dpx},
    Mark<PictureFormat>{0, "\x80\x2a\x5f\xd7"sv, PictureFormat::Cineon},
    Mark<PictureFormat>{0, "\x01\xda"sv, PictureFormat::Sgi},
    Mark<PictureFormat>{8, "CIMG"sv, PictureFormat::Iff},
    Mark<PictureFormat>{0, "\0\0\1\0"sv, PictureFormat::Ico},
    Mark<PictureFormat>{0, "SIMPLE  ="sv, PictureFormat::Fits},
    Mark<PictureFormat>{128, "DICM"sv, PictureFormat::Dicom},
    Mark<PictureFormat>{38, "image/openraster"sv, PictureFormat::OpenRaster},
    Mark<PictureFormat>{38, "application/x-krita"sv, PictureFormat::Krita},
    Mark<PictureFormat>{0, "BM"sv, PictureFormat::Bmp},
    Mark<PictureFormat>{0, "P1"sv, PictureFormat::Pnm},
    Mark<PictureFormat>{0, "P2"sv, PictureFormat::Pnm},
    Mark<PictureFormat>{0, "P3"sv, PictureFormat::Pnm},
    Mark<PictureFormat>{0, "P4"sv, PictureFormat::Pnm},
    Mark<PictureFormat>{0, "P5"sv, PictureFormat::Pnm},
    Mark<PictureFormat>{0, "P6"sv, PictureFormat::Pnm},
    Mark<PictureFormat>{0, "PF"sv, PictureFormat::Pnm},
    Mark<PictureFormat>{0, "Pf"sv, PictureFormat::Pnm},
};

/// The more exact ones first.
constexpr std::array kNotRead{
    Mark<Sentence>{4, "ftyp"sv, sentence("Core", "a film")},
    Mark<Sentence>{0, "\x1a\x45\xdf\xa3"sv, sentence("Core", "a film")},
    Mark<Sentence>{8, "AVI "sv, sentence("Core", "a film")},
    Mark<Sentence>{0, "FORM"sv, sentence("Core", "an IFF file")},
    Mark<Sentence>{0, "FOR4"sv, sentence("Core", "an IFF file")},
    Mark<Sentence>{4, "JXL \r\n"sv, sentence("Core", "a JPEG XL picture")},
    Mark<Sentence>{0, "\xff\x0a"sv, sentence("Core", "a JPEG XL picture")},
    Mark<Sentence>{0, "\xabKTX "sv, sentence("Core", "a KTX texture")},
    Mark<Sentence>{0, "%PDF"sv, sentence("Core", "a PDF document")},
    Mark<Sentence>{0, "%!PS"sv, sentence("Core", "a PostScript document")},
    Mark<Sentence>{0, "gimp xcf"sv,
                   sentence("Core", "a GIMP picture (XCF; export it from GIMP as PNG or OpenRaster)")},
    Mark<Sentence>{0, "P7"sv, sentence("Core", "a PAM picture")},
    Mark<Sentence>{0, "\0\0\2\0"sv, sentence("Core", "a Windows cursor")},
    Mark<Sentence>{0, "qoif"sv, sentence("Core", "a QOI picture")},
    Mark<Sentence>{0, "PK\3\4"sv, sentence("Core", "a ZIP archive")},
};

template <class Marks>
auto marked(const Marks& marks, std::string_view head) {
    const auto fits = [&](const auto& mark) {
        return head.size() >= mark.at && head.substr(mark.at).starts_with(mark.bytes);
    };
    return std::ranges::find_if(marks, fits);
}

/// Returns whether the file has the container of the format, because other files may contain the same name.
bool isInItsContainer(PictureFormat format, std::string_view head) {
    switch (format) {
        case PictureFormat::Webp:
            return head.starts_with("RIFF");
        case PictureFormat::Iff:
            return head.starts_with("FOR");
        case PictureFormat::Ico:  // of 1 to 255 pictures
            return head.size() > 5 && head[4] != 0 && head[5] == 0;
        case PictureFormat::OpenRaster:
        case PictureFormat::Krita:
            return head.starts_with("PK\3\4");
        default:
            return true;
    }
}

/// Returns whether the file is SVG, which may begin with a byte-order mark and comments of any length.
bool isSvg(const InputFile& file, std::string_view head) {
    constexpr std::size_t kLongestPrologue = 65536;
    if (head.starts_with("\xef\xbb\xbf")) head.remove_prefix(3);
    head.remove_prefix(std::min(head.find_first_not_of(" \t\r\n"), head.size()));
    if (head.starts_with("<svg")) return true;
    const bool isXml =
        head.starts_with("<?xml") || head.starts_with("<!--") || head.starts_with("<!DOCTYPE svg");
    return isXml && file.bytes(0, kLongestPrologue).find("<svg") != std::string::npos;
}

/// Returns whether there are no control characters but white space.
bool isText(std::string_view head) {
    return std::ranges::none_of(head, [](unsigned char c) { return c < ' ' && !(c >= '\t' && c <= '\r'); });
}

bool arePoints(std::string_view head) {
    return head.find_first_not_of("0123456789+-.,;eE \t\r\n") == std::string_view::npos &&
           head.find_first_of("0123456789") != std::string_view::npos;
}

/// Extensions of models and meshes that are not read, and what they are.
constexpr std::pair<std::string_view, std::string_view> kModels[] = {
    {".gltf", "glTF of several files"},
    {".fbx", "FBX"},
    {".dae", "COLLADA"},
    {".step", "STEP"},
    {".stp", "STEP"},
    {".iges", "IGES"},
    {".igs", "IGES"},
    {".brep", "BREP"},
    {".x_t", "Parasolid"},
    {".sldprt", "SolidWorks"},
    {".ifc", "IFC"},
    {".3dm", "Rhino"},
    {".dxf", "DXF"},
    {".dwg", "DWG"},
    {".blend", "Blender"},
    {".3ds", "3D Studio"},
    {".max", "3ds Max"},
    {".ma", "Maya"},
    {".mb", "Maya"},
    {".abc", "Alembic"},
    {".lwo", "LightWave"},
    {".x3d", "X3D"},
    {".wrl", "VRML"},
    {".usd", "USD"},
    {".usda", "USD"},
    {".usdc", "USD"},
    {".usdz", "USD"},
    {".amf", "AMF"},
    {".pvtu", "VTK's of several files"},
    {".pvtp", "VTK's of several files"},
    {".vtm", "VTK's of several files"},
    {".pvd", "VTK's of several files"},
    {".vts", "VTK's structured grid"},
    {".vtr", "VTK's rectilinear grid"},
    {".vti", "VTK's image data"},
    {".vtkhdf", "VTKHDF"},
    {".unv", "I-DEAS"},
    {".neu", "Gambit"},
    {".cas", "Fluent"},
    {".cdb", "Ansys"},
    {".op2", "Nastran's results"},
    {".k", "LS-DYNA"},
    {".vol", "Netgen"},
    {".su2", "SU2"},
    {".mphtxt", "COMSOL"},
    {".ugrid", "UGRID"},
    {".meshb", "Medit in bytes"},
    {".h5", "HDF5 without a mesh format: .med, .cgns, .exo, or .xdmf beside it"},
    {".nc", "netCDF"},
    {".face", "TetGen: open its .node"},
    {".edge", "TetGen: open its .node"},
    {".neigh", "TetGen: open its .node"},
    {".poly", "TetGen: open its .node"},
    {".smesh", "TetGen: open its .node"}};

std::string modelNamed(const std::string& path) {
    const std::string extension = lowerExtension(path);
    for (const auto& [known, what] : kModels)
        if (known == extension) return std::string(what);
    return {};
}

Sentence kindOfOther(std::string_view head) {
    if (const auto known = marked(kNotRead, head); known != kNotRead.end()) return known->what;
    if (arePoints(head)) return sentence("Core", "a list of points without a surface");
    return isText(head) ? sentence("Core", "a text file") : sentence("Core", "not a picture that Wend knows");
}

}  // namespace

PictureFormat pictureFormat(const InputFile& file) {
    if (file.size() == 0) throw InputError(file.path(), sentence("Core", "is empty"));
    const std::string head = file.bytes(0, 512);
    const auto known = marked(kRead, head);
    if (known != kRead.end() && isInItsContainer(known->what, head)) return known->what;
    if (isSvg(file, head)) return PictureFormat::Svg;
    if (isTga(head, static_cast<double>(file.size()))) return PictureFormat::Tga;
    if (const std::string model = modelNamed(file.path()); !model.empty()) {
        std::string read;
        for (const std::string& one : readableMeshExtensions()) read += (read.empty() ? "" : " ") + one;
        throw InputError(
            file.path(),
            {sentence("Core", "is a model or a mesh of a kind that is not read (%1); these are: %2"), model,
             read});
    }
    throw InputError(
        file.path(),
        {sentence(
             "Core",
             "is %1. Wend opens PNG, JPEG, TIFF, EXR, WebP, GIF, PSD, OpenRaster, Krita, SVG, HEIC, AVIF, "
             "JPEG 2000, camera raw and other pictures"),
         Message(kindOfOther(head))});
}

const std::vector<std::string>& pictureFileExtensions() {
    static const std::vector<std::string> extensions{
        ".png",  ".jpg", ".jpeg", ".tif", ".tiff", ".exr", ".webp", ".hdr", ".bmp", ".tga", ".pnm",  ".ppm",
        ".pgm",  ".pbm", ".pfm",  ".gif", ".apng", ".psd", ".psb",  ".ora", ".kra", ".svg", ".heic", ".heif",
        ".avif", ".jp2", ".j2k",  ".dds", ".dpx",  ".cin", ".sgi",  ".rgb", ".iff", ".ico", ".fits", ".dcm",
        ".dng",  ".cr2", ".cr3",  ".crw", ".nef",  ".nrw", ".arw",  ".srf", ".sr2", ".orf", ".raf",  ".rw2",
        ".pef",  ".srw", ".x3f",  ".mrw", ".3fr",  ".iiq", ".erf",  ".kdc"};
    return extensions;
}

}  // namespace wend
