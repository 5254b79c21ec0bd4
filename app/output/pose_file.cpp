#include "app/output/pose_file.h"

#include <filesystem>

#include "core/base/error.h"

namespace wend {
namespace fs = std::filesystem;

namespace {

std::string folderOfFile(const std::string& path) {
    const fs::path parent = fs::path(path).parent_path();
    return parent.empty() ? "." : parent.string();
}

}  // namespace

PoseFile::PoseFile(const std::string& path)
    : m_path(path),
      m_folder(folderOfFile(path)),
      m_stream((fs::path(m_folder.path()) / "poses").string(),
               std::ios::binary | std::ios::in | std::ios::out | std::ios::trunc) {}

void PoseFile::add(const Points<2>& pose) {
    m_columns = pose.cols();
    m_stream.write(reinterpret_cast<const char*>(pose.data()),
                   static_cast<std::streamsize>(sizeof(double)) * pose.size());
    if (!m_stream)
        throw InputError(m_path, {sentence("Core", "cannot be written: %1"),
                                  Message(sentence("Core", "the disk may be full"))});
    ++m_count;
}

Points<2> PoseFile::read(int k) {
    Points<2> pose(2, m_columns);
    const auto bytes = static_cast<std::streamsize>(sizeof(double)) * pose.size();
    m_stream.seekg(k * bytes);  // which writes what is still buffered
    m_stream.read(reinterpret_cast<char*>(pose.data()), bytes);
    if (!m_stream)
        throw InputError(m_path, {sentence("Core", "cannot be written: %1"),
                                  Message(sentence("Core", "the disk may be full"))});
    return pose;
}

}  // namespace wend
