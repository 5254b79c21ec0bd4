// EXR files with layers, read by OpenImageIO as it is.

#include <OpenImageIO/imageio.h>

#include <QTemporaryDir>
#include <QtTest>
#include <algorithm>

#include "tests/support/pictures.h"
#include "warp/layered_exr.h"

using namespace wend;
using namespace wend::test;

class TestLayeredExr : public QObject {
    Q_OBJECT

  private slots:
    void everyLayerHasChannels();
    void typesAreKept();
    void namesAreTheirOwn();
    void longNamesAreShortened();

  private:
    std::string at(const char* name) const { return m_folder.filePath(name).toStdString(); }
    QTemporaryDir m_folder;
};

/// Values are associated, with the layer's opacity, and zero beside the layer, which may reach beyond the
/// picture.
void TestLayeredExr::everyLayerHasChannels() {
    const std::vector<LayerToWrite> layers{{"left arm", plainPicture(4, 3, {200, 100, 50, 128}), 6, -1, 0.5},
                                           {"body", plainPicture(5, 4, {30, 60, 90}), 1, 2, 1, false}};
    writeLayeredExr(at("layers.exr"), plainPicture(8, 6, {10, 20, 30, 255}), layers);
    const auto input = OIIO::ImageInput::open(at("layers.exr"));
    QVERIFY(input != nullptr);
    const OIIO::ImageSpec spec = input->spec();
    QCOMPARE(spec.nchannels, 12);
    QVERIFY(spec.format == OIIO::TypeDesc::HALF);
    std::vector<float> pixels(static_cast<std::size_t>(8 * 6 * 12));
    QVERIFY(input->read_image(0, 0, 0, 12, OIIO::TypeDesc::FLOAT, pixels.data()));
    const auto value = [&](int x, int y, const std::string& channel) {
        const auto found = std::ranges::find(spec.channelnames, channel);
        if (found == spec.channelnames.end()) return -1.0F;
        return pixels[static_cast<std::size_t>((y * 8 + x) * 12 + (found - spec.channelnames.begin()))];
    };
    for (int y = 0; y < 6; ++y)
        for (int x = 0; x < 8; ++x) {
            const bool isArm = x >= 6 && y < 2, isBody = x >= 1 && x < 6 && y >= 2;
            const float alpha = isArm ? 0.5F * 128 / 255 : 0;
            QVERIFY(std::abs(value(x, y, "left_arm.A") - alpha) < 1e-3F);
            QVERIFY(std::abs(value(x, y, "left_arm.R") - alpha * 200 / 255) < 1e-3F);
            QVERIFY(std::abs(value(x, y, "left_arm.B") - alpha * 50 / 255) < 1e-3F);
            QCOMPARE(value(x, y, "body.A"), isBody ? 1.0F : 0.0F);
            QVERIFY(std::abs(value(x, y, "body.G") - (isBody ? 60 / 255.0F : 0.0F)) < 1e-3F);
            QVERIFY(std::abs(value(x, y, "G") - 20 / 255.0F) < 1e-3F);
            QCOMPARE(value(x, y, "A"), 1.0F);
        }
    const Image own = readImage(at("layers.exr"));  // the picture of all of them
    QCOMPARE(own.channels, 4);
    QCOMPARE(own.metadata->leftOut.size(), std::size_t(8));
}

void TestLayeredExr::typesAreKept() {
    Image deep = plainPicture(2, 2, {1, 2, 3, 255});
    deep.type = PixelType::UInt16;
    deep.makePixels();
    const auto typeOf = [&](const std::optional<PixelType>& wanted) {
        writeLayeredExr(at("deep.exr"), deep, {{"a", deep}}, wanted);
        return readImageHeader(at("deep.exr")).type;
    };
    QCOMPARE(typeOf({}), PixelType::Float);
    QCOMPARE(typeOf(PixelType::Half), PixelType::Half);
}

void TestLayeredExr::namesAreTheirOwn() {
    const auto layer = [](const char* name) { return LayerToWrite{name, {}}; };
    QCOMPARE(channelNames({layer("a.b"), layer("a b"), layer("Körper"), layer("")}),
             (std::vector<std::string>{"a_b", "a_b_2", "Körper", "layer"}));
}

/// OpenEXR holds names of 255 bytes, and OpenImageIO writes longer ones without their channels.
void TestLayeredExr::longNamesAreShortened() {
    std::string japanese;
    for (int k = 0; k < 100; ++k) japanese += "頭";
    const Image picture = plainPicture(4, 3, {200, 100, 50, 255});
    const std::vector<LayerToWrite> layers{
        {std::string(300, 'x') + "1", picture}, {std::string(300, 'x') + "2", picture}, {japanese, picture}};
    writeLayeredExr(at("long.exr"), picture, layers);
    const auto input = OIIO::ImageInput::open(at("long.exr"));
    QVERIFY(input != nullptr);
    QCOMPARE(input->spec().nchannels, 16);
    const std::vector<std::string> names = channelNames(layers);
    QVERIFY(names[0] != names[1]);
    QCOMPARE(names[2], japanese.substr(0, 198));  // whole characters
    for (const std::string& name : names)
        QVERIFY(std::ranges::find(input->spec().channelnames, name + ".R") !=
                input->spec().channelnames.end());
}

QTEST_GUILESS_MAIN(TestLayeredExr)
#include "test_layered_exr.moc"
