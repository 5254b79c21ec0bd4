// The canvas, grabbed from the window, compared with the formula of a picture and with the exported file as
// other decoders read it (Qt's for PNG, plain OpenImageIO for EXR): every number of channels, depth and
// association, with the shape inside, covering and outside the view, at rest and bent; and 40 megapixels.
// Runs at one and at two device pixels per pixel (tests/app/CMakeLists.txt).
#include <OpenImageIO/imageio.h>

#include <QImageReader>
#include <QPainter>
#include <QPainterPath>
#include <cmath>
#include <functional>
#include <optional>

#include "app/engine/shape/depth.h"
#include "app/project/domain.h"
#include "app/session/opening.h"
#include "app/views/canvas/canvas.h"
#include "app/views/canvas/ground.h"
#include "tests/support/window_fixture.h"
#include "warp/warped_picture.h"

using namespace wend;
using namespace wend::test;

/// Red, green, blue and alpha of the screen in [0, 1], colours associated.
using Colour = Eigen::Array4d;
using Expected = std::function<std::optional<Colour>(const Vec2&)>;  // nothing: not to be compared

class TestCanvasPictures : public QObject {
    Q_OBJECT
  private slots:
    void init();
    void canvasIsTheFile_data();
    void canvasIsTheFile();
    void fortyMegapixels();
    void partsAndHolesAreBentAndExported();
    void limbOverTheBodyIsWhole();
    void checksStandOutFromThePicture_data();
    void checksStandOutFromThePicture();
    void orientedPhotographsAreUpright_data();
    void orientedPhotographsAreUpright();

  private:
    void open(const QString& path);
    void openCutOut(const QImage& image);
    void drag(const std::vector<int>& pins, const Vec2& by);
    QImage exported(const View& view);
    void canvasIsExported();
    void bend();
    void setView(double zoom, const Vec2& corner);
    void everyViewShows(const Expected& expected, int tolerance);
    void viewShows(const Expected& expected, int tolerance);

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<ShapeSession> m_session;
    std::unique_ptr<ShapeCanvas> m_canvas;
};

namespace {

constexpr int kWidth = 901, kHeight = 667;  // odd, and larger than the canvas

double screenOf(double linear) {
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

Colour associated(Colour colour) {
    colour.head<3>() *= colour[3];
    return colour;
}

struct Kind {
    int channels = 4;
    OIIO::TypeDesc type = OIIO::TypeDesc::UINT8;
    bool isAssociated = false;  // in the file
    int width = kWidth, height = kHeight;

    bool alpha() const { return channels % 2 == 0; }
    bool linear() const { return type == OIIO::TypeDesc::HALF || type == OIIO::TypeDesc::FLOAT; }
    /// Returns a smooth colour, so that no filter changes it, that differs in every direction; colours are
    /// not associated, in the file's light.
    Colour colourAt(const Vec2& p) const {
        const double x = p.x() / width, y = p.y() / height;
        const double first = 0.15 + 0.7 * x;
        if (channels < 3) return {first, first, first, alpha() ? 0.3 + 0.6 * y : 1};
        return {first, 0.85 - 0.6 * y, 0.3 + 0.2 * (x + y), alpha() ? 0.3 + 0.6 * y : 1};
    }
    Colour shownAt(const Vec2& p) const {
        Colour colour = colourAt(p);
        if (linear()) colour.head<3>() = colour.head<3>().unaryExpr(&screenOf);
        return associated(colour);
    }
};

/// Writes the file with OpenImageIO alone.
void writeFile(const QString& path, const Kind& kind, int orientation = 1) {
    OIIO::ImageSpec spec(kind.width, kind.height, kind.channels, kind.type);
    static const std::vector<std::string> kNames[] = {
        {"Y"}, {"Y", "A"}, {"R", "G", "B"}, {"R", "G", "B", "A"}};
    spec.channelnames = kNames[kind.channels - 1];
    spec.alpha_channel = kind.alpha() ? kind.channels - 1 : -1;
    spec.attribute("oiio:UnassociatedAlpha", kind.isAssociated ? 0 : 1);
    spec.attribute("Orientation", orientation);
    spec.attribute("Compression", "jpeg:100");
    spec.attribute("png:compressionLevel", 1);
    const auto output = OIIO::ImageOutput::create(path.toStdString());
    QVERIFY(output && output->open(path.toStdString(), spec));
    std::vector<float> row;
    for (int y = 0; y < kind.height; ++y) {
        row.clear();
        for (int x = 0; x < kind.width; ++x) {
            const Colour colour = kind.colourAt({x + 0.5, y + 0.5});
            for (int c = 0; c < kind.channels; ++c) {
                const bool isAlpha = kind.alpha() && c == kind.channels - 1;
                row.push_back(static_cast<float>(isAlpha ? colour[3]
                                                         : colour[c] * (kind.isAssociated ? colour[3] : 1)));
            }
        }
        QVERIFY(output->write_scanline(y, 0, OIIO::TypeDesc::FLOAT, row.data()));
    }
    QVERIFY(output->close());
}

/// A picture file as the screen should show it, read by others.
class Decoded {
  public:
    explicit Decoded(const QString& path) {
        if (path.endsWith(QStringLiteral(".exr")))
            readLinear(path);
        else
            readCoded(path);
    }
    int width() const { return m_width; }
    int height() const { return m_height; }

    /// Interpolates between pixels; returns nothing if a border of the covered area is within `near`.
    std::optional<Colour> at(const Vec2& p, double near) const {
        const int covered = coveredAround(p);
        for (const Vec2& d : {Vec2(-near, 0), Vec2(near, 0), Vec2(0, -near), Vec2(0, near)})
            if (coveredAround(p + d) != covered) return {};
        if (covered != 0 && covered != 36) return {};
        const int i = static_cast<int>(std::floor(p.x() - 0.5)),
                  j = static_cast<int>(std::floor(p.y() - 0.5));
        const double s = p.x() - 0.5 - i, t = p.y() - 0.5 - j;
        return Colour((1 - t) * ((1 - s) * texel(i, j) + s * texel(i + 1, j)) +
                      t * ((1 - s) * texel(i, j + 1) + s * texel(i + 1, j + 1)));
    }

  private:
    /// Returns how many of 36 pixels are not transparent.
    int coveredAround(const Vec2& p) const {
        const int i = static_cast<int>(std::floor(p.x() - 0.5)),
                  j = static_cast<int>(std::floor(p.y() - 0.5));
        int covered = 0;
        for (int y = j - 2; y < j + 4; ++y)
            for (int x = i - 2; x < i + 4; ++x) covered += texel(x, y)[3] > 0 ? 1 : 0;
        return covered;
    }
    Colour texel(int x, int y) const {
        if (x < 0 || y < 0 || x >= m_width || y >= m_height) return Colour::Zero();
        return m_texels[static_cast<std::size_t>(y) * static_cast<std::size_t>(m_width) +
                        static_cast<std::size_t>(x)];
    }

    void readCoded(const QString& path) {
        QImageReader reader(path);
        reader.setAutoTransform(true);
        const QImage image = reader.read().convertToFormat(QImage::Format_RGBA64);
        m_width = image.width(), m_height = image.height();
        for (int y = 0; y < m_height; ++y)
            for (int x = 0; x < m_width; ++x) {
                const QRgba64 c = reinterpret_cast<const QRgba64*>(image.constScanLine(y))[x];
                m_texels.push_back(associated(Colour(c.red(), c.green(), c.blue(), c.alpha()) / 65535.0));
            }
    }

    void readLinear(const QString& path) {
        const auto input = OIIO::ImageInput::open(path.toStdString());
        if (!input) return;
        const OIIO::ImageSpec& spec = input->spec();
        m_width = spec.width, m_height = spec.height;
        const std::size_t channels = static_cast<std::size_t>(spec.nchannels);
        std::vector<float> pixels(static_cast<std::size_t>(m_width) * m_height * channels);
        input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, pixels.data());
        const auto place = [&](const char* name) {
            return static_cast<std::size_t>(spec.channelindex(name));
        };
        const bool grey = spec.channelindex("Y") >= 0, alpha = spec.channelindex("A") >= 0;
        for (std::size_t p = 0; p < pixels.size(); p += channels) {
            const double a = alpha ? pixels[p + place("A")] : 1;
            const auto light = [&](const char* name) {
                return a > 0 ? screenOf(pixels[p + place(grey ? "Y" : name)] / a) : 0;
            };
            m_texels.push_back(associated({light("R"), light("G"), light("B"), a}));
        }
    }

    int m_width = 0, m_height = 0;
    std::vector<Colour> m_texels;
};

Colour colourOf(QRgb c) {
    return Colour(qRed(c), qGreen(c), qBlue(c), qAlpha(c)) / 255.0;
}

/// Returns the canvas's drawing outside the shape.
QImage ground(const ShapeCanvas& canvas, const QSizeF& picture) {
    QImage image(canvas.size() * canvas.devicePixelRatioF(), QImage::Format_RGB32);
    image.setDevicePixelRatio(canvas.devicePixelRatioF());
    QPainter painter(&image);
    const Theme theme = Theme::of(canvas.palette());
    const QRectF paper({0, 0}, picture);
    Ground().paint(painter, {canvas.view(), canvas.size(), 1, paper, {}, theme.dark}, theme, false);
    return image;
}

}  // namespace

void TestCanvasPictures::init() {
    m_canvas.reset();
    m_folder = std::make_unique<QTemporaryDir>();
    m_session = std::make_unique<ShapeSession>();
    m_canvas = std::make_unique<ShapeCanvas>(*m_session);
    m_canvas->resize(420, 333);
    m_canvas->viewport().set(&Looks::hidden, true);
    m_canvas->show();
}

void TestCanvasPictures::open(const QString& path) {
    OpenedFile file = openFile(path);
    auto project = copyOf(*file.project);
    domainOf(*project).outline = OutlineKind::Frame;
    domainOf(*project).vertices = 300;
    file.project = project;
    m_session->document().open(std::move(file));
    QVERIFY(settle(*m_session));
}

void TestCanvasPictures::bend() {
    const int pin = m_session->addPin({0.2 * kWidth, 0.3 * kHeight, 0});
    m_session->addPin({0.8 * kWidth, 0.7 * kHeight, 0});
    m_session->selection().set({pin});
    m_session->gestures().begin();
    m_session->gestures().moveBy({90, 60, 0});
    m_session->gestures().end(0.2);
    QVERIFY(settle(*m_session));
}

/// `corner` is the place to show in the upper left corner of the widget.
void TestCanvasPictures::setView(double zoom, const Vec2& corner) {
    m_canvas->zoomTo(zoom);
    const QPoint at(m_canvas->width() / 2, m_canvas->height() / 2);
    const QPoint by = -m_canvas->toWidget(corner).toPoint();
    QTest::mousePress(m_canvas.get(), Qt::MiddleButton, {}, at);
    QTest::mouseMove(m_canvas.get(), at + by);
    QTest::mouseRelease(m_canvas.get(), Qt::MiddleButton, {}, at + by);
}

void TestCanvasPictures::viewShows(const Expected& expected, int tolerance) {
    QVERIFY(QTest::qWaitFor([&] { return m_canvas->isSettled(); }, 60000));
    const QImage shown = m_canvas->grab().toImage();
    const auto& picture = *m_session->document().picture();
    const QImage below = ground(*m_canvas, QSizeF(picture.width, picture.height));
    QCOMPARE(shown.size(), below.size());
    const double ratio = shown.devicePixelRatio();
    int compared = 0;
    const int step = 2 * static_cast<int>(ratio);
    for (int y = 0; y < shown.height(); y += step)
        for (int x = y / step % 3; x < shown.width(); x += 3) {
            const auto colour = expected(m_canvas->toShape(QPointF(x + 0.5, y + 0.5) / ratio));
            if (!colour) continue;
            ++compared;
            const Colour all = *colour + (1 - (*colour)[3]) * colourOf(below.pixel(x, y));
            const Colour off = 255 * (all - colourOf(shown.pixel(x, y))).abs();
            QVERIFY2(off.maxCoeff() <= tolerance,
                     qPrintable(QString("pixel %1, %2 at zoom %3: off by %4 %5 %6")
                                    .arg(x)
                                    .arg(y)
                                    .arg(m_canvas->view().zoom())
                                    .arg(off[0])
                                    .arg(off[1])
                                    .arg(off[2])));
        }
    QVERIFY(compared > shown.width() * shown.height() / (15 * step));
}

/// Checks views with the shape inside, at two levels of the pyramid; covering the view; crossing its borders;
/// and outside.
void TestCanvasPictures::everyViewShows(const Expected& expected, int tolerance) {
    m_canvas->fit();
    viewShows(expected, tolerance);
    if (QTest::currentTestFailed()) return;
    const std::pair<double, Vec2> views[] = {
        {0.21, {-300, -400}}, {1, {200, 150}}, {1, {700.5, -120}}, {4, {333, 301}}, {1, {-2000, 40}}};
    for (const auto& [zoom, corner] : views) {
        setView(zoom, corner);
        viewShows(expected, tolerance);
        if (QTest::currentTestFailed()) return;
    }
}

void TestCanvasPictures::canvasIsTheFile_data() {
    QTest::addColumn<QString>("extension");
    QTest::addColumn<int>("channels");
    QTest::addColumn<int>("type");
    QTest::addColumn<bool>("associated");
    const QString png = QStringLiteral("png"), exr = QStringLiteral("exr"), tiff = QStringLiteral("tif");
    const std::tuple<const char*, int, QString> types[] = {{"8 bits", OIIO::TypeDesc::UINT8, png},
                                                           {"16 bits", OIIO::TypeDesc::UINT16, png},
                                                           {"half", OIIO::TypeDesc::HALF, exr},
                                                           {"float", OIIO::TypeDesc::FLOAT, exr}};
    const char* const kChannels[] = {"grey", "grey and alpha", "RGB", "RGBA"};
    for (const auto& [name, type, extension] : types) {
        for (int channels = 1; channels <= 4; ++channels)
            QTest::addRow("%s, %s", kChannels[channels - 1], name)
                << extension << channels << type << (extension == exr);
        // The association is the one that the others do not have.
        for (const int channels : {2, 4})
            if (type != OIIO::TypeDesc::HALF)
                QTest::addRow("%s, %s, %s", kChannels[channels - 1], name,
                              extension == exr ? "straight" : "associated")
                    << tiff << channels << type << (extension != exr);
    }
}

void TestCanvasPictures::canvasIsTheFile() {
    QFETCH(QString, extension);
    QFETCH(int, channels);
    QFETCH(int, type);
    QFETCH(bool, associated);
    const Kind kind{channels, OIIO::TypeDesc(static_cast<OIIO::TypeDesc::BASETYPE>(type)), associated};
    const QString path = m_folder->filePath("picture." + extension),
                  written = m_folder->filePath(kind.linear() ? "bent.exr" : "bent.png");
    writeFile(path, kind);
    open(path);
    const auto atRest = [&](const Vec2& p) -> std::optional<Colour> {
        const double near = 2 / m_canvas->view().zoom();
        const double x = std::min(p.x(), kWidth - p.x()), y = std::min(p.y(), kHeight - p.y());
        if (std::min(x, y) < -near) return Colour(0, 0, 0, 0);
        if (std::min(x, y) < near) return {};
        return kind.shownAt(p);
    };
    everyViewShows(atRest, 2);
    if (QTest::currentTestFailed()) return;
    bend();
    const View view{kWidth + 400, kHeight + 400, Vec2(-200, -200), 1};
    const auto& frame = *m_session->motion().frame<2>();
    writeWarped(written.toStdString(),
                WarpedPicture(*m_session->document().picture(), *frame.rest, frame.pose, view, {}));
    const Decoded file(written);
    QCOMPARE(file.width(), view.width);
    everyViewShows([&](const Vec2& p) { return file.at(p - view.origin, 2 / m_canvas->view().zoom()); }, 3);
}

/// A photograph of a large camera is compared as a whole and in single pixels.
void TestCanvasPictures::fortyMegapixels() {
    const Kind kind{.channels = 3, .width = 7303, .height = 5477};
    const QString path = m_folder->filePath(QStringLiteral("large.png"));
    writeFile(path, kind);
    open(path);
    const auto atRest = [&](const Vec2& p) -> std::optional<Colour> {
        const double near = 2 / m_canvas->view().zoom();
        const double inside = std::min({p.x(), kind.width - p.x(), p.y(), kind.height - p.y()});
        if (inside < -near) return Colour(0, 0, 0, 0);
        if (inside < near) return {};
        return kind.shownAt(p);
    };
    m_canvas->fit();
    viewShows(atRest, 2);
    for (const double zoom : {0.3, 1.0, 4.0}) {
        if (QTest::currentTestFailed()) return;
        setView(zoom, {5200.25, 4300.5});
        viewShows(atRest, 2);
    }
}

/// Opens a picture whose visible part becomes the shape.
void TestCanvasPictures::openCutOut(const QImage& image) {
    const QString path = m_folder->filePath(QStringLiteral("cutout.png"));
    QVERIFY(image.save(path));
    OpenedFile file = openFile(path);
    auto project = copyOf(*file.project);
    domainOf(*project).vertices = 500;
    file.project = project;
    m_session->document().open(std::move(file));
    QVERIFY(settle(*m_session));
}

void TestCanvasPictures::drag(const std::vector<int>& pins, const Vec2& by) {
    m_session->selection().set(pins);
    m_session->gestures().begin();
    m_session->gestures().moveBy(inSpace(by));
    m_session->gestures().end(0.2);
    QVERIFY(settle(*m_session));
}

/// Exports a part of the plane and reads it by Qt.
QImage TestCanvasPictures::exported(const View& view) {
    const QString path = m_folder->filePath(QStringLiteral("exported.png"));
    const auto& frame = *m_session->motion().frame<2>();
    WarpOptions options;
    options.depth = cellDepths({}, *frame.rest);
    writeWarped(path.toStdString(),
                WarpedPicture(*m_session->document().picture(), *frame.rest, frame.pose, view, options));
    return QImage(path).convertToFormat(QImage::Format_ARGB32);
}

/// At 100 % the canvas equals the export pixel by pixel.
void TestCanvasPictures::canvasIsExported() {
    setView(1, {-20, -30});
    QVERIFY(QTest::qWaitFor([&] { return m_canvas->isSettled(); }, 60000));
    const QImage shown = m_canvas->grab().toImage();
    const auto& picture = *m_session->document().picture();
    const QImage below = ground(*m_canvas, QSizeF(picture.width, picture.height));
    const double ratio = shown.devicePixelRatio();
    const QImage file = exported({shown.width(), shown.height(), m_canvas->toShape({0, 0}), 1 / ratio});
    for (int y = 0; y < shown.height(); ++y)
        for (int x = 0; x < shown.width(); ++x) {
            const Colour colour = associated(colourOf(file.pixel(x, y)));
            const Colour all = colour + (1 - colour[3]) * colourOf(below.pixel(x, y));
            const Colour off = 255 * (all - colourOf(shown.pixel(x, y))).abs();
            QVERIFY2(off.maxCoeff() <= 2, qPrintable(QString("pixel %1, %2").arg(x).arg(y)));
        }
}

/// The shape is a ring and a disc. A part moves as its pins do if they have all moved alike, and nothing else
/// moves.
void TestCanvasPictures::partsAndHolesAreBentAndExported() {
    const QRectF ring(30, 40, 120, 120), hole(65, 75, 50, 50), disc(220, 50, 90, 90);
    const auto drawn = [&](const QPointF& ringBy, const QPointF& discBy) {
        QImage image(361, 227, QImage::Format_RGBA8888);
        image.fill(Qt::transparent);
        QPainter painter(&image);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(Qt::NoPen);
        QPainterPath path;
        path.addEllipse(ring.translated(ringBy));
        path.addEllipse(hole.translated(ringBy));
        painter.fillPath(path, QColor(210, 80, 40));
        painter.setBrush(QColor(30, 120, 190));
        painter.drawEllipse(disc.translated(discBy));
        return image;
    };
    const View whole{361, 227, Vec2::Zero(), 1};
    const auto difference = [&](const QPointF& ringBy, const QPointF& discBy) {
        const QImage file = exported(whole), expected = drawn(ringBy, discBy);
        double most = 0;
        for (int y = 0; y < whole.height; ++y)
            for (int x = 0; x < whole.width; ++x)
                most = std::max(most, (associated(colourOf(file.pixel(x, y))) -
                                       associated(colourOf(expected.pixel(x, y))))
                                          .abs()
                                          .maxCoeff());
        return 255 * most;
    };
    openCutOut(drawn({}, {}));
    const int left = m_session->addPin({48, 100, 0}), right = m_session->addPin({132, 100, 0}),
              other = m_session->addPin({265, 95, 0});
    QVERIFY(left >= 0 && right >= 0 && other >= 0);
    drag({left, right, other}, {20, 31});
    QVERIFY2(difference({20, 31}, {20, 31}) < 3, qPrintable(QString::number(difference({20, 31}, {20, 31}))));
    canvasIsExported();
    drag({left, right}, {-9, -40});
    QVERIFY2(difference({11, -9}, {20, 31}) < 3, qPrintable(QString::number(difference({11, -9}, {20, 31}))));
    drag({other}, {14, 20});
    QVERIFY2(difference({11, -9}, {34, 51}) < 3, qPrintable(QString::number(difference({11, -9}, {34, 51}))));
    QCOMPARE(qAlpha(exported(whole).pixel(90 + 11, 100 - 9)), 0);  // in the hole
    canvasIsExported();
}

/// An arm with soft edges is rotated over the body that it is attached to: the body is visible up to the arm
/// itself.
void TestCanvasPictures::limbOverTheBodyIsWhole() {
    QImage image(361, 227, QImage::Format_RGBA8888);
    image.fill(Qt::transparent);
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(QColor(200, 90, 60), 26, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPolyline(QPolygonF({{40, 180}, {40, 60}, {130, 40}}));
    painter.setPen(QPen(QColor(60, 110, 200), 80, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(QPointF(90, 180), QPointF(300, 180));
    painter.end();
    openCutOut(image);
    const int hand = m_session->addPin({126, 41, 0});
    QVERIFY(hand >= 0 && m_session->addPin({250, 180, 0}) >= 0 && m_session->addPin({120, 180, 0}) >= 0);
    drag({hand}, {60, 130});
    canvasIsExported();
    const QImage file = exported({361, 227, Vec2::Zero(), 1});
    // The body is opaque away from its borders and from the arm, and so is the arm over it.
    const auto& frame = *m_session->motion().frame<2>();
    int several = 0;
    for (int y = 155; y < 205; ++y)
        for (int x = 110; x < 290; ++x) {
            int cells = 0;
            for (const Cell<2>& cell : frame.rest->cells) {
                const Vec2 p(x + 0.5, y + 0.5);
                bool inside = true;
                for (int k = 0; k < 3; ++k) {
                    const Vec2 a = frame.pose.col(cell[k]), b = frame.pose.col(cell[(k + 1) % 3]);
                    inside =
                        inside && (b.x() - a.x()) * (p.y() - a.y()) - (b.y() - a.y()) * (p.x() - a.x()) > 0;
                }
                cells += inside ? 1 : 0;
            }
            several += cells > 1 ? 1 : 0;
            QCOMPARE(qAlpha(file.pixel(x, y)), 255);
        }
    QVERIFY(several > 500);
}

void TestCanvasPictures::orientedPhotographsAreUpright_data() {
    QTest::addColumn<int>("orientation");
    for (int orientation = 1; orientation <= 8; ++orientation)
        QTest::addRow("%d", orientation) << orientation;
}

/// Qt reads the orientation tag itself.
void TestCanvasPictures::orientedPhotographsAreUpright() {
    QFETCH(int, orientation);
    const QString path = m_folder->filePath(QStringLiteral("photograph.jpg"));
    writeFile(path, {.channels = 3}, orientation);
    open(path);
    const Decoded file(path);
    QCOMPARE(file.width(), orientation < 5 ? kWidth : kHeight);
    everyViewShows([&](const Vec2& p) { return file.at(p, 2 / m_canvas->view().zoom()); }, 4);
}

void TestCanvasPictures::checksStandOutFromThePicture_data() {
    QTest::addColumn<Appearance>("appearance");
    QTest::addColumn<QColor>("ink");
    QTest::newRow("dark ink, dark window") << Appearance::Dark << QColor(0x11, 0x11, 0x11);
    QTest::newRow("light ink, dark window") << Appearance::Dark << QColor(0xee, 0xdd, 0xcc);
    QTest::newRow("dark ink, light window") << Appearance::Light << QColor(0x11, 0x11, 0x11);
    QTest::newRow("white ink, light window") << Appearance::Light << QColor(Qt::white);
}

/// A ring of ink is seen on the checks within it and around it.
void TestCanvasPictures::checksStandOutFromThePicture() {
    QFETCH(Appearance, appearance);
    QFETCH(QColor, ink);
    QImage image(200, 200, QImage::Format_ARGB32);
    image.fill(Qt::transparent);
    QPainter painter(&image);
    painter.setPen(QPen(ink, 14));
    painter.drawEllipse(QPointF(100, 100), 70, 70);
    painter.end();
    m_canvas->setPalette(wendPalette(appearance, {}));
    openCutOut(image);
    QVERIFY(QTest::qWaitFor([&] { return m_canvas->isSettled(); }, 20000));
    const QImage seen = m_canvas->grab().toImage();
    const auto grayAt = [&](const Vec2& p) {
        return qGray(seen.pixel((m_canvas->toWidget(p) * seen.devicePixelRatio()).toPoint()));
    };
    const int ring = grayAt({100, 30});
    QVERIFY(std::abs(ring - qGray(ink.rgb())) < 6);
    for (const Vec2& p : {Vec2(100, 100), Vec2(91, 103), Vec2(20, 20), Vec2(185, 30)})
        QVERIFY2(std::abs(grayAt(p) - ring) > 50, qPrintable(QString::number(grayAt(p))));
}

QTEST_MAIN(TestCanvasPictures)
#include "test_canvas_pictures.moc"
