#include "bench/window_rows.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QSettings>
#include <QTemporaryDir>
#include <QThreadPool>
#include <QTimer>
#include <algorithm>
#include <cmath>
#include <ctime>
#include <functional>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "app/project/design.h"
#include "app/project/domain.h"
#include "app/session/shape_session.h"
#include "app/views/canvas/canvas.h"
#include "app/views/volume/solid_canvas.h"
#include "app/window/actions/toolbox.h"
#include "app/window/main_window.h"
#include "app/window/solid_workshop.h"
#include "bench/body.h"
#include "bench/test_picture.h"
#include "bench/window_drag.h"
#include "core/base/error.h"
#include "core/mesh/mesh_of_file.h"

namespace wend {
namespace {

constexpr QSize kWindow(1280, 800), kFineWindow(3840, 2160);
constexpr double kRound = 3;         // seconds for the path of the hand, there and back
constexpr double kFilm = 4;          // seconds of the film whose poses are moved
constexpr int kPoses = 5;            // that are moved in it
constexpr int kMostElastic = 12000;  // vertices of shapes that are shown springing back, and in films
constexpr int kPictureWidth = 2400, kPictureHeight = 1500;

/// The program's own, or one for the time of the rows; without a display it draws for itself, and no solids.
class WindowSystem {
  public:
    WindowSystem() {
        if (QCoreApplication::instance()) return;
        if (!qEnvironmentVariableIsSet("QT_QPA_PLATFORM"))
            qputenv("QT_QPA_PLATFORM", qEnvironmentVariableIsSet("DISPLAY") ? "xcb;offscreen" : "offscreen");
        m_application.emplace(m_count, m_words.data());
    }

  private:
    int m_count = 1;
    std::array<char, 5> m_name{"wend"};
    std::array<char*, 2> m_words{m_name.data(), nullptr};
    std::optional<QApplication> m_application;
};

/// Settings that are no one's.
class OwnSettings {
  public:
    OwnSettings() {
        QSettings::setDefaultFormat(QSettings::IniFormat);
        QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, m_folder.path());
    }
    QString file(const char* name) const { return m_folder.filePath(QString::fromLatin1(name)); }

  private:
    QTemporaryDir m_folder;
};

/// Returns handles for both ends, which hold the shape.
std::vector<Pin> ends(double length) {
    std::vector<Pin> handles(2);
    for (const int side : {0, 1}) {
        HalfSpace<3> half{Vec3::Zero(), Vec3::Zero()};
        half.point.x() = (side ? 1 - 1e-9 : 1e-9) * length;
        half.normal.x() = side ? 1 : -1;
        handles[static_cast<std::size_t>(side)].name = side ? "right" : "left";
        handles[static_cast<std::size_t>(side)].at = Region<3>(half);
    }
    return handles;
}

/// An energy by its φ, and whether the shape springs back fully.
struct Kept {
    const char* name;
    double phi;
    bool elastic = false;

    Design design(int dimension) const {
        Design design;
        design.dimension = dimension;
        design.material.phi = phi;
        if (elastic) design.material.memory = std::numeric_limits<double>::infinity();
        return design;
    }
};

/// Twelve parts of eight megapixels in all: a trunk, and limbs that are joined to it and reach beyond it.
/// Both ends of the row are held: the trunk, and the end of the last limb.
OpenedFile fileOfParts(int vertices, const OwnSettings& settings) {
    constexpr int kLimbs = 11, kTrunkWidth = 2200, kTrunkHeight = 1000, kLimbWidth = 640, kLimbHeight = 820;
    auto project = newProject();
    Domain& domain = domainOf(*project);
    domain.vertices = vertices;
    const auto add = [&](const std::string& name, int width, int height, const Vec2& at) -> PicturePart& {
        PicturePart part;
        part.name = name;
        part.path = settings.file((name + ".png").c_str()).toStdString();
        part.at = at;
        writeImage(part.path, testPicture(width, height));
        domain.parts.insert(domain.parts.begin(), std::move(part));
        return domain.parts.front();
    };
    add("trunk", kTrunkWidth, kTrunkHeight, {100, 250});
    for (int k = 0; k < kLimbs; ++k) {
        const bool isLast = k + 1 == kLimbs;
        const Vec2 at = isLast ? Vec2(1760, 340) : Vec2(60 + 165 * k, k % 2 == 0 ? 0 : 680);
        PicturePart& limb = add("limb " + std::to_string(k), kLimbWidth, kLimbHeight, at);
        limb.joints.push_back({"trunk", at + Vec2(0.5 * kLimbWidth, 0.5 * kLimbHeight)});
    }
    Design design;
    design.material.phi = phi::kMetr;
    design.handles.resize(2);
    design.handles[0].name = design.handles[0].part = "trunk";
    design.handles[0].at = Region<3>(Ball<3>{{300, 750, 0}, 120});
    design.handles[1].name = design.handles[1].part = domain.parts.front().name;
    design.handles[1].at = std::vector<Vec3>{{2370, 750, 0}};
    designOf(*project) = std::move(design);
    OpenedFile file;
    file.project = std::move(project);
    file.picture = std::make_shared<const Image>(testPicture(kPictureWidth, kPictureHeight));
    return file;
}

template <int Dim>
OpenedFile fileOf(int vertices, const Kept& kept, const OwnSettings& settings);

template <>
OpenedFile fileOf<2>(int vertices, const Kept& kept, const OwnSettings&) {
    auto project = newProject();
    domainOf(*project).vertices = vertices;
    Design design = kept.design(2);
    design.handles = ends(kPictureWidth);
    designOf(*project) = std::move(design);
    OpenedFile file;
    file.project = std::move(project);
    file.picture = std::make_shared<const Image>(testPicture(kPictureWidth, kPictureHeight));
    return file;
}

template <>
OpenedFile fileOf<3>(int vertices, const Kept& kept, const OwnSettings& settings) {
    auto project = newProject();
    const Body<3> body = makeBody<3>(vertices);
    Domain& domain = domainOf(*project);
    domain.kind = DomainKind::Mesh;
    domain.path = settings.file("body.vtu").toStdString();
    writeMesh<3>(domain.path, *body.rest);
    Design design = kept.design(3);
    design.handles = ends(body.rest->points.row(0).maxCoeff());
    designOf(*project) = std::move(design);
    OpenedFile file;
    file.project = std::move(project);
    return file;
}

/// Lets the right end and two points between the ends move in bars that overlap.
void addFilm(Project& project) {
    Design& design = designOf(project);
    endOf(project) = kFilm;
    const Vec3 middle(0.5 * kPictureWidth, 0.5 * kPictureHeight, 0);
    for (const double side : {-0.2, 0.2}) {
        Pin handle;
        handle.name = side < 0 ? "first" : "second";
        handle.at = std::vector<Vec3>{middle + Vec3(side * kPictureWidth, 0, 0)};
        design.handles.push_back(handle);
    }
    for (std::size_t i = 1; i < design.handles.size(); ++i) {
        const double delay = 0.3 * static_cast<double>(i - 1);
        for (int k = 0; k < 3; ++k) {
            const double angle = 2.1 * k + static_cast<double>(i);
            const Vec3 by = 0.1 * kPictureHeight * Vec3(std::cos(angle), std::sin(angle), 0);
            design.handles[i].motions.push_back(
                {Translate<3>{by}, delay + 1.1 * k, delay + 1.1 * (k + 1), Ease::InOut});
        }
    }
}

/// The times after a pose was set in a film, in milliseconds: until the shown shape is exact, and until all
/// is.
struct AfterRelease {
    double shown = 0, whole = 0;
};

/// A window with the shape in it, and the hand.
template <int Dim>
class Stage {
  public:
    using MakeFile = std::function<OpenedFile(const OwnSettings&)>;
    Stage(const MakeFile& make, const QSize& size, std::stop_token stop) : m_stop(stop) {
        m_window.show();
        session().document().open(make(m_settings));
        m_window.tools().action(QStringLiteral("select"))->trigger();
        wait([this] { return settled(); });
        for (int i = 0; i < 3; ++i) m_window.resize(m_window.size() + size - view().size());
        if constexpr (Dim == 3) solid().look(Camera::Axis::Front);
        if constexpr (Dim == 3) solid().fit();
        wait([this] { return settled(); });
        m_hand = std::make_unique<WindowDrag>(
            WindowDrag::Parts{view(), session(), [this]() -> FramePtr { return drawn(); }});
    }
    ~Stage() { session().document().undoStack()->setClean(); }

    /// The latencies of a drag, and the processor time per update, in milliseconds.
    struct Dragged {
        WindowDrag::Times times;
        double processor = 0;
    };
    Dragged drag(double seconds) {
        const QPointF from = pin();
        const double reach = 0.18 * std::min<double>(view().width(), 1.6 * view().height());
        const auto path = [reach](double t) {
            const double angle = 2 * std::numbers::pi * t / kRound;
            return reach * QPointF(-0.5 * (1 - std::cos(angle)), std::sin(angle));
        };
        const std::clock_t before = std::clock();
        Dragged result{m_hand->drag(from, path, seconds, m_stop)};
        result.processor = 1e3 * static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC /
                           static_cast<double>(result.times.shown.size());
        return result;
    }
    void wait() {
        wait([this] { return settled(); });
    }
    /// Plays a film with motions that overlap, and sets a pose of the right end at a time.
    void makeFilm() {
        const auto film = copyOf(*session().document().project());
        addFilm(*film);
        session().document().change({}, film);
        m_window.tools().setMode(Mode::Animate);
        wait();
    }
    AfterRelease pose(double time) {
        session().playback().setTime(time);
        wait();
        const double reach = 0.05 * view().height();
        m_hand->drag(
            pin(), [reach](double t) { return QPointF(reach * std::min(1.0, 4 * t), -reach * t); }, 0.3,
            m_stop);
        QElapsedTimer clock;
        clock.start();
        m_tick.start(1);
        AfterRelease times;
        while (session().motion().isBusy() || times.shown == 0) {
            if (m_stop.stop_requested()) throw Cancelled();
            QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
            const FramePtr frame = session().motion().frame();
            const bool exact = frame && !frame->live && !session().motion().isStale();
            if (exact && times.shown == 0) times.shown = 1e-6 * static_cast<double>(clock.nsecsElapsed());
        }
        times.whole = 1e-6 * static_cast<double>(clock.nsecsElapsed());
        m_tick.stop();
        return times;
    }

  private:
    ShapeSession& session() { return m_window.session(); }
    SolidCanvas& solid() { return *m_window.solids().canvas(); }
    QWidget& view() {
        if constexpr (Dim == 3) return solid();
        return m_window.canvas();
    }
    FramePtr drawn() {
        if constexpr (Dim == 3) return session().motion().frame();
        const auto& drawn = m_window.canvas().shape().drawn();
        return drawn ? FramePtr(drawn->request.frame) : FramePtr();
    }
    QPointF pin() {
        for (const auto& pin : session().gestures().pins()) {
            if (pin.handle != 1) continue;
            if constexpr (Dim == 3) return solid().onScreen(pin.centre);
            if constexpr (Dim == 2) return m_window.canvas().onScreen(pin.centre);
        }
        throw std::runtime_error("the shape has no pin");
    }
    bool settled() {
        if constexpr (Dim == 2)
            if (!m_window.canvas().isSettled()) return false;
        return session().motion().frame() && !session().motion().isBusy() && !session().motion().isStale();
    }
    template <class Condition>
    void wait(const Condition& condition) {
        m_tick.start(kTick);
        do {
            if (m_stop.stop_requested()) throw Cancelled();
            QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
        } while (!condition());
        rest();
        m_tick.stop();
    }
    /// Waits until nothing is computed: the next drag is prepared once the motion is known.
    void rest() {
        QThreadPool::globalInstance()->waitForDone();  // pictures of the start page
        for (std::clock_t before = 0, now = std::clock(); now - before > CLOCKS_PER_SEC / 50;) {
            before = std::clock();
            QElapsedTimer clock;
            for (clock.start(); clock.elapsed() < 200;)
                QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
            now = std::clock();
        }
    }

    static constexpr int kTick = 20;  // milliseconds: events that wake what waits

    OwnSettings m_settings;
    QTimer m_tick;
    MainWindow m_window;
    std::stop_token m_stop;
    std::unique_ptr<WindowDrag> m_hand;
};

BenchRow rowOf(const std::string& what, const WindowDrag::Times& times, double processor) {
    std::vector<double> sorted = times.latency;
    std::ranges::sort(sorted);
    BenchRow row{what, 0, {}, {}};
    row.time = {1e-3 * sorted[sorted.size() / 2], 1e-3 * sorted.front(), 1e-3 * sorted.back(), 0,
                static_cast<int>(sorted.size())};
    const double span = times.shown.back() - times.first;
    row.figures = {
        {"95 % below (ms)", sorted[sorted.size() * 95 / 100]},
        {"updates a second", span > 0 ? 1e3 * static_cast<double>(times.shown.size() - 1) / span : 0.0},
        {"processor's time for an update (ms)", processor},
        {"first after the press (ms)", times.first}};
    return row;
}

std::string pixels(const QSize& size) {
    return std::to_string(size.width()) + " × " + std::to_string(size.height());
}

/// Adds a drag of the resting shape, and the beginning of another one right after its release.
template <int Dim>
void addRow(const typename Stage<Dim>::MakeFile& make, const QSize& size, const std::string& name,
            double seconds, BenchRecorder& recorder) {
    Stage<Dim> stage(make, size, recorder.stop());
    const auto dragged = stage.drag(seconds);
    BenchRow row = rowOf("mouse to frame, " + name, dragged.times, dragged.processor);
    row.figures.push_back({"first of a drag right after it (ms)", stage.drag(0.2).times.first});
    recorder.add(row);
}

/// Adds the times after releases in a film: those of the whole motion as figures.
void addFilmRow(const ShownSize& body, const Kept& kept, BenchRecorder& recorder) {
    const auto make = [&](const OwnSettings& settings) { return fileOf<2>(body.vertices, kept, settings); };
    Stage<2> stage(make, kWindow, recorder.stop());
    stage.makeFilm();
    std::vector<double> shown, whole;
    for (int i = 0; i < kPoses; ++i) {
        const AfterRelease times = stage.pose(kFilm * (i + 0.5) / kPoses);
        shown.push_back(times.shown);
        whole.push_back(times.whole);
    }
    std::ranges::sort(shown);
    std::ranges::sort(whole);
    BenchRow row{"release to exact, film of 4 s, " + body.name + kept.name, 0, {}, {}};
    row.time = {1e-3 * shown[kPoses / 2], 1e-3 * shown.front(), 1e-3 * shown.back(), 0, kPoses};
    row.figures = {{"whole motion, median (ms)", whole[kPoses / 2]}, {"longest (ms)", whole.back()}};
    recorder.add(row);
}

}  // namespace

template <int Dim>
void addWindowRows(const std::vector<ShownSize>& sizes, BenchRecorder& recorder, double seconds) {
    const WindowSystem system;
    if (Dim == 3 && !VolumeView::available()) {
        recorder.remark("  (no rows of the window: solids need OpenGL 3.3 and a display)");
        return;
    }
    const Kept metr{"", phi::kMetr}, equia{", EQUIA", phi::kEquia};
    const std::array<Kept, 4> elastic = {Kept{", elastic", phi::kMetr, true},
                                         {", elastic, AKVF", phi::kAkvf, true},
                                         {", elastic, EQUIA", phi::kEquia, true},
                                         {", elastic, CONF", phi::conformal(Dim), true}};
    for (const ShownSize& body : sizes) {
        const auto add = [&](const Kept& kept, const QSize& size) {
            const auto make = [&](const OwnSettings& settings) {
                return fileOf<Dim>(body.vertices, kept, settings);
            };
            addRow<Dim>(make, size, body.name + ", " + pixels(size) + kept.name, seconds, recorder);
        };
        for (const Kept& kept : {metr, equia}) add(kept, kWindow);
        if constexpr (Dim == 2) add(metr, kFineWindow);
        if (body.vertices > kMostElastic) continue;
        for (const Kept& kept : elastic) add(kept, kWindow);
        if constexpr (Dim == 2)
            for (const Kept& kept : {metr, elastic[0], elastic[2]}) addFilmRow(body, kept, recorder);
    }
}

void addPartRows(int vertices, BenchRecorder& recorder, double seconds) {
    const WindowSystem system;
    const auto make = [=](const OwnSettings& settings) { return fileOfParts(vertices, settings); };
    addRow<2>(make, kWindow, "12 parts, 8 megapixels, 1280 × 800", seconds, recorder);
    addRow<2>(make, kFineWindow, "12 parts, 8 megapixels, 3840 × 2160", seconds, recorder);
}

template void addWindowRows<2>(const std::vector<ShownSize>&, BenchRecorder&, double);
template void addWindowRows<3>(const std::vector<ShownSize>&, BenchRecorder&, double);

}  // namespace wend
