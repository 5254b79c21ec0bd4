#include "app/view/export_dialog.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <cmath>

#include "app/document/in_background.h"
#include "app/document/said.h"
#include "app/panels/option_field.h"
#include "app/panels/panel_parts.h"
#include "app/session/playback.h"
#include "app/session/run_options.h"
#include "app/session/shape_file.h"
#include "core/mesh/error.h"
#include "core/mesh/mesh_formats.h"
#include "warp/image_formats.h"

namespace wend {

namespace {

struct Format {
    QString name, extension;
};
using Formats = QList<Format>;

const Formats kPictures{
    {"PNG", ".png"}, {"TIFF", ".tif"}, {"OpenEXR", ".exr"}, {"JPEG", ".jpg"}, {"WebP", ".webp"}};
const Formats kMaps{{"OpenEXR", ".exr"}, {"TIFF", ".tif"}};
/// Surfaces first in the plane, in space what holds the solid itself.
Formats meshFormats(bool solid, bool film) {
    Formats formats, others;
    for (const MeshFormatFacts& format : meshFormatFacts()) {
        if (format.together && (film || !solid)) continue;  // two files each
        const auto& first = format.extensions.front();
        (format.holdsTetrahedra == solid ? formats : others)
            << Format{QString::fromUtf8(format.name.data(), format.name.size()),
                      QString::fromUtf8(first.data(), first.size())};
    }
    if (solid && film) formats.prepend({QStringLiteral("glTF film"), QStringLiteral(".glb")});
    if (solid && !film) formats.append({QStringLiteral("glTF"), QStringLiteral(".glb")});
    return formats + others;
}

Formats formatsOf(ExportKind kind, const FrameExport& shape) {
    if (kind == ExportKind::Picture) return kPictures;
    if (kind == ExportKind::StMap) return kMaps;
    const bool solid = shape.dimension() == 3;
    const bool film = kind == ExportKind::Frames;
    const Formats meshes = meshFormats(solid, film);
    return film && shape.picture() ? kPictures + meshes : meshes;
}

QString titleOf(ExportKind kind) {
    switch (kind) {
        case ExportKind::Picture:
            return ExportDialog::tr("Export Picture");
        case ExportKind::Frames:
            return ExportDialog::tr("Export Sequence");
        case ExportKind::StMap:
            return ExportDialog::tr("Export ST Map");
        case ExportKind::Mesh:
            break;
    }
    return ExportDialog::tr("Export Mesh");
}

QString bytesText(double bytes) {
    return QLocale().formattedDataSize(static_cast<qint64>(bytes), bytes < 1000 ? 0 : 1,
                                       QLocale::DataSizeSIFormat);
}

/// What came of work in the background. (Futures would slice the exception.)
template <class Value>
struct Answer {
    Value value{};
    QString problem;
    bool stopped = false;
};

template <class Value, class Work>
Answer<Value> answerOf(const Work& work) {
    try {
        return {work(), {}, false};
    } catch (const Cancelled&) {
        return {{}, {}, true};
    } catch (const std::exception& error) {
        return {{}, said(error), false};
    }
}

}  // namespace

ExportDialog::ExportDialog(ExportKind kind, std::shared_ptr<const FrameExport> shape, const QImage& solidView,
                           QWidget* parent)
    : QDialog(parent),
      m_kind(kind),
      m_shape(std::move(shape)),
      m_preview(new ExportPreview(this)),
      m_format(new QComboBox(this)),
      m_facts(new QLabel(this)),
      m_cropText(new QLabel(this)),
      m_problem(new QLabel(this)),
      m_crop(makeCropNote()),
      m_write(nullptr) {
    setWindowTitle(titleOf(kind));
    makeFormats();
    makeFields();
    lay();
    for (QTimer* timer : {&m_previewTimer, &m_sizeTimer}) timer->setSingleShot(true);
    m_previewTimer.setInterval(40);
    m_sizeTimer.setInterval(250);
    connect(&m_previewTimer, &QTimer::timeout, this, &ExportDialog::startPreview);
    connect(&m_sizeTimer, &QTimer::timeout, this, &ExportDialog::startSize);
    if (!solidView.isNull()) {
        m_preview->setProperty("bare", true);
        m_preview->setImage(solidView);
    }
    adapt();
    preparePicture();
}

ExportDialog::~ExportDialog() {
    m_previewStop.request_stop();
    m_sizeStop.request_stop();
}

void ExportDialog::makeFormats() {
    for (const Format& format : formatsOf(m_kind, *m_shape)) m_format->addItem(format.name, format.extension);
    m_format->setObjectName(QStringLiteral("format"));
    describe(m_format, tr("Format"), tr("What kind of file is written."));
    connect(m_format, &QComboBox::currentIndexChanged, this, &ExportDialog::adapt);
}

void ExportDialog::makeFields() {
    for (const char* flag : {"--count", "--fps", "--depth", "--canvas", "--outside", "--filter", "--fields",
                             "--encoding", "--msh", "--border"}) {
        auto* field = new OptionField(flag, this);
        m_fields << field;
        connect(field, &OptionField::changed, this, [this, field] {
            tieRate(*field);
            adapt();
        });
    }
    if (m_kind == ExportKind::Frames) tieRate(*field("--fps"));
}

QWidget* ExportDialog::makeCropNote() {
    auto* note = new QWidget(this);
    note->setObjectName(QStringLiteral("cropNote"));
    auto* fit = new QPushButton(tr("Fit the &Canvas"), note);
    fit->setAutoDefault(false);
    describe(fit, tr("Fit the canvas"),
             tr("Make the canvas as large as the shape needs, so that nothing is cut off."));
    connect(fit, &QPushButton::clicked, this, [this] { field("--canvas")->setValue("fit"); });
    m_cropText->setWordWrap(true);
    m_cropText->setProperty("role", "warning");
    auto* row = new QHBoxLayout(note);
    row->setContentsMargins(12, 8, 8, 8);
    row->addWidget(m_cropText, 1);
    row->addWidget(fit);
    note->setAttribute(Qt::WA_StyledBackground);
    return note;
}

void ExportDialog::lay() {
    m_form = new QFormLayout;
    m_form->setVerticalSpacing(10);
    m_form->addRow(tr("F&ormat"), m_format);
    for (OptionField* field : m_fields) m_form->addRow(field->label(), field);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    m_write = buttons->addButton(tr("E&xport…"), QDialogButtonBox::AcceptRole);
    m_write->setProperty("role", "primary");
    m_write->setDefault(true);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    m_facts->setObjectName(QStringLiteral("facts"));
    m_facts->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_problem->setObjectName(QStringLiteral("problem"));
    m_problem->setProperty("role", "warning");
    m_problem->setWordWrap(true);
    m_problem->hide();
    auto* right = new QVBoxLayout;
    right->addLayout(m_form);
    right->addStretch(1);
    auto* top = new QHBoxLayout;
    top->setSpacing(20);
    top->addWidget(m_preview, 1);
    top->addLayout(right);
    auto* all = new QVBoxLayout(this);
    all->setContentsMargins(16, 16, 16, 16);
    all->setSpacing(12);
    all->addLayout(top, 1);
    all->addWidget(m_facts);
    all->addWidget(m_crop);
    all->addWidget(m_problem);
    all->addWidget(buttons);
    for (int i = 0; i < m_form->rowCount(); ++i)
        if (QWidget* control = m_form->itemAt(i, QFormLayout::FieldRole)->widget())
            control->setMinimumWidth(220);
}

QString ExportDialog::extension() const {
    return m_format->currentData().toString();
}

QString ExportDialog::filter() const {
    return QStringLiteral("%1 (*%2)").arg(m_format->currentText(), extension());
}

bool ExportDialog::isPicture() const {
    return canWriteImage("picture" + extension().toStdString());
}

OptionField* ExportDialog::field(const char* flag) const {
    for (OptionField* field : m_fields)
        if (field->flag() == flag) return field;
    return nullptr;
}

/// Whether the option says something about what is written now.
bool ExportDialog::takes(const std::string& flag) const {
    const std::string file = "mesh" + extension().toStdString();
    if (flag == "--count" || flag == "--fps") return m_kind == ExportKind::Frames;
    if (flag == "--canvas") return isPicture();
    if (flag == "--depth" || flag == "--outside" || flag == "--filter")
        return isPicture() && m_kind != ExportKind::StMap;
    if (isPicture()) return false;
    if (flag == "--border") return m_shape->dimension() == 3 && carriesValues(file);
    if (flag == "--fields") return carriesValues(file);
    return flag == "--encoding" ? knowsEncodings(file) : file.ends_with(".msh");
}

OptionValues ExportDialog::values() const {
    OptionValues values;
    for (const OptionField* field : m_fields)
        if (takes(field->flag()) && !field->value().empty()) values.set(field->flag(), field->value());
    return values;
}

/// The film lasts as long as the motion: number and rate of its frames follow each other.
void ExportDialog::tieRate(const OptionField& changed) {
    OptionField *count = field("--count"), *rate = field("--fps");
    if (!count || !rate || m_shape->seconds() <= 0) return;
    if (&changed == rate) count->setNumber(std::lround(m_shape->seconds() * rate->number()) + 1.0);
    if (&changed == count) rate->setNumber((count->number() - 1) / m_shape->seconds());
}

/// What belongs to the format.
void ExportDialog::adapt() {
    for (OptionField* field : m_fields) m_form->setRowVisible(field, takes(field->flag()));
    if (isPicture()) showDepths();
    showCrop();
    m_facts->setText(pixels());
    tellProblem({});
    askPreview();
    m_sizeTimer.start();
    ++m_asked;  // an answer that is under way is to another question
}

void ExportDialog::showDepths() {
    static const std::pair<const char*, PixelType> types[] = {{"8", PixelType::UInt8},
                                                              {"16", PixelType::UInt16},
                                                              {"half", PixelType::Half},
                                                              {"float", PixelType::Float}};
    const std::string file = "picture" + extension().toStdString();
    QStringList choices;
    QString own;
    for (const auto& [name, type] : types) {
        if (holdsType(file, type)) choices << QString::fromLatin1(name);
        if (m_shape->picture() && m_shape->picture()->type == type) own = QString::fromLatin1(name);
    }
    OptionField* depth = field("--depth");
    const bool kept = choices.contains(own);
    depth->setChoices(QStringList(QStringLiteral("picture")) + choices);
    depth->setWords(QStringLiteral("picture"),
                    kept ? tr("As in the picture") : tr("As the format holds it best"));
}

void ExportDialog::showCrop() {
    const bool cuts = isPicture() && field("--canvas")->value() == "picture";
    const Overhang over = cuts ? m_shape->overhang(m_kind) : Overhang{};
    QStringList sides;
    const auto add = [&sides](int by, const QString& text) {
        if (by > 0) sides << text.arg(QLocale().toString(by));
    };
    add(over.left, tr("%1 px on the left"));
    add(over.top, tr("%1 px at the top"));
    add(over.right, tr("%1 px on the right"));
    add(over.bottom, tr("%1 px at the bottom"));
    const QString where = sides.join(tr(", "));
    m_cropText->setText(
        m_kind == ExportKind::Frames
            ? tr("On its way the shape leaves the picture and is cut off there: %1.").arg(where)
            : tr("The shape reaches beyond the picture and is cut off there: %1.").arg(where));
    m_crop->setVisible(over.any());
}

QString ExportDialog::pixels() const {
    const QLocale locale;
    const auto count = static_cast<int>(m_kind == ExportKind::Frames ? field("--count")->number() : 1);
    if (!isPicture()) {
        const FramePtr& frame = m_shape->frame();
        const QString one = tr("%1 vertices").arg(locale.toString(frame->vertices));
        return m_kind == ExportKind::Frames ? tr("%n shapes of %1", nullptr, count).arg(one) : one;
    }
    try {
        const Canvas canvas = field("--canvas")->value() == "fit" ? Canvas::Fit : Canvas::Picture;
        const View view = m_shape->view(m_kind, canvas);
        const QString one =
            tr("%1 × %2 pixels").arg(locale.toString(view.width), locale.toString(view.height));
        return m_kind == ExportKind::Frames ? tr("%n pictures of %1", nullptr, count).arg(one) : one;
    } catch (const InputError&) {
        return {};  // the preview tells why
    }
}

void ExportDialog::showSize(const FileSize& size) {
    const QString text = bytesText(size.bytes);
    m_facts->setText(pixels() + QStringLiteral("  ·  ") +
                     (size.measured ? tr("%1 (measured)").arg(text) : tr("about %1 (estimated)").arg(text)));
    emit sizeTold();
}

void ExportDialog::tellProblem(const QString& problem) {
    m_problem->setText(problem);
    m_problem->setVisible(!problem.isEmpty());
    m_write->setEnabled(problem.isEmpty());
}

void ExportDialog::preparePicture() {
    const auto picture = m_shape->picture();
    if (!picture) return;
    const auto prepare = [picture] { return std::make_shared<const ScreenPicture>(picture); };
    inBackground(this, prepare, [this](const std::shared_ptr<const ScreenPicture>& prepared) {
        m_picture = prepared;
        startPreview();
    });
}

/// Soon; an answer that is under way is to another question.
void ExportDialog::askPreview() {
    m_previewStop.request_stop();
    m_preview->setOutdated();
    m_previewTimer.start();
}

void ExportDialog::startPreview() {
    const bool drawsNothing = m_shape->dimension() == 3 || (m_shape->picture() && !m_picture);
    if (drawsNothing) return;
    m_previewStop.request_stop();
    m_previewStop = std::stop_source();
    const bool dark = Theme::of(palette()).dark;
    const PreviewRequest request{m_kind,
                                 extension().toStdString(),
                                 runOptionsFrom(values()),
                                 m_preview->room(),
                                 devicePixelRatioF(),
                                 dark ? QColor(0x5b6070) : QColor(0xbfc6dd),
                                 QColor(24, 28, 44)};
    const std::stop_token stop = m_previewStop.get_token();
    const auto draw = [shape = m_shape, picture = m_picture, request, stop] {
        return answerOf<QImage>([&] { return exportPreview(*shape, picture, request, stop); });
    };
    inBackground(this, draw, [this, stop](const Answer<QImage>& answer) {
        if (stop.stop_requested()) return;
        if (!answer.problem.isEmpty()) tellProblem(answer.problem);
        m_preview->setProperty("bare", !isPicture());
        m_preview->setImage(answer.value);
    });
}

void ExportDialog::startSize() {
    m_sizeStop.request_stop();
    m_sizeStop = std::stop_source();
    const std::stop_token stop = m_sizeStop.get_token();
    const auto measure = [shape = m_shape, kind = m_kind, extension = extension().toStdString(),
                          options = runOptionsFrom(values()), stop] {
        return answerOf<FileSize>([&] { return shape->size(kind, extension, options, stop); });
    };
    inBackground(this, measure, [this, asked = m_asked](const Answer<FileSize>& answer) {
        if (asked != m_asked || answer.stopped) return;
        if (answer.problem.isEmpty()) return showSize(answer.value);
        tellProblem(answer.problem);
        emit sizeTold();
    });
}

void ExportDialog::resizeEvent(QResizeEvent* event) {
    QDialog::resizeEvent(event);
    askPreview();
}

}  // namespace wend
