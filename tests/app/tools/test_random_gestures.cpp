// After any gestures, in any order and interrupted by any others, the document can be written and read, and
// every step can be undone and redone.
#include <QInputDialog>
#include <map>
#include <nlohmann/json.hpp>

#include "app/base/connect_each.h"
#include "app/panels/pin_list.h"
#include "app/project/domain.h"
#include "app/project/edits/handle_edits.h"
#include "app/project/file/project_reader.h"
#include "tests/support/bar.h"
#include "tests/support/dialogs.h"
#include "tests/support/random_hand.h"

using namespace wend;
using namespace wend::test;

/// WEND_GESTURES gives the number of gestures for each seed, WEND_SEED the first seed and WEND_SEEDS the
/// number of seeds; with any of them, each gesture is printed. (A thousand gestures take longer than a test
/// function may by default: QTEST_FUNCTION_TIMEOUT, in milliseconds, gives them more.)
class TestRandomGestures : public QObject {
    Q_OBJECT
  private slots:
    void init();
    void cleanup();
    void documentStaysWhole_data();
    void documentStaysWhole();

  private:
    static int wish(const char* name, int otherwise) {
        return qEnvironmentVariableIsSet(name) ? qEnvironmentVariableIntValue(name) : otherwise;
    }
    static bool tells() {
        return qEnvironmentVariableIsSet("WEND_GESTURES") || qEnvironmentVariableIsSet("WEND_SEED");
    }
    ShapeSession& session() { return m_f->session(); }
    QUndoStack& stack() { return *session().document().undoStack(); }
    QString wrongInDocument();
    QString wrongInWindow();
    QString wrongInShape();
    void keepSteps();
    void takeStep(int index);
    void staySmall();
    void undoAndRedo();
    bool settles(const char* where);

    std::unique_ptr<SolidFixture> m_f;
    std::map<int, std::shared_ptr<const Project>> m_steps;  // what each index of the stack led to
    QString m_lost;                                         // what went wrong in between
    std::shared_ptr<const Project> m_looked;                // the project that was read back last
};

void TestRandomGestures::init() {
    if (!VolumeView::available()) QSKIP("needs OpenGL (run under xvfb-run)");
    m_f = std::make_unique<SolidFixture>();
    QVERIFY(QTest::qWaitForWindowActive(&m_f->window(), 20000));
}

void TestRandomGestures::cleanup() {
    if (m_f) disconnect(&stack(), nullptr, this, nullptr);
    if (m_f) disconnect(&session(), nullptr, this, nullptr);
    m_f.reset();
}

void TestRandomGestures::documentStaysWhole_data() {
    QTest::addColumn<int>("dimension");
    QTest::addColumn<int>("seed");
    const int first = wish("WEND_SEED", 1);
    for (int seed = first; seed < first + wish("WEND_SEEDS", 1); ++seed)
        for (const int dimension : {2, 3})
            QTest::addRow("%s, seed %d", dimension == 2 ? "picture" : "solid", seed) << dimension << seed;
}

/// A failure prints the last gestures and the seed in the row's name.
void TestRandomGestures::documentStaysWhole() {
    QFETCH(int, dimension);
    QFETCH(int, seed);
    QVERIFY(m_f->openProject(dimension, 300));
    const std::string opened = toJson(m_f->project());
    const auto atRest = session().motion().frame();
    keepSteps();
    QObject scope;
    whileAsked(&scope, [](QWidget& dialog) {
        if (auto* asks = qobject_cast<QInputDialog*>(&dialog)) {
            asks->setTextValue(QStringLiteral("Group"));
            asks->accept();
        } else {
            dialog.close();
        }
    });
    RandomHand hand(m_f->window(), static_cast<unsigned>(seed));
    const int count = wish("WEND_GESTURES", 200);
    for (int i = 0; i < count; ++i) {
        hand.act(tells());
        if (i % 25 == 24) QVERIFY2(settles("on the way"), qPrintable(hand.lately()));
        for (const QString& wrong : {wrongInDocument(), wrongInWindow(), wrongInShape(), m_lost})
            QVERIFY2(wrong.isEmpty(), qPrintable(QStringLiteral("%1\nafter\n%2").arg(wrong, hand.lately())));
        staySmall();
    }
    hand.letGo();
    undoAndRedo();
    stack().setIndex(0);
    QCOMPARE(toJson(m_f->project()), opened);
    QVERIFY(settles("at the beginning"));
    session().playback().setTime(0);
    const auto frame = session().motion().frame();
    QCOMPARE(frame->vertices, atRest->vertices);
    if (dimension == 2) QVERIFY(posed<2>(frame)->pose == posed<2>(atRest)->pose);
    if (dimension == 3) QVERIFY(posed<3>(frame)->pose == posed<3>(atRest)->pose);
}

/// Checks that nothing is lost in writing and reading, and that the selection exists.
QString TestRandomGestures::wrongInDocument() {
    const std::vector<int> selected = session().selection().handles();
    const int handles = session().pins().count();
    for (const int h : selected)
        if (h < 0 || h >= handles) return QStringLiteral("pin %1 of %2 is selected").arg(h).arg(handles);
    if (m_looked == session().document().project()) return {};
    m_looked = session().document().project();
    try {
        const std::string text = toJson(*m_looked);
        const LoadedProject read = parseProject(text, "memory.wend");
        if (!read.warnings.empty()) return QString::fromStdString(read.warnings.front());
        if (nlohmann::json::parse(toJson(*read.project)) != nlohmann::json::parse(text))
            return QStringLiteral("read otherwise than written: %1").arg(QString::fromStdString(text));
    } catch (const std::exception& error) {
        return QStringLiteral("cannot be read: %1\n%2")
            .arg(error.what(), QString::fromStdString(toJson(*m_looked)));
    }
    return {};
}

/// Checks that everything shown, and every available command, belongs to the document.
QString TestRandomGestures::wrongInWindow() {
    const MainWindow& window = m_f->window();
    if (window.isWindowModified() == stack().isClean()) return QStringLiteral("the title's star");
    if (m_f->window().actions().undo->isEnabled() != stack().canUndo())
        return QStringLiteral("undo's action");
    for (int h = 0; h < session().pins().count(); ++h)
        if (!m_f->window().properties().pins().rowOf(h)) return QStringLiteral("no row of pin %1").arg(h);
    const Playback& playback = session().playback();
    if (session().motion().isDragging()) return QStringLiteral("a drag goes on with no button down");
    if (playback.end() != motionEnd(m_f->project()))
        return QStringLiteral("the film ends at %1").arg(playback.end());
    if (!(playback.time() >= 0 && playback.time() <= playback.end()))
        return QStringLiteral("the time is %1 of %2").arg(playback.time()).arg(playback.end());
    return {};
}

/// Checks that a shape has finite coordinates, as many as vertices, and that pins have places, also during a
/// drag.
QString TestRandomGestures::wrongInShape() {
    const auto wrong = [](const auto& frame, const auto& pins) -> QString {
        if (!frame) return {};
        if (frame->pose.cols() != frame->rest->points.cols()) return QStringLiteral("a pose of another mesh");
        if (!frame->pose.allFinite()) return QStringLiteral("a pose without numbers");
        for (const auto& pin : pins)
            if (!pin.centre.allFinite()) return QStringLiteral("pin %1 is nowhere").arg(pin.handle);
        return {};
    };
    return session().document().dimension() == 2
               ? wrong(session().motion().frame<2>(), session().gestures().pins())
               : wrong(session().motion().frame<3>(), session().gestures().pins());
}

/// Records every step, and checks that undo and redo lead to the recorded documents.
void TestRandomGestures::keepSteps() {
    m_steps = {{0, session().document().project()}};
    m_lost.clear();
    connect(&stack(), &QUndoStack::indexChanged, this, &TestRandomGestures::takeStep);
    const auto look = [this] {
        if (m_lost.isEmpty()) m_lost = wrongInShape();
    };
    connectEach(this, look, &session().motion(), &ShapeMotion::frameChanged, &session().gestures(),
                &ShapeGesture::pinsChanged);
}

void TestRandomGestures::takeStep(int index) {
    const auto project = session().document().project();
    if (index == stack().count()) {  // a step that is new, that grew, or that was gone again
        m_steps.erase(m_steps.upper_bound(index), m_steps.end());
        m_steps[index] = project;
    } else if (m_steps.contains(index) && m_steps[index] != project) {
        m_lost = QStringLiteral("step %1 of %2 leads elsewhere").arg(index).arg(stack().count());
    }
}

/// A random gesture may request a mesh that takes minutes: it is undone.
void TestRandomGestures::staySmall() {
    const auto frame = session().motion().frame();
    while (stack().canUndo() &&
           (m_f->domain().vertices > 1500 || (frame && frame->vertices > 3000 && stack().index() > 0))) {
        stack().undo();
        if (m_f->domain().vertices <= 1500) break;
    }
}

/// Undoes one by one to the opened file, and redoes to the last gesture.
void TestRandomGestures::undoAndRedo() {
    stack().setIndex(stack().count());
    const std::string last = toJson(m_f->project());
    std::vector<std::string> steps;
    for (; stack().canUndo(); stack().undo()) steps.push_back(toJson(m_f->project()));
    for (; stack().canRedo(); steps.pop_back()) {
        stack().redo();
        QCOMPARE(toJson(m_f->project()), steps.back());
    }
    QCOMPARE(toJson(m_f->project()), last);
    for (const QString& wrong : {wrongInDocument(), wrongInWindow(), wrongInShape(), m_lost})
        QVERIFY2(wrong.isEmpty(), qPrintable(wrong));
}

/// Returns whether the shape settles; a motion that cannot be computed and was reported counts as settled.
bool TestRandomGestures::settles(const char* where) {
    const bool settled = QTest::qWaitFor([&] { return !session().motion().isBusy(); }, 120000);
    if (!settled) qWarning("%s it computes for ever: %s", where, toJson(m_f->project()).c_str());
    return settled;
}

QTEST_MAIN(TestRandomGestures)
#include "test_random_gestures.moc"
