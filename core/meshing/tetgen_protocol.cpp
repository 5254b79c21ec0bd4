#include "core/meshing/tetgen_protocol.h"

#include "core/meshing/array_bytes.h"

namespace wend {

std::string pack(const TetgenRequest& request) {
    ArrayWriter writer;
    writer.array(request.switches);
    writer.array(request.points);
    writer.array(request.triangles);
    writer.array(request.labels);
    writer.array(request.sizes);
    writer.array(request.sizeCounts);
    return writer.take();
}

std::string pack(const TetgenReply& reply) {
    ArrayWriter writer;
    writer.array(std::vector<std::int32_t>{reply.error});
    writer.array(reply.points);
    writer.array(reply.cells);
    writer.array(reply.regions);
    writer.array(reply.boundary);
    writer.array(reply.labels);
    return writer.take();
}

bool unpack(const std::string& bytes, TetgenRequest& request) {
    ArrayReader reader(bytes);
    return reader.array(request.switches) && reader.array(request.points) &&
           reader.array(request.triangles) && reader.array(request.labels) && reader.array(request.sizes) &&
           reader.array(request.sizeCounts) && reader.done();
}

bool unpack(const std::string& bytes, TetgenReply& reply) {
    ArrayReader reader(bytes);
    std::vector<std::int32_t> error;
    if (!reader.array(error) || error.size() != 1) return false;
    reply.error = error[0];
    return reader.array(reply.points) && reader.array(reply.cells) && reader.array(reply.regions) &&
           reader.array(reply.boundary) && reader.array(reply.labels) && reader.done();
}

}  // namespace wend
