#pragma once

namespace wend {

/// Scale of all marks over a shape (pins, rings, curves, arrows, labels, tool lines) and of their hit areas.
/// Chosen by the user for all views.
double markSize();
void setMarkSize(double factor);

/// A length of a mark, given in pixels of the screen for the usual size.
inline double marked(double pixels) {
    return pixels * markSize();
}

}  // namespace wend
