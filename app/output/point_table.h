#pragma once

#include <string>
#include <vector>

#include "core/base/types.h"

namespace wend {

/// Reads points from the rows of a text: numbers between commas, semicolons, tabs or blanks. Everything but
/// the coordinates is kept unchanged: other columns, comments (#, // and %), empty lines and line ends. The
/// coordinates are the columns that a header calls x, y and z (ParaView: Points:0 …), or else the first
/// numbers of a row. In an .xyz file that begins with the number of its atoms, the second line is a comment.
class PointTable {
  public:
    /// Throws InputError with the line.
    PointTable(std::string text, int dimension);

    /// Returns the points; without a third coordinate, z is 0.
    const Points<3>& points() const { return m_points; }
    /// Returns the number of columns beside the coordinates.
    int furtherColumns() const { return m_furtherColumns; }
    /// Returns the text with other points, in 17 significant digits.
    std::string withPoints(const Points<3>& points) const;

  private:
    struct Field {
        std::size_t begin, end;  // in the text
    };
    class Reader;

    std::string m_text;
    int m_dimension, m_furtherColumns = 0;
    std::vector<Field> m_fields;  // of the coordinates, point by point
    Points<3> m_points;
};

/// True for names of such files: .csv, .tsv, .txt, .xyz and .dat.
bool isPointTable(const std::string& path);

/// Returns the points as such a text: in a .csv file below the header "x,y[,z]", elsewhere between blanks.
std::string pointTableText(const Points<3>& points, int dimension, bool commas);

}  // namespace wend
