#pragma once

namespace wend {

/// How coarsely a shape is drawn while it moves: as finely as it can be for a picture in time, as the last
/// ones tell.
class DrawingPace {
  public:
    /// Device pixels per side of a drawn one, for a view of so many device pixels.
    int coarseness(double pixels);
    /// So many drawn pixels took so long.
    void learn(double drawnPixels, double milliseconds);

  private:
    bool isInTime(double pixels, int coarseness, double margin) const;

    double m_perPixel = 0;  // milliseconds; 0: not known
    int m_coarseness = 1;
};

}  // namespace wend
