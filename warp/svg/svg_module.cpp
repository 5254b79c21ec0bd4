// The module that draws SVG files: Qt's library, in the process that reads pictures.

#include <QBuffer>
#include <QGuiApplication>
#include <QImage>
#include <QSvgRenderer>
#include <algorithm>
#include <array>
#include <cmath>
#include <pugixml.hpp>
#include <sstream>

#include "core/base/error.h"
#include "warp/layered_file.h"
#include "warp/svg/svg_painter.h"
#include "warp/svg/vector_maker.h"
#include "warp/svg_layers.h"

namespace wend {
namespace {

constexpr double kFewestPixels = 1024;  // of the longer side: small drawings are drawn larger

/// Fonts need an application, which has no display here.
void needApplication() {
    if (QCoreApplication::instance()) return;
    static int count = 1;
    static char name[] = "wend-picture";
    static char* arguments[] = {name, nullptr};
    qputenv("QT_QPA_PLATFORM", "offscreen");
    static QGuiApplication application(count, arguments);
}

std::vector<pugi::xml_node> drawnIn(const pugi::xml_node& parent) {
    std::vector<pugi::xml_node> nodes;
    for (const pugi::xml_node& node : parent.children())
        if (isDrawn(node)) nodes.push_back(node);
    return nodes;
}

bool isGroup(const pugi::xml_node& node) {
    return std::string_view(node.name()) == "g";
}

/// Returns the node whose children are the layers: the drawing, or the one group that holds all of it and has
/// groups itself.
pugi::xml_node layerParent(pugi::xml_node node) {
    for (auto nodes = drawnIn(node); nodes.size() == 1 && isGroup(nodes.front()); nodes = drawnIn(node)) {
        if (std::ranges::none_of(drawnIn(nodes.front()), isGroup)) break;
        node = nodes.front();
    }
    return node;
}

/// Returns a value of a node's style, or of the attribute of that name.
std::string styleOf(const pugi::xml_node& node, const std::string& key) {
    std::istringstream style(node.attribute("style").value());
    for (std::string one; std::getline(style, one, ';');) {
        std::erase(one, ' ');
        if (one.starts_with(key + ":")) return one.substr(key.size() + 1);
    }
    return node.attribute(key.c_str()).value();
}

/// A layer: a group, or shapes that follow one another beside groups.
struct SvgLayer {
    std::vector<pugi::xml_node> nodes;
    PictureLayer layer;
};

std::string nameOf(const pugi::xml_node& node) {
    for (const char* key : {"inkscape:label", "id"})
        if (const std::string name = node.attribute(key).value(); !name.empty()) return name;
    return isGroup(node) ? "group" : "shapes";
}

/// Returns the layers from front to back.
std::vector<SvgLayer> layersIn(const pugi::xml_node& parent) {
    std::vector<SvgLayer> layers;
    for (const pugi::xml_node& node : drawnIn(parent)) {
        const bool continues = !layers.empty() && !isGroup(node) && !isGroup(layers.back().nodes.back());
        if (!continues) {
            layers.emplace_back();
            PictureLayer& layer = layers.back().layer;
            layer.name = nameOf(node);
            layer.visible = !isGroup(node) || styleOf(node, "display") != "none";
            layer.blend = isGroup(node) ? styleOf(node, "mix-blend-mode") : std::string();
            if (layer.blend.empty()) layer.blend = "normal";
            if (layer.blend == "plus-lighter") layer.blend = "plus";
        }
        layers.back().nodes.push_back(node);
    }
    std::ranges::reverse(layers);
    std::vector<std::string*> names;
    for (SvgLayer& layer : layers) names.push_back(&layer.layer.name);
    giveOwnNames(names);
    return layers;
}

/// Shows a hidden layer, because the program itself hides layers.
void show(pugi::xml_node node) {
    if (std::string_view(node.attribute("display").value()) == "none") node.remove_attribute("display");
    std::string style = node.attribute("style").value();
    for (const std::string_view hides : {"display:none", "display: none"})
        if (const auto at = style.find(hides); at != std::string::npos) style.erase(at, hides.size());
    if (node.attribute("style")) node.attribute("style").set_value(style.c_str());
}

class SvgDrawing {
  public:
    SvgDrawing(const std::string& svg, const DrawnSize& size) {
        needApplication();
        if (!m_document.load_buffer(svg.data(), svg.size(), pugi::parse_default | pugi::parse_ws_pcdata))
            throw InputError("is damaged (not valid XML)");
        m_layers = layersIn(layerParent(m_document.document_element()));
        const QSvgRenderer renderer(bytesOf(svg));
        if (!renderer.isValid() || renderer.defaultSize().isEmpty())
            throw InputError("has no drawing of a size");
        const QSize own = renderer.defaultSize();
        const double longer = std::max(own.width(), own.height());
        const double scale = std::max(1.0, std::ceil(kFewestPixels / longer));
        if (scale * scale * 1e-6 * own.width() * own.height() > kMaxMegapixels && size[0] == 0)
            throw InputError("is larger than 400 million pixels");
        m_viewBox = renderer.viewBoxF();
        m_size = size[0] > 0 ? sizeLike(own, size) : own * scale;
    }

    /// Returns all of it.
    DrawnSvg drawn() const {
        DrawnSvg result{layers(), pngOf(paintedSvg(m_document, m_viewBox, m_size))};
        for (std::size_t k = 0; k < m_layers.size(); ++k) {
            const QRect seen = seenOf(pictureOf(k));
            PictureLayer& layer = result.layers[k];
            layer.x = seen.x(), layer.y = seen.y(), layer.width = seen.width(), layer.height = seen.height();
        }
        return result;
    }

    /// Returns all of it, or one layer, as paths.
    VectorDrawing vectors(const std::string& name) const {
        pugi::xml_document alone;
        if (name.empty())
            alone.reset(m_document);
        else
            keepAlone(layerNamed(layers(), name), alone);
        return vectorsOf(alone, m_viewBox, m_size);
    }

    DrawnSvg drawn(const std::string& name) const {
        const QImage image = pictureOf(layerNamed(layers(), name));
        const QRect seen = seenOf(image);
        if (seen.isEmpty()) throw InputError("shows nothing of its layer \"" + name + '"');
        return {{}, pngOf(image.copy(seen))};
    }

  private:
    /// Returns the size that was asked for if it has the proportions of the view box or, within rounding, of
    /// the drawing's own size; otherwise the height follows them.
    QSize sizeLike(const QSize& own, const DrawnSize& asked) const {
        const double high = static_cast<double>(asked[0]) * own.height() / own.width();
        const double exact = asked[0] * m_viewBox.height() / m_viewBox.width();
        const auto isAsked = [&](double height) { return std::abs(height - asked[1]) <= 1; };
        const bool isPlain = std::abs(own.width() * exact / asked[0] - own.height()) <= 1;  // not stretched
        const double rows =
            isAsked(high) || isAsked(exact) ? asked[1] : std::max(1.0, std::round(isPlain ? exact : high));
        if (1e-6 * asked[0] * rows > kMaxMegapixels) throw InputError("is larger than 400 million pixels");
        return {asked[0], static_cast<int>(rows)};
    }

    static QByteArray bytesOf(const std::string& text) {
        return {text.data(), static_cast<qsizetype>(text.size())};
    }
    static std::string pngOf(const QImage& image) {
        QBuffer buffer;
        buffer.open(QIODevice::WriteOnly);
        image.convertToFormat(QImage::Format_RGBA8888).save(&buffer, "PNG", 80);
        return buffer.data().toStdString();
    }

    /// Draws one layer within the groups that it is in.
    QImage pictureOf(std::size_t layer) const {
        pugi::xml_document alone;
        keepAlone(layer, alone);
        return paintedSvg(alone, m_viewBox, m_size);
    }
    void keepAlone(std::size_t layer, pugi::xml_document& alone) const {
        alone.reset(m_document);
        pugi::xml_node parent = layerParent(alone.document_element());
        const std::vector<pugi::xml_node> own = layersIn(parent)[layer].nodes;
        for (const pugi::xml_node& node : drawnIn(parent))
            if (std::ranges::find(own, node) == own.end()) parent.remove_child(node);
        if (isGroup(own.front())) show(own.front());
    }

    /// Returns the box of what is not transparent; empty if all is.
    static QRect seenOf(const QImage& image) {
        int left = image.width(), top = image.height(), right = 0, bottom = 0;
        for (int y = 0; y < image.height(); ++y) {
            const auto* row = reinterpret_cast<const std::array<uchar, 4>*>(image.constScanLine(y));
            const auto isSeen = [](const std::array<uchar, 4>& pixel) { return pixel[3] != 0; };
            const auto* const first = std::find_if(row, row + image.width(), isSeen);
            if (first == row + image.width()) continue;
            int last = image.width();
            while (row[last - 1][3] == 0) --last;
            left = std::min(left, static_cast<int>(first - row)), right = std::max(right, last);
            top = std::min(top, y), bottom = y + 1;
        }
        return bottom > 0 ? QRect(left, top, right - left, bottom - top) : QRect(0, 0, 0, 0);
    }

    std::vector<PictureLayer> layers() const {
        std::vector<PictureLayer> layers;
        for (const SvgLayer& layer : m_layers) layers.push_back(layer.layer);
        return layers;
    }

    pugi::xml_document m_document;
    std::vector<SvgLayer> m_layers;
    QSize m_size;
    QRectF m_viewBox;
};

class QtSvg final : public SvgLibrary {
  public:
    DrawnSvg draw(const std::string& svg, const std::string& layer, const DrawnSize& size) const override {
        const SvgDrawing drawing(svg, size);
        return layer.empty() ? drawing.drawn() : drawing.drawn(layer);
    }
    VectorDrawing vectors(const std::string& svg, const std::string& layer,
                          const DrawnSize& size) const override {
        return SvgDrawing(svg, size).vectors(layer);
    }
};

}  // namespace
}  // namespace wend

extern "C" __attribute__((visibility("default"))) const wend::SvgLibrary* wendSvgLibrary() {
    static const wend::QtSvg library;
    return &library;
}
