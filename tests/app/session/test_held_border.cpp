// The border of a photograph is fixed or slides along itself: vertex by vertex while a pin is dragged, when
// its motion is computed, and while the shape settles; and in the pixels of the exported file.

#include <QtTest>

#include "app/output/frame_export.h"
#include "app/output/run.h"
#include "app/project/domain.h"
#include "app/project/edits/handle_edits.h"
#include "app/project/edits/setting_edits.h"
#include "app/project/file/project_reader.h"
#include "app/session/opening.h"
#include "app/session/settle_step.h"
#include "core/integration/deformer.h"
#include "tests/support/window_fixture.h"

using namespace wend;
using namespace wend::test;

namespace {

constexpr int kWidth = 300, kHeight = 200;

/// Returns a picture in which red encodes the row and green the column.
QImage photograph() {
    QImage image(kWidth, kHeight, QImage::Format_RGB888);
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) image.setPixel(x, y, qRgb(20 + y, 10 + x * 230 / kWidth, 90));
    return image;
}

bool onSide(double coordinate, double size) {
    return coordinate == 0 || coordinate == size;
}

/// The largest distance of border vertices from their sides, along them, and of the corners.
struct Way {
    double off = 0, along = 0, corners = 0;
};

Way wayOf(const PosedFrame<2>& frame) {
    Way way;
    for (int v = 0; v < frame.rest->vertexCount(); ++v) {
        const Vec2 p = frame.rest->points.col(v), by = (frame.pose.col(v) - p).cwiseAbs();
        const bool x = onSide(p.x(), kWidth), y = onSide(p.y(), kHeight);
        if (x && y) way.corners = std::max(way.corners, by.maxCoeff());
        if (x) way.off = std::max(way.off, by.x());
        if (y) way.off = std::max(way.off, by.y());
        if (x != y) way.along = std::max(way.along, x ? by.y() : by.x());
    }
    return way;
}

}  // namespace

class TestHeldBorder : public QObject {
    Q_OBJECT
  private slots:
    void initTestCase();
    void init();
    void borderIsHeld_data();
    void borderIsHeld();
    void handlesOnTheBorderAreLeftAlone();
    void partsOnTheBorderAreLeftAlone_data();
    void partsOnTheBorderAreLeftAlone();
    void changingItComputesTheMotionAnew();

  private:
    void open(Border border);
    int dragMiddle();
    void pixelsAreThere(const QString& file, Border border);

    QTemporaryDir m_folder;
    std::unique_ptr<ShapeSession> m_session;
};

void TestHeldBorder::initTestCase() {
    QVERIFY(photograph().save(m_folder.filePath(QStringLiteral("photograph.png"))));
}

void TestHeldBorder::init() {
    m_session = std::make_unique<ShapeSession>();
}

void TestHeldBorder::open(Border border) {
    OpenedFile file = openFile(m_folder.filePath(QStringLiteral("photograph.png")));
    auto project = copyOf(*file.project);
    QCOMPARE(domainOf(*project).outline, OutlineKind::Frame);
    domainOf(*project).vertices = 400;
    domainOf(*project).border = border;
    file.project = project;
    m_session->document().open(std::move(file));
    QVERIFY(settle(*m_session));
}

/// Drags by an eighth of the picture; returns the number of live frames in which the border was off its
/// place, or had not slid by the end although it may.
int TestHeldBorder::dragMiddle() {
    const int pin = m_session->addPin({140, 90, 0});
    m_session->selection().set({pin});
    const Border border = m_session->document().domain().border;
    int live = 0, wrong = 0;
    double along = 0;
    const auto watch = connect(&m_session->motion(), &ShapeMotion::frameChanged, this, [&] {
        const auto frame = m_session->motion().frame<2>();
        if (!frame || !frame->live) return;
        ++live;
        const Way way = wayOf(*frame);
        along = way.along;
        wrong += (border != Border::Free && way.off + way.corners > 0) ||
                         (border == Border::Fixed && way.along > 0)
                     ? 1
                     : 0;
    });
    m_session->gestures().begin();
    for (int step = 1; step <= 5; ++step) {
        m_session->gestures().moveBy({7.0 * step, 5.0 * step, 0});
        const auto isThere = [&] { return live > 0 && m_session->motion().frame()->sample == step; };
        if (!QTest::qWaitFor(isThere, 60000)) return -1;
    }
    wrong += border == Border::Slide && along < 1 ? 1 : 0;
    m_session->gestures().end(0.2);
    disconnect(watch);
    return settle(*m_session) ? wrong : -1;
}

void TestHeldBorder::pixelsAreThere(const QString& file, Border border) {
    const QImage written(file), source = photograph();
    QCOMPARE(written.size(), source.size());
    QVERIFY(!written.hasAlphaChannel());
    const auto compare = [&](int x, int y) {
        const QRgb a = written.pixel(x, y), b = source.pixel(x, y);
        // The centres of the pixels are half a pixel inside, where the shape is bent a little.
        const bool row = y == 0 || y == kHeight - 1, column = x == 0 || x == kWidth - 1;
        if (border == Border::Fixed || row)
            QVERIFY2(std::abs(qRed(a) - qRed(b)) <= 2, qPrintable(QString("%1 %2").arg(x).arg(y)));
        if (border == Border::Fixed || column)
            QVERIFY2(std::abs(qGreen(a) - qGreen(b)) <= 2, qPrintable(QString("%1 %2").arg(x).arg(y)));
    };
    for (int x = 0; x < kWidth; ++x) compare(x, 0), compare(x, kHeight - 1);
    for (int y = 0; y < kHeight; ++y) compare(0, y), compare(kWidth - 1, y);
    // The inner vertices moved with the pin.
    QVERIFY((m_session->gestures().pins()[0].centre - Vec3(175, 115, 0)).norm() < 0.3);
    const QRgb middle = written.pixel(175, 115);
    QVERIFY(std::abs(qRed(middle) - (20 + 90)) <= 3 &&
            std::abs(qGreen(middle) - (10 + 140 * 230 / kWidth)) <= 3);
}

void TestHeldBorder::borderIsHeld_data() {
    QTest::addColumn<Border>("border");
    QTest::newRow("fixed") << Border::Fixed;
    QTest::newRow("slides") << Border::Slide;
    QTest::newRow("free") << Border::Free;  // so that the others are known to do something
}

void TestHeldBorder::borderIsHeld() {
    QFETCH(Border, border);
    open(border);
    QCOMPARE(dragMiddle(), 0);
    changeSetting(m_session->document(), "material.memory", 0);
    settleAtEnd(m_session->document(), m_session->playback());
    QVERIFY(settle(*m_session));
    for (const FramePtr& frame : m_session->motion().track().frames()) {
        const Way way = wayOf(*posed<2>(frame));
        if (border == Border::Free) continue;
        QCOMPARE(way.off, 0.0);
        QCOMPARE(way.corners, 0.0);
        if (border == Border::Fixed) QCOMPARE(way.along, 0.0);
    }
    m_session->document().undoStack()->undo();
    QVERIFY(settle(*m_session));
    m_session->playback().setTime(m_session->playback().end());
    const Way way = wayOf(*m_session->motion().frame<2>());
    if (border == Border::Free) QVERIFY(way.off > 1 && way.corners > 1);
    if (border == Border::Slide) QVERIFY(way.along > 1);
    if (border == Border::Free) return;
    const QString exported = m_folder.filePath(QStringLiteral("exported.png"));
    std::string remark;
    FrameExport(m_session->document(), m_session->motion().frame(), {}, 1)
        .write(ExportKind::Picture, exported.toStdString(), {}, {}, remark);
    pixelsAreThere(exported, border);
    const QString saved = m_folder.filePath(QStringLiteral("saved.wend")),
                  run = m_folder.filePath(QStringLiteral("run.png"));
    m_session->document().save(saved);
    RunOptions options;
    options.outputs.image = {run.toStdString()};
    QVERIFY(runProject(*readProject(saved.toStdString()).project, saved.toStdString(), options).outcome ==
            Outcome::Done);
    pixelsAreThere(run, border);
}

/// A pin that the user sets on the border moves, and the rest of the border stays.
void TestHeldBorder::handlesOnTheBorderAreLeftAlone() {
    open(Border::Fixed);
    const int pin = m_session->addPin({150, 0, 0});
    QVERIFY(pin >= 0);
    m_session->selection().set({pin});
    m_session->gestures().begin();
    m_session->gestures().moveBy({0, 12, 0});
    m_session->gestures().end(0.2);
    QVERIFY(settle(*m_session));
    const auto frame = m_session->motion().frame<2>();
    int moved = 0;
    for (int v = 0; v < frame->rest->vertexCount(); ++v) {
        const Vec2 p = frame->rest->points.col(v);
        if (!onSide(p.x(), kWidth) && !onSide(p.y(), kHeight)) continue;
        const bool pinned = p == Vec2(150, 0);
        moved += pinned ? 1 : 0;
        QVERIFY((frame->pose.col(v) - p - (pinned ? Vec2(0, 12) : Vec2(0, 0))).norm() <= (pinned ? 1e-6 : 0));
    }
    QCOMPARE(moved, 1);
}

void TestHeldBorder::partsOnTheBorderAreLeftAlone_data() {
    QTest::addColumn<bool>("byNumber");
    QTest::newRow("region") << false;
    QTest::newRow("vertices") << true;
}

/// The left end as a handle moves as a whole, and the border beyond it stays.
void TestHeldBorder::partsOnTheBorderAreLeftAlone() {
    QFETCH(bool, byNumber);
    open(Border::Fixed);
    const auto rest = m_session->motion().frame<2>()->rest;
    const auto isHeld = [&](int v) { return rest->points(0, v) <= 30; };
    std::vector<int> numbers;
    for (int v = 0; v < rest->vertexCount(); ++v)
        if (isHeld(v)) numbers.push_back(v);
    const Region<3> region = HalfSpace<3>{{30, 0, 0}, {-1, 0, 0}};
    m_session->addHandle(byNumber ? Placement<3>(numbers) : Placement<3>(region), "End");
    const Vec2 by(-8, 6);
    m_session->gestures().moveAtOnce({}, {by.x(), by.y(), 0});
    QVERIFY(settle(*m_session));
    const auto frame = m_session->motion().frame<2>();
    QCOMPARE(frame->rest, rest);
    for (int v = 0; v < rest->vertexCount(); ++v) {
        const Vec2 p = rest->points.col(v);
        if (!isHeld(v) && !onSide(p.x(), kWidth) && !onSide(p.y(), kHeight)) continue;
        const Vec2 way = isHeld(v) ? by : Vec2(0, 0);
        QVERIFY2((frame->pose.col(v) - p - way).norm() < 1e-6, qPrintable(QString::number(v)));
    }
}

void TestHeldBorder::changingItComputesTheMotionAnew() {
    open(Border::Free);
    QVERIFY(dragMiddle() >= 0);
    QVERIFY(wayOf(*m_session->motion().frame<2>()).off > 1);
    for (const Border border : {Border::Slide, Border::Fixed}) {
        const auto project = copyOf(*m_session->document().project());
        domainOf(*project).border = border;
        m_session->document().change(QStringLiteral("Hold border"), project);
        QVERIFY(settle(*m_session));
        QCOMPARE(wayOf(*m_session->motion().frame<2>()).off, 0.0);
        QCOMPARE(wayOf(*m_session->motion().frame<2>()).along > 0, border == Border::Slide);
    }
    m_session->document().undoStack()->undo();
    m_session->document().undoStack()->undo();
    QVERIFY(settle(*m_session));
    QVERIFY(wayOf(*m_session->motion().frame<2>()).off > 1);
}

QTEST_GUILESS_MAIN(TestHeldBorder)
#include "test_held_border.moc"
