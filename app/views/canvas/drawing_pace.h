#pragma once

namespace wend {

/// Adapts the resolution of a moving shape so that frames are drawn in time, based on the last ones.
class DrawingPace {
  public:
    /// Device pixels per side of a drawn one, for a view of so many device pixels.
    int coarseness(double pixels);
    /// Records how long a number of drawn pixels took.
    void learn(double drawnPixels, double milliseconds);

  private:
    bool isInTime(double pixels, int coarseness, double margin) const;

    double m_perPixel = 0;  // milliseconds; 0: not known
    int m_coarseness = 1;
};

}  // namespace wend
