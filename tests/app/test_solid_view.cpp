// What is seen of a solid, through it and on it.
#include "tests/support/solid_fixture.h"

using namespace wend;
using namespace wend::test;

class TestSolidView : public QObject {
    Q_OBJECT
  private slots:
    void init();
    void cleanup() { m_f.reset(); }
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
