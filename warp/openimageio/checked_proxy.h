#pragma once

#include <OpenImageIO/filesystem.h>

#include "core/base/checked_file.h"

namespace wend {

/// A checked file as OpenImageIO's writers take it.
class CheckedProxy : public OIIO::Filesystem::IOProxy {
  public:
    explicit CheckedProxy(const std::string& path) : IOProxy(path, Write), m_file(path) {}

    const char* proxytype() const override { return "checked"; }
    void close() override {}
    bool seek(int64_t offset) override {
        m_pos = offset;
        return true;
    }
    std::size_t read(void* bytes, std::size_t size) override {
        const std::size_t count = m_file.read(m_pos, bytes, size);
        m_pos += static_cast<int64_t>(count);
        return count;
    }
    std::size_t write(const void* bytes, std::size_t size) override {
        m_file.write(m_pos, bytes, size);
        m_pos += static_cast<int64_t>(size);
        return size;
    }
    std::size_t size() const override { return static_cast<std::size_t>(m_file.size()); }

    CheckedFile& file() { return m_file; }

  private:
    CheckedFile m_file;
};

}  // namespace wend
