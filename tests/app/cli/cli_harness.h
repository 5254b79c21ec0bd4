#pragma once

#include <QProcess>
#include <QProcessEnvironment>
#include <QString>
#include <QStringList>
#include <filesystem>
#include <string>

#include "app/project/file/text_file.h"
#include "core/mesh/simplicial_mesh.h"
#include "tests/support/quoted.h"
#include "warp/image.h"

/// The real program, run in a folder.
struct CliResult {
    int code = -1;
    QString out, error;
    bool crashed = false;
};

inline CliResult runCli(const QString& folder, const QStringList& arguments,
                        const QProcessEnvironment& environment,
                        const QString& program = QStringLiteral(WEND_BINARY)) {
    QProcess process;
    process.setWorkingDirectory(folder);
    process.setProcessEnvironment(environment);
    process.start(program, arguments);
    process.waitForFinished(120000);
    return {process.exitCode(), QString::fromUtf8(process.readAllStandardOutput()),
            QString::fromUtf8(process.readAllStandardError()), process.exitStatus() != QProcess::NormalExit};
}

inline CliResult runCli(const QString& folder, const QStringList& arguments) {
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.remove("DISPLAY");  // subcommands need none
    environment.remove("QT_QPA_PLATFORM");
    return runCli(folder, arguments, environment);
}

inline void put(const QString& folder, const char* name, const std::string& text) {
    wend::writeTextFile((folder + "/" + name).toStdString(), text);
}

/// Writes a project in JSON, with ' for ".
inline void putProject(const QString& folder, const char* name, const std::string& rest) {
    put(folder, name, json("{'format': 'wend', 'version': 1, " + rest + "}"));
}

/// Returns the motion of a handle that moves by @p there in one unit of time and back in the next, 10,000
/// times over; no machine completes it before a test stops the run.
inline std::string endlessMotion(const char* there, const char* back) {
    std::string motion = "'motion': [";
    for (int k = 0; k < 10000; ++k) {
        const std::string time = std::to_string(k) + ", " + std::to_string(k + 1);
        motion += (k > 0 ? ", " : "") + std::string("{'kind': 'translate', 'by': ") +
                  (k % 2 == 0 ? there : back) + ", 'time': [" + time + "]}";
    }
    return motion + "]";
}

/// Returns nx × ny unit squares, each of two triangles, with the points row by row.
inline wend::SimplicialMesh<2> stripMesh(int nx, int ny) {
    wend::SimplicialMesh<2> mesh;
    mesh.points.resize(2, (nx + 1) * (ny + 1));
    const auto id = [nx](int i, int j) { return j * (nx + 1) + i; };
    for (int j = 0; j <= ny; ++j)
        for (int i = 0; i <= nx; ++i) mesh.points.col(id(i, j)) << i, j;
    for (int j = 0; j < ny; ++j)
        for (int i = 0; i < nx; ++i) {
            mesh.cells.push_back({id(i, j), id(i + 1, j), id(i + 1, j + 1)});
            mesh.cells.push_back({id(i, j), id(i + 1, j + 1), id(i, j + 1)});
        }
    return mesh;
}

/// Returns a block of nx × ny × nz unit cubes, each of six tetrahedra around its diagonal.
inline wend::SimplicialMesh<3> blockMesh(int nx, int ny, int nz) {
    wend::SimplicialMesh<3> mesh;
    mesh.points.resize(3, (nx + 1) * (ny + 1) * (nz + 1));
    const auto id = [nx, ny](int i, int j, int k) { return (k * (ny + 1) + j) * (nx + 1) + i; };
    for (int k = 0; k <= nz; ++k)
        for (int j = 0; j <= ny; ++j)
            for (int i = 0; i <= nx; ++i) mesh.points.col(id(i, j, k)) << i, j, k;
    const int paths[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {1, 0, 2}, {0, 2, 1}, {2, 1, 0}};
    for (int k = 0; k < nz; ++k)
        for (int j = 0; j < ny; ++j)
            for (int i = 0; i < nx; ++i)
                for (int p = 0; p < 6; ++p) {
                    int at[3] = {i, j, k};
                    wend::Cell<3> cell{id(i, j, k), 0, 0, 0};
                    for (int step = 0; step < 3; ++step) {
                        ++at[paths[p][step]];
                        cell[step + 1] = id(at[0], at[1], at[2]);
                    }
                    if (p >= 3) std::swap(cell[2], cell[3]);
                    mesh.cells.push_back(cell);
                }
    return mesh;
}

/// Returns a bar of 2 × 2 × n unit cubes along z.
inline wend::SimplicialMesh<3> barMesh(int n) {
    return blockMesh(2, 2, n);
}

/// Returns a picture of an opaque disc on a transparent ground.
inline wend::Image discPicture(int size, double radius) {
    wend::Image image;
    image.width = image.height = size;
    image.channels = 4;
    image.alpha = image.unassociated = true;
    image.data.resize(static_cast<std::size_t>(size) * size * 4);
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const bool inside = std::hypot(x + 0.5 - size / 2.0, y + 0.5 - size / 2.0) < radius;
            std::byte* pixel = image.row(y) + 4 * x;
            if (!inside) continue;
            pixel[0] = std::byte((x * 5) % 256);
            pixel[1] = std::byte((y * 3) % 256);
            pixel[2] = std::byte((x * y) % 256);
            pixel[3] = std::byte(255);
        }
    return image;
}
