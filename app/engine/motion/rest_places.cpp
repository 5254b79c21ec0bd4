#include "app/engine/motion/rest_places.h"

namespace wend {

namespace {

constexpr double kTolerance = 1e-9;  // of barycentric coordinates

template <int Dim>
class RestPlacesOf : public RestPlaces {
  public:
    explicit RestPlacesOf(const SimplicialMesh<Dim>& rest)
        : m_rest(rest), m_locator(rest.points, rest.cells), m_vertices(rest.vertexCount()) {
        for (int c = 0; c < rest.cellCount(); ++c)
            for (int k = 0; k <= Dim; ++k) {
                Place& place = m_vertices[rest.cells[c][k]];
                if (place.cell >= 0) continue;
                place.cell = c;
                place.weights.setUnit(k);
            }
    }

    std::optional<Place> find(const Vec3& p) const override { return find(m_locator, p, 0); }
    int nearestVertex(const Vec3& p) const override { return m_locator.nearestVertex(p.head<Dim>()); }
    PinPlace placeOf(const Pin& pin) const override {
        std::vector<MeshPart> parts;  // that the handle may be in, from front to back
        for (auto part = m_rest.parts.rbegin(); part != m_rest.parts.rend(); ++part)
            if (pin.part.empty() || pin.part == part->name) parts.push_back(*part);
        if (parts.empty()) parts.push_back({"", 0, m_rest.vertexCount(), 0, m_rest.cellCount()});
        const bool isNamed = !pin.part.empty() && parts.size() == 1;
        if (const auto* region = std::get_if<Region<3>>(&pin.at))
            return inRegion(regionIn<Dim>(*region), parts);
        if (const auto* points = std::get_if<std::vector<Vec3>>(&pin.at))
            return isNamed ? inPart(*points, parts.front()) : inShape(*points);
        return atVertices(std::get<std::vector<int>>(pin.at), isNamed ? parts.front().firstVertex : 0);
    }

  private:
    static std::optional<Place> find(const PointLocator<Dim>& locator, const Vec3& p, int firstCell) {
        const auto found = locator.find(p.head<Dim>(), kTolerance);
        if (!found) return {};
        Place place = inSpace(*found);
        place.cell += firstCell;
        return place;
    }
    /// Leaves out vertices that no cell has.
    void add(int vertex, PinPlace& place) const {
        if (m_vertices[vertex].cell >= 0) place.points.push_back(m_vertices[vertex]);
    }
    PinPlace atVertices(const std::vector<int>& vertices, int first) const {
        PinPlace place;
        for (const int v : vertices)
            if (v >= 0 && first + v < m_rest.vertexCount()) add(first + v, place);
        return place;
    }
    PinPlace inShape(const std::vector<Vec3>& points) const { return among(points, m_locator, 0); }
    PinPlace inPart(const std::vector<Vec3>& points, const MeshPart& part) const {
        const std::vector<Cell<Dim>> cells(m_rest.cells.begin() + part.firstCell,
                                           m_rest.cells.begin() + part.endCell);
        return among(points, PointLocator<Dim>(m_rest.points, cells), part.firstCell);
    }
    static PinPlace among(const std::vector<Vec3>& points, const PointLocator<Dim>& locator, int firstCell) {
        PinPlace place;
        for (const Vec3& p : points)
            if (const auto found = find(locator, p, firstCell)) place.points.push_back(*found);
        return place;
    }
    PinPlace inRegion(const Region<Dim>& region, const std::vector<MeshPart>& parts) const {
        PinPlace place;
        place.region = true;
        for (std::size_t i = 0; i < parts.size() && place.points.empty(); ++i)
            for (int v = parts[i].firstVertex; v < parts[i].endVertex; ++v)
                if (signedDistance<Dim>(region, m_rest.points.col(v)) <= 0) add(v, place);
        return place;
    }

    const SimplicialMesh<Dim>& m_rest;
    PointLocator<Dim> m_locator;
    std::vector<Place> m_vertices;  // each as a corner of the first cell that has it
};

}  // namespace

std::unique_ptr<const RestPlaces> RestPlaces::of(const ShapeFrame& frame) {
    if (frame.dimension == 2)
        return std::make_unique<RestPlacesOf<2>>(*static_cast<const PosedFrame<2>&>(frame).rest);
    return std::make_unique<RestPlacesOf<3>>(*static_cast<const PosedFrame<3>&>(frame).rest);
}

std::vector<PinPlace> RestPlaces::placesOf(const std::vector<Pin>& pins) const {
    std::vector<PinPlace> places;
    places.reserve(pins.size());
    for (const Pin& pin : pins) places.push_back(placeOf(pin));
    return places;
}

}  // namespace wend
