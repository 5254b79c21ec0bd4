#include <QApplication>
#include <QCheckBox>
#include <QLabel>
#include <QToolBar>
#include <cmath>

#include "app/style/theme.h"
#include "app/window/main_window.h"
#include "tests/support/contrast.h"
#include "tests/support/window_fixture.h"

using namespace wend;
using namespace wend::test;

/// The palettes, by the formula of WCAG 2.
class TestLooks : public QObject {
    Q_OBJECT
  private slots:
    void formulaIsThatOfTheStandard();
    void textIsReadable_data();
    void textIsReadable();
    void boxesToTickAreSeen_data() { textIsReadable_data(); }
    void boxesToTickAreSeen();
    void iconsDiffer();
    void firstWindowIsAsAnyOther();

  private:
    static QColor over(QColor tint, const QColor& ground);
};

QColor TestLooks::over(QColor tint, const QColor& ground) {
    const double a = tint.alphaF();
    return QColor::fromRgbF(float(a * tint.redF() + (1 - a) * ground.redF()),
                            float(a * tint.greenF() + (1 - a) * ground.greenF()),
                            float(a * tint.blueF() + (1 - a) * ground.blueF()));
}

/// The known examples are black on white, and the lightest grey that is readable on white.
void TestLooks::formulaIsThatOfTheStandard() {
    QVERIFY(std::abs(contrast(Qt::black, Qt::white) - 21) < 1e-9);
    QVERIFY(contrast(QColor(0x767676), Qt::white) > 4.5 && contrast(QColor(0x777777), Qt::white) < 4.5);
}

void TestLooks::textIsReadable_data() {
    QTest::addColumn<int>("appearance");
    QTest::newRow("light") << int(Appearance::Light);
    QTest::newRow("dark") << int(Appearance::Dark);
}

void TestLooks::textIsReadable() {
    QFETCH(int, appearance);
    const QPalette look = wendPalette(static_cast<Appearance>(appearance), QApplication::palette());
    const Theme theme = Theme::of(look);
    QCOMPARE(theme.dark, static_cast<Appearance>(appearance) == Appearance::Dark);
    const auto readable = [](const char* what, const QColor& text, const QColor& ground,
                             double minimum = 4.5) {
        const double found = contrast(text, ground);
        QVERIFY2(found >= minimum, qPrintable(QStringLiteral("%1: %2").arg(QLatin1String(what)).arg(found)));
    };
    const QColor surface = look.color(QPalette::Window), raised = look.color(QPalette::Button);
    for (const QColor& ground : {surface, raised, look.color(QPalette::Base)}) {
        readable("text", look.color(QPalette::WindowText), ground);
        readable("muted", theme.secondText, ground);
        readable("accent text", theme.accentText, ground);
        readable("danger", theme.danger, ground);
        readable("warning", theme.warning, ground);
        readable("success", theme.success, ground);
        readable("control border", look.color(QPalette::Mid), ground, 3);  // of what is no text
    }
    readable("primary", Qt::white, theme.accent);
    readable("primary, pressed", Qt::white, theme.accent.darker(115));
    readable("selected", look.color(QPalette::HighlightedText), look.color(QPalette::Highlight));
    readable("tooltip", look.color(QPalette::ToolTipText), look.color(QPalette::ToolTipBase));
    QColor tint = theme.accent;  // of a tool that is chosen
    tint.setAlphaF(theme.dark ? 0.3F : 0.18F);
    readable("chosen", theme.accentText, over(tint, surface), 3);
    readable("chosen text", look.color(QPalette::WindowText), over(tint, surface));
    readable("steps", look.color(QPalette::WindowText), theme.line);
}

/// Check boxes contrast with their ground, ticked or not, and the two states differ.
void TestLooks::boxesToTickAreSeen() {
    QFETCH(int, appearance);
    const QPalette look = wendPalette(static_cast<Appearance>(appearance), QApplication::palette());
    QWidget ground;
    ground.setPalette(look);
    ground.setStyleSheet(wendStyleSheet(look));
    QCheckBox box(QStringLiteral(" "), &ground);
    box.resize(40, 24);
    double seen[2];
    for (const bool ticked : {false, true}) {
        box.setChecked(ticked);
        const QImage image = box.grab().toImage();
        double largest = 1;
        for (int x = 0; x < 18; ++x)
            largest = std::max(largest, contrast(image.pixelColor(x, 12), look.color(QPalette::Window)));
        QVERIFY2(largest >= 3, qPrintable(QString::number(largest)));
        seen[ticked] = contrast(image.pixelColor(5, 12), look.color(QPalette::Base));
    }
    QVERIFY2(seen[0] < 1.2 && seen[1] > 2, qPrintable(QStringLiteral("%1, %2").arg(seen[0]).arg(seen[1])));
}

/// At display size, every pair of icons differs in a share of the pixels.
void TestLooks::iconsDiffer() {
    const QPalette look = wendPalette(Appearance::Light, QApplication::palette());
    const QStringList names = {"pin",       "select",   "area-lasso", "area-rectangle", "area-brush",
                               "area-ball", "area-box", "area-half",  "sizes",          "brush",
                               "measure",   "mesh",     "distortion", "hide",           "fit",
                               "layers",    "through",  "depth"};
    std::vector<QImage> drawn;
    for (const QString& name : names) {
        drawn.push_back(wendIcon(name, look).pixmap(20, 20).toImage());
        QVERIFY2(!drawn.back().isNull(), qPrintable(name));
    }
    for (std::size_t i = 0; i < drawn.size(); ++i)
        for (std::size_t k = 0; k < i; ++k) {
            double differs = 0, inked = 0;
            for (int y = 0; y < 20; ++y)
                for (int x = 0; x < 20; ++x) {
                    const double a = drawn[i].pixelColor(x, y).alphaF(),
                                 b = drawn[k].pixelColor(x, y).alphaF();
                    differs += std::abs(a - b);
                    inked += std::max(a, b);
                }
            QVERIFY2(differs > 0.4 * inked, qPrintable(names[qsizetype(i)] + ' ' + names[qsizetype(k)]));
        }
}

/// The first window, which sets the program's style, looks like any other.
void TestLooks::firstWindowIsAsAnyOther() {
    const TestFolder folder;
    qApp->setStyleSheet({});
    MainWindow first, second;
    for (const char* name : {"topBar", "optionRow"}) {
        const auto height = [name](const MainWindow& window) {
            return window.findChild<QToolBar*>(QLatin1String(name))->sizeHint().height();
        };
        QCOMPARE(height(first), height(second));
    }
}

QTEST_MAIN(TestLooks)
#include "test_looks.moc"
