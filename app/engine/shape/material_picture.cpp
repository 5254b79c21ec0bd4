#include "app/engine/shape/material_picture.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "app/engine/shape/material_raster.h"
#include "app/engine/shape/part_pictures.h"
#include "app/project/domain.h"
#include "app/project/file/named_files.h"
#include "core/base/error.h"
#include "core/energy/energy_stops.h"
#include "core/mesh/mesh_of_file.h"
#include "warp/convert.h"
#include "warp/drawn_picture.h"

namespace wend {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kMostMegapixels = 100;  // of a picture that is read: it is held as numbers
constexpr int kMeshPixels = 2048;        // the longer side of a picture of a mesh
constexpr double kLastStop = kEnergyStops - 1;

/// Maps domain coordinates to pixels of a picture: the box becomes width × height.
class ToPixels {
  public:
    ToPixels(const Box<2>& box, bool up, int width, int height)
        : m_corner(box.min.x(), up ? box.max.y() : box.min.y()),
          m_scale(width / (box.max.x() - box.min.x()), height / (box.max.y() - box.min.y())) {
        if (up) m_scale.y() = -m_scale.y();
    }
    Vec2 operator()(const Vec2& p) const { return (p - m_corner).cwiseProduct(m_scale); }

  private:
    Vec2 m_corner, m_scale;
};

/// Calls the function for every pixel whose centre is inside the triangle.
template <class Take>
void forPixelsIn(const std::array<Vec2, 3>& corners, int width, int height, const Take& take) {
    Vec2 low = corners[0], high = corners[0];
    for (const Vec2& p : corners) low = low.cwiseMin(p), high = high.cwiseMax(p);
    const Vec2 u = corners[1] - corners[0], v = corners[2] - corners[0];
    const double area = u.x() * v.y() - u.y() * v.x();
    if (area == 0) return;
    const auto first = [](double x) { return static_cast<int>(std::ceil(std::max(x, 0.0) - 0.5)); };
    const int right = static_cast<int>(std::min<double>(width, std::floor(high.x() + 0.5)));
    const int bottom = static_cast<int>(std::min<double>(height, std::floor(high.y() + 0.5)));
    for (int y = std::max(0, first(low.y())); y < bottom; ++y)
        for (int x = std::max(0, first(low.x())); x < right; ++x) {
            const Vec2 w = Vec2(x + 0.5, y + 0.5) - corners[0];
            const double a = (w.x() * v.y() - w.y() * v.x()) / area;
            const double b = (u.x() * w.y() - u.y() * w.x()) / area;
            if (a >= 0 && b >= 0 && a + b <= 1) take(x, y);
        }
}

std::array<Vec2, 3> cornersOf(const SimplicialMesh<2>& rest, const Cell<2>& cell, const ToPixels& toPixels) {
    return {toPixels(rest.points.col(cell[0])), toPixels(rest.points.col(cell[1])),
            toPixels(rest.points.col(cell[2]))};
}

/// Returns the angle of an axis to the horizontal, in [0, 1[ half turns.
double halfTurns(const Vec2& axis, bool up) {
    const double turns = std::atan2(up ? axis.y() : -axis.y(), axis.x()) / kPi;
    return turns - std::floor(turns);
}

double grayOf(MaterialPart part, const Material<2>& material, int cell, bool up) {
    if (part == MaterialPart::Keep) return stopOfPhi(material.phi[cell], 2) / kLastStop;
    if (material.anisotropy.empty()) return 0;
    const Stiffness stiffness = stiffnessOf<2>(material.anisotropy[cell]);
    if (part == MaterialPart::Stiffness) return std::log(stiffness.ratio) / std::log(kStiffestGray);
    return stiffness.ratio > 1 + 1e-9 ? halfTurns(inPlane(stiffness.axis), up) : 0;
}

// --- Reading ---

/// The value of a cell in a picture: the painted fraction and the mean, of numbers or of angles (doubled,
/// since 0° and 180° are equal).
struct Found {
    double weight = 0;
    double value = 0;
};

/// A picture as gray in [0, 1] and weights.
class GrayPicture {
  public:
    explicit GrayPicture(const std::string& path) {
        const Image image = readImage(path, kMostMegapixels);
        m_width = image.width, m_height = image.height;
        const auto channels = static_cast<std::size_t>(image.channels);
        std::vector<float> row(static_cast<std::size_t>(m_width) * channels);
        for (int y = 0; y < m_height; ++y) {
            loadRow(image, y, row.data());
            for (std::size_t x = 0; x < row.size(); x += channels) add(image, row.data() + x);
        }
    }

    int width() const { return m_width; }
    int height() const { return m_height; }

    /// Returns the mean over a triangle, or at its centroid if it contains no pixel centre.
    template <class Mean>
    Found over(const std::array<Vec2, 3>& corners, Mean mean) const {
        forPixelsIn(corners, m_width, m_height, [&](int x, int y) { add(mean, x, y, 1); });
        if (!mean.isEmpty()) return mean.found();
        const Vec2 middle = (corners[0] + corners[1] + corners[2]) / 3 - Vec2(0.5, 0.5);
        const Vec2 from = middle.array().floor(), part = middle - from;
        for (const int dx : {0, 1})
            for (const int dy : {0, 1})
                add(mean, std::clamp(static_cast<int>(from.x()) + dx, 0, m_width - 1),
                    std::clamp(static_cast<int>(from.y()) + dy, 0, m_height - 1),
                    (dx ? part.x() : 1 - part.x()) * (dy ? part.y() : 1 - part.y()));
        return mean.found();
    }

  private:
    void add(const Image& image, const float* pixel) {
        const float alpha = image.alpha ? std::clamp(pixel[image.channels - 1], 0.0F, 1.0F) : 1.0F;
        const float luma =
            image.colours() >= 3 ? 0.2126F * pixel[0] + 0.7152F * pixel[1] + 0.0722F * pixel[2] : pixel[0];
        const float gray = image.unassociated || alpha <= 0 ? luma : luma / alpha;
        m_gray.push_back(std::fmin(std::fmax(gray, 0.0F), 1.0F));  // NaN becomes black
        m_alpha.push_back(alpha);
    }
    template <class Mean>
    void add(Mean& mean, int x, int y, double weight) const {
        const std::size_t at = static_cast<std::size_t>(y) * m_width + x;
        mean.add(m_gray[at], m_alpha[at], weight);
    }

    int m_width = 0, m_height = 0;
    std::vector<float> m_gray, m_alpha;
};

class MeanOfNumbers {
  public:
    void add(double gray, double alpha, double weight) {
        m_sum += weight * alpha * gray, m_alpha += weight * alpha, m_weight += weight;
    }
    bool isEmpty() const { return m_weight <= 0; }
    Found found() const {
        return m_alpha > 0 ? Found{std::min(1.0, m_alpha / m_weight), m_sum / m_alpha} : Found{};
    }

  private:
    double m_sum = 0, m_alpha = 0, m_weight = 0;
};

/// Mean of directions, in half turns.
class MeanOfDirections {
  public:
    void add(double gray, double alpha, double weight) {
        m_sum += std::polar(weight * alpha, 2 * kPi * gray), m_alpha += weight * alpha, m_weight += weight;
    }
    bool isEmpty() const { return m_weight <= 0; }
    Found found() const {
        return m_alpha > 0 ? Found{std::min(1.0, m_alpha / m_weight), std::arg(m_sum) / (2 * kPi)} : Found{};
    }

  private:
    std::complex<double> m_sum = 0;
    double m_alpha = 0, m_weight = 0;
};

/// A picture placed over the cells of a region's box.
struct Laid {
    Laid(const std::string& file, const std::string& folder, const MaterialRegion& region)
        : picture(pathIn(folder, file)),
          toPixels(std::get<Box<2>>(inPlane(region.shape)), region.pictures.up, picture.width(),
                   picture.height()) {}
    GrayPicture picture;
    ToPixels toPixels;
};

std::optional<Laid> laid(const std::string& file, const std::string& folder, const MaterialRegion& region) {
    return file.empty() ? std::nullopt : std::optional<Laid>(std::in_place, file, folder, region);
}

template <class Mean>
Found found(const std::optional<Laid>& picture, const SimplicialMesh<2>& rest, const Cell<2>& cell) {
    return picture ? picture->picture.over(cornersOf(rest, cell, picture->toPixels), Mean()) : Found{};
}

}  // namespace

std::string MaterialPictures::*fileOf(MaterialPart part) {
    return part == MaterialPart::Keep        ? &MaterialPictures::phi
           : part == MaterialPart::Stiffness ? &MaterialPictures::stiffness
                                             : &MaterialPictures::direction;
}

PictureFrame pictureFrame(int width, int height, const SimplicialMesh<2>& rest) {
    if (width > 0) return {{Vec2::Zero(), Vec2(width, height)}, false, width, height};
    const Box<2> box{rest.points.rowwise().minCoeff(), rest.points.rowwise().maxCoeff()};
    const Vec2 size = box.max - box.min;
    const Vec2 pixels = (kMeshPixels / size.maxCoeff() * size).cwiseMax(1);
    return {box, true, static_cast<int>(std::lround(pixels.x())), static_cast<int>(std::lround(pixels.y()))};
}

PictureFrame pictureFrame(const Domain& domain, const std::string& folder) {
    if (!domain.parts.empty()) {
        const PartPictures pictures = loadParts(atRest(domain.parts), folder, {}, nullptr, domain.size);
        return pictureFrame(pictures.width, pictures.height, {});
    }
    const std::string path = pathIn(folder, domain.path);
    if (domain.kind != DomainKind::Image) return pictureFrame(0, 0, readMesh<2>(path));
    const Image header = readImageHeader(path, domain.size);
    return pictureFrame(header.width, header.height, {});
}

Image materialPicture(MaterialPart part, const PictureFrame& frame, const SimplicialMesh<2>& rest,
                      const Material<2>& material) {
    Image image;
    image.width = frame.width, image.height = frame.height;
    image.channels = 2;
    image.type = PixelType::UInt16;
    image.alpha = image.unassociated = true;
    image.makePixels();
    const ToPixels toPixels(frame.box, frame.up, frame.width, frame.height);
    for (int c = 0; c < rest.cellCount(); ++c) {
        const double gray = std::clamp(grayOf(part, material, c, frame.up), 0.0, 1.0);
        const auto level = static_cast<std::uint16_t>(std::lround(65535 * gray));
        forPixelsIn(cornersOf(rest, rest.cells[c], toPixels), frame.width, frame.height, [&](int x, int y) {
            auto* pixel = reinterpret_cast<std::uint16_t*>(image.row(y)) + 2 * x;
            pixel[0] = level, pixel[1] = 65535;
        });
    }
    return image;
}

void layPictures(const MaterialRegion& region, const SimplicialMesh<2>& rest, const std::string& folder,
                 Material<2>& material) {
    const auto phi = laid(region.pictures.phi, folder, region);
    const auto stiff = laid(region.pictures.stiffness, folder, region);
    const auto direction = laid(region.pictures.direction, folder, region);
    if ((stiff || direction) && material.anisotropy.empty())
        material.anisotropy.assign(rest.cells.size(), Mat2::Identity());
    const Region<2> shape = inPlane(region.shape);
    for (int c = 0; c < rest.cellCount(); ++c) {
        const Cell<2>& cell = rest.cells[c];
        const Vec2 centre =
            (rest.points.col(cell[0]) + rest.points.col(cell[1]) + rest.points.col(cell[2])) / 3;
        const double m = membership<2>(shape, centre, region.feather);
        if (m <= 0) continue;
        if (const Found keep = found<MeanOfNumbers>(phi, rest, cell); keep.weight > 0)
            material.phi[c] += m * keep.weight * (phiAtStop(kLastStop * keep.value, 2) - material.phi[c]);
        if (!stiff && !direction) continue;
        Mat2& B = material.anisotropy[c];
        Stiffness next = stiffnessOf<2>(B);
        const Found ratio = found<MeanOfNumbers>(stiff, rest, cell);
        const Found turns = found<MeanOfDirections>(direction, rest, cell);
        if (next.ratio <= 1 + 1e-9) next.axis = Vec3::UnitX();
        if (ratio.weight > 0) next.ratio = std::pow(kStiffestGray, ratio.value);
        if (turns.weight > 0) {
            const double angle = kPi * turns.value;
            next.axis = Vec3(std::cos(angle), region.pictures.up ? std::sin(angle) : -std::sin(angle), 0);
        }
        const double part = m * std::max(ratio.weight, turns.weight);
        if (part > 0) B = (1 - part) * B + part * anisotropyOf<2>(next);
    }
}

}  // namespace wend
