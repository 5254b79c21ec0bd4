#include "app/window/export/export_form.h"

#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <cmath>

#include "app/base/in_background.h"
#include "app/engine/motion/playback.h"
#include "app/output/layer_export.h"
#include "app/output/run_options.h"
#include "app/output/shape_file.h"
#include "app/output/svg_export.h"
#include "app/panels/fields/option_field.h"
#include "app/panels/fields/panel_parts.h"
#include "app/window/export/answer.h"
#include "app/window/export/export_formats.h"
#include "core/base/error.h"
#include "warp/film_format.h"
#include "warp/image_formats.h"

namespace wend {

namespace {

constexpr int kFilmRole = Qt::UserRole + 1;  // of a format's entry: whether it is a film
constexpr int kLow = 140;                    // of a preview above its fields, where room is scarce

}  // namespace

ExportForm::ExportForm(Fields place, QWidget* parent)
    : QWidget(parent),
      m_preview(place == Fields::Beside ? new ExportPreview(this)
                                        : new ExportPreview(this, {0, kLow}, {0, kLow})),
      m_format(new QComboBox(this)),
      m_form(new QFormLayout),
      m_facts(new QLabel(this)),
      m_cropText(new QLabel(this)),
      m_problem(new QLabel(this)),
      m_crop(new QWidget(this)) {
    m_format->setObjectName(QStringLiteral("format"));
    describe(m_format, tr("Format"), tr("What kind of file is written."));
    connect(m_format, &QComboBox::currentIndexChanged, this, [this] {
        m_formats[kind()] = m_format->currentText();
        adapt();
    });
    makeFields();
    for (const OptionField* field : std::as_const(m_fields))
        m_defaults.emplace_back(field->value(), field->number());
    makeCropNote(place);
    lay(place);
    showFields();
    m_previewTimer.setSingleShot(true);
    m_previewTimer.setInterval(40);
    connect(&m_previewTimer, &QTimer::timeout, this, &ExportForm::startPreview);
}

ExportForm::~ExportForm() {
    m_previewStop.request_stop();
}

void ExportForm::setSubject(const ExportSubject& subject) {
    const auto picture = m_subject.shape ? m_subject.shape->picture() : nullptr;
    const auto prepared = subject.shape->picture() == picture ? m_subject.picture : nullptr;
    m_subject = subject;
    if (!m_subject.picture) m_subject.picture = prepared;
    showFormats();
    showPart();
    const double rate = shape()->frameRate();
    if (m_rate != rate) field("--fps")->setNumber(rate);
    if (m_seconds != shape()->seconds() || m_rate != rate) tieRate(*field("--fps"));
    m_seconds = shape()->seconds();
    m_rate = rate;
    adapt();
    if (!subject.solidView.isNull()) {
        m_preview->setProperty("bare", true);
        m_preview->setImage(subject.solidView);
    }
    if (shape()->picture() && !m_subject.picture) preparePicture();
}

void ExportForm::reset() {
    for (qsizetype k = 0; k < m_fields.size(); ++k) {
        OptionField& field = *m_fields[k];
        const auto& [value, number] = m_defaults[static_cast<std::size_t>(k)];
        const QSignalBlocker quiet(field);
        if (!field.choices().isEmpty() && field.value() != value) field.setValue(value);
        if (field.choices().isEmpty() && field.number() != number) field.setNumber(number);
    }
    m_part.reset();
    m_wasTransparent = false;
    m_seconds = m_rate = 0;
}

/// Keeps the last preview unless it belongs to another document.
void ExportForm::setNothing(const QString& why) {
    m_previewStop.request_stop();
    m_previewTimer.stop();
    m_subject.shape.reset();
    m_preview->setOutdated();
    m_facts->clear();
    m_crop->hide();
    tellProblem(why);
}

bool ExportForm::isReady() const {
    return shape() && m_problem->text().isEmpty();
}

/// A newly drawn crop becomes the choice; a removed one is no longer offered.
void ExportForm::showPart() {
    if (m_subject.part == m_part) return;
    m_part = m_subject.part;
    QStringList choices{QStringLiteral("picture"), QStringLiteral("fit")};
    if (m_part) choices << QString::fromStdString(textOf(*m_part));
    OptionField* canvas = field("--canvas");
    const QSignalBlocker quiet(canvas);
    canvas->setChoices(choices);
    if (!m_part) return;
    canvas->setWords(choices.last(), tr("Cropped"));
    canvas->setValue(choices.last().toStdString());
}

/// Lists the formats of the kind and keeps the last choice.
void ExportForm::showFormats() {
    const QSignalBlocker quiet(m_format);
    const QString before = m_formats[kind()];
    m_format->clear();
    for (const ExportFormat& format : exportFormats(kind(), *shape())) {
        m_format->addItem(format.name, format.extension);
        m_format->setItemData(m_format->count() - 1, format.film, kFilmRole);
    }
    m_format->setCurrentIndex(std::max(0, m_format->findText(before)));
}

QString ExportForm::extension() const {
    return m_format->currentData().toString();
}

QString ExportForm::filter() const {
    return QStringLiteral("%1 (*%2)").arg(m_format->currentText(), extension());
}

bool ExportForm::isFilm() const {
    return m_format->currentData(kFilmRole).toBool();
}

bool ExportForm::isPicture() const {
    const std::string file = "picture" + extension().toStdString();
    return kind() == ExportKind::Film || canWriteImage(file) || isLayeredFile(file) || isSvgFile(file);
}

OptionField* ExportForm::field(const char* flag) const {
    for (OptionField* field : m_fields)
        if (field->flag() == flag) return field;
    return nullptr;
}

/// Returns whether the option applies to the current export.
bool ExportForm::takes(const std::string& flag) const {
    const std::string file = "mesh" + extension().toStdString();
    if (flag == "--count" || flag == "--fps" || flag == "--loop") return isMotion(kind());
    if (flag == "--canvas" || flag == "--scale") return isPicture();
    if (flag == "--width") return false;  // it follows from the scale
    if (flag == "--webp") return extension() == QStringLiteral(".webp");
    if (isLayeredFile(file) && flag == "--outside") return false;
    if (flag == "--depth" && !canWriteImage(file) && !holdsType(file, PixelType::UInt8)) return false;
    if (isSvgFile(file) && (flag == "--depth" || flag == "--outside" || flag == "--filter")) return false;
    if (flag == "--depth" && isFilm()) return false;
    if (flag == "--depth" || flag == "--outside" || flag == "--filter")
        return isPicture() && kind() != ExportKind::StMap;
    if (isPicture()) return false;
    if (flag == "--border") return shape()->dimension() == 3 && carriesValues(file);
    if (flag == "--fields") return carriesValues(file);
    return flag == "--encoding" ? knowsEncodings(file) : file.ends_with(".msh");
}

OptionValues ExportForm::values() const {
    OptionValues values;
    for (const OptionField* field : m_fields)
        if (takes(field->flag()) && !field->value().empty()) values.set(field->flag(), field->value());
    return values;
}

/// The film lasts as long as the motion: number and rate of its frames follow each other. So do the width and
/// the scale of pictures.
void ExportForm::tie(const OptionField& changed) {
    if (!shape()) return;
    if (&changed == field("--width")) tieWidth();
    if (&changed == field("--outside")) m_wasTransparent = false;
    tieRate(changed);
}

void ExportForm::tieRate(const OptionField& changed) {
    OptionField *count = field("--count"), *rate = field("--fps");
    const bool loop = field("--loop")->number() != 0;
    const FrameSpan span = shape()->span(loop);
    const double seconds = span.to - span.from;
    if (seconds <= 0) return;
    if (&changed == rate || &changed == field("--loop"))
        count->setNumber(frameCount(span, rate->number(), loop));
    if (&changed == count) rate->setNumber((count->number() - (loop ? 0 : 1)) / seconds);
}

void ExportForm::tieWidth() {
    const RunOptions options = runOptionsFrom(values());
    CanvasChoice canvas = options.canvas;
    canvas.scale = 1;
    const double own = shape()->view(kind(), canvas, options.outputs.loop).width;
    field("--scale")->setNumber(100 * field("--width")->number() / own);
}

/// Shows the width that follows from the scale.
void ExportForm::showWidth() {
    if (!isPicture()) return;
    try {
        const RunOptions options = runOptionsFrom(values());
        field("--width")->setNumber(shape()->view(kind(), options.canvas, options.outputs.loop).width);
    } catch (const InputError&) {  // the preview shows the reason
    }
}

/// Shows the options of the format.
void ExportForm::adapt() {
    if (!shape()) return;
    showFields();
    if (takes("--depth")) showDepths();
    if (takes("--outside")) showBackgrounds();
    showCrop();
    showWidth();
    m_facts->setText(pixels());
    tellProblem(missingProgram());
    askPreview();
}

/// Hides options while there is nothing to export.
void ExportForm::showFields() {
    m_form->setRowVisible(m_format, m_format->count() > 0);
    for (OptionField* field : m_fields) m_form->setRowVisible(field, shape() && shows(field->flag()));
}

/// The number of a film's frames follows from its length and rate.
bool ExportForm::shows(const std::string& flag) const {
    if (flag == "--count") return kind() == ExportKind::Frames;
    return takes(flag == "--width" ? "--scale" : flag);
}

QString ExportForm::missingProgram() const {
    return kind() == ExportKind::Film ? missingFilmProgram(extension()) : QString();
}

void ExportForm::showDepths() {
    static const std::pair<const char*, PixelType> types[] = {{"8", PixelType::UInt8},
                                                              {"16", PixelType::UInt16},
                                                              {"half", PixelType::Half},
                                                              {"float", PixelType::Float}};
    const std::string file = "picture" + extension().toStdString();
    QStringList choices;
    QString own;
    for (const auto& [name, type] : types) {
        if (holdsType(file, type)) choices << QString::fromLatin1(name);
        if (shape()->picture() && shape()->picture()->type == type) own = QString::fromLatin1(name);
    }
    OptionField* depth = field("--depth");
    const bool kept = choices.contains(own);
    depth->setChoices(QStringList(QStringLiteral("picture")) + choices);
    depth->setWords(QStringLiteral("picture"),
                    kept ? tr("As in the picture") : tr("As it suits the format best"));
}

bool ExportForm::holdsTransparency() const {
    const std::string file = "picture" + extension().toStdString();
    return kind() == ExportKind::Film ? filmFormatOf(file)->alpha : holdsAlpha(file);
}

/// Where a format has no transparency, the white that such pictures are placed on is what is shown and
/// chosen.
void ExportForm::showBackgrounds() {
    OptionField* background = field("--outside");
    const bool holds = holdsTransparency();
    background->allow(
        0, holds, tr("%1 has no transparency: pictures are placed on white.").arg(m_format->currentText()));
    const std::string from = holds ? "white" : "transparent", to = holds ? "transparent" : "white";
    if (background->value() != from || (holds && !m_wasTransparent)) return;
    const QSignalBlocker quiet(background);
    background->setValue(to);
    m_wasTransparent = !holds;
}

void ExportForm::showCrop() {
    const bool cuts = isPicture() && field("--canvas")->value() == "picture";
    const Overhang over =
        cuts ? shape()->overhang(kind(), runOptionsFrom(values()).outputs.loop) : Overhang{};
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
        isMotion(kind())
            ? tr("As it moves, the shape leaves the picture and is cut off there: %1.").arg(where)
            : tr("The shape reaches beyond the picture and is cut off there: %1.").arg(where));
    m_crop->setVisible(over.any());
}

QString ExportForm::pixels() const {
    const QLocale locale;
    const auto count = static_cast<int>(isMotion(kind()) ? field("--count")->number() : 1);
    if (!isPicture()) {
        const int vertices = shape()->vertexCount(extension().toStdString());
        const QString one = tr("%1 vertices").arg(locale.toString(vertices));
        return kind() == ExportKind::Frames ? tr("%n shapes of %1", nullptr, count).arg(one) : one;
    }
    try {
        const RunOptions options = runOptionsFrom(values());
        const View view = shape()->view(kind(), options.canvas, options.outputs.loop);
        const QString one =
            tr("%1 × %2 pixels").arg(locale.toString(view.width), locale.toString(view.height));
        return isMotion(kind()) ? tr("%n pictures of %1", nullptr, count).arg(one) : one;
    } catch (const InputError&) {
        return {};  // the preview shows the reason
    }
}

void ExportForm::tellProblem(const QString& problem) {
    m_problem->setText(problem);
    m_problem->setVisible(!problem.isEmpty());
    emit readyChanged(isReady());
}

void ExportForm::preparePicture() {
    const auto picture = shape()->picture();
    const auto prepare = [picture] { return std::make_shared<const ScreenPicture>(picture); };
    inBackground(this, prepare, [this, picture](const std::shared_ptr<const ScreenPicture>& prepared) {
        if (!shape() || shape()->picture() != picture) return;
        m_subject.picture = prepared;
        startPreview();
    });
}

/// Starts a preview soon and cancels pending ones. The picture of a solid came with the subject.
void ExportForm::askPreview() {
    if (shape()->dimension() == 3) return;
    m_previewStop.request_stop();
    m_preview->setOutdated();
    m_previewTimer.start();
}

void ExportForm::startPreview() {
    if (!shape() || (shape()->picture() && !m_subject.picture)) return;
    m_previewStop.request_stop();
    m_previewStop = std::stop_source();
    const bool dark = Theme::of(palette()).dark;
    const PreviewRequest request{kind(),
                                 extension().toStdString(),
                                 runOptionsFrom(values()),
                                 m_preview->room(),
                                 devicePixelRatioF(),
                                 dark ? QColor(0x5b6070) : QColor(0xbfc6dd),
                                 QColor(24, 28, 44)};
    const std::stop_token stop = m_previewStop.get_token();
    const auto draw = [shape = m_subject.shape, picture = m_subject.picture, request, stop] {
        return answerOf<QImage>([&] { return exportPreview(*shape, picture, request, stop); });
    };
    inBackground(this, draw, [this, stop](const Answer<QImage>& answer) {
        if (stop.stop_requested()) return;
        if (!answer.problem.isEmpty()) tellProblem(answer.problem);
        m_preview->setProperty("bare", !isPicture());
        m_preview->setImage(answer.value);
    });
}

void ExportForm::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    if (shape()) askPreview();
}

}  // namespace wend
