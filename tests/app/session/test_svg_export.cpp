// SVG files of projects whose pictures are SVG drawings: Qt's library draws them as the picture of the same
// pose.

#include <QImage>
#include <QPainter>
#include <QSvgRenderer>
#include <QTemporaryDir>
#include <QtTest>
#include <cmath>
#include <fstream>
#include <pugixml.hpp>

#include "app/engine/shape/shape_builder.h"
#include "app/output/run.h"
#include "app/project/domain.h"
#include "app/project/edits/scaled_project.h"
#include "app/project/file/project_reader.h"
#include "app/project/file/project_writer.h"
#include "app/project/project.h"
#include "app/session/opening.h"
#include "core/base/error.h"
#include "core/integration/deformer.h"
#include "tests/support/pictures.h"

using namespace wend;
using namespace wend::test;

namespace {

constexpr const char* kDrawing =
    "<?xml version='1.0'?>\n"
    "<svg xmlns='http://www.w3.org/2000/svg' width='64mm' height='48mm' viewBox='0 0 64 48'>\n"
    "<g id='body'><ellipse cx='32' cy='24' rx='24' ry='16' fill='#3a7'/>"
    "<path d='M14 23H50V25H14Z' fill='#fff'/>"
    "<path d='M20 30H44' fill='none' stroke='#3a7' stroke-width='2'/></g>\n"  // as what is below it
    "<g id='eye'><circle cx='40' cy='18' r='4' fill='#222'/><circle cx='41' cy='17' r='1' fill='#fff'/></g>\n"
    "</svg>\n";

QImage drawn(const QString& path, const QSize& size) {
    QSvgRenderer renderer(path);
    QImage image(size, QImage::Format_RGBA8888_Premultiplied);
    image.fill(Qt::transparent);
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    renderer.render(&painter);
    return image;
}

struct Difference {
    double mean = 0;
    int strong = 0;  // pixels that differ by more than a third
};

Difference differenceOf(const QImage& a, const QImage& b) {
    Difference difference;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x) {
            const QColor p = a.pixelColor(x, y), q = b.pixelColor(x, y);
            // Colours are associated, so transparent pixels have none.
            const double most = std::max<double>({std::abs(p.redF() * p.alphaF() - q.redF() * q.alphaF()),
                                                  std::abs(p.greenF() * p.alphaF() - q.greenF() * q.alphaF()),
                                                  std::abs(p.blueF() * p.alphaF() - q.blueF() * q.alphaF()),
                                                  std::abs(p.alphaF() - q.alphaF())});
            difference.mean += most / (double(a.width()) * a.height());
            if (most > 1.0 / 3) ++difference.strong;
        }
    return difference;
}

}  // namespace

class TestSvgExport : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase();
    void bentDrawingsLookLikeTheirPicture();
    void restIsTheDrawing();
    void partsAreGroups();
    void picturesAmongParts();
    void canvasIsTheViewBox();
    void framesAreFiles();
    void otherPicturesAreRefused();
    void sizesAreKept();
    void sizesAreRead_data();
    void sizesAreRead();

  private:
    QString at(const QString& name) const { return m_folder.filePath(name); }
    LoadedProject project(const std::string& domain, const std::string& rest = "") const {
        return parseProject(
            R"({"format": "wend", "version": 1, "domain": {"vertices": 6000, )" + domain + "}" + rest + "}",
            at("project.wend").toStdString());
    }
    LoadedProject bent() const {
        return project(R"("image": "drawing.svg", "size": [640, 480], "outline": {"from": "alpha"})",
                       R"(, "handles": [{"name": "held", "at": {"points": [[120, 240]]}},
                           {"name": "pulled", "at": {"points": [[520, 240]]}, "motion": [{"kind": "curve",
                            "interpolation": "polyline", "points": [[520, 240], [470, 330]], "time": [0, 1]}]}])");
    }
    void run(const LoadedProject& loaded, const QStringList& names, const CanvasChoice& canvas = {},
             const QString& frames = {}) {
        RunOptions options;
        for (const QString& name : names) options.outputs.image.push_back(at(name).toStdString());
        if (!frames.isEmpty()) options.outputs.frames = {at(frames).toStdString()}, options.outputs.count = 3;
        options.canvas = canvas;
        options.backEnd = BackEndKind::Cpu;
        RunWatch watch;
        m_notices.clear();
        watch.notice = [this](const std::string& text) { m_notices << QString::fromStdString(text); };
        const AdvanceResult result =
            runProject(*loaded.project, at("project.wend").toStdString(), options, watch);
        QVERIFY2(result.outcome == Outcome::Done, result.message.text().c_str());
    }
    pugi::xml_document parsed(const QString& name) const {
        pugi::xml_document document;
        document.load_file(at(name).toStdString().c_str());
        return document;
    }

    QTemporaryDir m_folder;
    QStringList m_notices;
};

void TestSvgExport::initTestCase() {
    std::ofstream(at("drawing.svg").toStdString()) << kDrawing;
    writeImage(at("board.png").toStdString(), plainPicture(200, 100, {0, 0, 255, 255}));
}

/// Edges may be half a pixel apart: the picture is bent cell by cell, curves smoothly, and both are smoothed.
void TestSvgExport::bentDrawingsLookLikeTheirPicture() {
    run(bent(), {"bent.png", "bent.svg"});
    const QImage picture(at("bent.png")), rest = drawn(at("drawing.svg"), picture.size());
    QCOMPARE(picture.size(), QSize(640, 480));
    const QImage paths = drawn(at("bent.svg"), picture.size());
    const Difference own = differenceOf(picture, paths), moved = differenceOf(picture, rest);
    QVERIFY2(own.mean < 0.004, qPrintable(QString::number(own.mean)));
    QVERIFY2(own.strong < 40, qPrintable(QString::number(own.strong)));
    QVERIFY2(moved.mean > 10 * own.mean, qPrintable(QString::number(moved.mean)));
    const auto document = parsed("bent.svg");
    const pugi::xml_node svg = document.document_element();
    QCOMPARE(svg.attribute("width").value(), "64mm");
    QCOMPARE(svg.attribute("viewBox").value(), "0 0 64 48");
    QCOMPARE(document.select_node("//path[@stroke]").node().attribute("stroke-width").value(), "2");
}

void TestSvgExport::restIsTheDrawing() {
    run(project(R"("image": "drawing.svg", "outline": {"from": "frame"})",
                R"(, "handles": [{"at": {"points": [[100, 100]]}}])"),
        {"rest.svg"});
    const QSize size(960, 720);
    const Difference own = differenceOf(drawn(at("drawing.svg"), size), drawn(at("rest.svg"), size));
    QVERIFY2(own.mean < 0.0005 && own.strong == 0, qPrintable(QString::number(own.mean)));
}

/// Each part follows its own mesh, under its name.
void TestSvgExport::partsAreGroups() {
    run(project(
            R"("size": [640, 480], "outline": {"from": "alpha"}, "parts": [
                  {"layer": {"file": "drawing.svg", "name": "eye"}, "opacity": 0.5, "blend": "multiply"},
                  {"layer": {"file": "drawing.svg", "name": "body"}, "hidden": true}])",
            R"(, "handles": [{"at": {"part": "body", "points": [[320, 240]]}}, {"at": {"part": "eye", "points": [[400, 180]]},
                     "motion": [{"kind": "translate", "by": [-100, 50], "time": [0, 1]}]}])"),
        {"parts.svg", "parts.png"});
    const auto document = parsed("parts.svg");
    const auto groups = document.document_element().children("g");
    QStringList found;
    for (const pugi::xml_node& group : groups)
        found << QString("%1 %2 %3")
                     .arg(group.attribute("inkscape:label").value(), group.attribute("opacity").value(),
                          group.attribute("style").value());
    QCOMPARE(found, (QStringList{"body  display:none;", "eye 0.5 mix-blend-mode:multiply;"}));
    // 100 pixels are 10 of the drawing's units.
    const auto eye = document.select_node("//g[@inkscape:label='eye']//path").node();
    const QStringList start = QString(eye.attribute("d").value()).mid(1).split('C').first().split(',');
    QVERIFY(std::abs(start[0].toDouble() - 34) < 0.01 && std::abs(start[1].toDouble() - 23) < 0.01);
    const QImage picture(at("parts.png"));
    QCOMPARE(picture.size(), QSize(640, 480));
}

/// A part made of pixels is a picture at its place in the order, and one line names it.
void TestSvgExport::picturesAmongParts() {
    run(project(
            R"("size": [640, 480], "outline": {"from": "alpha"}, "parts": [
                  {"layer": {"file": "drawing.svg", "name": "eye"}},
                  {"name": "board", "image": "board.png", "at": [300, 100], "outline": {"from": "frame"}},
                  {"layer": {"file": "drawing.svg", "name": "body"}}])",
            R"(, "handles": [{"at": {"part": "body", "points": [[320, 240]]}}, {"at": {"part": "eye", "points": [[400, 180]]}},
                     {"at": {"part": "board", "points": [[320, 140]]}}])"),
        {"mixed.svg", "mixed.png"});
    QCOMPARE(m_notices.filter("board").size(), 1);
    QVERIFY(m_notices.filter("board").first().contains("becomes a picture"));
    const auto document = parsed("mixed.svg");
    QStringList kinds;
    for (const pugi::xml_node& child : document.document_element().children()) kinds << child.name();
    QCOMPARE(kinds, (QStringList{"g", "image", "g"}));
    const QImage picture(at("mixed.png"));
    const Difference own = differenceOf(picture, drawn(at("mixed.svg"), picture.size()));
    QVERIFY2(own.mean < 0.004, qPrintable(QString::number(own.mean)));
}

void TestSvgExport::canvasIsTheViewBox() {
    CanvasChoice part(Canvas::Part);
    part.part = {100, 50, 320, 240};
    run(bent(), {"part.svg", "part.png"}, part);
    const auto document = parsed("part.svg");
    QCOMPARE(document.document_element().attribute("viewBox").value(), "10 5 32 24");
    QCOMPARE(document.document_element().attribute("width").value(), "32mm");
    const Difference own = differenceOf(QImage(at("part.png")), drawn(at("part.svg"), {320, 240}));
    QVERIFY2(own.mean < 0.004, qPrintable(QString::number(own.mean)));
    CanvasChoice wide;
    wide.width = 1000;
    run(bent(), {"wide.svg"}, wide);
    QCOMPARE(parsed("wide.svg").document_element().attribute("width").value(), "1000");
}

void TestSvgExport::framesAreFiles() {
    run(bent(), {}, {}, "frame_##.svg");
    const QSize size(640, 480);
    run(bent(), {"bent.svg"});
    QVERIFY(differenceOf(drawn(at("frame_02.svg"), size), drawn(at("bent.svg"), size)).mean < 1e-6);
    QVERIFY(differenceOf(drawn(at("frame_00.svg"), size), drawn(at("drawing.svg"), size)).mean < 0.0005);
}

void TestSvgExport::otherPicturesAreRefused() {
    const LoadedProject other = project(R"("image": "board.png")");
    RunOptions options;
    options.outputs.image = {at("no.svg").toStdString()};
    try {
        runProject(*other.project, at("project.wend").toStdString(), options);
        QFAIL("it is written");
    } catch (const InputError& error) {
        QVERIFY(QString(error.what()).contains("no.svg: the project's picture is no SVG drawing"));
    }
    QVERIFY(!QFile::exists(at("no.svg")));
    options.outside = Outside::Original;
    QVERIFY_EXCEPTION_THROWN(runProject(*bent().project, at("project.wend").toStdString(), options),
                             InputError);
}

/// A drawing opens in the requested size, and a project of it in the same one.
void TestSvgExport::sizesAreKept() {
    const OpenedFile small = openFile(at("drawing.svg"));
    QVERIFY(!small.project->domain.parts.empty());
    QVERIFY(small.picture->width >= 1024);
    const OpenedFile file = openFile(at("drawing.svg"), false, {2000, 1500});
    QCOMPARE(QSize(file.picture->width, file.picture->height), QSize(2000, 1500));
    QCOMPARE(file.project->domain.size, (DrawnSize{2000, 1500}));
    writeProject(at("large.wend").toStdString(), *file.project);
    const OpenedFile again = openFile(at("large.wend"));
    QCOMPARE(QSize(again.picture->width, again.picture->height), QSize(2000, 1500));
    QVERIFY(again.warnings.isEmpty());
    const AnyShape shape = loadShape(*again.project, m_folder.path().toStdString());
    QCOMPARE(canvasSize(std::get<Shape<2>>(shape)), (std::array{2000, 1500}));
    // At twice the size, points are at the same places of the drawing.
    LoadedProject loaded = bent();
    Project twice = *loaded.project;
    drawAt(twice, drawnSize(twice.domain, m_folder.path().toStdString()), {1280, 960});
    QCOMPARE(std::get<std::vector<Vec3>>(designOf(twice).handles[1].at).front(), Vec3(1040, 480, 0));
    QCOMPARE(drawnSize(twice.domain, m_folder.path().toStdString()), (DrawnSize{1280, 960}));
}

void TestSvgExport::sizesAreRead_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<QSize>("size");
    QTest::newRow("width") << "2000" << QSize(2000, 1500);
    QTest::newRow("box, wide") << "4000x300" << QSize(400, 300);
    QTest::newRow("box, high") << "400x3000" << QSize(400, 300);
    QTest::newRow("percent") << "150%" << QSize(960, 720);
    QTest::newRow("part of a percent") << "12.5%" << QSize(80, 60);
    for (const char* wrong : {"", "0", "-5", "x", "200x", "x200", "1e300", "20000%%", "12 a", "90000"})
        QTest::newRow(wrong) << wrong << QSize();
}

void TestSvgExport::sizesAreRead() {
    QFETCH(QString, text);
    QFETCH(QSize, size);
    const auto read = drawnSizeOf(text.toStdString(), {640, 480});
    QCOMPARE(read.has_value(), size.isValid());
    if (read) QCOMPARE(QSize((*read)[0], (*read)[1]), size);
}

QTEST_MAIN(TestSvgExport)
#include "test_svg_export.moc"
