#include "core/base/zip_archive.h"

#include <minizip/unzip.h>

#include <algorithm>

#include "core/base/error.h"

namespace wend {

namespace {

constexpr int kAnyCase = 2;  // of minizip

}  // namespace

ZipArchive::ZipArchive(const std::string& path) : m_path(path), m_zip(unzOpen64(path.c_str()), unzClose) {
    if (!m_zip) fail("is a damaged ZIP archive");
}

std::optional<std::string> ZipArchive::file(const std::string& name, std::uint64_t most) const {
    unz_file_info64 info{};
    if (unzLocateFile(m_zip.get(), name.c_str(), kAnyCase) != UNZ_OK) return std::nullopt;
    if (unzGetCurrentFileInfo64(m_zip.get(), &info, nullptr, 0, nullptr, 0, nullptr, 0) != UNZ_OK ||
        unzOpenCurrentFile(m_zip.get()) != UNZ_OK)
        fail({sentence("Core", "has a damaged %1"), name});
    if (info.uncompressed_size > kLongest) fail("has a " + name + " of more than 2 GB");
    std::string bytes(std::min<std::uint64_t>(info.uncompressed_size, most), '\0');
    for (std::size_t at = 0; at < bytes.size();) {
        const auto part = static_cast<unsigned>(std::min<std::size_t>(bytes.size() - at, 1 << 20));
        const int got = unzReadCurrentFile(m_zip.get(), bytes.data() + at, part);
        if (got <= 0) fail({sentence("Core", "has a damaged %1"), name});
        at += static_cast<std::size_t>(got);
    }
    if (unzCloseCurrentFile(m_zip.get()) == UNZ_CRCERROR) fail({sentence("Core", "has a damaged %1"), name});
    return bytes;
}

void ZipArchive::fail(const Message& why) const {
    throw InputError(m_path, why);
}

}  // namespace wend
