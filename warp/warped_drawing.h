#pragma once

#include <functional>
#include <pugixml.hpp>
#include <set>
#include <string>

#include "warp/blend_mode.h"
#include "warp/image.h"
#include "warp/plane_map.h"
#include "warp/vector_drawing.h"

namespace wend {

/// The distance in pixels that the curves of an SVG file keep from where the map takes them.
inline constexpr double kCurveTolerance = 0.05;

/// A PNG file at a place of the plane.
struct PlacedPng {
    std::string bytes;
    Vec2 at = Vec2::Zero();
    int width = 0, height = 0;
};

/// Carries a picture with its first pixel at that place at rest.
using WarpToPng = std::function<PlacedPng(const Image& picture, const Vec2& at)>;

/// A drawing, or a picture in the place of one, in an SVG file.
struct SvgGroup {
    std::string name;  // empty: it is all of the file
    double opacity = 1;
    bool hidden = false;
    BlendMode blend = BlendMode::Normal;
};

/// The document that an SVG file is.
struct SvgPage {
    std::array<double, 4> viewBox{0, 0, 1, 1};
    std::string width, height;
    Affine fromPixels;    // of the plane to the coordinates of the view box
    std::string outside;  // the colour behind all of it; empty: none
};

/// Puts an SVG file together, from back to front.
class SvgFile {
  public:
    explicit SvgFile(const SvgPage& page);

    /// Adds a drawing whose pixels are at `shift` at rest, carried by a map.
    void add(const SvgGroup& group, const VectorDrawing& drawing, const Vec2& shift, const PlaneMap& map,
             const WarpToPng& warp);
    void add(const SvgGroup& group, const PlacedPng& png);
    std::string text() const;

  private:
    class Carrier;
    pugi::xml_node begin(const SvgGroup& group, const char* kind);
    void giveOwnIds(pugi::xml_node drawing);

    SvgPage m_page;
    pugi::xml_document m_document;
    pugi::xml_node m_root;
    std::set<std::string> m_ids;
};

}  // namespace wend
