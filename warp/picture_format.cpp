#include "warp/picture_format.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "core/mesh/error.h"
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
    Mark<const char*>{0, "GIF8"sv, "a GIF picture"},
    Mark<const char*>{0, "8BPS"sv, "a Photoshop file"},
    Mark<const char*>{4, "ftyphei"sv, "a HEIC picture"},
    Mark<const char*>{4, "ftyphev"sv, "a HEIC picture"},
    Mark<const char*>{4, "ftypmif1"sv, "a HEIC picture"},
    Mark<const char*>{4, "ftypmsf1"sv, "a HEIC picture"},
    Mark<const char*>{4, "ftypavi"sv, "an AVIF picture"},
    Mark<const char*>{4, "ftyp"sv, "a film"},
    Mark<const char*>{0, "\x1a\x45\xdf\xa3"sv, "a film"},
    Mark<const char*>{8, "AVI "sv, "a film"},
    Mark<const char*>{0, "FORM"sv, "an IFF file"},
    Mark<const char*>{0, "FOR4"sv, "an IFF file"},
    Mark<const char*>{4, "jP  \r\n"sv, "a JPEG 2000 picture"},
    Mark<const char*>{0, "\xff\x4f\xff\x51"sv, "a JPEG 2000 picture"},
    Mark<const char*>{4, "JXL \r\n"sv, "a JPEG XL picture"},
    Mark<const char*>{0, "\xff\x0a"sv, "a JPEG XL picture"},
    Mark<const char*>{0, "DDS "sv, "a DDS texture"},
    Mark<const char*>{0, "\xabKTX "sv, "a KTX texture"},
    Mark<const char*>{0, "%PDF"sv, "a PDF document"},
    Mark<const char*>{0, "%!PS"sv, "a PostScript document"},
    Mark<const char*>{0, "<svg"sv, "an SVG drawing"},
    Mark<const char*>{0, "gimp xcf"sv, "a GIMP picture (XCF)"},
    Mark<const char*>{0, "P7"sv, "a PAM picture"},
    Mark<const char*>{0, "\0\0\1\0"sv, "a Windows icon"},
    Mark<const char*>{0, "\0\0\2\0"sv, "a Windows cursor"},
    Mark<const char*>{0, "SDPX"sv, "a DPX picture"},
    Mark<const char*>{0, "XPDS"sv, "a DPX picture"},
    Mark<const char*>{0, "\x80\x2a\x5f\xd7"sv, "a Cineon picture"},
    Mark<const char*>{0, "\x01\xda"sv, "an SGI picture"},
    Mark<const char*>{0, "SIMPLE  ="sv, "a FITS file"},
    Mark<const char*>{128, "DICM"sv, "a DICOM file"},
    Mark<const char*>{0, "qoif"sv, "a QOI picture"},
    Mark<const char*>{0, "PK\3\4"sv, "a ZIP archive"},
};

template <class Marks>
auto marked(const Marks& marks, std::string_view head) {
    const auto fits = [&](const auto& mark) {
        return head.size() >= mark.at && head.substr(mark.at).starts_with(mark.bytes);
    };
    return std::ranges::find_if(marks, fits);
}

bool isSvg(std::string_view head) {
    return head.starts_with("<?xml") && head.find("<svg") != std::string_view::npos;
}

/// Bytes below a blank that no text has.
bool isText(std::string_view head) {
    return std::ranges::none_of(head, [](unsigned char c) { return c < ' ' && !(c >= '\t' && c <= '\r'); });
}

bool arePoints(std::string_view head) {
    return head.find_first_not_of("0123456789+-.,;eE \t\r\n") == std::string_view::npos &&
           head.find_first_of("0123456789") != std::string_view::npos;
}

std::string kindOfOther(std::string_view head) {
    if (isSvg(head)) return "an SVG drawing";
    if (const auto known = marked(kNotRead, head); known != kNotRead.end()) return known->what;
    if (arePoints(head)) return "a list of points without a surface";
    return isText(head) ? "a text file" : "not a picture that Wend knows";
}

}  // namespace

PictureFormat pictureFormat(const InputFile& file) {
    if (file.size() == 0) throw InputError(file.path(), "is empty");
    const std::string head = file.bytes(0, 512);
    const auto known = marked(kRead, head);
    // The name of the chunk counts only in the container that it is of.
    if (known != kRead.end() && (known->what != PictureFormat::Webp || head.starts_with("RIFF")))
        return known->what;
    if (isTga(head, static_cast<double>(file.size()))) return PictureFormat::Tga;
    throw InputError(file.path(), "is " + kindOfOther(head) +
                                      ". Wend opens PNG, JPEG, TIFF, EXR, WebP, HDR, BMP, TGA and PNM "
                                      "pictures");
}

const std::vector<std::string>& pictureFileExtensions() {
    static const std::vector<std::string> extensions{".png", ".jpg",  ".jpeg", ".tif", ".tiff",
                                                     ".exr", ".webp", ".hdr",  ".bmp", ".tga",
                                                     ".pnm", ".ppm",  ".pgm",  ".pbm", ".pfm"};
    return extensions;
}

}  // namespace wend
