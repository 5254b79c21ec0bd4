#include "app/window/export/picture_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QFormLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSpinBox>
#include <algorithm>
#include <cmath>

#include "app/base/connect_each.h"
#include "app/panels/fields/option_field.h"
#include "app/panels/fields/panel_parts.h"
#include "app/panels/fields/reasons.h"
#include "app/project/file/named_files.h"
#include "app/project/project.h"
#include "app/window/export/dialogs.h"
#include "app/window/export/export_formats.h"
#include "app/window/export/export_preview.h"
#include "app/window/export/view_picture.h"
#include "warp/film_format.h"
#include "warp/image_formats.h"

namespace wend {

namespace {

constexpr int kLeastPixels = 16, kMostPixels = 20000;  // pixels; drawn in tiles
constexpr int kTyped = 9999999;                        // larger numbers can be typed and are then rejected

bool fits(const QSpinBox* box) {
    return box->value() >= kLeastPixels && box->value() <= kMostPixels;
}

}  // namespace

PictureDialog::PictureDialog(const QSize& proposal, bool hasLegend, QWidget* parent, Draw draw,
                             std::optional<FilmSubject> film)
    : QDialog(parent),
      m_proportions(proposal),
      m_width(new QSpinBox(this)),
      m_height(new QSpinBox(this)),
      m_tied(new QCheckBox(tr("&Proportions of the view"), this)),
      m_note(new QLabel(this)),
      m_buttons(dialogButtons(QDialogButtonBox::Cancel, this)),
      m_write(addExportButton(*m_buttons)),
      m_preview(new ExportPreview(this)),
      m_format(new QComboBox(this)),
      m_form(new QFormLayout),
      m_rate(new OptionField("--fps", this)),
      m_loop(new OptionField("--loop", this)),
      m_quality(new OptionField("--webp", this)),
      m_film(std::move(film)),
      m_facts(new QLabel(this)),
      m_draw(std::move(draw)),
      m_transparent(new QCheckBox(tr("&Transparent background"), this)),
      m_marks(new QCheckBox(tr("P&ins and axes"), this)),
      m_legend(new QCheckBox(tr("&Legend of the overlay"), this)) {
    setWindowTitle(m_film ? tr("Export Film") : tr("Export View"));
    if (m_film) m_rate->setNumber(m_film->project->frameRate);
    for (QSpinBox* box : {m_width, m_height}) {
        box->setRange(1, kTyped);
        box->setSuffix(tr(" px"));
    }
    m_width->setValue(proposal.width());
    m_height->setValue(proposal.height());
    m_transparent->setObjectName(QStringLiteral("transparent"));
    for (QCheckBox* box : {m_transparent, m_tied}) box->setChecked(true);
    m_legend->setEnabled(hasLegend);
    m_legend->setChecked(hasLegend);
    addFormats();
    describeControls();
    lay();
    connectControls();
    check();
}

void PictureDialog::addFormats() {
    if (m_film) {
        for (const FilmFormatFacts& format : filmFormats())
            m_format->addItem(QString::fromUtf8(format.name.data(), format.name.size()),
                              QString::fromUtf8(format.extension.data(), format.extension.size()));
        return;
    }
    for (const auto& [name, extension] : {std::pair{"PNG", ".png"},
                                          {"TIFF", ".tif"},
                                          {"OpenEXR", ".exr"},
                                          {"JPEG", ".jpg"},
                                          {"WebP", ".webp"}})
        m_format->addItem(QString::fromLatin1(name), QString::fromLatin1(extension));
}

void PictureDialog::describeControls() {
    describe(m_format, tr("Format"), tr("What kind of file is written."));
    describe(m_tied, tr("Proportions of the view"),
             tr("Width and height follow each other, so that the picture shows what the view shows."));
    describe(m_width, tr("Width"), tr("Width of the picture in pixels."));
    describe(m_height, tr("Height"),
             tr("Height of the picture in pixels; it decides how large the solid is."));
    describe(m_transparent, tr("Transparent background"), tr("Only the solid, without a background."));
    describe(m_marks, tr("Pins and axes"), tr("Pins, their paths and the axes, as large as in the window."));
    describe(m_legend, tr("Legend of the overlay"),
             m_legend->isEnabled() ? tr("The colours of the overlay and their values.")
                                   : tr("Show the colour overlay first: it has the legend."));
}

void PictureDialog::connectControls() {
    m_timer.setSingleShot(true);
    m_timer.setInterval(60);
    m_timer.callOnTimeout(this, &PictureDialog::showPreview);
    connectEach(
        this, [this] { tie(m_width); }, m_width, &QSpinBox::valueChanged, m_tied, &QCheckBox::toggled);
    connect(m_height, &QSpinBox::valueChanged, this, [this] { tie(m_height); });
    connectEach(this, &PictureDialog::check, m_format, &QComboBox::currentIndexChanged, m_transparent,
                &QCheckBox::toggled, m_marks, &QCheckBox::toggled, m_legend, &QCheckBox::toggled, m_rate,
                &OptionField::changed, m_loop, &OptionField::changed, m_quality, &OptionField::changed);
}

void PictureDialog::lay() {
    QFormLayout* form = m_form;
    form->setVerticalSpacing(10);
    form->addRow(tr("F&ormat"), m_format);
    for (OptionField* field : {m_rate, m_quality}) form->addRow(field->label(), field);
    m_loop->sayLabel();
    form->addRow(m_loop);
    form->addRow(tr("&Width"), m_width);
    form->addRow(tr("&Height"), m_height);
    for (QCheckBox* box : {m_tied, m_transparent, m_marks, m_legend}) form->addRow(box);
    for (QWidget* control : {static_cast<QWidget*>(m_format), static_cast<QWidget*>(m_width)})
        control->setMinimumWidth(180);
    m_note->setObjectName(QStringLiteral("sizeNote"));
    m_note->setProperty("role", "warning");
    m_note->setWordWrap(true);
    m_facts->setObjectName(QStringLiteral("facts"));
    auto* right = new QVBoxLayout;
    right->addLayout(form);
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
    all->addWidget(m_note);
    all->addWidget(m_buttons);
}

/// Adjusts the other side if the proportions are kept.
void PictureDialog::tie(QSpinBox* changed) {
    const bool width = changed == m_width;
    const double of = width ? m_proportions.width() : m_proportions.height();
    const double other = width ? m_proportions.height() : m_proportions.width();
    if (m_tied->isChecked() && of > 0) {
        QSpinBox* follower = width ? m_height : m_width;
        const QSignalBlocker quiet(follower);
        follower->setValue(static_cast<int>(std::lround(changed->value() * other / of)));
    }
    check();
}

void PictureDialog::check() {
    const QString why = problem();
    const bool good = why.isEmpty();
    m_note->setText(why);
    m_note->setVisible(!good);
    m_write->setEnabled(good);
    const FilmFormatFacts* film = filmFormat();
    showTransparency(film ? film->alpha : holdsAlpha("view" + extension().toStdString()));
    for (OptionField* field : {m_rate, m_loop}) m_form->setRowVisible(field, film != nullptr);
    m_form->setRowVisible(m_quality, extension() == QStringLiteral(".webp"));
    m_facts->setText(pixels());
    if (good && m_draw) m_timer.start();
}

/// Clears the box for formats without transparency, and restores it later.
void PictureDialog::showTransparency(bool isHeld) {
    if (m_transparent->isEnabled()) m_wantsTransparent = m_transparent->isChecked();
    const QSignalBlocker quiet(m_transparent);
    m_transparent->setChecked(isHeld && m_wantsTransparent);
    allow(m_transparent, isHeld,
          tr("%1 has no transparency: the background is that of the view.").arg(m_format->currentText()));
}

QString PictureDialog::extension() const {
    return m_format->currentData().toString();
}

QString PictureDialog::filter() const {
    return QStringLiteral("%1 (*%2)").arg(m_format->currentText(), extension());
}

const FilmFormatFacts* PictureDialog::filmFormat() const {
    return m_film ? filmFormatOf("view" + extension().toStdString()) : nullptr;
}

/// Returns why it cannot be written; empty if it can be.
QString PictureDialog::problem() const {
    const QLocale locale;
    if (!fits(m_width) || !fits(m_height))
        return tr("Width and height must be between %1 and %2 pixels.")
            .arg(locale.toString(kLeastPixels), locale.toString(kMostPixels));
    return m_film ? missingFilmProgram(extension()) : QString();
}

PictureChoice PictureDialog::choice() const {
    PictureChoice choice;
    choice.size = {m_width->value(), m_height->value()};
    choice.transparent = m_transparent->isChecked() && m_transparent->isEnabled();
    choice.marks = m_marks->isChecked();
    choice.legend = m_legend->isChecked();
    choice.lossy = m_quality->value() == "lossy" && extension() == QStringLiteral(".webp");
    if (!m_film) return choice;
    if (filmFormat()->even)
        choice.size = {(choice.size.width() + 1) / 2 * 2, (choice.size.height() + 1) / 2 * 2};
    choice.framesPerSecond = m_rate->number();
    choice.loop = m_loop->number() != 0;
    RunOutputs outputs;
    outputs.loop = choice.loop;
    choice.span = frameSpan(*m_film->project, m_film->end, outputs);
    choice.frames = frameCount(*choice.span, choice.framesPerSecond, choice.loop);
    if (!m_film->project->audio.empty())
        choice.sound = {pathIn(m_film->folder, m_film->project->audio), choice.span->from};
    return choice;
}

PictureSettings PictureDialog::settings() const {
    PictureSettings settings{m_format->currentText(), choice(), m_tied->isChecked()};
    settings.choice->size = {m_width->value(), m_height->value()};
    settings.choice->transparent =
        m_transparent->isEnabled() ? m_transparent->isChecked() : m_wantsTransparent;
    settings.choice->lossy = m_quality->value() == "lossy";
    return settings;
}

void PictureDialog::set(const PictureSettings& settings) {
    if (settings.choice) {
        const PictureChoice& choice = *settings.choice;
        m_tied->setChecked(settings.tied);
        m_width->setValue(choice.size.width());
        if (!settings.tied) m_height->setValue(choice.size.height());
        m_wantsTransparent = choice.transparent;
        m_transparent->setChecked(m_transparent->isEnabled() && choice.transparent);
        m_marks->setChecked(choice.marks);
        if (m_legend->isEnabled()) m_legend->setChecked(choice.legend);
        m_quality->setValue(choice.lossy ? "lossy" : "lossless");
        if (m_film) m_rate->setNumber(choice.framesPerSecond);
        m_loop->setNumber(choice.loop ? 1 : 0);
    }
    m_format->setCurrentIndex(std::max(0, m_format->findText(settings.format)));
    check();
}

QString PictureDialog::pixels() const {
    const QLocale locale;
    const QSize size = choice().size;
    const QString one =
        tr("%1 × %2 pixels").arg(locale.toString(size.width()), locale.toString(size.height()));
    const int frames = choice().frames;
    if (frames == 0) return one;
    return QCoreApplication::translate("wend::ExportForm", "%n pictures of %1", nullptr, frames).arg(one);
}

void PictureDialog::showPreview() {
    PictureChoice small = choice();
    if (small.size.width() > m_preview->room().width() || small.size.height() > m_preview->room().height())
        small.size = small.size.scaled(m_preview->room(), Qt::KeepAspectRatio).expandedTo({1, 1});
    QImage image = m_draw(small);
    if (image.isNull()) return;
    image.setDevicePixelRatio(devicePixelRatioF());
    m_preview->setImage(image);
}

void PictureDialog::resizeEvent(QResizeEvent* event) {
    QDialog::resizeEvent(event);
    if (m_draw) m_timer.start();
}

}  // namespace wend
