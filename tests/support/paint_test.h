#pragma once

#include <QListWidget>
#include <QUndoStack>

#include "app/panels/layer_panel.h"
#include "app/panels/paint_panel.h"
#include "app/project/design.h"
#include "app/project/edits/material_edits.h"
#include "tests/support/bar.h"
#include "tests/support/layers.h"

namespace wend::test {

/// The base of tests that paint on the bar: the window, its brush, strokes and their results.
class PaintTest : public QObject {
  protected:
    void begin() {
        if (!VolumeView::available()) QSKIP("needs OpenGL (run under xvfb-run)");
        m_f = std::make_unique<SolidFixture>();
        QVERIFY(QTest::qWaitForWindowActive(&m_f->window(), 20000));
    }
    Brush& brush() { return m_f->window().properties().brush(); }
    template <class Change>
    void set(const Change& change) {
        BrushSettings next = brush().now();
        change(next);
        brush().set(next);
    }
    template <int Dim>
    void stroke(const Vec2& from, const Vec2& to, Qt::KeyboardModifiers modifiers = {}, bool release = true) {
        auto& canvas = Bar<Dim>::canvas(*m_f);
        const QPoint a = canvas.toWidget(Bar<Dim>::place(from.x(), from.y())).toPoint();
        const QPoint b = canvas.toWidget(Bar<Dim>::place(to.x(), to.y())).toPoint();
        QTest::mouseMove(&canvas, a);
        QTest::mousePress(&canvas, Qt::LeftButton, modifiers, a);
        for (int i = 1; i <= 8; ++i) QTest::mouseMove(&canvas, a + (b - a) * i / 8);
        if (release) QTest::mouseRelease(&canvas, Qt::LeftButton, modifiers, b);
    }
    template <int Dim>
    const std::vector<MaterialRegion>& regions() {
        return m_regions = regionsIn(m_f->session().document().design());
    }
    template <int Dim>
    bool setEverywhere(double phi) {
        Design next = m_f->session().document().design();
        next.material.phi = phi;
        m_f->session().document().changeDesign(QStringLiteral("Energy"), next);
        return settle(m_f->session());
    }

    template <int Dim>
    const std::vector<double>& phis() {
        return m_f->session().motion().frame<Dim>()->material->phi;
    }
    template <int Dim>
    int cellAt(double u) {
        auto& canvas = Bar<Dim>::canvas(*m_f);
        return canvas.touch(canvas.toWidget(Bar<Dim>::place(u, 0)))->place.cell;
    }
    std::vector<std::string> layers() {
        std::vector<std::string> names;
        for (const MaterialLayer& layer : m_f->session().document().design().material.layers)
            names.push_back(layer.name);
        return names;
    }
    QListWidget* list() { return m_f->window().properties().layers().list(); }
    int steps() { return m_f->session().document().undoStack()->count(); }
    QString undoText() { return m_f->window().actions().undo->text(); }
    bool undo() {
        m_f->window().actions().undo->trigger();
        return settle(m_f->session());
    }
    /// A tetrahedron's middle is below the surface.
    template <int Dim>
    void eraseWith(double radius) {
        m_f->tool("eraser")->trigger();
        set([&](BrushSettings& b) { b.radius = Dim == 3 ? 2.2 * radius : radius; });
    }

    std::unique_ptr<SolidFixture> m_f;

  private:
    std::vector<MaterialRegion> m_regions;
};

}  // namespace wend::test
