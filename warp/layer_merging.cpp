#include "warp/layer_merging.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "warp/blend_mode.h"
#include "warp/convert.h"
#include "warp/layered_file.h"

namespace wend {
namespace {

/// A layer or group in the tree of a file.
struct LayerNode {
    const PictureLayer* layer = nullptr;  // null: it is a group
    LayerGroup group;
    std::vector<LayerNode> below = {};  // the layers of the group, from back to front

    const std::string& name() const { return layer ? layer->name : group.name; }
    bool isRead() const {
        return layer ? layer->unread.empty() : std::ranges::any_of(below, &LayerNode::isRead);
    }
    bool isShown() const {
        return layer ? layer->visible && layer->unread.empty()
                     : group.visible && std::ranges::any_of(below, &LayerNode::isShown);
    }
    bool isClipped() const { return layer ? layer->clipped : group.clipped; }
    bool isAtop() const { return layer ? layer->atop : group.atop; }
    double opacity() const { return layer ? layer->ownOpacity : group.opacity; }
    const std::string& blend() const { return layer ? layer->blend : group.blend; }
    /// Returns whether its layers can be in the list of the group around it.
    bool isPassedThrough() const {
        return !layer && !group.isolated && isPlainBlend(group.blend) && group.opacity == 1;
    }
};

using Nodes = std::vector<LayerNode>;

/// Returns the tree of layers from back to front; those in [begin, end) are in the same groups up to `depth`.
Nodes treeOf(const std::vector<const PictureLayer*>& layers, std::size_t begin, std::size_t end,
             std::size_t depth) {
    Nodes nodes;
    for (std::size_t i = begin; i < end;) {
        const PictureLayer& first = *layers[i];
        std::size_t next = i + 1;
        LayerNode& node = nodes.emplace_back();
        if (first.groups.size() <= depth) {
            node.layer = &first;
        } else {
            node.group = first.groups[depth];
            while (next < end && layers[next]->groups.size() > depth &&
                   layers[next]->groups[depth].id == node.group.id)
                ++next;
            node.below = treeOf(layers, i, next, depth + 1);
        }
        i = next;
    }
    return nodes;
}

Nodes treeOf(const std::vector<PictureLayer>& fromFront) {
    std::vector<const PictureLayer*> layers;
    for (std::size_t i = fromFront.size(); i-- > 0;) layers.push_back(&fromFront[i]);
    return treeOf(layers, 0, layers.size(), 0);
}

/// Returns the number of nodes behind `base` that it clips.
std::size_t clippedBy(const Nodes& nodes, std::size_t base) {
    std::size_t count = 0;
    while (base + 1 + count < nodes.size() && nodes[base + 1 + count].isClipped()) ++count;
    return count;
}

/// A node of a list that is drawn with those that it clips.
struct DrawnNode {
    std::size_t base = 0, clips = 0;
    bool isAtop = false;  // it leaves the alpha of what is below it in the list
};
std::vector<DrawnNode> drawnOf(const Nodes& nodes) {
    std::vector<DrawnNode> drawn;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const bool isByNext = i + 1 < nodes.size() && !nodes[i + 1].isAtop();
        const std::size_t clips = nodes[i].isRead() && isByNext ? clippedBy(nodes, i) : 0;
        if (nodes[i].isShown()) drawn.push_back({i, clips, nodes[i].isAtop() && i > 0});
        i += clips;
    }
    return drawn;
}

void addNames(const LayerNode& node, std::vector<std::string>& names) {
    if (node.layer && node.isShown()) names.push_back(node.layer->name);
    for (const LayerNode& one : node.below)
        if (node.isShown()) addNames(one, names);
}

/// The shown layers of a group, and how many of them are merely laid over one another.
struct GroupCount {
    int shown = 0, plain = 0;
};
GroupCount countOf(const LayerNode& node) {
    GroupCount count;
    if (node.layer) {
        const bool isPlain = isPlainBlend(node.blend()) && !node.isClipped() && !node.isAtop();
        return {node.isShown() ? 1 : 0, node.isShown() && isPlain ? 1 : 0};
    }
    for (const LayerNode& one : node.below) {
        const GroupCount of = countOf(one);
        count.shown += of.shown, count.plain += of.plain;
    }
    return count;
}

bool mustMerge(const LayerNode& node) {
    if (node.layer || !node.isShown()) return false;
    if (!isPlainBlend(node.group.blend)) return true;
    const GroupCount count = countOf(node);
    return count.shown > 1 && (node.group.opacity < 1 || (node.group.isolated && count.plain == 1));
}

/// Makes the list of what is shown, from back to front.
class ShownLister {
  public:
    std::vector<ShownLayer> list(const std::vector<PictureLayer>& layers) {
        walk(treeOf(layers), 1, true);
        giveNames(layers);
        std::ranges::reverse(m_shown);
        return std::move(m_shown);
    }

  private:
    void walk(const Nodes& nodes, double opacity, bool visible) {
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            const std::size_t clips = nodes[i].isRead() ? clippedBy(nodes, i) : 0;
            const auto first = nodes.begin() + static_cast<std::ptrdiff_t>(i);
            const auto last = first + 1 + static_cast<std::ptrdiff_t>(clips);
            const bool clipsAny =
                std::any_of(first + 1, last, [](const LayerNode& one) { return one.isShown(); });
            if (nodes[i].isShown() && (clipsAny || mustMerge(nodes[i]))) {
                merge({first, last}, opacity, visible);
                for (auto one = first; one != last; ++one) putHidden(*one);
                i += clips;
            } else {
                if (!nodes[i].layer)
                    walk(nodes[i].below, opacity * nodes[i].group.opacity, visible && nodes[i].group.visible);
                put(nodes[i]);
            }
        }
    }

    void put(const LayerNode& node) {
        if (node.layer && node.isRead()) m_shown.push_back({*node.layer, node.layer->name});
    }

    /// Puts what of merged nodes is not shown.
    void putHidden(const LayerNode& node) {
        if (node.layer && !node.isShown()) put(node);
        for (const LayerNode& one : node.below) putHidden(one);
    }

    void merge(const Nodes& nodes, double opacity, bool visible) {
        const LayerNode& base = nodes.front();
        ShownLayer one;
        one.name = one.layer.name = base.name();
        one.layer.blend = isPlainBlend(base.blend()) ? "normal" : base.blend();
        one.layer.opacity = one.layer.ownOpacity = opacity * base.opacity();
        one.layer.visible = visible;
        for (const LayerNode& node : nodes) {
            if (!node.isShown()) continue;
            if (&node != &base) one.layer.name += " + " + node.name();
            addNames(node, one.merges);
            addLeftOut(node, one.layer.leftOut);
        }
        addBox(base, one.layer);
        m_shown.push_back(std::move(one));
    }

    static void addLeftOut(const LayerNode& node, std::vector<std::string>& leftOut) {
        if (!node.isShown()) return;
        for (const LayerNode& one : node.below) addLeftOut(one, leftOut);
        if (!node.layer) return;
        leftOut.insert(leftOut.end(), node.layer->leftOut.begin(), node.layer->leftOut.end());
    }

    /// Adds the box of the picture that LayerMerger draws: what is clipped does not reach beyond its base.
    static void addBox(const LayerNode& node, PictureLayer& all) {
        for (const DrawnNode& one : drawnOf(node.below))
            if (!one.isAtop) addBox(node.below[one.base], all);
        if (!node.layer) return;
        const PictureLayer& own = *node.layer;
        const bool isFirst = all.width == 0;
        const int x = isFirst ? own.x : std::min(all.x, own.x), y = isFirst ? own.y : std::min(all.y, own.y);
        all.width = std::max(isFirst ? 0 : all.x + all.width, own.x + own.width) - x;
        all.height = std::max(isFirst ? 0 : all.y + all.height, own.y + own.height) - y;
        all.x = x, all.y = y;
    }

    /// Merged pictures have other names than all layers.
    void giveNames(std::vector<PictureLayer> layers) {
        std::vector<std::string*> names;
        for (PictureLayer& layer : layers) names.push_back(&layer.name);
        for (ShownLayer& one : m_shown)
            if (!one.merges.empty()) names.push_back(&one.layer.name);
        giveOwnNames(names);
    }

    std::vector<ShownLayer> m_shown;
};

constexpr PixelLayout kFloats{PixelType::Float, 4, true, false};

/// Floats with associated colours at a place of the file's picture.
struct MergedSheet {
    Image picture;
    int x = 0, y = 0;

    float* at(int column, int row) {
        return reinterpret_cast<float*>(picture.row(row - y)) + std::ptrdiff_t{4} * (column - x);
    }
};

/// Composites nodes of the tree.
class LayerMerger {
  public:
    LayerMerger(const std::function<Image(const std::string&)>& read, std::vector<Message>* notices)
        : m_read(read), m_notices(notices) {}

    /// Composites a node with those that it clips; their own opacity and mode are left to the caller.
    MergedSheet clipped(const Nodes& nodes, std::size_t base, std::size_t clips) {
        MergedSheet sheet = drawn(nodes[base]);
        for (std::size_t i = base + 1; i <= base + clips; ++i) {
            if (!nodes[i].isShown()) continue;
            MergedSheet above = drawn(nodes[i]);
            layAtop(above, nodes[i].opacity(), modeOf(nodes[i]), sheet);
        }
        return sheet;
    }

    const std::optional<PixelLayout>& layout() const { return m_layout; }
    const std::shared_ptr<const Image::Metadata>& metadata() const { return m_metadata; }

  private:
    BlendMode modeOf(const LayerNode& node) {
        if (isPlainBlend(node.blend())) return BlendMode::Normal;
        const auto mode = blendNamed(node.blend());
        if (!mode && m_notices)
            m_notices->push_back(
                {sentence("Core", "the layer \"%1\" has the blend mode %2: it is shown as normal"),
                 node.name(), node.blend()});
        return mode.value_or(BlendMode::Normal);
    }

    MergedSheet drawn(const LayerNode& node) {
        MergedSheet sheet;
        if (!node.layer) {
            layAll(node.below, sheet);
            return sheet;
        }
        const Image picture = m_read(node.layer->name);
        if (!m_layout) m_layout = PixelLayout{picture.type, 4, true, true}, m_metadata = picture.metadata;
        return {converted(picture, kFloats), node.layer->x, node.layer->y};
    }

    void layAll(const Nodes& nodes, MergedSheet& sheet) {
        for (const auto [base, clips, isAtop] : drawnOf(nodes)) {
            const LayerNode& node = nodes[base];
            if (clips == 0 && node.isPassedThrough()) {
                layAll(node.below, sheet);
                continue;
            }
            MergedSheet above = clipped(nodes, base, clips);
            if (isAtop)
                layAtop(above, node.opacity(), modeOf(node), sheet);
            else
                layOver(above, node.opacity(), modeOf(node), sheet);
        }
    }

    /// Makes room for another sheet.
    static void widen(MergedSheet& sheet, const MergedSheet& by) {
        if (sheet.picture.width == 0) sheet.x = by.x, sheet.y = by.y;
        const int x = std::min(sheet.x, by.x), y = std::min(sheet.y, by.y),
                  right = std::max(sheet.x + sheet.picture.width, by.x + by.picture.width),
                  bottom = std::max(sheet.y + sheet.picture.height, by.y + by.picture.height);
        MergedSheet wide;
        wide.picture = Image{right - x, bottom - y, kFloats.channels, kFloats.type, true, false, {}, {}};
        wide.picture.makePixels();
        wide.x = x, wide.y = y;
        for (int row = 0; row < sheet.picture.height; ++row)
            std::copy_n(sheet.at(sheet.x, sheet.y + row), 4 * sheet.picture.width,
                        wide.at(sheet.x, sheet.y + row));
        sheet = std::move(wide);
    }

    static void layOver(MergedSheet& above, double opacity, BlendMode mode, MergedSheet& below) {
        widen(below, above);
        const auto share = static_cast<float>(opacity);
        for (int y = above.y; y < above.y + above.picture.height; ++y)
            for (int x = above.x; x < above.x + above.picture.width; ++x) {
                const float* top = above.at(x, y);
                float* const under = below.at(x, y);
                const float alpha = share * top[3];
                for (int c = 0; c < 3; ++c)
                    under[c] = blendedColour(mode, share * top[c], alpha, under[c], under[3], false);
                under[3] = alpha + (1 - alpha) * under[3];
            }
    }

    /// Blends with the colours below as if these were opaque, and leaves their alpha.
    static void layAtop(MergedSheet& above, double opacity, BlendMode mode, MergedSheet& below) {
        const int left = std::max(above.x, below.x), top = std::max(above.y, below.y),
                  right = std::min(above.x + above.picture.width, below.x + below.picture.width),
                  bottom = std::min(above.y + above.picture.height, below.y + below.picture.height);
        const auto share = static_cast<float>(opacity);
        for (int y = top; y < bottom; ++y)
            for (int x = left; x < right; ++x) {
                const float* over = above.at(x, y);
                float* const under = below.at(x, y);
                const float alpha = under[3];
                for (int c = 0; alpha > 0 && c < 3; ++c)
                    under[c] = alpha * blendedColour(mode, share * over[c], share * over[3], under[c] / alpha,
                                                     1.0F, false);
            }
    }

    const std::function<Image(const std::string&)>& m_read;
    std::vector<Message>* m_notices;
    std::optional<PixelLayout> m_layout;
    std::shared_ptr<const Image::Metadata> m_metadata;
};

/// Finds the nodes of a shown layer: the one at the back by its first layer, and those in front of it that it
/// clips.
bool findNodes(const Nodes& nodes, const ShownLayer& shown, const Nodes*& in, std::size_t& base) {
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        std::vector<std::string> names;
        const std::size_t clips = clippedBy(nodes, i);
        for (std::size_t k = i; k <= i + clips; ++k) addNames(nodes[k], names);
        if (names == shown.merges && nodes[i].name() == shown.name) {
            in = &nodes, base = i;
            return true;
        }
        if (findNodes(nodes[i].below, shown, in, base)) return true;
    }
    return false;
}

}  // namespace

std::vector<PictureLayer> fromTheFront(std::vector<PictureLayer> layers, PictureFormat format) {
    if (format == PictureFormat::Psd || format == PictureFormat::Tiff) std::ranges::reverse(layers);
    return layers;
}

std::vector<ShownLayer> shownLayers(const std::vector<PictureLayer>& layers) {
    return ShownLister().list(layers);
}

MergedPicture mergedPicture(const std::vector<PictureLayer>& layers, const ShownLayer& shown,
                            const std::function<Image(const std::string& layer)>& read,
                            std::vector<Message>* notices) {
    const Nodes tree = treeOf(layers);
    const Nodes* nodes = nullptr;
    std::size_t base = 0;
    if (!findNodes(tree, shown, nodes, base)) return {};
    LayerMerger merger(read, notices);
    MergedSheet sheet = merger.clipped(*nodes, base, clippedBy(*nodes, base));
    sheet.picture.metadata = merger.metadata();
    return {converted(sheet.picture, merger.layout().value_or(kFloats)), sheet.x, sheet.y};
}

}  // namespace wend
