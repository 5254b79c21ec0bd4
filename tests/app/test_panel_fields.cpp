#include <QAbstractSpinBox>
#include <QDoubleSpinBox>
#include <QScrollArea>

#include "app/panels/cut_panel.h"
#include "tests/support/solid_fixture.h"

using namespace wend;
using namespace wend::test;

/// Fields of the panels, by keys and the wheel, in a window with a picture or a solid.
class TestPanelFields : public QObject {
    Q_OBJECT
  private slots:
    void init();
    void numbersCanBeTyped_data();
    void numbersCanBeTyped();
    void framesLeaveTheCutsNumbers();

  private:
    bool open(bool solid);
    QWidget& view();
    QAbstractSpinBox* box(const QString& name);
    void type(QAbstractSpinBox& box, const QString& text);

    std::unique_ptr<SolidFixture> m_f;
};

void TestPanelFields::init() {
    if (!VolumeView::available()) QSKIP("needs OpenGL (run under xvfb-run)");
    m_f = std::make_unique<SolidFixture>();
    QVERIFY(QTest::qWaitForWindowActive(&m_f->window()));
}

bool TestPanelFields::open(bool solid) {
    return solid ? m_f->open() : m_f->openPicture();
}

QAbstractSpinBox* TestPanelFields::box(const QString& name) {
    for (auto* one : m_f->window().findChildren<QAbstractSpinBox*>())
        if (one->isVisible() && one->accessibleName() == name) return one;
    return nullptr;
}

void TestPanelFields::type(QAbstractSpinBox& box, const QString& text) {
    box.setFocus();
    box.selectAll();
    QTest::keyClicks(&box, text);
    QTest::keyClick(&box, Qt::Key_Return);
}

void TestPanelFields::numbersCanBeTyped_data() {
    QTest::addColumn<bool>("solid");
    QTest::addColumn<QString>("name");
    QTest::addColumn<QString>("typed");
    QTest::addColumn<QString>("shown");
    for (const bool solid : {false, true}) {
        const QByteArray in = solid ? "solid" : "picture";
        const auto row = [&](const char* name, const char* typed, const char* shown) {
            QTest::newRow(in + ": " + name + " " + typed)
                << solid << QString::fromUtf8(name) << QString::fromUtf8(typed) << QString::fromUtf8(shown);
        };
        row("Energy φ", "1.257", "1.257 rad");
        row("Smoothing length", "0.02", "0.020");
        row("Smoothing length", "0", "none");
        row("Vertices", "450", "450");
        if (!solid) row("Threshold", "25", "25 %");
        if (!solid) row("Margin", "0.5", "0.5 px");
        if (solid) row("Roundness", "2.25", "2.25");
    }
}

/// What is typed is not shown anew before it is complete.
void TestPanelFields::numbersCanBeTyped() {
    QFETCH(bool, solid);
    QFETCH(QString, name);
    QFETCH(QString, typed);
    QVERIFY(open(solid));
    QAbstractSpinBox* field = box(name);
    QVERIFY(field);
    const int steps = m_f->session().document().undoStack()->count();
    type(*field, typed);
    QTEST(field->text(), "shown");
    QVERIFY(settle(m_f->session()));
    QTEST(field->text(), "shown");
    QCOMPARE(m_f->session().document().undoStack()->count(), steps + 1);
}

/// A motion that plays, or is being computed, brings frames all the time.
void TestPanelFields::framesLeaveTheCutsNumbers() {
    QVERIFY(open(true));
    m_f->actions().cut->trigger();
    QAbstractSpinBox* place = box(QStringLiteral("Distance of the cut"));
    QVERIFY(place);
    place->setFocus();
    place->selectAll();
    QTest::keyClicks(place, QStringLiteral("0.25"));
    emit m_f->session().frameChanged();
    QTest::keyClick(place, Qt::Key_Return);
    QCOMPARE(place->text(), QStringLiteral("0.2500"));
    const CutPlane& plane = m_f->canvas().plane();
    QCOMPARE(plane.normal.dot(plane.point), 0.25);
}

QTEST_MAIN(TestPanelFields)
#include "test_panel_fields.moc"
