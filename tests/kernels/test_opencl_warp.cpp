// The texture warp on every kind of OpenCL device against the processor's.
#include <QTemporaryDir>
#include <QTest>
#include <cmath>

#include "kernels/back_end_choice.h"
#include "kernels/opencl_warp.h"
#include "tests/support/pictures.h"
#include "warp/convert.h"
#include "warp/warped_picture.h"

using namespace wend;
using namespace wend::test;

class TestOpenClWarp : public QObject {
    Q_OBJECT
  private slots:
    void agreesWithTheProcessor_data();
    void agreesWithTheProcessor();
    void identityKeepsEveryBit();
    void outsideAndFoldsAreTheProcessors_data();
    void outsideAndFoldsAreTheProcessors();
    void overlapsAreOneOnScreenInFilesAndOnDevices_data();
    void overlapsAreOneOnScreenInFilesAndOnDevices();
    void stripsAreTheWhole();
    void thePictureGoesToTheDeviceOnce();
    void floatsAreTheProcessors();
    void failingDeviceIsReplaced();
    void isChosenByNameOnly();
};

namespace {

const View kView{64, 48, Vec2::Zero(), 1};

Points2 wave(const Points2& rest) {
    Points2 pose = rest;
    for (Eigen::Index i = 0; i < rest.cols(); ++i)
        pose.col(i) += 3 * Vec2(std::sin(rest(1, i) / 9.0), std::cos(rest(0, i) / 7.0));
    return pose;
}

MakeCellPainter devicePainter() {
    return cellPainters(BackEndKind::OpenCl, {},
                        [](const std::string& text) { qWarning("%s", text.c_str()); });
}

Image onDevice(const Image& source, const SimplicialMesh<2>& mesh, const Points2& pose, WarpOptions options,
               const View& view = kView) {
    options.makePainter = devicePainter();
    const WarpedPicture picture(source, mesh, pose, view, options);
    if (!picture.hasPainter()) throw std::runtime_error("no device paints");
    Image image = picture.header();
    image.data.resize(image.rowBytes() * static_cast<std::size_t>(image.height));
    picture.paint(0, image);
    if (!picture.hasPainter()) throw std::runtime_error("the device failed");
    return image;
}

/// One step; a colour of almost no alpha is a quotient of two small numbers and may be anything.
template <typename T>
bool agree(const Image& a, const Image& b) {
    const int last = a.channels - 1;
    for (int y = 0; y < a.height; ++y)
        for (int x = 0; x < a.width; ++x)
            for (int c = 0; c < a.channels; ++c) {
                const auto p = static_cast<float>(valueAt<T>(a, x, y, c)),
                           q = static_cast<float>(valueAt<T>(b, x, y, c));
                const bool faint =
                    a.alpha && c < last && static_cast<float>(valueAt<T>(a, x, y, last)) < 0.02F * kFull<T>;
                if (!faint && !(std::abs(p - q) <= 1)) return false;
            }
    return true;
}

bool agree(const Image& a, const Image& b) {
    return a.channels == b.channels && a.data.size() == b.data.size() &&
           withPixelType(a.type, [&](auto t) { return agree<decltype(t)>(a, b); });
}

}  // namespace

void TestOpenClWarp::agreesWithTheProcessor_data() {
    QTest::addColumn<int>("type");
    QTest::addColumn<int>("channels");
    QTest::addColumn<int>("filter");
    const auto row = [](PixelType type, int channels, Filter filter) {
        QTest::addRow("type %d channels %d filter %d", static_cast<int>(type), channels,
                      static_cast<int>(filter))
            << static_cast<int>(type) << channels << static_cast<int>(filter);
    };
    // A program is compiled for each filter.
    for (Filter filter : {Filter::Nearest, Filter::Bilinear, Filter::Bicubic, Filter::Ewa})
        row(PixelType::UInt8, 4, filter);
    row(PixelType::UInt16, 4, Filter::Ewa);
    for (int channels : {1, 3}) row(PixelType::UInt8, channels, Filter::Ewa);
    row(PixelType::UInt16, 3, Filter::Bilinear);
}

void TestOpenClWarp::agreesWithTheProcessor() {
    QFETCH(int, type);
    QFETCH(int, channels);
    QFETCH(int, filter);
    const Image source = randomPicture(64, 48, channels, static_cast<PixelType>(type), channels == 4);
    const auto mesh = rectangle({0, 0}, {64, 48}, 7);
    WarpOptions options;
    options.filter = static_cast<Filter>(filter);
    Points2 pose = wave(mesh.points);
    QVERIFY(agree(warpImage(source, mesh, pose, kView, options), onDevice(source, mesh, pose, options)));
    pose.row(0) *= 0.21;  // long ellipses, upper levels
    QVERIFY(agree(warpImage(source, mesh, pose, kView, options), onDevice(source, mesh, pose, options)));
}

void TestOpenClWarp::identityKeepsEveryBit() {
    for (PixelType type : {PixelType::UInt8, PixelType::UInt16}) {
        const Image source = randomPicture(64, 48, 4, type, true);
        const auto mesh = rectangle({0, 0}, {64, 48}, 7);
        QVERIFY(onDevice(source, mesh, mesh.points, {}).data == source.data);
    }
}

void TestOpenClWarp::outsideAndFoldsAreTheProcessors_data() {
    QTest::addColumn<int>("outside");
    for (int outside = 0; outside < 4; ++outside) QTest::addRow("outside %d", outside) << outside;
}

void TestOpenClWarp::outsideAndFoldsAreTheProcessors() {
    QFETCH(int, outside);
    const Image source = randomPicture(64, 48, 4, PixelType::UInt8, true);
    const auto mesh = rectangle({0, 0}, {64, 48}, 7);
    Points2 pose = wave(mesh.points);
    for (Eigen::Index i = 0; i < pose.cols(); ++i)
        if (pose(0, i) > 40) pose(0, i) = 80 - pose(0, i);  // the right third folded back
    WarpOptions options;
    options.outside = static_cast<Outside>(outside);
    options.colour = {0.2F, 0.4F, 0.1F, 0.5F};
    for (int c = 0; c < mesh.cellCount(); ++c) options.depth.push_back(static_cast<float>(c % 3));
    QVERIFY(agree(warpImage(source, mesh, pose, kView, options), onDevice(source, mesh, pose, options)));
}

void TestOpenClWarp::overlapsAreOneOnScreenInFilesAndOnDevices_data() {
    QTest::addColumn<int>("type");
    QTest::addColumn<int>("channels");
    QTest::addColumn<bool>("unassociated");
    QTest::addColumn<QString>("extension");
    QTest::newRow("8 bits") << static_cast<int>(PixelType::UInt8) << 4 << true << "png";
    QTest::newRow("grey, 8 bits") << static_cast<int>(PixelType::UInt8) << 2 << true << "png";
    QTest::newRow("16 bits") << static_cast<int>(PixelType::UInt16) << 4 << true << "png";
    QTest::newRow("8 bits, associated") << static_cast<int>(PixelType::UInt8) << 4 << false << "tif";
    QTest::newRow("16 bits, associated") << static_cast<int>(PixelType::UInt16) << 4 << false << "tif";
}

/// A rolled-up strip of many alphas is compared as the window draws it (at both of its qualities), as it is
/// exported, and as a device paints it.
void TestOpenClWarp::overlapsAreOneOnScreenInFilesAndOnDevices() {
    QFETCH(int, type);
    QFETCH(int, channels);
    QFETCH(bool, unassociated);
    QFETCH(QString, extension);
    Image source = randomPicture(91, 37, channels, static_cast<PixelType>(type), true);
    source.unassociated = true;
    source = converted(source, {source.type, channels, true, unassociated});
    const auto mesh = rectangle({0, 0}, {91, 37}, 24);
    const Points2 pose = rolledUp(mesh.points, {91, 37});
    const View view{160, 160, Vec2::Zero(), 1};
    const Pyramid pyramid(std::make_shared<const Image>(source));
    QTemporaryDir folder;
    const std::string path = folder.filePath("rolled." + extension).toStdString();
    for (const Filter filter : {Filter::Bilinear, Filter::Ewa}) {
        WarpOptions options;
        options.filter = filter;
        const Image screen = warpImage(pyramid, mesh, pose, view, options);
        QVERIFY(agree(screen, onDevice(source, mesh, pose, options, view)));
        writeWarped(path, WarpedPicture(source, mesh, pose, view, options));
        QVERIFY(readImage(path).data == screen.data);
    }
}

void TestOpenClWarp::stripsAreTheWhole() {
    const Image source = randomPicture(64, 48, 4, PixelType::UInt8, true);
    const auto mesh = rectangle({0, 0}, {64, 48}, 7);
    const Points2 pose = wave(mesh.points);
    WarpOptions options;
    const Image whole = onDevice(source, mesh, pose, options);
    options.makePainter = devicePainter();
    const WarpedPicture picture(source, mesh, pose, kView, options);
    for (int top : {0, 32}) {
        Image strip = picture.header();
        strip.height = top == 0 ? 32 : 16;
        strip.data.resize(strip.rowBytes() * static_cast<std::size_t>(strip.height));
        QVERIFY(picture.paint(top, strip));
        QVERIFY(std::equal(strip.data.begin(), strip.data.end(), whole.row(top)));
    }
}

/// For the later frames of a sequence only the cells' maps and the pixels' cells are copied to the device;
/// another picture replaces the first one.
void TestOpenClWarp::thePictureGoesToTheDeviceOnce() {
    std::string why;
    const auto picture = std::make_shared<OpenClPicture>(chooseOpenClDevice({}, why).value(), DeviceNotice());
    const Image source = randomPicture(64, 48, 4, PixelType::UInt8, true),
                other = randomPicture(64, 48, 4, PixelType::UInt8, false);
    const auto mesh = rectangle({0, 0}, {64, 48}, 7);
    WarpOptions options, onProcessor;
    options.filter = onProcessor.filter = Filter::Bilinear;
    options.makePainter = [&](const WarpJob& job) { return OpenClPicture::painter(picture, job); };
    const Pyramid pyramid(std::make_shared<const Image>(source));
    const auto frame = [&](double amount) {
        const Points2 pose = mesh.points + amount * (wave(mesh.points) - mesh.points);
        const std::size_t before = picture->copied().toDevice;
        const Image image = warpImage(pyramid, mesh, pose, kView, options);
        if (!agree(warpImage(pyramid, mesh, pose, kView, onProcessor), image))
            throw std::runtime_error("another picture");
        return picture->copied().toDevice - before;
    };
    std::size_t texels = 0;
    for (int k = 0; k < pyramid.levels(); ++k)
        texels += pyramid.level(k).data.size() + 3 * sizeof(std::int64_t);
    const std::size_t perCell = 9 * sizeof(double) + 4 * sizeof(float) + 4 * sizeof(int),
                      perFrame = mesh.cells.size() * perCell + 64 * 48 * sizeof(int);
    QCOMPARE(frame(0.2), texels + perFrame);
    QCOMPARE(frame(0.4), perFrame);
    QCOMPARE(frame(0.5), perFrame);
    const Points2 pose = wave(mesh.points);
    QVERIFY(agree(warpImage(other, mesh, pose, kView, onProcessor),
                  warpImage(other, mesh, pose, kView, options)));
    QCOMPARE(frame(0.6), texels + perFrame);
}

void TestOpenClWarp::floatsAreTheProcessors() {
    const auto mesh = rectangle({0, 0}, {64, 48}, 7);
    WarpOptions options;
    options.makePainter = devicePainter();
    for (PixelType type : {PixelType::Half, PixelType::Float}) {
        const Image source = randomPicture(64, 48, 4, type, true);
        QVERIFY(!WarpedPicture(source, mesh, wave(mesh.points), kView, options).hasPainter());
    }
}

void TestOpenClWarp::failingDeviceIsReplaced() {
    class Lost final : public CellPainter {
        bool paint(const WarpJob&, int, Image& strip) override {
            std::fill(strip.data.begin(), strip.data.end(), std::byte(77));
            return false;
        }
    };
    const Image source = randomPicture(64, 48, 4, PixelType::UInt8, true);
    const auto mesh = rectangle({0, 0}, {64, 48}, 7);
    const Points2 pose = wave(mesh.points);
    WarpOptions options;
    const Image expected = warpImage(source, mesh, pose, kView, options);
    options.makePainter = [](const WarpJob&) { return std::make_unique<Lost>(); };
    QVERIFY(warpImage(source, mesh, pose, kView, options).data == expected.data);
    OpenClDeviceInfo nowhere;
    nowhere.platform = 99;
    nowhere.name = "nowhere";
    std::vector<std::string> notices;
    const auto picture =
        std::make_shared<OpenClPicture>(nowhere, [&](const std::string& text) { notices.push_back(text); });
    options.makePainter = [&](const WarpJob& job) { return OpenClPicture::painter(picture, job); };
    for (int frame = 0; frame < 2; ++frame)  // it is said once
        QVERIFY(warpImage(source, mesh, pose, kView, options).data == expected.data);
    QCOMPARE(notices.size(), std::size_t(1));
}

void TestOpenClWarp::isChosenByNameOnly() {
    QVERIFY(!cellPainters(BackEndKind::Cpu));
    QVERIFY(!cellPainters(BackEndKind::Automatic));
    QVERIFY(cellPainters(BackEndKind::OpenCl));
}

QTEST_GUILESS_MAIN(TestOpenClWarp)
#include "test_opencl_warp.moc"
