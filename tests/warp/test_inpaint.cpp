// The ground behind a cut-out part, filled by G'MIC.

#include <QtTest>
#include <cmath>
#include <random>

#include "tests/support/pictures.h"
#include "warp/inpaint.h"

using namespace wend;
using namespace wend::test;

class TestInpaint : public QObject {
    Q_OBJECT

  private slots:
    void stemsAreContinued_data();
    void stemsAreContinued();
};

void TestInpaint::stemsAreContinued_data() {
    QTest::addColumn<double>("width");
    QTest::addColumn<bool>("alpha");
    QTest::newRow("thin") << 8.0 << false;
    QTest::newRow("thick") << 14.0 << false;
    QTest::newRow("cut-out") << 10.0 << true;
}

/// A dark stem over a noisy ground continues through a hole that is many times as wide, and is not repeated
/// in it.
void TestInpaint::stemsAreContinued() {
    if (!canInpaint()) QSKIP("gmic is not installed");
    QFETCH(double, width);
    QFETCH(bool, alpha);
    constexpr int kWidth = 440, kHeight = 300;
    const std::size_t channels = alpha ? 4 : 3;
    Image picture{kWidth, kHeight, static_cast<int>(channels), PixelType::Float, alpha, false, {}, {}};
    picture.makePixels();
    std::vector<bool> hole;
    std::mt19937 random(5);
    std::uniform_real_distribution<float> noise(-0.06F, 0.06F);
    const auto middleAt = [](int x) { return 150 + 12 * std::sin(x / 120.0); };
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            auto* pixel = reinterpret_cast<float*>(picture.row(y)) + channels * static_cast<std::size_t>(x);
            const bool isStem = std::abs(y - middleAt(x)) < width / 2;
            pixel[0] = (isStem ? 0.15F : 0.45F) + noise(random);
            pixel[1] = (isStem ? 0.25F : 0.65F) + noise(random);
            pixel[2] = (isStem ? 0.1F : 0.3F) + noise(random);
            if (alpha) pixel[3] = 1;
            hole.push_back(std::hypot((x - 220) / 75.0, (y - 150) / 100.0) < 1);
        }
    const Image filled = inpainted(picture, hole);
    const auto darkIn = [&](int x) {
        int dark = 0;
        for (int y = 0; y < kHeight; ++y) dark += valueAt<float>(filled, x, y, 1) < 0.45F;
        return dark;
    };
    for (int x = 140; x < 300; ++x) {
        const int dark = darkIn(x);
        QVERIFY2(dark > 0.5 * width && dark < 2 * width, qPrintable(QString("%1: %2").arg(x).arg(dark)));
    }
}

QTEST_GUILESS_MAIN(TestInpaint)
#include "test_inpaint.moc"
