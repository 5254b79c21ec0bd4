#include "core/meshing/cage.h"

#include "core/meshing/cage_protocol.h"

namespace wend {

Cage fitCage(const Surface& surface, const CageOptions& options) {
    static constexpr MesherProcess kMesher{
        "wend-cage", "the cage mesher",
        sentence("Core",
                 "the cage mesher did not finish within %1 s of computing; "
                 "fewer vertices or larger cells may help")};
    CageReply reply;
    const std::string request = pack(CageRequest{{surface.points, surface.triangles, {}}, options});
    if (!unpack(answerOf(kMesher, request, surface.triangleCount(), options.stop), reply))
        throw InputError("the cage mesher gave an incomplete answer");
    if (!reply.error.isEmpty()) throw InputError(reply.error);
    return std::move(reply.cage);
}

}  // namespace wend
