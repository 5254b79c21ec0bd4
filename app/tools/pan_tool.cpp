#include <QCoreApplication>

#include "app/tools/tool_kinds.h"

namespace wend {

namespace {

/// Drags the view. The view itself moves, as while the space bar is held.
class PanTool : public ShapeTool<> {
  public:
    using ShapeTool<>::ShapeTool;

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

}  // namespace

ToolKind panTool() {
    return toolKind(
        "pan", "pan", QT_TRANSLATE_NOOP("Tools", "Pa&n"),
        QT_TRANSLATE_NOOP(
            "Tools", "Drag the view to another place; in every step, holding the space bar does so, too"),
        "Q", Mode::Export, both<PanTool>());
}

}  // namespace wend
