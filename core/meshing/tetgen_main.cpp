// wend-tetgen: reads a TetgenRequest from standard input, meshes it, writes a TetgenReply to standard output.
// A program of its own because TetGen may abort, exit, crash or never end: then only this process does.

#include <fcntl.h>
#include <tetgen.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <new>

#include "core/base/helper_program.h"
#include "core/meshing/tetgen_protocol.h"

namespace {

/// TetGen prints to standard output: the reply keeps the pipe, and the output is discarded.
int takeStandardOutput() {
    const int pipe = dup(STDOUT_FILENO);
    const int nowhere = open("/dev/null", O_WRONLY);
    dup2(nowhere, STDOUT_FILENO);
    dup2(nowhere, STDERR_FILENO);
    return pipe;
}

/// tetgenio frees these arrays itself, with delete[].
template <typename T>
T* copyOf(const std::vector<T>& values) {
    T* copy = new T[values.size()];
    std::copy(values.begin(), values.end(), copy);
    return copy;
}

/// Fills TetGen's input from a request. TetGen frees the arrays.
void fill(tetgenio& in, const wend::TetgenRequest& request) {
    in.firstnumber = 0;
    in.numberofpoints = static_cast<int>(request.points.size() / 3);
    in.pointlist = copyOf(request.points);
    in.numberoffacets = static_cast<int>(request.triangles.size() / 3);
    in.facetlist = new tetgenio::facet[static_cast<std::size_t>(in.numberoffacets)];
    in.facetmarkerlist = copyOf(request.labels);
    for (int f = 0; f < in.numberoffacets; ++f) {
        tetgenio::facet& facet = in.facetlist[f];
        tetgenio::init(&facet);
        facet.numberofpolygons = 1;
        facet.polygonlist = new tetgenio::polygon[1];
        tetgenio::init(facet.polygonlist);
        facet.polygonlist[0].numberofvertices = 3;
        facet.polygonlist[0].vertexlist = new int[3];
        std::copy_n(request.triangles.begin() + 3 * f, 3, facet.polygonlist[0].vertexlist);
    }
}

/// The size field, for the callback below, which TetGen hands nothing but points.
const wend::TetgenRequest* sizeField = nullptr;

/// Returns the factor at p, trilinear between the grid's nodes.
double factorAt(const std::array<double, 3>& p) {
    const double *low = sizeField->sizes.data() + 1, *spacing = low + 3, *factors = spacing + 3;
    const int* counts = sizeField->sizeCounts.data();
    std::array<int, 3> node;
    std::array<double, 3> t;
    for (int k = 0; k < 3; ++k) {
        const double at = spacing[k] > 0 ? (p[k] - low[k]) / spacing[k] : 0;
        node[k] = std::clamp(static_cast<int>(at), 0, counts[k] - 2);
        t[k] = std::clamp(at - node[k], 0.0, 1.0);
    }
    double sum = 0;
    for (int corner = 0; corner < 8; ++corner) {
        double weight = 1;
        std::size_t index = 0;
        for (int k = 2; k >= 0; --k) {
            const int up = corner >> k & 1;
            weight *= up ? t[k] : 1 - t[k];
            index = index * counts[k] + node[k] + up;
        }
        sum += weight * factors[index];
    }
    return sum;
}

/// Returns whether a cell is larger than the local target.
bool isTooLarge(double* a, double* b, double* c, double* d, double*, double) {
    std::array<double, 3> centre;
    double e[3][3];
    for (int k = 0; k < 3; ++k) {
        centre[k] = (a[k] + b[k] + c[k] + d[k]) / 4;
        e[0][k] = b[k] - a[k];
        e[1][k] = c[k] - a[k];
        e[2][k] = d[k] - a[k];
    }
    const double det = e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) -
                       e[0][1] * (e[1][0] * e[2][2] - e[1][2] * e[2][0]) +
                       e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0]);
    const double factor = factorAt(centre);
    return std::abs(det) / 6 > sizeField->sizes[0] * factor * factor * factor;
}

/// Copies TetGen's output to a reply.
wend::TetgenReply read(const tetgenio& out) {
    wend::TetgenReply reply;
    reply.points.assign(out.pointlist, out.pointlist + 3 * out.numberofpoints);
    reply.cells.assign(out.tetrahedronlist, out.tetrahedronlist + 4 * out.numberoftetrahedra);
    reply.regions.assign(static_cast<std::size_t>(out.numberoftetrahedra), 0);
    if (out.numberoftetrahedronattributes > 0)
        for (int c = 0; c < out.numberoftetrahedra; ++c)
            reply.regions[c] =
                static_cast<int>(out.tetrahedronattributelist[c * out.numberoftetrahedronattributes]);
    reply.boundary.assign(out.trifacelist, out.trifacelist + 3 * out.numberoftrifaces);
    if (out.trifacemarkerlist != nullptr)
        reply.labels.assign(out.trifacemarkerlist, out.trifacemarkerlist + out.numberoftrifaces);
    return reply;
}

/// Meshes a request. TetGen throws an error code, which becomes part of the reply.
wend::TetgenReply mesh(const wend::TetgenRequest& request) {
    wend::TetgenReply reply;
    tetgenio in, out;
    fill(in, request);
    if (!request.sizes.empty()) {
        sizeField = &request;
        in.tetunsuitable = isTooLarge;
    }
    std::string switches = request.switches;
    try {
        tetrahedralize(switches.data(), &in, &out);
        reply = read(out);
    } catch (int code) {
        reply.error = code == 0 ? -1 : code;
    } catch (const std::bad_alloc&) {
        reply.error = 1;
    }
    return reply;
}

}  // namespace

int main(int argc, char** argv) {
    wend::beginHelper(argc, argv);
    const int pipe = takeStandardOutput();
    wend::TetgenRequest request;
    if (!unpack(wend::readAll(STDIN_FILENO), request)) return 2;
    const bool written = wend::writeAll(pipe, pack(mesh(request)));
    // Not exit(): after an error TetGen's destructors free memory twice.
    _exit(written ? 0 : 1);
}
