// A film made by mouse and keys alone, as an animator would: from a sample to poses, from poses to a loop, to
// an MP4 that ffprobe and ffmpeg read, to a file, and reopened in another window.
#include <QCheckBox>
#include <QDialogButtonBox>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QPushButton>
#include <QSignalSpy>
#include <QSlider>
#include <QUndoStack>
#include <nlohmann/json.hpp>

#include "app/output/run_options.h"
#include "app/panels/fields/number_boxes.h"
#include "app/panels/fields/option_field.h"
#include "app/panels/flow_panel.h"
#include "app/project/edits/film_edits.h"
#include "app/project/edits/key_edits.h"
#include "app/window/export/export_panel.h"
#include "app/window/export/exporter.h"
#include "app/window/film/time_ruler.h"
#include "app/window/film/time_strip.h"
#include "app/window/film/track_view.h"
#include "tests/support/dialogs.h"
#include "tests/support/solid_fixture.h"

using namespace wend;
using namespace wend::test;

namespace {

constexpr int kLeftFoot = 1, kRightFoot = 2;  // of the sample's handles: they hold still, side by side
constexpr int kWidth = 301;                   // of the film: odd, which H.264 does not take
constexpr double kRate = 12;

QByteArray outputOf(const QString& program, const QStringList& arguments) {
    QProcess process;
    process.start(program, arguments);
    if (!process.waitForFinished(60000)) qWarning("%s does not end", qPrintable(program));
    return process.readAllStandardOutput();
}

/// The mean difference of two pictures, in steps of eight bits.
double meanDifference(const QImage& a, const QImage& b) {
    if (a.size() != b.size() || a.isNull()) return 255;
    double sum = 0;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x) {
            const QColor p = a.pixelColor(x, y), q = b.pixelColor(x, y);
            sum +=
                std::abs(p.red() - q.red()) + std::abs(p.green() - q.green()) + std::abs(p.blue() - q.blue());
        }
    return sum / (3.0 * a.width() * a.height());
}

}  // namespace

class TestFilmTask : public QObject {
    Q_OBJECT
  private slots:
    void init();
    void cleanup() { m_f.reset(); }
    void aFilmIsMade();

  private:
    ShapeSession& session() { return m_f->session(); }
    QUndoStack& undo() { return *session().document().undoStack(); }
    TrackView& tracks() { return *m_f->window().findChild<TrackView*>(); }
    ShapeCanvas& canvas() { return m_f->window().canvas(); }
    std::vector<double> keys(int handle) { return keyTimes(designOf(m_f->project()), handle); }
    QPoint spot(int handle, double time) { return tracks().keySpot({handle, time}).toPoint(); }
    void key(QWidget& in, int key, Qt::KeyboardModifiers modifiers = {});
    void drag(QWidget& in, const QPoint& from, const QPoint& to, Qt::KeyboardModifiers modifiers = {});
    void show(double time);
    Vec2 pin(int handle);
    void pose(int handle, const QPoint& by);
    void poseLive(int handle, const QPoint& by);
    void type(QAbstractSpinBox& box, const QString& text);
    void openSample();
    void setPoses();
    void retimeAndCopy();
    void addLatePin();
    void loop();
    void writeFilm(const QString& path);
    void checkFilm(const QString& path);
    void reopen(const QString& path);

    std::unique_ptr<SolidFixture> m_f;
};

void TestFilmTask::init() {
    QSettings().remove(QStringLiteral("ruler"));
    m_f = std::make_unique<SolidFixture>();
    QVERIFY(QTest::qWaitForWindowActive(&m_f->window(), 20000));
}

void TestFilmTask::key(QWidget& in, int key, Qt::KeyboardModifiers modifiers) {
    m_f->window().activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&m_f->window(), 20000));
    in.setFocus();
    QTest::keyClick(&in, static_cast<Qt::Key>(key), modifiers);
}

void TestFilmTask::drag(QWidget& in, const QPoint& from, const QPoint& to, Qt::KeyboardModifiers modifiers) {
    QTest::mouseMove(&in, from);
    QTest::mousePress(&in, Qt::LeftButton, modifiers, from);
    for (int i = 1; i <= 6; ++i) QTest::mouseMove(&in, from + (to - from) * i / 6);
    QTest::mouseRelease(&in, Qt::LeftButton, modifiers, to);
    QVERIFY(settle(session()));
}

/// Shows a time by a click on the ruler.
void TestFilmTask::show(double time) {
    TimeRuler& ruler = tracks().ruler();
    QTest::mouseClick(&ruler, Qt::LeftButton, {}, QPoint(qRound(tracks().scale().xOf(time)), 12));
    QVERIFY(settle(session()));
    QVERIFY(std::abs(session().playback().time() - time) < 1.5 / tracks().scale().pixelsOf(1));
}

Vec2 TestFilmTask::pin(int handle) {
    for (const auto& view : session().gestures().pins())
        if (view.handle == handle) return inPlane(view.centre);
    return Vec2::Zero();
}

void TestFilmTask::pose(int handle, const QPoint& by) {
    const QPoint from = canvas().toWidget(pin(handle)).toPoint();
    drag(canvas(), from, from + by);
}

/// Poses as above; the dragged shape is visible until the exact one is computed.
void TestFilmTask::poseLive(int handle, const QPoint& by) {
    const QPoint from = canvas().toWidget(pin(handle)).toPoint();
    QTest::mouseMove(&canvas(), from);
    QTest::mousePress(&canvas(), Qt::LeftButton, {}, from);
    for (int i = 1; i <= 6; ++i) QTest::mouseMove(&canvas(), from + by * i / 6);
    QVERIFY(QTest::qWaitFor([&] { return session().motion().frame()->live; }, 20000));
    QTest::mouseRelease(&canvas(), Qt::LeftButton, {}, from + by);
    QVERIFY(session().motion().isBusy() && session().motion().frame()->live && !session().motion().isStale());
    QCOMPARE(session().motion().frame()->time, session().playback().time());
    QVERIFY(settle(session()));
    QVERIFY(!session().motion().frame()->live);
}

void TestFilmTask::type(QAbstractSpinBox& box, const QString& text) {
    box.setFocus();
    box.selectAll();
    QTest::keyClicks(&box, text);
    QTest::keyClick(&box, Qt::Key_Return);
    QVERIFY(settle(session()));
}

void TestFilmTask::openSample() {
    for (QAction* one : m_f->window().actions().samples->actions())
        if (one->text() == QLatin1String("frog")) one->trigger();
    QVERIFY(m_f->takeOpened([&] { return !session().document().isEmpty(); }));
    setVertices(session().document(), 500);
    QVERIFY(settle(session()));
    key(canvas(), Qt::Key_4, Qt::ControlModifier);
    settleLayout(canvas());
    auto* memory = m_f->window().findChild<MemorySlider*>();
    QTest::mouseClick(memory->slider(), Qt::LeftButton, {},
                      {memory->slider()->width() - 2, memory->slider()->height() / 2});
    QVERIFY(settle(session()));
    QVERIFY(std::isinf(session().document().design().material.memory));
    type(*m_f->window().findChild<TimeStrip*>()->length(), QStringLiteral("4"));
    QCOMPARE(endOf(m_f->project()), 4.0);
}

/// Sets three poses, and one more between two of them, which stay unchanged.
void TestFilmTask::setPoses() {
    const Vec2 rest = pin(kLeftFoot);
    for (const auto& [time, by] : {std::pair{1.0, QPoint(-20, -40)}, {2.0, {30, 60}}, {3.0, {-15, -25}}}) {
        show(time);
        pose(kLeftFoot, by);
    }
    QCOMPARE(keys(kLeftFoot).size(), 4U);
    const auto placeAt = [&](double time) {
        show(time);
        return pin(kLeftFoot);
    };
    const double first = keys(kLeftFoot)[1], second = keys(kLeftFoot)[2];
    const Vec2 before = placeAt(first), after = placeAt(second);
    QVERIFY((before - rest).norm() > 20 && (after - before).norm() > 20);
    show(1.5);
    const Vec2 between = pin(kLeftFoot);
    poseLive(kLeftFoot, {-30, 0});
    QCOMPARE(keys(kLeftFoot).size(), 5U);
    QVERIFY((pin(kLeftFoot) - between).norm() > 10);
    QVERIFY(placeAt(first) == before);
    QVERIFY(placeAt(second) == after);
}

void TestFilmTask::retimeAndCopy() {
    show(0);
    const std::array rests = {pin(kLeftFoot), pin(kRightFoot)};
    const double was = keys(kLeftFoot)[2];
    show(was);
    const Vec2 place = pin(kLeftFoot);
    const int right = qRound(tracks().scale().pixelsOf(0.25));
    drag(*tracks().viewport(), spot(kLeftFoot, was), spot(kLeftFoot, was) + QPoint(right, 0));
    const double now = keys(kLeftFoot)[2];
    QVERIFY(std::abs(now - was - 0.25) < 0.05);
    session().playback().setTime(now);
    QVERIFY(settle(session()) && (pin(kLeftFoot) - place).norm() < 1e-9);
    // Both poses, mirrored, are those of the other foot.
    tracks().setFocus();
    QTest::mouseClick(tracks().viewport(), Qt::LeftButton, {}, spot(kLeftFoot, keys(kLeftFoot)[1]));
    QTest::mouseClick(tracks().viewport(), Qt::LeftButton, Qt::ShiftModifier, spot(kLeftFoot, now));
    QTest::keyClick(&tracks(), Qt::Key_C, Qt::ControlModifier);
    const double apart = now - keys(kLeftFoot)[1];
    show(2.5);
    tracks().setFocus();
    QTest::keyClick(&tracks(), Qt::Key_V, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(settle(session()));
    QCOMPARE(keys(kRightFoot).size(), 3U);
    QVERIFY(std::abs(keys(kRightFoot)[2] - keys(kRightFoot)[1] - apart) < 1e-9);
    session().playback().setTime(keys(kRightFoot)[2]);
    QVERIFY(settle(session()));
    const Vec2 moved = pin(kRightFoot), left = place - rests[0];
    QVERIFY((moved - rests[1] - Vec2(-left.x(), left.y())).norm() < 1e-6);
}

/// A pin set late holds from then on, and everything before is unchanged.
void TestFilmTask::addLatePin() {
    show(3.5);
    const auto frame = session().motion().frame<2>();
    const Vec2 hand(1845, 775);  // of the picture at rest
    int nearest = 0;
    for (int v = 1; v < frame->vertices; ++v)
        if ((frame->rest->points.col(v) - hand).norm() < (frame->rest->points.col(nearest) - hand).norm())
            nearest = v;
    const Points2 before = frame->pose;
    key(canvas(), Qt::Key_2, Qt::ControlModifier);
    settleLayout(canvas());
    key(canvas(), Qt::Key_P);
    const int pins = session().pins().count();
    QTest::mouseClick(&canvas(), Qt::LeftButton, {}, canvas().toWidget(before.col(nearest)).toPoint());
    QVERIFY(settle(session()));
    QCOMPARE(session().pins().count(), pins + 1);
    const Pin& late = session().document().design().handles.back();
    QVERIFY(late.activeFrom > 3.4 && late.activeFrom < 3.6);
    QVERIFY((session().motion().frame<2>()->pose - before).cwiseAbs().maxCoeff() < 1e-6 * 2400);
    key(canvas(), Qt::Key_4, Qt::ControlModifier);
    settleLayout(canvas());
    show(4);
    pose(pins, {25, -30});
    QCOMPARE(session().document().design().handles.back().motions.size(), 1U);
}

void TestFilmTask::loop() {
    TimeRuler& ruler = tracks().ruler();
    const auto at = [&](double time) { return QPoint(qRound(tracks().scale().xOf(time)), 12); };
    drag(ruler, at(1), at(3), Qt::ShiftModifier);
    QVERIFY(filmMarksOf(session().document()).cycle);
    m_f->picture(QStringLiteral("film-task"));
}

/// Writes the film by the dialog, with an odd width.
void TestFilmTask::writeFilm(const QString& path) {
    QSignalSpy done(&m_f->window().exporter(), &Exporter::done);
    withNext<ExportDialog>(this, [&](ExportDialog& dialog) {
        ExportForm& form = dialog.form();
        QCOMPARE(form.extension(), QStringLiteral(".mp4"));
        QTest::mouseClick(form.field("--loop")->findChild<QCheckBox*>(), Qt::LeftButton, {}, {8, 8});
        for (const auto& [flag, value] : {std::pair{"--fps", kRate}, {"--width", double(kWidth)}}) {
            form.field(flag)->setNumber(value);
            emit form.field(flag)->changed();
        }
        nameNextFile(this, path);
        for (QAbstractButton* button : dialog.findChild<QDialogButtonBox*>()->buttons())
            if (button->text().contains(QStringLiteral("xport"))) button->click();
    });
    m_f->window().actions().exportFilm->trigger();
    QTRY_COMPARE_WITH_TIMEOUT(done.count(), 1, 120000);
}

/// Checks that the film has as many pictures as the cycle, of an even size, and that the first and the last
/// equal those of PNG files.
void TestFilmTask::checkFilm(const QString& path) {
    const auto [from, to] = *filmMarksOf(session().document()).cycle;
    const QJsonObject stream = QJsonDocument::fromJson(outputOf(
        QStringLiteral("ffprobe"),
        {"-v", "error", "-count_frames", "-show_streams", "-of", "json", path}))["streams"][0]
                                   .toObject();
    QCOMPARE(stream["codec_name"].toString(), QStringLiteral("h264"));
    const int width = stream["width"].toInt();
    QCOMPARE(std::abs(width - kWidth), 1);
    QCOMPARE(stream["height"].toInt() % 2, 0);
    QCOMPARE(stream["avg_frame_rate"].toString(), QStringLiteral("12/1"));
    const int count = qRound((to - from) * kRate);
    QCOMPARE(stream["nb_read_frames"].toString().toInt(), count);
    const QString folder = m_f->folder().path();
    outputOf(QStringLiteral("ffmpeg"), {"-v", "error", "-y", "-i", path, folder + "/film_%03d.png"});
    QSignalSpy done(&m_f->window().exporter(), &Exporter::done);
    OptionValues values;
    for (const auto& [flag, value] : {std::pair{"--count", std::to_string(count)},
                                      {"--loop", std::string("1")},
                                      {"--width", std::to_string(width)},
                                      {"--outside", std::string("white")}})
        values.set(flag, value);
    m_f->window().exporter().write(ExportKind::Frames, folder + "/frame_###.png", runOptionsFrom(values));
    QTRY_COMPARE_WITH_TIMEOUT(done.count(), 1, 120000);
    const auto frame = [&](int k) {
        return QImage(QStringLiteral("%1/frame_%2.png").arg(folder).arg(k, 3, 10, QChar('0')));
    };
    for (const int k : {0, count - 1}) {
        const QImage film(QStringLiteral("%1/film_%2.png").arg(folder).arg(k + 1, 3, 10, QChar('0')));
        const double off = meanDifference(film, frame(k)), beside = meanDifference(film, frame(count / 2));
        QVERIFY2(off < 4 && beside > 2 * off, qPrintable(QStringLiteral("%1, %2").arg(off).arg(beside)));
    }
}

/// Checks that the document, and the shape at the end of the cycle, are the same.
void TestFilmTask::reopen(const QString& path) {
    nameNextFile(&m_f->window(), path);
    m_f->window().actions().saveAs->trigger();
    QVERIFY(QFile::exists(path) && undo().isClean());
    SolidFixture other;
    QVERIFY(other.openFile(path));
    const auto valuesOf = [](const Project& project) {
        auto values = nlohmann::json::parse(toJson(project));
        values["domain"].erase("image");  // relative to another folder
        return values;
    };
    QVERIFY(valuesOf(other.project()) == valuesOf(m_f->project()));
    for (const double time : {filmMarksOf(session().document()).cycle->at(1), endOf(m_f->project())}) {
        for (SolidFixture* one : {m_f.get(), &other}) {
            one->session().playback().setTime(time);
            QVERIFY(settle(one->session()));
        }
        QVERIFY(session().motion().frame<2>()->pose == other.session().motion().frame<2>()->pose);
    }
}

void TestFilmTask::aFilmIsMade() {
    openSample();
    if (QTest::currentTestFailed()) return;
    const int steps = undo().index();
    const std::string first = toJson(m_f->project());
    const QString folder = m_f->folder().path();
    for (const std::function<void()>& part : {std::function<void()>([&] { setPoses(); }),
                                              {[&] { retimeAndCopy(); }},
                                              {[&] { addLatePin(); }},
                                              {[&] { loop(); }},
                                              {[&] { writeFilm(folder + "/film.mp4"); }},
                                              {[&] { checkFilm(folder + "/film.mp4"); }},
                                              {[&] { reopen(folder + "/film.wend"); }}}) {
        part();
        if (QTest::currentTestFailed()) return;
    }
    const std::string last = toJson(m_f->project());
    const int all = undo().index();
    undo().setIndex(steps);
    QCOMPARE(toJson(m_f->project()), first);
    undo().setIndex(all);
    QCOMPARE(toJson(m_f->project()), last);
}

QTEST_MAIN(TestFilmTask)
#include "test_film_task.moc"
