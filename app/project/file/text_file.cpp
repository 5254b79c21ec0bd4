#include "app/project/file/text_file.h"

#include <array>
#include <cstdio>

#include "core/base/error.h"
#include "core/base/input_file.h"
#include "core/base/safe_file.h"

namespace wend {

namespace {

constexpr std::size_t kLongest = std::size_t(256) << 20;  // a stream may never end

std::string standardInput() {
    std::string text;
    std::array<char, 65536> piece{};
    while (const std::size_t got = std::fread(piece.data(), 1, piece.size(), stdin)) {
        text.append(piece.data(), got);
        if (text.size() > kLongest) throw InputError("-", "is longer than 256 MB");
    }
    if (std::ferror(stdin) != 0) throw InputError("-", "standard input cannot be read");
    return text;
}

}  // namespace

std::string readTextFile(const std::string& path) {
    return path == "-" ? standardInput() : readInput(path);
}

void writeTextFile(const std::string& path, const std::string& text, Access access) {
    writeWhole(path, text, access);
}

}  // namespace wend
