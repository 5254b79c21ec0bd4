#pragma once

#include <array>
#include <vector>

namespace wend {
struct MeshField;
struct MeshFile;
}  // namespace wend

namespace wend::formats {

/// Red, green, blue and alpha from 0 to 1, as a screen shows them (sRGB).
using Colour = std::array<double, 4>;

/// Returns the colours of a file's vertices, or of its own cells: the fields red, green, blue and perhaps
/// alpha, or one field of three or four bytes. Bytes count from 0 to 255. Empty if there are none.
std::vector<Colour> coloursOf(const MeshFile& file, bool perCell);

/// Returns whether bytes hold these colours without rounding.
bool areBytes(const std::vector<Colour>& colours);

/// Adds colours as the fields red, green, blue and, unless all are opaque, alpha: bytes if nothing is rounded
/// by them, else numbers from 0 to 1.
void addColours(MeshFile& file, const std::vector<Colour>& colours, bool perCell);

/// Returns whether a field is part of the colours that coloursOf() returns for fields of this kind.
bool isColour(const MeshField& field, bool perCell);

/// Return a component of a colour as light, and light as such a component (IEC 61966-2-1).
double lightOf(double shown);
double shownOf(double light);

}  // namespace wend::formats
