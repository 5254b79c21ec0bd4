#pragma once

#include <OpenImageIO/imageio.h>

#include <array>

#include "warp/picture_format.h"

// OpenImageIO's readers and writers are made one by one: its own search looks for plug-ins, and when a reader
// fails, it tries all the others, of which some write where they must not. As in its imageioplugin.cpp: no
// header of its declares them.
OIIO_NAMESPACE_BEGIN
// NOLINTBEGIN(readability-identifier-naming)
OIIO_API ImageInput* png_input_imageio_create();
OIIO_API ImageInput* jpeg_input_imageio_create();
OIIO_API ImageInput* jpeg2000_input_imageio_create();
OIIO_API ImageInput* tiff_input_imageio_create();
OIIO_API ImageInput* openexr_input_imageio_create();
OIIO_API ImageInput* webp_input_imageio_create();
OIIO_API ImageInput* hdr_input_imageio_create();
OIIO_API ImageInput* bmp_input_imageio_create();
OIIO_API ImageInput* targa_input_imageio_create();
OIIO_API ImageInput* pnm_input_imageio_create();
OIIO_API ImageInput* gif_input_imageio_create();
OIIO_API ImageInput* psd_input_imageio_create();
OIIO_API ImageInput* heif_input_imageio_create();
OIIO_API ImageInput* raw_input_imageio_create();
OIIO_API ImageInput* dds_input_imageio_create();
OIIO_API ImageInput* dpx_input_imageio_create();
OIIO_API ImageInput* cineon_input_imageio_create();
OIIO_API ImageInput* sgi_input_imageio_create();
OIIO_API ImageInput* iff_input_imageio_create();
OIIO_API ImageInput* ico_input_imageio_create();
OIIO_API ImageInput* fits_input_imageio_create();
OIIO_API ImageInput* dicom_input_imageio_create();

OIIO_API ImageOutput* png_output_imageio_create();
OIIO_API ImageOutput* jpeg_output_imageio_create();
OIIO_API ImageOutput* jpeg2000_output_imageio_create();
OIIO_API ImageOutput* tiff_output_imageio_create();
OIIO_API ImageOutput* openexr_output_imageio_create();
OIIO_API ImageOutput* hdr_output_imageio_create();
OIIO_API ImageOutput* bmp_output_imageio_create();
OIIO_API ImageOutput* targa_output_imageio_create();
OIIO_API ImageOutput* pnm_output_imageio_create();
// NOLINTEND(readability-identifier-naming)
OIIO_NAMESPACE_END

namespace wend {

/// OpenImageIO's reader and writer of a format, and the writer's compression.
struct PictureCodec {
    OIIO::ImageInput* (*reader)() = nullptr;
    OIIO::ImageOutput* (*writer)() = nullptr;
    const char* compression = "";
};

inline const PictureCodec& codecOf(PictureFormat format) {
    static constexpr std::array codecs{
        PictureCodec{OIIO::png_input_imageio_create, OIIO::png_output_imageio_create},
        PictureCodec{OIIO::jpeg_input_imageio_create, OIIO::jpeg_output_imageio_create, "jpeg:95"},
        PictureCodec{OIIO::tiff_input_imageio_create, OIIO::tiff_output_imageio_create, "zip"},
        PictureCodec{OIIO::openexr_input_imageio_create, OIIO::openexr_output_imageio_create, "zip"},
        PictureCodec{OIIO::webp_input_imageio_create, nullptr},  // written by libwebp itself
        PictureCodec{OIIO::hdr_input_imageio_create, OIIO::hdr_output_imageio_create},
        PictureCodec{OIIO::bmp_input_imageio_create, OIIO::bmp_output_imageio_create},
        PictureCodec{OIIO::targa_input_imageio_create, OIIO::targa_output_imageio_create, "rle"},
        PictureCodec{OIIO::pnm_input_imageio_create, OIIO::pnm_output_imageio_create},
        PictureCodec{OIIO::jpeg2000_input_imageio_create, OIIO::jpeg2000_output_imageio_create},
        PictureCodec{OIIO::gif_input_imageio_create},
        PictureCodec{OIIO::psd_input_imageio_create},
        PictureCodec{OIIO::heif_input_imageio_create},
        PictureCodec{OIIO::raw_input_imageio_create},
        PictureCodec{OIIO::dds_input_imageio_create},
        PictureCodec{OIIO::dpx_input_imageio_create},
        PictureCodec{OIIO::cineon_input_imageio_create},
        PictureCodec{OIIO::sgi_input_imageio_create},
        PictureCodec{OIIO::iff_input_imageio_create},
        PictureCodec{OIIO::ico_input_imageio_create},
        PictureCodec{OIIO::fits_input_imageio_create},
        PictureCodec{OIIO::dicom_input_imageio_create}};
    static_assert(codecs.size() == static_cast<std::size_t>(PictureFormat::Dicom) + 1);
    return codecs[static_cast<std::size_t>(format)];
}

}  // namespace wend
