// picture_fuzzer SEED COUNT [FOLDER [NAME]]: makes small pictures in every format that is read, changes them
// at random, COUNT times each, and reads them. The same seed gives the same files. Each must be read, or
// refused with a message that names it; anything else, including a wait of five minutes, is a finding. Files
// that crash the reading process are counted and kept in FOLDER: a user gets one line for each. NAME
// restricts the samples to those whose names contain it. Exit code 0 if there is no finding.
//
// Run it with glibc's checking allocator (LD_PRELOAD=libc_malloc_debug.so.0
// GLIBC_TUNABLES=glibc.malloc.check=3): a write behind a block then ends the process when the block is freed,
// also in libraries that no sanitizer has compiled.

#include <OpenImageIO/imageio.h>
#include <unistd.h>
#include <zlib.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <random>

#include "core/base/error.h"
#include "core/base/input_file.h"
#include "tests/fuzz/picture_samples.h"
#include "warp/drawn_picture.h"
#include "warp/image.h"
#include "warp/picture_metadata.h"
#include "warp/picture_process.h"

namespace fs = std::filesystem;

namespace {

using Random = std::mt19937;
using wend::fuzz::Sample;

void put(const fs::path& path, const std::string& bytes) {
    std::ofstream(path, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

// --- Changes ---

std::size_t below(Random& random, std::size_t count) {
    return count == 0 ? 0 : random() % count;
}

void changeNumber(std::string& bytes, Random& random) {
    constexpr std::array<std::uint32_t, 12> odd{0,      1,      0x7f,   0x80,       0xff,       0x100,
                                                0x7fff, 0x8000, 0xffff, 0x7fffffff, 0x80000000, 0xffffffff};
    const std::uint32_t value = odd[below(random, odd.size())];
    const std::size_t size = std::size_t(1) << below(random, 3), at = below(random, bytes.size());
    const bool big = below(random, 2) == 0;
    for (std::size_t k = 0; k < size && at + k < bytes.size(); ++k)
        bytes[at + k] = static_cast<char>(value >> 8 * (big ? size - 1 - k : k));
}

void change(std::string& bytes, Random& random) {
    const std::size_t at = below(random, bytes.size()), size = below(random, 40);
    switch (below(random, 8)) {
        case 0:
            bytes[at] = static_cast<char>(bytes[at] ^ 1 << below(random, 8));
            break;
        case 1:
            bytes[at] = static_cast<char>(random());
            break;
        case 2:
            bytes.erase(at, size);
            break;
        case 3:
            bytes.insert(at, bytes.substr(below(random, bytes.size()), size));
            break;
        case 4:
            bytes.resize(at + 1);
            break;
        default:  // mostly near the front, where the sizes are
            changeNumber(bytes, random);
    }
    if (bytes.empty()) bytes = "x";
}

/// The code behind the checksums would never be reached without valid ones.
void mendPngChecksums(std::string& bytes) {
    const auto word = [&](std::size_t at) {
        std::uint32_t value = 0;
        for (std::size_t k = 0; k < 4; ++k) value = value << 8 | static_cast<unsigned char>(bytes[at + k]);
        return value;
    };
    for (std::size_t at = 8; at + 12 <= bytes.size();) {
        const std::size_t length = word(at);
        if (length > bytes.size() - at - 12) return;
        const uLong sum =
            crc32(0, reinterpret_cast<const Bytef*>(bytes.data()) + at + 4, static_cast<uInt>(length + 4));
        for (std::size_t k = 0; k < 4; ++k)
            bytes[at + 8 + length + k] = static_cast<char>(sum >> (24 - 8 * k));
        at += 12 + length;
    }
}

std::string changed(const Sample& sample, unsigned seed) {
    Random random(seed);
    std::string bytes = sample.bytes;
    for (std::size_t k = 1 + below(random, 4); k > 0; --k) change(bytes, random);
    if (bytes.starts_with("\x89PNG") && below(random, 8) > 0) mendPngChecksums(bytes);
    return bytes;
}

// --- Reading ---

/// Returns an empty text if the file was read, or the message of the reader.
std::string read(const fs::path& path) {
    alarm(300);
    try {
        const wend::Image image = wend::readImage(path.string(), 20);
        if (const auto* metadata = wend::fileMetadata(image))
            for (const wend::PictureLayer& layer : metadata->layers)
                wend::readLayer(path.string(), layer.name);
        if (wend::isDrawing(path.string())) wend::readVectors(path.string(), {}, {160, 120});
    } catch (const wend::InputError& error) {
        return error.what();
    } catch (const wend::OutOfMemory& error) {
        return error.what();
    }
    return {};
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 3) return 2;
    const auto seed = static_cast<unsigned>(std::atoi(argv[1])),
               count = static_cast<unsigned>(std::atoi(argv[2]));
    std::string pattern = (fs::temp_directory_path() / "wend-fuzz-XXXXXX").string();
    const fs::path folder = mkdtemp(pattern.data());
    int findings = 0, inputs = 0, falls = 0;
    for (const Sample& sample : wend::fuzz::makeSamples(folder)) {
        if (argc > 4 && sample.name.find(argv[4]) == std::string::npos) continue;
        const fs::path path = folder / ("changed" + fs::path(sample.name).extension().string());
        put(path, sample.bytes);
        const std::string expected = sample.refusal.empty() ? "" : path.string() + sample.refusal;
        if (const std::string said = read(path); said != expected) {
            ++findings;
            std::printf("%s as it is: %s\n", sample.name.c_str(), said.c_str());
        }
        for (unsigned change = seed * count; change < seed * count + count; ++change, ++inputs) {
            put(path, changed(sample, change));
            const std::string said = read(path);
            const bool isWrong = !said.empty() && !said.starts_with(path.string() + ": ");
            const bool isFall = said.find("its reader") != std::string::npos;
            findings += isWrong, falls += isFall;
            if (!isWrong && !isFall) continue;
            std::printf("%s change %u: %s\n", sample.name.c_str(), change, said.c_str());
            if (argc > 3)
                fs::copy_file(path, fs::path(argv[3]) / (std::to_string(change) + "-" + sample.name));
        }
    }
    fs::remove_all(folder);
    std::printf("%d inputs, %d findings, %d falls\n", inputs, findings, falls);
    return findings == 0 ? 0 : 1;
}
