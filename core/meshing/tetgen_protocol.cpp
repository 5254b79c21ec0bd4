#include "core/meshing/tetgen_protocol.h"

#include <cstring>
#include <type_traits>

namespace wend {
namespace {

class Writer {
  public:
    template <typename Container>
    void array(const Container& values) {
        const std::uint64_t count = values.size();
        m_bytes.append(reinterpret_cast<const char*>(&count), sizeof count);
        m_bytes.append(reinterpret_cast<const char*>(values.data()), count * sizeof(values[0]));
    }
    std::string take() { return std::move(m_bytes); }

  private:
    std::string m_bytes;
};

class Reader {
  public:
    explicit Reader(const std::string& bytes) : m_bytes(bytes) {}

    template <typename Container>
    bool array(Container& values) {
        std::uint64_t count = 0;
        if (m_bytes.size() - m_at < sizeof count) return false;
        std::memcpy(&count, m_bytes.data() + m_at, sizeof count);
        m_at += sizeof count;
        constexpr std::size_t size = sizeof(typename Container::value_type);
        if (count > (m_bytes.size() - m_at) / size) return false;
        values.resize(count);
        std::memcpy(values.data(), m_bytes.data() + m_at, count * size);
        m_at += count * size;
        return true;
    }
    bool done() const { return m_at == m_bytes.size(); }

  private:
    const std::string& m_bytes;
    std::size_t m_at = 0;
};

}  // namespace

std::string pack(const TetgenRequest& request) {
    Writer writer;
    writer.array(request.switches);
    writer.array(request.points);
    writer.array(request.triangles);
    writer.array(request.labels);
    writer.array(request.sizes);
    writer.array(request.sizeCounts);
    return writer.take();
}

std::string pack(const TetgenReply& reply) {
    Writer writer;
    writer.array(std::vector<std::int32_t>{reply.error});
    writer.array(reply.points);
    writer.array(reply.cells);
    writer.array(reply.regions);
    writer.array(reply.boundary);
    writer.array(reply.labels);
    return writer.take();
}

bool unpack(const std::string& bytes, TetgenRequest& request) {
    Reader reader(bytes);
    return reader.array(request.switches) && reader.array(request.points) &&
           reader.array(request.triangles) && reader.array(request.labels) && reader.array(request.sizes) &&
           reader.array(request.sizeCounts) && reader.done();
}

bool unpack(const std::string& bytes, TetgenReply& reply) {
    Reader reader(bytes);
    std::vector<std::int32_t> error;
    if (!reader.array(error) || error.size() != 1) return false;
    reply.error = error[0];
    return reader.array(reply.points) && reader.array(reply.cells) && reader.array(reply.regions) &&
           reader.array(reply.boundary) && reader.array(reply.labels) && reader.done();
}

}  // namespace wend
