#include <QImage>
#include <QPainter>
#include <QTest>

#include "app/views/canvas/ground.h"
#include "app/views/canvas/moving_shape.h"

using namespace wend;

/// Fast drawing of a moving shape: coarser pixels where time is short, and a ground that is painted once.
class TestMovingPicture : public QObject {
    Q_OBJECT
  private slots:
    void smallViewsAreNotCoarse();
    void largeViewsAreAsFineAsTheTimeAllows();
    void itDoesNotGoToAndFro();
    void oneSlowPictureIsForgotten();
    void keptGroundIsTheSame_data();
    void keptGroundIsTheSame();
    void keptGroundFollowsItsLook();
};

namespace {

constexpr double kFourK = 3840.0 * 2160;

QImage painted(Ground& ground, const Ground::Look& look, bool keeps) {
    QImage image(look.size * look.ratio, QImage::Format_ARGB32_Premultiplied);
    image.setDevicePixelRatio(look.ratio);
    image.fill(Qt::red);
    QPainter painter(&image);
    QPalette palette;
    palette.setColor(QPalette::Window, look.dark ? Qt::black : Qt::white);
    palette.setColor(QPalette::WindowText, look.dark ? Qt::white : Qt::black);
    ground.paint(painter, look, Theme::of(palette), keeps);
    return image;
}

Ground::Look lookOf(const QSize& size, double ratio) {
    Ground::Look look;
    look.size = size;
    look.ratio = ratio;
    look.paper = QRectF(0, 0, 100, 60);
    look.view.setZoomLimits(1e-3, 1e3);
    look.view.fit(*look.paper, size, 20);
    return look;
}

}  // namespace

/// 200,000 pixels are drawn even if drawing is slow.
void TestMovingPicture::smallViewsAreNotCoarse() {
    DrawingPace pace;
    for (int i = 0; i < 20; ++i) pace.learn(1e6, 500);
    QCOMPARE(pace.coarseness(1280.0 * 800), 2);
    QCOMPARE(pace.coarseness(800.0 * 600), 1);
    QCOMPARE(pace.coarseness(1900.0 * 1000), 3);
    for (int i = 0; i < 60; ++i) pace.learn(1e6, 13);
    QCOMPARE(pace.coarseness(1280.0 * 800), 1);  // 13.3 ms, and up to 20
    for (int i = 0; i < 60; ++i) pace.learn(1e6, 19);
    QCOMPARE(pace.coarseness(1280.0 * 800), 1);
    for (int i = 0; i < 60; ++i) pace.learn(1e6, 21);
    QCOMPARE(pace.coarseness(1280.0 * 800), 2);
}

/// At the given nanoseconds for each of 8.3 million pixels, 14 ms suffice for 8.3/4 at 6.7 and 8.3/9 at 15;
/// there are never less than 8.3/16.
void TestMovingPicture::largeViewsAreAsFineAsTheTimeAllows() {
    const auto at = [](double nanoseconds) {
        DrawingPace pace;
        pace.learn(1e6, nanoseconds);  // 1e6 pixels: as many milliseconds
        return pace.coarseness(kFourK);
    };
    QCOMPARE(at(1.6), 1);
    QCOMPARE(at(1.8), 2);
    QCOMPARE(at(6.7), 2);
    QCOMPARE(at(6.8), 3);
    QCOMPARE(at(15.1), 3);
    QCOMPARE(at(15.3), 4);
    QCOMPARE(at(500), 4);
    QCOMPARE(DrawingPace().coarseness(kFourK), 2);  // not known yet
}

/// The pixels become finer only with time to spare: at 6.0 a third of the time would be used at once.
void TestMovingPicture::itDoesNotGoToAndFro() {
    DrawingPace pace;
    const auto next = [&pace](double nanoseconds) {
        for (int i = 0; i < 60; ++i) pace.learn(1e6, nanoseconds);  // until it is known well
        return pace.coarseness(kFourK);
    };
    QCOMPARE(next(7), 3);
    QCOMPARE(next(6), 3);
    QCOMPARE(next(4.6), 2);
    QCOMPARE(next(6), 2);
    QCOMPARE(next(0.1), 1);
}

void TestMovingPicture::oneSlowPictureIsForgotten() {
    DrawingPace pace;
    for (int i = 0; i < 10; ++i) pace.learn(2e6, 4);
    QCOMPARE(pace.coarseness(kFourK), 2);
    pace.learn(2e6, 200);
    QVERIFY(pace.coarseness(kFourK) > 2);
    for (int i = 0; i < 20; ++i) pace.learn(1e6, 2);
    QCOMPARE(pace.coarseness(kFourK), 2);
    pace.learn(0, 5);  // nothing was drawn
    QCOMPARE(pace.coarseness(kFourK), 2);
}

void TestMovingPicture::keptGroundIsTheSame_data() {
    QTest::addColumn<double>("ratio");
    QTest::addColumn<bool>("checks");
    for (const double ratio : {1.0, 1.5, 2.0})
        for (const bool checks : {true, false})
            QTest::addRow("%g, %s", ratio, checks ? "checks" : "a colour") << ratio << checks;
}

void TestMovingPicture::keptGroundIsTheSame() {
    QFETCH(double, ratio);
    QFETCH(bool, checks);
    Ground ground;
    Ground::Look look = lookOf({200, 140}, ratio);
    if (!checks) look.colour = QColor(10, 200, 30);
    const QImage still = painted(ground, look, false);
    for (int i = 0; i < 2; ++i) QCOMPARE(painted(ground, look, true), still);
    QVERIFY(still.pixelColor(still.rect().center()) != still.pixelColor(2, 2));
}

void TestMovingPicture::keptGroundFollowsItsLook() {
    Ground ground;
    Ground::Look look = lookOf({200, 140}, 1);
    painted(ground, look, true);
    const auto follows = [&] {
        Ground fresh;
        return painted(ground, look, true) == painted(fresh, look, false);
    };
    look.view.pan({7, 3});
    QVERIFY(follows());
    look.colour = Qt::blue;
    QVERIFY(follows());
    look.dark = true;
    QVERIFY(follows());
    look.size = {90, 150};
    QVERIFY(follows());
    look.paper.reset();
    QVERIFY(follows());
}

QTEST_MAIN(TestMovingPicture)
#include "test_moving_picture.moc"
