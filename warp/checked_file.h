#pragma once

#include <OpenImageIO/filesystem.h>

#include <fstream>

namespace wend {

/// A file for those of OpenImageIO's writers that do not tell of a full disk, or end the process: a write
/// that fails looks like success to them, and is remembered here.
class CheckedFile final : public OIIO::Filesystem::IOProxy {
  public:
    explicit CheckedFile(const std::string& path)
        : IOProxy(path, Write), m_file(path, std::ios::binary | std::ios::trunc) {}

    const char* proxytype() const override { return "checked"; }
    bool seek(int64_t offset) override {
        m_pos = offset;
        m_file.seekp(offset);
        return true;
    }
    std::size_t write(const void* bytes, std::size_t size) override {
        m_file.write(static_cast<const char*>(bytes), static_cast<std::streamsize>(size));
        m_pos += static_cast<int64_t>(size);
        m_end = std::max(m_end, m_pos);
        return size;
    }
    std::size_t size() const override { return static_cast<std::size_t>(m_end); }
    void close() override {}

    bool failed() const { return !m_file; }
    /// Whether all came to the disk.
    bool finish() {
        m_file.close();
        return !failed();
    }

  private:
    std::ofstream m_file;
    int64_t m_end = 0;
};

}  // namespace wend
