#pragma once

#include <QCoreApplication>

#include "app/tools/shape_tool.h"

namespace wend {

/// Moves the view: the view itself does so, as it does while the space bar is held.
template <int Dim>
class PanTool : public ShapeTool<Dim> {
  public:
    using ShapeTool<Dim>::ShapeTool;

    QString hint() const override {
        return QCoreApplication::translate("PanTool", "Drag to move the view; the wheel zooms");
    }
    QCursor cursor() const override { return Qt::OpenHandCursor; }
    bool pans() const override { return true; }
    void press(const QMouseEvent&) override {}
    void move(const QMouseEvent&) override {}
    void release(const QMouseEvent&) override {}
    bool key(const QKeyEvent&) override { return false; }
    void cancel() override {}
};

}  // namespace wend
