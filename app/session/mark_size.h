#pragma once

namespace wend {

/// How large the marks over a shape are against their usual size, for the eye and for the hand: pins, rings,
/// curves, arrows, labels, the lines of tools, and what is taken hold of. The user's choice, for all views.
double markSize();
void setMarkSize(double factor);

/// A length of a mark, given in pixels of the screen for the usual size.
inline double marked(double pixels) {
    return pixels * markSize();
}

}  // namespace wend
