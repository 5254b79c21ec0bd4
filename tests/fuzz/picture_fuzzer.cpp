// picture_fuzzer SEED COUNT [FOLDER [NAME]]: makes small pictures in every format that is read, changes them
// at random, COUNT times each, and reads them. The same seed gives the same files. Reading happens in
// processes of their own; a signal, ten seconds of computing, or a line that a library prints by itself is a
// finding: its file is kept in FOLDER. With NAME, only samples with that in theirs. Exit code 0 if there is
// none.
//
// To be run with glibc's checking allocator (LD_PRELOAD=libc_malloc_debug.so.0
// GLIBC_TUNABLES=glibc.malloc.check=3): what is written behind a block ends the process when the block is
// freed, in the libraries too, which no sanitizer has compiled. Fifty times slower, but of every read and
// write: valgrind -q --undef-value-errors=no --exit-on-first-error=yes --error-exitcode=9 picture_fuzzer …

#include <OpenImageIO/imageio.h>
#include <fcntl.h>
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
#include <random>

#include "core/mesh/error.h"
#include "core/mesh/input_file.h"
#include "tests/fuzz/picture_samples.h"
#include "warp/image.h"

namespace fs = std::filesystem;

namespace {

using Random = std::mt19937;
using wend::fuzz::Sample;

constexpr int kPrinted = 4;  // the exit code of a process whose reader has printed something

std::string contents(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

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
    std::fflush(stdout);  // or the child, too, would write what is in its buffer
    const pid_t child = fork();
    if (child == 0) {
        const int printed =
            ::open((path.parent_path() / "printed").c_str(), O_CREAT | O_TRUNC | O_RDWR, 0600);
        dup2(printed, STDERR_FILENO);
        for (unsigned seed = first; seed < last; ++seed) {
            put(path, changed(sample, seed));
            if (write(ends[1], &seed, sizeof seed) < 0) _exit(3);
            const rlimit time{static_cast<rlim_t>(10 + clock() / CLOCKS_PER_SEC), RLIM_INFINITY};
            setrlimit(RLIMIT_CPU, &time);
            alarm(300);
            read(path);
            if (lseek(STDERR_FILENO, 0, SEEK_END) > 0) _exit(kPrinted);
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
    end = WIFEXITED(status) && WEXITSTATUS(status) == kPrinted
              ? "printed " + contents(path.parent_path() / "printed")
          : WIFSIGNALED(status) ? "signal " + std::to_string(WTERMSIG(status))
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
    for (const Sample& sample : wend::fuzz::makeSamples(folder)) {
        if (argc > 4 && sample.name.find(argv[4]) == std::string::npos) continue;
        const fs::path path = folder / ("changed" + fs::path(sample.name).extension().string());
        put(path, sample.bytes);
        try {
            wend::readImage(path.string());
        } catch (const wend::InputError& error) {
            ++findings;
            std::printf("%s as it is: %s\n", sample.name.c_str(), error.what());
        }
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
