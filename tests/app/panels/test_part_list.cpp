// A file with layers in the window: its layers become parts, which a list hides, renames, orders, joins and
// embeds in one another; the canvas shows the same as the export.

#include <Eigen/Geometry>
#include <QAbstractButton>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <QListWidget>
#include <QScrollBar>
#include <QUndoStack>
#include <QtTest>
#include <set>

#include "app/engine/shape/mesh_parts.h"
#include "app/output/frame_export.h"
#include "app/output/run.h"
#include "app/panels/fields/option_field.h"
#include "app/panels/mesh_panel.h"
#include "app/panels/part_list.h"
#include "app/project/design.h"
#include "app/project/domain.h"
#include "app/project/file/project_writer.h"
#include "app/session/brush.h"
#include "app/session/part_making.h"
#include "app/style/theme.h"
#include "app/views/canvas/canvas.h"
#include "app/window/actions/actions.h"
#include "app/window/export/export_formats.h"
#include "app/window/files/file_workflow.h"
#include "app/window/notices/info_banner.h"
#include "app/window/notices/notes.h"
#include "tests/support/layers.h"
#include "tests/support/pictures.h"
#include "tests/support/solid_fixture.h"
#include "warp/inpaint.h"
#include "warp/open_raster.h"

using namespace wend;
using namespace wend::test;

class TestPartList : public QObject {
    Q_OBJECT
  private slots:
    void init();
    void cleanup() { m_f.reset(); }
    void layersAreParts();
    void listChangesParts();
    void canvasIsTheExport_data();
    void canvasIsTheExport();
    void partIsBlended();
    void rowsStayInView();
    void partsApartAreNotJoined();
    void signsFollowTheAppearance();
    void picturesOpenTogether();
    void partsHaveTheirOutlines();
    void outlinesOfPartsAreDrawn();
    void orderChangesFromHere();
    void hiddenPartsAreNotTouched();
    void lockedPartsAreLeftAlone();
    void paintBelongsToParts();
    void gradientsAndFillsBelongToParts();
    void detailBelongsToParts();
    void dragsWaitForParts();
    void renamedPartIsCut();
    void noteNamesTheFilling();
    void outlinesOfLockedPartsStay();
    void edgesAreSoftened();
    void partsWithoutPinsCanBeAttached();
    void partsOnAStrayPartFollowIt_data();
    void partsOnAStrayPartFollowIt();
    void islandsCanBeAttached();

  private:
    void dragged();
    void jointIsMoved(const Vec2& from);
    void lock(int row);
    void stroke(const std::vector<Vec2>& way, Qt::KeyboardModifiers modifiers = {});
    bool isPainted(std::size_t part);
    double gap() {
        const auto frame = m_f->session().motion().frame<2>();
        Vec2 difference = Vec2::Zero();
        for (const auto& [v, weight] : frame->rest->welds.at(0).terms)
            difference += weight * frame->pose.col(v);
        return difference.norm();
    }
    PartList& panel() { return m_f->window().properties().parts(); }
    QListWidget& list() { return *panel().list(); }
    const std::vector<PicturePart>& parts() { return m_f->session().document().domain().parts; }
    QStringList names() {
        QStringList all;
        for (const PicturePart& part : parts()) all << QString::fromStdString(part.name);
        return all;
    }
    QUndoStack& undo() { return *m_f->session().document().undoStack(); }

    QTemporaryDir m_folder;
    std::unique_ptr<SolidFixture> m_f;
};

/// A red bar over a green board that it reaches beyond, with a small blue dot on it.
void TestPartList::init() {
    m_f = std::make_unique<SolidFixture>();
    const auto layer = [](const char* name, int width, int height, const std::vector<std::uint8_t>& colour,
                          int x, int y) {
        return LayerToWrite{name, plainPicture(width, height, colour), x, y};
    };
    const QString path = m_folder.filePath("layers.ora");
    writeOpenRaster(
        path.toStdString(),
        {layer("dot", 6, 6, {0, 0, 255, 255}, 60, 37), layer("bar", 120, 24, {255, 0, 0, 255}, 40, 28),
         layer("board", 80, 70, {0, 255, 0, 255}, 10, 10)},
        plainPicture(180, 90, {9, 9, 9, 255}));
    QVERIFY(m_f->openFile(path));
}

/// A layer that is too small for a mesh is embedded in another part; one click merges the parts into the
/// file's picture, which undo reverts.
void TestPartList::layersAreParts() {
    QCOMPARE(names(), (QStringList{"dot", "bar", "board"}));
    QCOMPARE(parts()[0].ridesOn, std::string("bar"));
    QVERIFY(panel().isVisible());
    QCOMPARE(list().count(), 3);
    auto* banner = m_f->window().findChild<InfoBanner*>();
    QVERIFY(banner && banner->text().contains("3 layers"));
    QAbstractButton* flatten = nullptr;
    for (auto* button : banner->findChildren<QAbstractButton*>())
        if (button->text() == "Open Flattened") flatten = button;
    QVERIFY(flatten);
    flatten->click();
    QVERIFY(parts().empty());
    QVERIFY(settle(m_f->session()));
    QCOMPARE(m_f->session().motion().frame<2>()->built->picture->width, 180);
    QVERIFY(!panel().isVisible());
    undo().undo();
    QVERIFY(settle(m_f->session()));
    QCOMPARE(parts().size(), std::size_t{3});
    QVERIFY(panel().isVisible());
}

/// Writes twelve squares in a row, none of which overlaps another.
static QString writeTwelve(const QTemporaryDir& folder) {
    std::vector<LayerToWrite> layers;
    for (int i = 0; i < 12; ++i)
        layers.push_back({"layer " + std::to_string(i), plainPicture(30, 30, {200, 90, 40, 255}), 40 * i, 5});
    const QString path = folder.filePath("twelve.ora");
    writeOpenRaster(path.toStdString(), layers, plainPicture(480, 40, {9, 9, 9, 255}));
    return path;
}

/// Changes leave the list where it was scrolled to, so that the next click meets the same part.
void TestPartList::rowsStayInView() {
    QVERIFY(m_f->openFile(writeTwelve(m_folder)));
    list().setCurrentRow(9);
    list().verticalScrollBar()->setValue(list().verticalScrollBar()->maximum());
    const int before = list().verticalScrollBar()->value();
    QVERIFY(before > 0);
    const QRect row = list().visualItemRect(list().item(9));
    auto* opacity = panel().findChild<QDoubleSpinBox*>("partOpacity");
    opacity->setValue(40);
    QCOMPARE(parts()[9].opacity, 0.4);
    QCOMPARE(list().verticalScrollBar()->value(), before);
    QCOMPARE(list().visualItemRect(list().item(9)), row);
}

/// Parts that do not overlap cannot be chosen for a joint, by mouse or keys.
void TestPartList::partsApartAreNotJoined() {
    list().setCurrentRow(1);
    auto* joined = panel().findChild<QComboBox*>("partJoined");
    const auto isOffered = [joined](const char* name) {
        const int at = joined->findText(QString::fromLatin1(name));
        return at >= 0 && joined->model()->index(at, 0).flags().testFlag(Qt::ItemIsEnabled);
    };
    QTRY_VERIFY(isOffered("board"));
    QVERIFY(m_f->openFile(writeTwelve(m_folder)));
    QVERIFY(settle(m_f->session()));
    list().setCurrentRow(5);
    QTRY_VERIFY(joined->findText("layer 4") > 0 && !isOffered("layer 4"));
    QVERIFY(!joined->itemData(joined->findText("layer 4"), Qt::ToolTipRole).toString().isEmpty());
    QVERIFY(isOffered("Nothing"));
}

void TestPartList::signsFollowTheAppearance() {
    const auto lightness = [this](const char* name) {
        const QIcon icon = panel().findChild<QAbstractButton*>(name)->icon();
        return lightnessOf(icon.pixmap(16, 16).toImage());
    };
    for (const auto& [look, isDark] :
         {std::pair{m_f->window().actions().darkLook, true}, {m_f->window().actions().lightLook, false}}) {
        look->trigger();
        for (const char* name : {"partForward", "partBackward", "partLock"})
            QVERIFY2((lightness(name) > 0.5) == isDark, name);
    }
}

/// Types another place for the joint of the third part, which is welded there and marked by a ring.
void TestPartList::jointIsMoved(const Vec2& from) {
    const Vec2 to = (from + Vec2(4, -3)).array().round();
    const char* names[] = {"partJointX", "partJointY"};
    for (int axis = 0; axis < 2; ++axis) {
        auto* box = panel().findChild<QDoubleSpinBox*>(names[axis]);
        QVERIFY(box->isVisible() && std::abs(box->value() - from[axis]) < 0.06);
        box->setValue(to[axis]);
    }
    QCOMPARE(parts()[2].joints[0].at, to);
    QVERIFY(settle(m_f->session()));
    const auto frame = m_f->session().motion().frame<2>();
    Vec2 welded = Vec2::Zero();
    for (const auto& [vertex, weight] : frame->rest->welds.at(0).terms)
        if (weight > 0) welded += weight * frame->rest->points.col(vertex);
    QVERIFY((welded - to).norm() < 1e-9);
    ShapeCanvas& canvas = m_f->window().canvas();
    QVERIFY(QTest::qWaitFor([&] { return canvas.isSettled(); }, 20000));
    const QImage seen = canvas.grab().toImage();
    const double ratio = seen.devicePixelRatio();
    for (const QPointF& side : {QPointF(5, 0), QPointF(-5, 0), QPointF(0, 5), QPointF(0, -5)}) {
        const QPoint at = ((canvas.toWidget(to) + side) * ratio).toPoint();
        int darkest = 255;
        for (int dy = -1; dy <= 1; ++dy)
            for (int dx = -1; dx <= 1; ++dx)
                darkest = std::min(darkest, qGray(seen.pixel(at + QPoint(dx, dy))));
        QVERIFY2(darkest < 60, qPrintable(QString::number(darkest)));  // the bar has 87, the board 143
    }
}

void TestPartList::listChangesParts() {
    QVERIFY(list().model()->moveRow({}, 0, {}, 3));  // as a drag does
    QTRY_COMPARE(names(), (QStringList{"bar", "board", "dot"}));
    undo().undo();
    QCOMPARE(names(), (QStringList{"dot", "bar", "board"}));
    list().item(1)->setCheckState(Qt::Unchecked);
    QTRY_VERIFY(parts()[1].hidden);
    list().item(1)->setText("arm");
    QTRY_COMPARE(names(), (QStringList{"dot", "arm", "board"}));
    QCOMPARE(parts()[0].ridesOn, std::string("arm"));  // references follow
    list().item(1)->setText("board");
    QTRY_COMPARE(list().item(1)->text(), QString("arm"));  // names are their own
    list().setCurrentRow(1);
    QTest::keyClick(&list(), Qt::Key_Down, Qt::AltModifier);
    QCOMPARE(names(), (QStringList{"dot", "board", "arm"}));
    QCOMPARE(list().currentItem()->text(), QString("arm"));
    QVERIFY(settle(m_f->session()));
    auto* joined = panel().findChild<QComboBox*>("partJoined");
    joined->setCurrentText("board");
    emit joined->activated(joined->currentIndex());
    QCOMPARE(parts()[2].joints.size(), std::size_t{1});
    const Vec2 at = parts()[2].joints[0].at;  // where bar and board overlap
    QVERIFY(at.x() > 38 && at.x() < 92 && at.y() > 26 && at.y() < 54);
    QVERIFY(settle(m_f->session()));
    QCOMPARE(m_f->session().motion().frame<2>()->rest->welds.size(), std::size_t{1});
    jointIsMoved(at);
    dragged();
    while (undo().canUndo()) undo().undo();
    QCOMPARE(names(), (QStringList{"dot", "bar", "board"}));
    QVERIFY(!parts()[1].hidden && parts()[1].joints.empty());
    QVERIFY(settle(m_f->session()));
}

/// During the drag and after the release both parts are together at the joint.
void TestPartList::dragged() {
    ShapeSession& session = m_f->session();
    session.addPin({20, 70, 0});
    session.addPin({150, 40, 0});
    QVERIFY(settle(session));
    session.gestures().begin();
    for (int k = 1; k <= 5; ++k) {
        session.gestures().moveBy({-6.0 * k, 8.0 * k, 0});
        QTRY_VERIFY(session.motion().frame()->live && session.motion().frame()->amount.norm() > 1);
        QVERIFY(gap() < 1e-9);
    }
    session.gestures().end(0.2);
    QVERIFY(settle(session));
    QVERIFY(gap() < 1e-9);
    QVERIFY((session.motion().frame<2>()->pose - session.motion().frame<2>()->rest->points)
                .colwise()
                .norm()
                .maxCoeff() > 20);
}

void TestPartList::canvasIsTheExport_data() {
    QTest::addColumn<int>("mode");
    QTest::newRow("normal") << 0;
    QTest::newRow("multiply") << 1;
    QTest::newRow("add") << 3;
}

/// A pin belongs to the part under it, and the canvas has the pixels of the file.
void TestPartList::canvasIsTheExport() {
    ShapeSession& session = m_f->session();
    ShapeCanvas& canvas = m_f->window().canvas();
    QFETCH(int, mode);
    list().setCurrentRow(1);
    emit panel().findChild<QComboBox*>("partBlend")->activated(mode);
    QVERIFY(settle(session));
    const QPoint middle = canvas.toWidget({70, 45}).toPoint(), end = canvas.toWidget({140, 40}).toPoint();
    QTest::mouseClick(&canvas, Qt::LeftButton, {}, middle);
    QVERIFY(settle(session));
    QTest::mousePress(&canvas, Qt::LeftButton, {}, end);
    for (int i = 1; i <= 6; ++i) QTest::mouseMove(&canvas, end + QPoint(-4 * i, 5 * i));
    QTest::mouseRelease(&canvas, Qt::LeftButton, {}, end + QPoint(-24, 30));
    QVERIFY(settle(session));
    const auto& handles = session.document().design().handles;
    QCOMPARE(handles.size(), std::size_t{2});
    for (const Pin& handle : handles) QCOMPARE(handle.part, std::string("bar"));
    session.selection().clear();
    m_f->window().canvas().viewport().set(&Looks::hidden, true);
    QTRY_VERIFY_WITH_TIMEOUT(canvas.isSettled(), 20000);
    const QString path = m_folder.filePath("out.png");
    const FrameExport frame(session.document(), session.motion().frame(), {}, 1);
    std::string remark;
    frame.write(ExportKind::Picture, path.toStdString(), {}, {}, remark);
    const QImage file(path), drawn = canvas.shape().drawn()->image;
    const double ratio = drawn.devicePixelRatio();
    int compared = 0;
    std::set<QRgb> colours;
    for (int y = 4; y < file.height() - 4; y += 3)
        for (int x = 4; x < file.width() - 4; x += 3) {
            const QRgb own = file.pixel(x, y);
            bool isEdge = false;  // where scaling mixes colours
            for (const auto& [u, v] :
                 {std::pair{-3, 0}, {3, 0}, {0, -3}, {0, 3}, {-2, -2}, {2, 2}, {2, -2}, {-2, 2}})
                isEdge = isEdge || file.pixel(x + u, y + v) != own;
            if (isEdge) continue;
            const QPointF at = canvas.toWidget({x + 0.5, y + 0.5}) * ratio;
            const QColor seen = drawn.pixelColor(at.toPoint());
            ++compared;
            QVERIFY2(std::abs(seen.alpha() - qAlpha(own)) <= 2 &&
                         (qAlpha(own) == 0 || (std::abs(seen.red() - qRed(own)) <= 2 &&
                                               std::abs(seen.green() - qGreen(own)) <= 2)),
                     qPrintable(QString("%1 %2").arg(x).arg(y)));
            colours.insert(own);
        }
    QVERIFY(compared > 500);
    const QRgb both = mode == 0 ? 0xffff0000 : mode == 1 ? 0xff000000 : 0xffffff00;  // of red over green
    QVERIFY(colours.contains(both));
}

/// A part is Normal unless its layer's file gives another mode; the project may override either.
void TestPartList::partIsBlended() {
    auto* blend = panel().findChild<QComboBox*>("partBlend");
    list().setCurrentRow(1);
    QCOMPARE(blend->currentText(), QString("Normal"));
    emit blend->activated(2);
    QCOMPARE(parts()[1].blend, BlendMode::Screen);
    QVERIFY(settle(m_f->session()));
    QCOMPARE(blend->currentText(), QString("Screen"));
    undo().undo();
    QVERIFY(!parts()[1].blend);
    QVERIFY(settle(m_f->session()));
    QCOMPARE(blend->currentText(), QString("Normal"));
    const QString path = m_folder.filePath("shade.ora");
    writeOpenRaster(path.toStdString(),
                    {{"shade", plainPicture(90, 60, {90, 90, 90, 255}), 10, 10, 1, true, BlendMode::Multiply},
                     {"ground", plainPicture(180, 90, {9, 200, 9, 255})}},
                    plainPicture(180, 90, {9, 9, 9, 255}));
    QVERIFY(m_f->openFile(path));
    QVERIFY(parts()[0].blend == BlendMode::Multiply && !parts()[1].blend);
    list().setCurrentRow(0);
    QCOMPARE(blend->currentText(), QString("Multiply"));
}

/// The first picture is in front; a file that is not a picture is refused by its name.
void TestPartList::picturesOpenTogether() {
    const QString front = m_folder.filePath("a.png"), back = m_folder.filePath("b/a.png");
    QVERIFY(QDir(m_folder.path()).mkpath("b"));
    writeImage(front.toStdString(), plainPicture(30, 20, {255, 0, 0, 255}));
    writeImage(back.toStdString(), plainPicture(90, 60, {0, 0, 255}));
    m_f->window().files().openAll(QStringList{front, back});
    QVERIFY(m_f->takeOpened([&] { return m_f->session().document().source() == front; }));
    QCOMPARE(names(), (QStringList{"a", "a 2"}));
    QCOMPARE(m_f->session().document().picture()->width, 90);
    QVERIFY(m_f->window().findChild<InfoBanner*>()->text().contains("2 pictures"));
    const QString written = m_folder.filePath("out.ora");
    const FrameExport frame(m_f->session().document(), m_f->session().motion().frame(), {}, 1);
    QVERIFY(frame.hasParts());
    std::string remark;
    frame.write(ExportKind::Picture, written.toStdString(), {}, {}, remark);
    QCOMPARE(readLayer(written.toStdString(), "a 2").width, 90);
    const QList<ExportFormat> formats = exportFormats(ExportKind::Picture, frame);
    QCOMPARE(formats.last().extension, QString(".psd"));
    const QString layers = m_folder.filePath("out.psd");
    frame.write(ExportKind::Picture, layers.toStdString(), {}, {}, remark);
    QCOMPARE(readLayer(layers.toStdString(), "a").width, readLayer(written.toStdString(), "a").width);
    const QString project = m_folder.filePath("p.wend");
    QVERIFY(QFile::copy(front, project));
    m_f->window().files().openAll(QStringList{front, project});
    auto* banner = m_f->window().findChild<InfoBanner*>();
    QTRY_VERIFY(banner->text().contains("only pictures are opened together"));
}

/// The outline settings are those of the part chosen in the list, until it shares those of all parts again.
void TestPartList::partsHaveTheirOutlines() {
    QVERIFY(settle(m_f->session()));
    MeshPanel& mesh = m_f->window().properties().mesh();
    const auto boxOf = [this](const std::string& name) {
        const auto frame = m_f->session().motion().frame<2>();
        Eigen::AlignedBox2d box;
        for (const MeshPart& part : frame->rest->parts)
            for (int v = part.firstVertex; part.name == name && v < part.endVertex; ++v)
                box.extend(Vec2(frame->rest->points.col(v)));
        return box;
    };
    const double bar = boxOf("bar").min().x(), before = boxOf("board").min().x();
    auto* whose = mesh.findChild<QComboBox*>("outlineOf");
    QCOMPARE(whose->currentText(), QString("All parts"));
    list().setCurrentRow(2);
    QCOMPARE(whose->currentText(), QString("board"));
    const auto field = [&](const char* key) { return mesh.findChild<OptionField*>(key); };
    const int steps = undo().count();
    field("domain.outline.margin")->setNumber(9);
    emit field("domain.outline.margin")->changed();
    QCOMPARE(undo().count(), steps + 1);
    const Domain& domain = m_f->session().document().domain();
    QVERIFY(parts()[2].outline && parts()[2].outline->alpha.margin == 9);
    QVERIFY(!parts()[1].outline && domain.alpha.margin != 9);
    QVERIFY(settle(m_f->session()));
    QVERIFY(std::abs(boxOf("bar").min().x() - bar) < 1);
    field("domain.vertices")->setNumber(700);
    emit field("domain.vertices")->changed();
    QCOMPARE(parts()[2].vertices, 700);
    QVERIFY(domain.vertices != 700);
    QVERIFY(settle(m_f->session()));
    const MeshPart& range = m_f->session().motion().frame<2>()->rest->parts[0];
    QCOMPARE(range.name, std::string("board"));
    QVERIFY(std::abs(range.endVertex - range.firstVertex - 700) < 200);
    mesh.findChild<QAbstractButton*>("outlineAsAll")->click();
    QVERIFY(!parts()[2].outline && parts()[2].vertices == 0);
    QVERIFY(settle(m_f->session()));
    QVERIFY(std::abs(boxOf("board").min().x() - before) < 1);
    emit whose->activated(0);
    QCOMPARE(whose->currentIndex(), 0);
}

/// The lasso with Ctrl takes the right half away from the chosen part, and from no other.
void TestPartList::outlinesOfPartsAreDrawn() {
    ShapeSession& session = m_f->session();
    QVERIFY(settle(session));
    list().setCurrentRow(2);
    m_f->tool("outlineLasso")->trigger();
    ShapeCanvas& canvas = m_f->window().canvas();
    const auto at = [&](double x, double y) { return canvas.toWidget({x, y}).toPoint(); };
    QTest::mousePress(&canvas, Qt::LeftButton, Qt::ControlModifier, at(50, 4));
    for (const auto& [x, y] : {std::pair{50, 86}, {110, 86}, {110, 4}, {52, 4}}) {
        QMouseEvent move(QEvent::MouseMove, at(x, y), canvas.mapToGlobal(at(x, y)), Qt::NoButton,
                         Qt::LeftButton, Qt::ControlModifier);
        QCoreApplication::sendEvent(&canvas, &move);
    }
    QTest::mouseRelease(&canvas, Qt::LeftButton, Qt::ControlModifier, at(52, 4));
    QVERIFY(parts()[2].outline && parts()[2].outline->kind == OutlineKind::Polygons);
    QVERIFY(!parts()[1].outline);
    QVERIFY(settle(session));
    double board = 0, bar = 0;
    const SimplicialMesh<2>& rest = *session.motion().frame<2>()->rest;
    for (const MeshPart& part : rest.parts)
        for (int v = part.firstVertex; v < part.endVertex; ++v) {
            double& most = part.name == "board" ? board : bar;
            most = std::max(most, rest.points(0, v));
        }
    QVERIFY2(std::abs(board - 50) < 1.5, qPrintable(QString::number(board)));
    QVERIFY(bar > 155);
}

/// Pictures before and after the change show which part is in front.
void TestPartList::orderChangesFromHere() {
    ShapeSession& session = m_f->session();
    session.addPin({20, 70, 0});
    session.addPin({150, 40, 0});
    QVERIFY(settle(session));
    session.gestures().begin();
    session.gestures().moveBy({2, 2, 0});
    session.gestures().end(0.2);
    QVERIFY(settle(session));
    list().setCurrentRow(2);
    session.playback().setTime(0.5);
    panel().findChild<QAbstractButton*>("partFrontFromHere")->click();
    QCOMPARE(parts()[2].order.size(), std::size_t{1});
    QCOMPARE(parts()[2].order[0].time, 0.5);
    QVERIFY(parts()[2].order[0].place < 0);
    QVERIFY(settle(session));
    const auto colourAt = [&](double time) {
        session.playback().setTime(time);
        const QString path = m_folder.filePath("order.png");
        const FrameExport frame(session.document(), session.motion().frame(), {}, 1);
        std::string remark;
        frame.write(ExportKind::Picture, path.toStdString(), {}, {}, remark);
        return QImage(path).pixelColor(70, 33);  // of bar and board
    };
    QVERIFY(colourAt(0.25).red() > 250);
    QVERIFY(colourAt(0.75).green() > 250);
    auto* times = panel().findChild<QLabel*>("partOrderTimes");
    QVERIFY(times->isVisibleTo(&panel()) && !times->text().isEmpty());
    panel().findChild<QAbstractButton*>("partOrderNever")->click();
    QVERIFY(parts()[2].order.empty());
    QVERIFY(settle(session));
    QVERIFY(colourAt(0.75).red() > 250);
}

/// A click passes through a hidden part to the one behind it.
void TestPartList::hiddenPartsAreNotTouched() {
    ShapeSession& session = m_f->session();
    QVERIFY(settle(session));
    const ShapeCanvas& canvas = m_f->window().canvas();
    const auto touched = [&] {
        const auto touch = canvas.touch(canvas.toWidget({70, 35}));
        return touch ? session.motion().frame()->partOf(touch->place.cell) : std::string();
    };
    QCOMPARE(touched(), std::string("bar"));
    list().item(1)->setCheckState(Qt::Unchecked);
    QTRY_VERIFY(parts()[1].hidden);
    QVERIFY(settle(session));
    QCOMPARE(touched(), std::string("board"));
}

/// A click on the lock at the end of a row locks the part: pins are set through it, its own ones stay, and
/// neither the shape nor its motion is computed again.
void TestPartList::lockedPartsAreLeftAlone() {
    ShapeSession& session = m_f->session();
    QVERIFY(settle(session));
    ShapeCanvas& canvas = m_f->window().canvas();
    const int before = session.addPin({150, 40, 0});
    QVERIFY(settle(session));
    const auto rest = session.motion().frame<2>()->rest;
    QVERIFY(list().isVisible());
    const QRect row = list().visualItemRect(list().item(1));
    QTest::mouseClick(list().viewport(), Qt::LeftButton, {}, {row.right() - 10, row.center().y()});
    QVERIFY(parts()[1].locked && !parts()[1].hidden);
    QVERIFY(list().item(1)->toolTip().contains("locked"));
    QVERIFY(settle(session));
    QCOMPARE(session.motion().frame<2>()->rest, rest);
    QVERIFY(!session.gestures().mayChange(before));
    m_f->tool("pin")->trigger();
    QTest::mouseClick(&canvas, Qt::LeftButton, {}, canvas.toWidget({70, 35}).toPoint());
    const auto& handles = session.document().design().handles;
    QCOMPARE(handles.size(), std::size_t{2});
    QCOMPARE(handles.back().part, std::string("board"));
    QVERIFY(session.gestures().mayChange(1));
    list().setCurrentRow(1);
    auto* lock = panel().findChild<QAbstractButton*>("partLock");
    QVERIFY(lock->isChecked());
    lock->click();
    QVERIFY(!parts()[1].locked && session.gestures().mayChange(before));
}

void TestPartList::lock(int row) {
    list().setCurrentRow(row);
    panel().findChild<QAbstractButton*>("partLock")->click();
}

/// Presses at the first place of the document and releases at the last.
void TestPartList::stroke(const std::vector<Vec2>& way, Qt::KeyboardModifiers modifiers) {
    ShapeCanvas& canvas = m_f->window().canvas();
    QTest::mousePress(&canvas, Qt::LeftButton, modifiers, canvas.toWidget(way.front()).toPoint());
    for (const Vec2& p : way) {
        const QPointF at = canvas.toWidget(p);
        QMouseEvent move(QEvent::MouseMove, at, canvas.mapToGlobal(at), Qt::NoButton, Qt::LeftButton,
                         modifiers);
        QCoreApplication::sendEvent(&canvas, &move);
    }
    QTest::mouseRelease(&canvas, Qt::LeftButton, modifiers, canvas.toWidget(way.back()).toPoint());
    QVERIFY(settle(m_f->session()));
}

bool TestPartList::isPainted(std::size_t part) {
    const auto frame = m_f->session().motion().frame<2>();
    const MeshPart& range = frame->rest->parts.at(part);
    const auto& phi = frame->material->phi;
    return std::any_of(phi.begin() + range.firstCell, phi.begin() + range.endCell,
                       [](double value) { return std::abs(value - phi::kMetr) > 1e-6; });
}

/// A stroke paints the part on which it began, or, if that is locked, the one below.
void TestPartList::paintBelongsToParts() {
    ShapeSession& session = m_f->session();
    QVERIFY(settle(session));
    ShapeCanvas& canvas = m_f->window().canvas();
    m_f->window().tools().setMode(Mode::Paint);
    m_f->tool("paint")->trigger();
    const auto stroke = [&] {
        const QPoint from = canvas.toWidget({75, 35}).toPoint(), to = canvas.toWidget({85, 40}).toPoint();
        QTest::mousePress(&canvas, Qt::LeftButton, {}, from);
        QTest::mouseMove(&canvas, to);
        QTest::mouseRelease(&canvas, Qt::LeftButton, {}, to);
    };
    const auto painted = [&](std::size_t part) {
        const auto frame = session.motion().frame<2>();
        const MeshPart& range = frame->rest->parts.at(part);
        const auto& phi = frame->material->phi;
        return std::any_of(phi.begin() + range.firstCell, phi.begin() + range.endCell,
                           [](double value) { return std::abs(value - phi::kMetr) > 1e-6; });
    };
    BrushSettings brush = m_f->window().properties().brush().now();
    brush.phi = phi::kAkvf;
    m_f->window().properties().brush().set(brush);
    stroke();
    QVERIFY(settle(session));
    QCOMPARE(regionsIn(session.document().design()).front().part, std::string("bar"));
    QCOMPARE(session.motion().frame<2>()->rest->parts[1].name, std::string("bar"));
    QVERIFY(painted(1) && !painted(0));
    undo().undo();
    list().setCurrentRow(1);
    panel().findChild<QAbstractButton*>("partLock")->click();
    stroke();
    QVERIFY(settle(session));
    QVERIFY(!painted(1) && painted(0));
}

/// A gradient and a fill of everything change the frontmost part that is not locked where they begin; the
/// ends of the gradient of a locked one are not dragged.
void TestPartList::gradientsAndFillsBelongToParts() {
    ShapeSession& session = m_f->session();
    QVERIFY(settle(session));
    QCOMPARE(session.motion().frame<2>()->rest->parts[1].name, std::string("bar"));
    m_f->window().tools().setMode(Mode::Paint);
    BrushSettings brush = m_f->window().properties().brush().now();
    brush.phi = phi::kAkvf;
    m_f->window().properties().brush().set(brush);
    const auto regions = [&] { return regionsIn(session.document().design()); };
    m_f->tool("gradient")->trigger();
    stroke({{75, 35}, {80, 37}, {85, 45}});
    QCOMPARE(regions().size(), std::size_t{1});
    QCOMPARE(regions()[0].part, std::string("bar"));
    QVERIFY(isPainted(1) && !isPainted(0));
    lock(1);
    const int steps = undo().index();
    stroke({{85, 45}, {82, 60}});  // not its end, but a gradient of the board
    QCOMPARE(undo().index(), steps + 1);
    QCOMPARE(regions().size(), std::size_t{2});
    QCOMPARE(regions()[1].part, std::string("board"));
    QVERIFY(isPainted(0));
    undo().setIndex(0);
    QVERIFY(settle(session) && !isPainted(0) && !isPainted(1));
    m_f->tool("fill")->trigger();
    stroke({{75, 35}}, Qt::ShiftModifier);
    QVERIFY(isPainted(1) && !isPainted(0));
}

/// The detail brush makes one part finer, and the meshes of the others stay; the project keeps which one,
/// also under another name.
void TestPartList::detailBelongsToParts() {
    ShapeSession& session = m_f->session();
    QVERIFY(settle(session));
    const auto pointsOf = [&](const std::string& name) {
        const SimplicialMesh<2>& rest = *session.motion().frame<2>()->rest;
        const auto part = std::ranges::find(rest.parts, name, &MeshPart::name);
        return Points2(rest.points.middleCols(part->firstVertex, part->endVertex - part->firstVertex));
    };
    const auto sizes = [&] { return session.document().domain().sizes; };
    const auto near = [](const Points2& points) {
        return ((points.colwise() - Vec2(72, 37)).colwise().norm().array() < 10).count();
    };
    const Points2 bar = pointsOf("bar"), board = pointsOf("board");
    m_f->window().tools().setMode(Mode::Mesh);
    m_f->tool("sizes")->trigger();
    stroke({{70, 35}, {75, 40}});
    QCOMPARE(sizes().front().regions.front().part, std::string("bar"));
    QVERIFY(pointsOf("board") == board);
    QVERIFY(near(pointsOf("bar")) > near(bar));
    const QByteArray written = QByteArray::fromStdString(toJson(*session.document().project()));
    const QJsonObject domain = QJsonDocument::fromJson(written)["domain"].toObject();
    QCOMPARE(domain["sizes"][0]["part"].toString(), QString("bar"));
    list().item(1)->setText("arm");
    QTRY_COMPARE(sizes().front().regions.front().part, std::string("arm"));
    QVERIFY(settle(session));
    const Points2 finer = pointsOf("arm");
    QVERIFY(near(finer) > near(bar));
    lock(1);
    stroke({{70, 35}, {75, 40}});
    QCOMPARE(sizes().back().regions.front().part, std::string("board"));
    QVERIFY(pointsOf("arm") == finer);
    QVERIFY(near(pointsOf("board")) > near(board));
}

/// While a part of a photograph is being made, nothing can be dragged, and a message says so.
void TestPartList::dragsWaitForParts() {
    const QString path = m_folder.filePath("photo.png");
    writeImage(path.toStdString(), plainPicture(180, 120, {90, 120, 60}));
    QVERIFY(m_f->openFile(path));
    ShapeSession& session = m_f->session();
    QVERIFY(settle(session));
    QSignalSpy notices(&session.document(), &Document::notice),
        problems(&session.motion(), &ShapeMotion::problem);
    makePart(session, {{{{60, 30}, {110, 30}, {110, 80}, {60, 80}}}});
    QVERIFY(session.motion().isMeshing());
    session.selection().set({session.addPin({80, 50, 0})});
    notices.clear();
    session.gestures().begin();
    QVERIFY(!session.motion().isDragging());
    QCOMPARE(notices.count(), 1);
    QVERIFY(notices[0][0].toString().contains("still being made"));
    QVERIFY(settle(session));
    for (const auto& problem : problems) QCOMPARE(problem[0].toString(), QString());
    session.gestures().begin();
    QVERIFY(session.motion().isDragging());
    session.gestures().cancel();
}

/// A part drawn before the shape knows another part's new name is cut from that part; one drawn before there
/// are parts to cut from waits, with a message.
void TestPartList::renamedPartIsCut() {
    ShapeSession& session = m_f->session();
    QVERIFY(settle(session));
    const Outline onBoard{{{{15, 56}, {45, 56}, {45, 76}, {15, 76}}}};
    list().item(2)->setText("plank");
    QTRY_COMPARE(names(), (QStringList{"dot", "bar", "plank"}));
    QVERIFY(session.motion().isMeshing());
    makePart(session, onBoard);
    QCOMPARE(parts().size(), std::size_t{4});
    QCOMPARE(parts()[2].cutFrom, std::string("plank"));
    QVERIFY(settle(session));
    QCOMPARE(session.motion().frame<2>()->rest->parts.size(), std::size_t{3});  // the dot has no mesh
    undo().undo();
    undo().undo();
    QVERIFY(settle(session));
    Domain domain = session.document().domain();  // as after a drag of the list and a new name, at once
    std::swap(domain.parts[1], domain.parts[2]);
    domain.parts[1].name = "plank";
    session.document().changeDomain("both", domain);
    makePart(session, onBoard);
    QCOMPARE(parts()[1].cutFrom, std::string("plank"));
    QVERIFY(settle(session));
    undo().setClean();
    const QString path = m_folder.filePath("leaf.png");
    writeImage(path.toStdString(), plainPicture(180, 120, {90, 120, 60}));
    QVERIFY(m_f->openFile(path));
    QVERIFY(settle(session));
    makePart(session, {{{{60, 30}, {110, 30}, {110, 80}, {60, 80}}}});
    QVERIFY(session.motion().isMeshing());
    QSignalSpy notices(&session.document(), &Document::notice);
    makePart(session, {{{{20, 30}, {50, 30}, {50, 80}, {20, 80}}}});
    QCOMPARE(parts().size(), std::size_t{2});
    QCOMPARE(notices.count(), 1);
    QVERIFY(notices[0][0].toString().contains("still being made"));
    QVERIFY(settle(session));
}

/// The note about a new part says that the ground is being filled; one after a rename does not.
void TestPartList::noteNamesTheFilling() {
    QVERIFY(canInpaint());
    const QString path = m_folder.filePath("meadow.png");
    Image meadow = plainPicture(900, 700, {90, 120, 60});
    for (int y = 0; y < meadow.height; ++y)
        for (int x = 0; x < meadow.width; ++x)
            meadow.row(y)[3 * x] = static_cast<std::byte>((x * x / 7 + 13 * y) % 200);
    writeImage(path.toStdString(), meadow);
    QVERIFY(m_f->openFile(path));
    ShapeSession& session = m_f->session();
    QVERIFY(settle(session));
    auto* note = m_f->window().findChild<WorkNote*>();
    auto* banner = m_f->window().findChild<InfoBanner*>();
    QVERIFY(banner->text().contains("fills its frame"));
    makePart(session, {{{{200, 150}, {700, 150}, {700, 550}, {200, 550}}}});
    QVERIFY(!banner->text().contains("fills its frame"));  // the ground is held
    QTRY_VERIFY_WITH_TIMEOUT(!note->text().isEmpty(), 20000);
    QCOMPARE(note->text(), QString("Filling the ground behind “Part 1” …"));
    QVERIFY(settle(session));
    note->show();
    list().item(0)->setText("flower");
    QTRY_COMPARE(names().front(), QString("flower"));
    QTRY_VERIFY(note->isVisible() || !session.motion().isBusy());
    QVERIFY(!note->text().contains("Filling"));
    QVERIFY(settle(session));
}

/// A lasso neither changes the outline of a locked part nor cuts a part out of it.
void TestPartList::outlinesOfLockedPartsStay() {
    QVERIFY(settle(m_f->session()));
    lock(1);
    m_f->tool("outlineLasso")->trigger();
    const int steps = undo().index();
    const std::vector<Vec2> around{{60, 30}, {85, 30}, {85, 50}, {60, 50}, {60, 31}};
    stroke(around, Qt::ControlModifier);
    QCOMPARE(undo().index(), steps);
    auto* makesPart = m_f->window().findChild<QAction*>("makesPart");
    QVERIFY(makesPart);
    makesPart->trigger();
    stroke(around);
    QCOMPARE(undo().index(), steps + 1);
    QCOMPARE(parts().size(), std::size_t{4});
    QCOMPARE(parts()[2].cutFrom, std::string("board"));
    undo().undo();
    QVERIFY(settle(m_f->session()));
    for (const int row : {0, 2}) lock(row);
    stroke(around);
    QCOMPARE(parts().size(), std::size_t{3});
}

/// The field appears for parts that were cut out, whose picture is remade.
void TestPartList::edgesAreSoftened() {
    auto* edge = panel().findChild<QDoubleSpinBox*>("partFeather");
    list().setCurrentRow(1);
    QVERIFY(!edge->isVisible());
    Domain domain = m_f->session().document().domain();
    PicturePart piece;
    piece.name = "piece";
    piece.cutFrom = "board";
    piece.cut.loops = {{{20, 50}, {60, 50}, {60, 78}, {20, 78}}};
    piece.outline = PartOutline{OutlineKind::Alpha, {}, {}};
    domain.parts.insert(domain.parts.begin(), piece);
    m_f->session().document().changeDomain("cut", domain);
    QVERIFY(settle(m_f->session()));
    const auto alphaAt = [&](int x) {
        const Texture& texture = *m_f->session().motion().frame<2>()->built->texture;
        const Sheet& sheet = texture.sheets.back();
        const Image& picture = *sheet.picture;
        return std::to_integer<int>(
            picture.row(64 - static_cast<int>(sheet.at.y()))[4 * (x - static_cast<int>(sheet.at.x())) + 3]);
    };
    QCOMPARE(alphaAt(22), 255);
    list().setCurrentRow(0);
    QVERIFY(edge->isVisible() && edge->value() == 0);
    edge->setValue(8);
    QCOMPARE(parts()[0].feather, 8.0);
    QVERIFY(settle(m_f->session()));
    QVERIFY(alphaAt(22) > 128 && alphaAt(22) < 255);
    QCOMPARE(alphaAt(40), 255);
    undo().undo();
    QCOMPARE(parts()[0].feather, 0.0);
}

/// The bar has no pin and is the smaller part; a click attaches it to the other, which it then follows.
void TestPartList::partsWithoutPinsCanBeAttached() {
    ShapeSession& session = m_f->session();
    session.addPin({20, 70, 0});
    QVERIFY(settle(session));
    session.gestures().begin();
    session.gestures().moveBy({5, 4, 0});
    session.gestures().end(0.2);
    QVERIFY(settle(session));
    auto* banner = m_f->window().findChild<InfoBanner*>();
    QTRY_VERIFY(banner->text().contains("ride on “board”"));
    QVERIFY(banner->property("offers").toBool());  // no error
    QAbstractButton* ride = nullptr;
    for (auto* button : banner->findChildren<QAbstractButton*>())
        if (button->text() == "Let It Ride") ride = button;
    QVERIFY(ride);
    while (undo().canUndo()) undo().undo();
    QVERIFY(settle(session));
    QTRY_VERIFY(!banner->text().contains("ride on"));  // nothing moves any more
    while (undo().canRedo()) undo().redo();
    QVERIFY(settle(session));
    QTRY_VERIFY(banner->text().contains("ride on “board”"));
    for (auto* button : banner->findChildren<QAbstractButton*>())
        if (button->text() == "Let It Ride") ride = button;
    ride->click();
    QCOMPARE(parts()[1].ridesOn, std::string("board"));
    QVERIFY(settle(session));
    QVERIFY(!banner->text().contains("ride on"));
}

void TestPartList::partsOnAStrayPartFollowIt_data() {
    QTest::addColumn<int>("headSize");
    QTest::addColumn<QStringList>("expected");
    QTest::newRow("larger than the arm") << 90 << QStringList{"ball on arm"};
    QTest::newRow("smaller") << 60 << QStringList{"ball on arm", "head on arm", "eye on head"};
}

/// An eye on a head without a pin is not offered to the arm beside it; it follows the head if that follows
/// the arm.
void TestPartList::partsOnAStrayPartFollowIt() {
    QFETCH(int, headSize);
    QFETCH(QStringList, expected);
    const auto layer = [](const char* name, int width, int height, int x, int y) {
        return LayerToWrite{name, plainPicture(width, height, {90, 90, 90, 255}), x, y};
    };
    const QString path = m_folder.filePath("head.ora");
    writeOpenRaster(
        path.toStdString(),
        {layer("eye", 20, 20, 30, 30), layer("head", headSize, headSize, 20, 20),
         layer("ball", 24, 24, 300, 150), layer("arm", 160, 40, 120, 20), layer("ground", 400, 200, 0, 0)},
        plainPicture(400, 200, {9, 9, 9, 255}));
    QVERIFY(m_f->openFile(path));
    ShapeSession& session = m_f->session();
    session.addPin({200, 40, 0});
    QVERIFY(settle(session));
    QStringList found;
    for (const StrayPart& one : strayParts(session))
        found << QString::fromStdString(one.name + " on " + one.host);
    QCOMPARE(found, expected);
}

/// Two blobs of one picture: the one without a pin becomes a part that follows the other one's map, which is
/// a translation.
void TestPartList::islandsCanBeAttached() {
    Image picture = plainPicture(120, 60, {0, 0, 0, 0});
    const auto fill = [&](int x0, int y0, int x1, int y1) {
        for (int y = y0; y < y1; ++y)
            for (int x = x0; x < x1; ++x)
                for (int c = 0; c < 4; ++c) picture.row(y)[4 * x + c] = std::byte{200};
    };
    fill(10, 10, 60, 50), fill(80, 20, 96, 36);
    const QString path = m_folder.filePath("blobs.png");
    writeImage(path.toStdString(), picture);
    QVERIFY(m_f->openFile(path));
    ShapeSession& session = m_f->session();
    session.addPin({35, 30, 0});
    QVERIFY(settle(session));
    session.gestures().begin();
    session.gestures().moveBy({0, 7, 0});
    session.gestures().end(0.2);
    QVERIFY(settle(session));
    const std::vector<StrayPart> strays = strayParts(session);
    QCOMPARE(strays.size(), std::size_t{1});
    session.document().change("ride", withRiders(*session.document().project(), strays));
    QVERIFY(settle(session));
    QCOMPARE(parts().size(), std::size_t{2});
    QCOMPARE(parts()[0].ridesOn, parts()[1].name);
    const QString out = m_folder.filePath("ridden.png");
    const FrameExport frame(session.document(), session.motion().frame(), {}, 1);
    std::string remark;
    frame.write(ExportKind::Picture, out.toStdString(), {}, {}, remark);
    const QImage seen(out);
    for (const auto& [y, alpha] : {std::pair{21, 0}, {25, 0}, {29, 200}, {40, 200}, {46, 0}})
        QVERIFY2(std::abs(qAlpha(seen.pixel(88, y)) - alpha) <= 2, qPrintable(QString::number(y)));
}

QTEST_MAIN(TestPartList)
#include "test_part_list.moc"
