#include "app/document/text_file.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "core/mesh/error.h"
#include "core/mesh/safe_file.h"

namespace wend {

std::string readTextFile(const std::string& path) {
    std::error_code error;
    if (std::filesystem::is_directory(path, error)) throw InputError(path, "is a folder");
    std::ifstream stream(path, std::ios::binary);
    if (!stream) throw InputError(path, std::string("cannot be read: ") + std::strerror(errno));
    std::string text{std::istreambuf_iterator<char>(stream), {}};
    if (stream.bad()) throw InputError(path, "cannot be read to its end");
    return text;
}

void writeTextFile(const std::string& path, const std::string& text) {
    writeWhole(path, [&](const std::string& temporary) {
        std::ofstream stream(temporary, std::ios::binary);
        stream << text;
        stream.close();  // what is still buffered meets the full disk here
        if (!stream) throw InputError(path, std::string("cannot be written: ") + std::strerror(errno));
    });
}

}  // namespace wend
