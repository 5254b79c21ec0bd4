// What is seen of a solid, through it and on it.
#include <QCheckBox>

#include "app/panels/distortion_panel.h"
#include "app/panels/folding_section.h"
#include "tests/support/solid_fixture.h"

using namespace wend;
using namespace wend::test;

class TestSolidView : public QObject {
    Q_OBJECT
  private slots:
    void init();
    void cleanup() { m_f.reset(); }
    void colourMapIsSmooth();
    void stiffnessShinesThrough();

  private:
    Document& document() { return m_f->session().document(); }

    std::unique_ptr<SolidFixture> m_f;
};

void TestSolidView::init() {
    if (!VolumeView::available()) QSKIP("needs OpenGL (run under xvfb-run)");
    m_f = std::make_unique<SolidFixture>();
    QVERIFY(m_f->open());
}

/// The box lies in the folded part of the properties, and its choice is remembered.
void TestSolidView::colourMapIsSmooth() {
    auto* box = m_f->window().findChild<QCheckBox*>(QStringLiteral("mapSmooth"));
    QVERIFY(box && !box->isChecked() && !box->toolTip().isEmpty());
    bool isFolded = false;
    for (const QWidget* w = box; w; w = w->parentWidget())
        isFolded = isFolded || dynamic_cast<const FoldingSection*>(w);
    QVERIFY(isFolded);
    QVERIFY(m_f->holdEnds());
    m_f->window().actions().showMap->setChecked(true);
    auto* panel = m_f->window().findChild<DistortionPanel*>();
    panel->setMeasure(Measure::CellSize);
    m_f->canvas().camera().fit(Vec<3>(-1, -0.5, -0.5), Vec<3>(1, 0.5, 0.5));
    // Neighbouring pixels that differ much: the borders of the cells.
    const auto jumps = [&] {
        const QImage image = m_f->canvas().grabFramebuffer();
        const QPoint middle = image.rect().center();
        int count = 0;
        for (int y = middle.y() - 50; y < middle.y() + 50; ++y)
            for (int x = middle.x() - 100; x < middle.x() + 100; ++x)
                count += std::abs(qGray(image.pixel(x, y)) - qGray(image.pixel(x + 1, y))) > 8;
        return count;
    };
    const int flat = jumps();
    QVERIFY2(flat > 100, qPrintable(QString::number(flat)));
    box->click();
    QVERIFY(box->isChecked());
    const int smooth = jumps();
    QVERIFY2(10 * smooth < flat, qPrintable(QString::number(smooth)));
    QVERIFY(DistortionPanel(m_f->session()).isSmooth());
    box->click();
    QCOMPARE(jumps(), flat);
}

/// What is stiff at the back of the bar is told on its front, which is not; arrows there are not told.
void TestSolidView::stiffnessShinesThrough() {
    Project stiff = m_f->project();
    std::get<Design<3>>(stiff.design)
        .material.regions.push_back(
            {"back", Box<3>{{-3, 0.2, -1}, {3, 1, 1}}, 0, {}, Stiffness<3>{{1, 0, 0}, 20}});
    document().change(QStringLiteral("Stiffen"), stiff);
    QVERIFY(settle(m_f->session()));
    m_f->canvas().fit();
    const auto front = [&] {
        const QRectF face(m_f->canvas().toWidget({-1.8, -0.5, 0.4}),
                          m_f->canvas().toWidget({1.8, -0.5, -0.4}));
        return m_f->canvas().grabFramebuffer().copy(face.toRect());
    };
    const QImage plain = front();
    m_f->window().actions().showMarks->setChecked(true);
    const QImage marked = front();
    int told = 0;
    for (int y = 0; y < plain.height(); ++y)
        for (int x = 0; x < plain.width(); ++x) {
            const QColor before = plain.pixelColor(x, y), after = marked.pixelColor(x, y);
            if (before == after) continue;
            QVERIFY(after.red() - after.blue() > before.red() - before.blue());  // orange, on a brown ground
            ++told;
        }
    QVERIFY2(told > 300, qPrintable(QString::number(told)));
    m_f->window().actions().showMarks->setChecked(false);
    QVERIFY(front() == plain);
}

QTEST_MAIN(TestSolidView)
#include "test_solid_view.moc"
