#include "core/meshing/surface_fixes.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/meshing/sound_part.h"
#include "core/meshing/surface_edges.h"
#include "core/meshing/surface_holes.h"

namespace wend {
namespace {

class Fixer {
  public:
    explicit Fixer(const Surface& surface) : m_all(surface), m_gone(surface.triangles.size(), false) {}

    /// Applies one step. Throws InputError if it names a triangle that does not exist any more.
    void apply(const SurfaceFix& fix) {
        if (fix.kind == SurfaceFix::Kind::Fill) return fill(fix.ids);
        m_holes.clear();
        for (const int triangle : fix.ids) {
            if (triangle < 0 || triangle >= m_all.triangleCount() || m_gone[triangle])
                throw InputError({sentence("Core", "there is no triangle %1"), triangle});
            if (fix.kind == SurfaceFix::Kind::Drop)
                m_gone[triangle] = true;
            else
                turn(triangle);
        }
    }

    FixedSurface result() const {
        FixedSurface fixed{{m_all.points, {}, {}}, {}};
        for (int t = 0; t < m_all.triangleCount(); ++t) {
            if (m_gone[t]) continue;
            fixed.surface.triangles.push_back(m_all.triangles[t]);
            if (!m_all.labels.empty()) fixed.surface.labels.push_back(m_all.labels[t]);
            fixed.numbers.push_back(t);
        }
        return fixed;
    }

  private:
    void turn(int triangle) {
        const FixedSurface now = result();
        const auto place = std::ranges::lower_bound(now.numbers, triangle) - now.numbers.begin();
        for (const int t : SoundPart(now.surface).patchOf(static_cast<int>(place))) {
            auto& ids = m_all.triangles[now.numbers[t]];
            std::swap(ids[1], ids[2]);
        }
    }

    void fill(const std::vector<int>& edge) {
        if (fillKnown(edge)) return;
        m_holes = holesOf(SoundPart(result().surface).surface);
        if (!fillKnown(edge))
            throw InputError({sentence("Core", "no hole has the edge %1"),
                              std::to_string(edge[0]) + "–" + std::to_string(edge[1])});
    }

    bool fillKnown(const std::vector<int>& edge) {
        const auto hole = std::ranges::find_if(m_holes, [&](const std::vector<int>& loop) {
            return std::ranges::count(sidesOf(loop), sorted(edge.at(0), edge.at(1))) > 0;
        });
        if (hole == m_holes.end()) return false;
        fillHole(m_all, *hole);
        m_gone.resize(m_all.triangles.size(), false);
        m_holes.erase(hole);
        return true;
    }

    Surface m_all;                          // including removed triangles
    std::vector<bool> m_gone;               // triangles
    std::vector<std::vector<int>> m_holes;  // if they are known
};

}  // namespace

FixedSurface fixSurface(const Surface& surface, const std::vector<SurfaceFix>& fixes) {
    Fixer fixer(surface);
    for (std::size_t i = 0; i < fixes.size(); ++i) try {
            fixer.apply(fixes[i]);
        } catch (const InputError& error) {
            throw InputError("fixes[" + std::to_string(i) + "]: " + error.message());
        }
    return fixer.result();
}

}  // namespace wend
