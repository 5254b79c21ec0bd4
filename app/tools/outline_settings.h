#pragma once

#include <QObject>

namespace wend {

/// What the tools of the outline have in common.
struct OutlineSettings {
    bool takesAway = false;   // else it is added; with Ctrl the other way round
    double radius = 22;       // of the brush, in pixels of the screen
    double tolerance = 0.12;  // of colours, of full scale
    bool operator==(const OutlineSettings&) const = default;
};

/// The pen in the user's hand, one for all tools that draw the outline.
class OutlinePen : public QObject {
    Q_OBJECT

  public:
    static constexpr double kSmallest = 3, kLargest = 300;  // radius

    using QObject::QObject;
    const OutlineSettings& now() const { return m_now; }
    /// Bounded.
    void set(const OutlineSettings& settings);

  signals:
    void changed();

  private:
    OutlineSettings m_now;
};

}  // namespace wend
