#include "app/window/export/export_form.h"

#include <QAbstractSpinBox>
#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QVBoxLayout>
#include <cmath>

#include "app/base/in_background.h"
#include "app/engine/motion/playback.h"
#include "app/output/layer_export.h"
#include "app/output/run_options.h"
#include "app/output/shape_file.h"
#include "app/output/svg_export.h"
#include "app/panels/fields/controls.h"
#include "app/panels/fields/option_field.h"
#include "app/panels/fields/panel_parts.h"
#include "app/window/export/export_formats.h"
#include "core/base/error.h"
#include "warp/film_format.h"
#include "warp/image_formats.h"

namespace wend {

namespace {

constexpr int kFilmRole = Qt::UserRole + 1;  // of a format's entry: whether it is a film
constexpr int kLow = 140;                    // of a preview above its fields, where room is scarce

constexpr int kNumberWidth = 140;  // common width, since they are in one column

}  // namespace

ExportForm::ExportForm(Fields place, ExportChoices& choices, QWidget* parent)
    : QWidget(parent),
      m_choices(choices),
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
        m_choices.formats[kind()] = m_format->currentText();
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
    m_previewTimer.callOnTimeout(this, &ExportForm::startPreview);
}

void ExportForm::setSubject(const ExportSubject& subject) {
    const auto picture = m_subject.shape ? m_subject.shape->picture() : nullptr;
    const auto prepared = subject.shape->picture() == picture ? m_subject.picture : nullptr;
    m_subject = subject;
    if (!m_subject.picture) m_subject.picture = prepared;
    showFormats();
    showPart();
    takeChoices();
    const double rate = shape()->frameRate();
    if (m_choices.rate != rate) field("--fps")->setNumber(rate);
    if (m_choices.seconds != shape()->seconds() || m_choices.rate != rate) tieRate(*field("--fps"));
    m_choices.seconds = shape()->seconds();
    m_choices.rate = rate;
    adapt();
    if (!subject.solidView.isNull()) {
        m_preview->setProperty("bare", true);
        m_preview->setImage(subject.solidView);
    }
    if (shape()->picture() && !m_subject.picture) preparePicture();
}

/// Leaves fields with equal values alone, because one of them may be edited.
void ExportForm::takeChoices() {
    for (qsizetype k = 0; k < m_fields.size(); ++k) {
        OptionField& field = *m_fields[k];
        const auto known = m_choices.values.find(field.flag());
        const auto& [value, number] =
            known != m_choices.values.end() ? known->second : m_defaults[static_cast<std::size_t>(k)];
        const QSignalBlocker quiet(field);
        if (!field.choices().isEmpty() && field.value() != value) field.setValue(value);
        if (field.choices().isEmpty() && field.number() != number) field.setNumber(number);
    }
}

void ExportForm::keepChoices() {
    for (const OptionField* field : std::as_const(m_fields))
        m_choices.values[field->flag()] = {field->value(), field->number()};
}

/// Keeps the last preview unless it belongs to another document.
void ExportForm::setNothing(const QString& why) {
    m_previews.drop();
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

/// Offers a crop, and selects it if it is newly drawn.
void ExportForm::showPart() {
    OptionField* canvas = field("--canvas");
    if (m_subject.part != m_part) {
        m_part = m_subject.part;
        QStringList choices{QStringLiteral("picture"), QStringLiteral("fit")};
        if (m_part) choices << QString::fromStdString(textOf(*m_part));
        const QSignalBlocker quiet(canvas);
        canvas->setChoices(choices);
        if (m_part) canvas->setWords(choices.last(), tr("Cropped"));
    }
    if (m_choices.part == m_part) return;
    m_choices.part = m_part;
    if (m_part) m_choices.values[canvas->flag()] = {textOf(*m_part), canvas->choices().size() - 1.0};
}

/// Lists the formats of the kind and keeps the last choice.
void ExportForm::showFormats() {
    const QSignalBlocker quiet(m_format);
    const QString before = m_choices.formats[kind()];
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

/// Keeps the number of a film's frames and their rate consistent with its length, and the width of pictures
/// with their scale.
void ExportForm::tie(const OptionField& changed) {
    if (!shape()) return;
    if (&changed == field("--width")) tieWidth();
    if (&changed == field("--outside")) m_choices.wasTransparent = false;
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
    keepChoices();
    m_facts->setText(pixels());
    tellProblem(missingProgram());
    askPreview();
}

/// Hides options while there is nothing to export.
void ExportForm::showFields() {
    m_form->setRowVisible(m_format, m_format->count() > 0);
    for (OptionField* field : m_fields) m_form->setRowVisible(field, shape() && shows(field->flag()));
}

/// Returns whether the option is shown; the number of a film's frames is not, because it follows from length
/// and rate.
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

/// Selects white in the place of transparency if the format has none, and restores the choice later.
void ExportForm::showBackgrounds() {
    OptionField* background = field("--outside");
    const bool holds = holdsTransparency();
    background->allow(
        0, holds, tr("%1 has no transparency: pictures are placed on white.").arg(m_format->currentText()));
    const std::string from = holds ? "white" : "transparent", to = holds ? "transparent" : "white";
    if (background->value() != from || (holds && !m_choices.wasTransparent)) return;
    const QSignalBlocker quiet(background);
    background->setValue(to);
    m_choices.wasTransparent = !holds;
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
    m_previews.drop();
    m_preview->setOutdated();
    m_previewTimer.start();
}

void ExportForm::startPreview() {
    if (!shape() || (shape()->picture() && !m_subject.picture)) return;
    const bool dark = Theme::of(palette()).dark;
    const PreviewRequest request{kind(),
                                 extension().toStdString(),
                                 runOptionsFrom(values()),
                                 m_preview->room(),
                                 devicePixelRatioF(),
                                 dark ? QColor(0x5b6070) : QColor(0xbfc6dd),
                                 QColor(24, 28, 44)};
    const auto draw = [shape = m_subject.shape, picture = m_subject.picture,
                       request](const std::stop_token& stop) {
        return exportPreview(*shape, picture, request, stop);
    };
    m_previews.ask(draw, [this](const Answer<QImage>& answer) {
        if (!answer.problem.isEmpty()) tellProblem(answer.problem);
        m_preview->setProperty("bare", !isPicture());
        m_preview->setImage(answer.value);
    });
}

void ExportForm::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    if (shape()) askPreview();
}

// --- The widgets of the form and their layout ---

void ExportForm::makeFields() {
    for (const char* flag :
         {"--count", "--fps", "--loop", "--webp", "--depth", "--canvas", "--scale", "--width", "--outside",
          "--filter", "--fields", "--encoding", "--msh", "--border"}) {
        auto* field = new OptionField(flag, this);
        m_fields << field;
        connect(field, &OptionField::changed, this, [this, field] {
            tie(*field);
            adapt();
        });
    }
}

void ExportForm::makeCropNote(Fields place) {
    m_crop->setObjectName(QStringLiteral("cropNote"));
    const QString label = tr("Fit the Can&vas");
    QPushButton* fit = pushButton(
        this, "", place == Fields::Beside ? label : withoutKey(label),
        tr("Make the canvas as large as the shape needs, so that nothing is cut off."),
        [this] { field("--canvas")->setValue("fit"); }, tr("Fit the canvas"));
    fit->setAutoDefault(false);
    m_cropText->setWordWrap(true);
    m_cropText->setProperty("role", "warning");
    auto* line =
        new QBoxLayout(place == Fields::Beside ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom, m_crop);
    line->setContentsMargins(12, 8, 8, 8);
    line->addWidget(m_cropText, 1);
    line->addWidget(fit);
    m_crop->setAttribute(Qt::WA_StyledBackground);
    m_crop->hide();
}

/// Adds a row without a label for a check box, which shows its own.
void ExportForm::addRow(OptionField& field, bool hasKey) {
    if (field.option().kind == OptionKind::Flag) {
        field.sayLabel(hasKey);
        return m_form->addRow(&field);
    }
    m_form->addRow(hasKey ? field.label() : withoutKey(field.label()), &field);
}

/// Lays out the fields. Below the preview, long fields get a line of their own, and mnemonics are left to the
/// menus.
void ExportForm::lay(Fields place) {
    const bool beside = place == Fields::Beside;
    if (!beside) m_form->setHorizontalSpacing(4);
    m_form->setVerticalSpacing(beside ? 10 : 6);
    m_form->setRowWrapPolicy(beside ? QFormLayout::DontWrapRows : QFormLayout::WrapLongRows);
    m_form->setFieldGrowthPolicy(QFormLayout::ExpandingFieldsGrow);
    const QString format = tr("F&ormat");
    m_form->addRow(beside ? format : withoutKey(format), m_format);
    for (OptionField* field : m_fields) addRow(*field, beside);
    m_facts->setObjectName(QStringLiteral("facts"));
    m_facts->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_facts->setWordWrap(!beside);
    m_problem->setObjectName(QStringLiteral("problem"));
    m_problem->setProperty("role", "warning");
    m_problem->setWordWrap(true);
    m_problem->hide();
    auto* fields = new QVBoxLayout;
    fields->addLayout(m_form);
    fields->addStretch(1);
    auto* top = new QBoxLayout(beside ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
    top->setSpacing(beside ? 20 : 8);
    top->addWidget(m_preview, 1);
    if (!beside) top->addWidget(m_facts);
    top->addLayout(fields);
    auto* all = bareColumn(this, beside ? 12 : 8);
    all->addLayout(top, 1);
    if (beside) all->addWidget(m_facts);
    all->addWidget(m_crop);
    all->addWidget(m_problem);
    for (auto* number : findChildren<QAbstractSpinBox*>()) {
        number->setMinimumWidth(kNumberWidth);
        number->setKeyboardTracking(false);  // a size is made even once it is complete, not at every digit
    }
    for (QComboBox* box : findChildren<QComboBox*>()) {
        box->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
        if (beside) {
            box->setMinimumWidth(220);
        } else {
            box->setSizeAdjustPolicy(QComboBox::AdjustToContents);
        }
    }
}

}  // namespace wend
