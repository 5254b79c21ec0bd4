#pragma once

#include <QColor>
#include <QRectF>
#include <QString>
#include <optional>
#include <vector>

#include "app/project/edits/key_edits.h"
#include "app/project/edits/progress.h"

namespace wend {

class TimeScale;

/// The rows of the tracks: their geometry, hit tests, and the drag of bars and keys.
struct TrackLayout {
    static constexpr int kHold = -1;          // in the place of a motion: the line along which the pin holds
    static constexpr double kRowHeight = 24;  // pixels
    struct Bar : MotionId {
        MotionTime time = {};
        SlowSides slow = {};
        QString kind = {};
        std::optional<Ease> ease = Ease::Linear;  // none: a curve of its own
    };
    struct Row {
        QString name;
        QColor colour;
        Bar hold;
        std::vector<Bar> bars = {};
        std::vector<KeyId> keys = {};
    };
    enum class Part { Key, Body, Start, End };
    /// A key, a part of a bar, or an end of a hold.
    struct Hit {
        Part part = Part::Key;
        KeyId key = {};
        Bar bar = {};
        bool isKey() const { return part == Part::Key; }
        bool isHold() const { return !isKey() && bar.motion == kHold; }
    };
    struct Drag {
        Hit hit;
        double at = 0;                        // the time that was pressed
        bool alone = false;                   // a click chooses it alone
        std::vector<MotionId> bars = {};      // the dragged motions or hold
        std::vector<KeyId> keys = {};         // that move along
        MotionTime from = {0, 1}, to = from;  // of the bars before and during the drag; of keys, any interval
        bool moves() const { return to != from; }
    };

    const TimeScale& scale;
    std::vector<Row> rows = {};
    QRectF area = {};  // of the rows
    double scrolled = 0;
    std::optional<Drag> drag = {};

    QRectF rowRect(int row) const;
    QRectF rectOf(const Bar& bar) const;
    /// Returns where a key pose is drawn.
    QPointF spotOf(const KeyId& key) const;
    /// Returns the interval of a bar, clipped to the film, or its dragged one.
    MotionTime timeOf(const Bar& bar) const;
    /// Returns the row at a point, or −1.
    int rowAt(const QPointF& at) const;
    /// Returns the nearest key within reach that is none of `others`, or else the bar or end of a hold there.
    std::optional<Hit> hitAt(const QPointF& at, const std::vector<KeyId>& others) const;
    /// Drags to a place. Times snap to marks and to keys that do not move along.
    void dragTo(double x, const Design& design, const std::vector<double>& marks);

  private:
    double timeOf(const KeyId& key) const;
    double snapped(double time, std::vector<double> marks) const;
    MotionTime draggedHold(double by, const std::vector<double>& marks) const;
    MotionTime draggedBars(double by, const Design& design, const std::vector<double>& marks) const;
};

}  // namespace wend
