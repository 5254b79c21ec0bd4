// picture_fuzzer SEED COUNT [FOLDER]: makes small pictures in every format that is read, changes them at
// random, COUNT times each, and reads them. The same seed gives the same files. Reading happens in processes
// of their own; a signal or ten seconds of computing is a finding: its file is kept in FOLDER. Exit code 0 if
// there is none.
//
// To be run with glibc's checking allocator (LD_PRELOAD=libc_malloc_debug.so.0
// GLIBC_TUNABLES=glibc.malloc.check=3): what is written behind a block ends the process when the block is
// freed, in the libraries too, which no sanitizer has compiled.

#include <OpenImageIO/imageio.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <zlib.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <random>

#include "core/mesh/error.h"
#include "core/mesh/input_file.h"
#include "warp/image.h"

namespace fs = std::filesystem;

namespace {

using Random = std::mt19937;

struct Sample {
    std::string name, bytes;
};

std::string contents(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

void put(const fs::path& path, const std::string& bytes) {
    std::ofstream(path, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

// --- Samples ---

using Set = std::function<void(OIIO::ImageSpec&)>;

/// A gradient with something of noise, written by OpenImageIO.
void add(std::vector<Sample>& samples, const fs::path& folder, const std::string& name, int channels,
         OIIO::TypeDesc type, const Set& set = {}) {
    OIIO::ImageSpec spec(23, 17, channels, type);
    spec.attribute("ImageDescription", "a small picture");
    if (set) set(spec);
    std::vector<float> pixels(static_cast<std::size_t>(23 * 17 * channels));
    for (std::size_t i = 0; i < pixels.size(); ++i) pixels[i] = static_cast<float>(i * i % 251) / 251;
    const fs::path path = folder / name;
    const auto output = OIIO::ImageOutput::create(path.string());
    const bool written = output && output->open(path.string(), spec) &&
                         output->write_image(OIIO::TypeDesc::FLOAT, pixels.data()) && output->close();
    if (!written) {
        std::fprintf(stderr, "%s cannot be made: %s\n", name.c_str(), OIIO::geterror().c_str());
        std::exit(3);
    }
    samples.push_back({name, contents(path)});
}

std::vector<Sample> makeSamples(const fs::path& folder) {
    using T = OIIO::TypeDesc;
    std::vector<Sample> samples;
    const auto packed = [](const char* how) {
        return [how](OIIO::ImageSpec& spec) { spec.attribute("compression", how); };
    };
    const auto tiled = [](OIIO::ImageSpec& spec) { spec.tile_width = spec.tile_height = 16; };
    for (int channels = 1; channels <= 4; ++channels) {
        const std::string n = std::to_string(channels);
        add(samples, folder, "8-" + n + ".png", channels, T::UINT8);
        add(samples, folder, "16-" + n + ".png", channels, T::UINT16);
        add(samples, folder, "f-" + n + ".tif", channels, T::FLOAT);
    }
    for (const char* how : {"none", "lzw", "zip", "packbits"})
        add(samples, folder, std::string("c-") + how + ".tif", 3, T::UINT8, packed(how));
    add(samples, folder, "tiled.tif", 3, T::UINT16, tiled);
    for (const char* how : {"none", "rle", "zip", "zips", "piz", "pxr24", "b44", "b44a", "dwaa"})
        add(samples, folder, std::string("c-") + how + ".exr", 4, T::HALF, packed(how));
    add(samples, folder, "float.exr", 3, T::FLOAT);
    add(samples, folder, "tiled.exr", 3, T::HALF, tiled);
    for (int channels : {1, 3})
        add(samples, folder, "p-" + std::to_string(channels) + ".jpg", channels, T::UINT8);
    add(samples, folder, "progressive.jpg", 3, T::UINT8,
        [](OIIO::ImageSpec& spec) { spec.attribute("jpeg:progressive", 1); });
    for (int channels : {3, 4})
        add(samples, folder, "w-" + std::to_string(channels) + ".webp", channels, T::UINT8);
    add(samples, folder, "a.hdr", 3, T::FLOAT);
    for (int channels : {1, 3, 4})
        add(samples, folder, "b-" + std::to_string(channels) + ".bmp", channels, T::UINT8);
    for (const char* how : {"none", "rle"})
        for (int channels : {1, 3, 4})
            add(samples, folder, std::string(how) + std::to_string(channels) + ".tga", channels, T::UINT8,
                packed(how));
    for (int binary : {0, 1})
        for (int channels : {1, 3})
            add(samples, folder, std::to_string(binary) + std::to_string(channels) + ".ppm", channels,
                T::UINT8, [binary](OIIO::ImageSpec& spec) { spec.attribute("pnm:binary", binary); });
    samples.push_back({"palette.tga", std::string("\0\1\1\0\0\2\0\x18\0\0\0\0\4\0\4\0\x08\0", 18) + "abcdef" +
                                          std::string("\0\1\0\1\0\1\0\1\0\1\0\1\0\1\0\1", 16)});
    samples.push_back({"grey.pfm", "Pf\n4 2\n-1.0\n" + std::string(32, '?')});
    samples.push_back({"bits.pbm", "P1\n4 2\n0 1 0 1\n1 0 1 0\n"});
    return samples;
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

/// Else nothing behind the checksums would ever be reached.
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

void read(const fs::path& path) {
    try {
        wend::readImage(path.string(), 20);
    } catch (const wend::InputError&) {
    } catch (const wend::OutOfMemory&) {
    }
}

/// Reads changes first … last − 1 of a sample in a child; tells the one that ended it, or last.
unsigned tryRange(const Sample& sample, const fs::path& path, unsigned first, unsigned last,
                  std::string& end) {
    int ends[2];
    if (pipe(ends) != 0) std::exit(3);
    const pid_t child = fork();
    if (child == 0) {
        for (unsigned seed = first; seed < last; ++seed) {
            put(path, changed(sample, seed));
            if (write(ends[1], &seed, sizeof seed) < 0) _exit(3);
            const rlimit time{static_cast<rlim_t>(10 + clock() / CLOCKS_PER_SEC), RLIM_INFINITY};
            setrlimit(RLIMIT_CPU, &time);
            alarm(300);
            read(path);
        }
        _exit(0);
    }
    close(ends[1]);
    unsigned current = first;
    for (unsigned seed = 0; ::read(ends[0], &seed, sizeof seed) == sizeof seed;) current = seed;
    close(ends[0]);
    int status = 0;
    waitpid(child, &status, 0);
    if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return last;
    end = WIFSIGNALED(status) ? "signal " + std::to_string(WTERMSIG(status))
                              : "exit code " + std::to_string(WEXITSTATUS(status));
    return current;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 3) return 2;
    const auto seed = static_cast<unsigned>(std::atoi(argv[1])),
               count = static_cast<unsigned>(std::atoi(argv[2]));
    std::string pattern = (fs::temp_directory_path() / "wend-fuzz-XXXXXX").string();
    const fs::path folder = mkdtemp(pattern.data());
    OIIO::attribute("threads", 1);
    OIIO::attribute("exr_threads", -1);
    int findings = 0, inputs = 0;
    for (const Sample& sample : makeSamples(folder)) {
        const fs::path path = folder / ("changed" + fs::path(sample.name).extension().string());
        for (unsigned first = seed * count, last = first + count; first < last;) {
            std::string end;
            const unsigned stopped = tryRange(sample, path, first, last, end);
            inputs += static_cast<int>(std::min(stopped + 1, last) - first);
            first = stopped + 1;
            if (stopped == last) break;
            ++findings;
            std::printf("%s change %u: %s\n", sample.name.c_str(), stopped, end.c_str());
            if (argc > 3)
                fs::copy_file(path, fs::path(argv[3]) / (std::to_string(stopped) + "-" + sample.name));
        }
    }
    fs::remove_all(folder);
    std::printf("%d inputs, %d findings\n", inputs, findings);
    return findings == 0 ? 0 : 1;
}
