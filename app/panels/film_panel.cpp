#include "app/panels/film_panel.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QSignalBlocker>
#include <algorithm>

#include "app/base/connect_each.h"
#include "app/base/preferences.h"
#include "app/panels/fields/controls.h"
#include "app/panels/fields/option_field.h"
#include "app/panels/fields/panel_parts.h"
#include "app/project/edits/setting_edits.h"
#include "app/project/options/settings.h"
#include "app/project/project.h"

namespace wend {

namespace {

constexpr double kShortest = 0.01;  // seconds of a cycle

}  // namespace

FilmPanel::FilmPanel(Document& document, QWidget* parent)
    : QWidget(parent),
      m_document(document),
      m_rate(new OptionField("time.frameRate", this)),
      m_cycles(checkBox(
          this, "", tr("Cycle"),
          tr("The part of the film that repeats, in seconds. A film that is exported as a loop shows it, "
             "and no picture twice."),
          [this] { changeCycle({}); })),
      m_from(new ExactBox(this)),
      m_to(new ExactBox(this)),
      m_cycle(new QWidget(this)),
      m_sound(secondLabel({}, this)),
      m_choose(pushButton(
          this, "", tr("Choose…"),
          tr("A file whose sound begins with the motion, and goes into MP4, WebM and QuickTime films."),
          &FilmPanel::chooseSound, tr("Choose sound"))),
      m_remove(pushButton(
          this, "", tr("Remove"), tr("The film has no sound then."), [this] { setSound({}); },
          tr("Remove sound"))) {
    makeCycle();
    m_sound->setObjectName(QStringLiteral("soundFile"));
    auto* column = sectionColumn(this);
    column->addWidget(panelTitle(tr("Film"), this));
    column->addLayout(panelRow(withoutKey(m_rate->label()), m_rate, this));
    column->addWidget(m_cycles);
    column->addWidget(m_cycle);
    column->addLayout(sideBySide({secondLabel(tr("Sound"), this), nullptr, m_choose, m_remove}));
    column->addWidget(m_sound);
    connect(m_rate, &OptionField::changed, this,
            [this] { changeSetting(m_document, "time.frameRate", m_rate->number()); });
    connectEach(this, &FilmPanel::showProject, &m_document, &Document::projectChanged, &m_document,
                &Document::opened);
    showProject();
}

void FilmPanel::makeCycle() {
    auto* row = bareRow(m_cycle, 6);
    for (const auto& [box, name] : {std::pair{m_from, tr("from")}, {m_to, tr("to")}}) {
        box->setDecimals(2);
        box->setSingleStep(0.1);
        box->setSuffix(tr(" s"));
        box->setKeyboardTracking(false);
        describe(box, name, m_cycles->toolTip());
        row->addWidget(secondLabel(name, m_cycle));
        row->addWidget(box, 1);
    }
    whenChanged(std::array{m_from, m_to}, this, [this] { changeCycle(QStringLiteral("cycle")); });
}

void FilmPanel::showProject() {
    setEnabled(!m_document.isEmpty());
    if (m_document.isEmpty()) return;
    const Project& project = *m_document.project();
    m_rate->setNumber(project.frameRate);
    const auto [from, to] = project.cycle.value_or(std::array{0.0, project.end});
    const QSignalBlocker quiet(m_cycles), alsoFrom(m_from), alsoTo(m_to);
    m_cycles->setChecked(project.cycle.has_value());
    m_cycle->setVisible(project.cycle.has_value());
    m_from->setRange(0, to - kShortest);
    m_to->setRange(from + kShortest, std::max(project.end, to));
    m_from->put(from);
    m_to->put(to);
    m_sound->setText(QFileInfo(QString::fromStdString(project.audio)).fileName());
    m_sound->setVisible(!project.audio.empty());
    m_remove->setVisible(!project.audio.empty());
}

/// Changes that have a name merge into one step.
void FilmPanel::changeCycle(const QString& name) {
    if (m_document.isEmpty()) return;
    Project next = *m_document.project();
    next.cycle.reset();
    if (m_cycles->isChecked()) next.cycle = {m_from->exact(), m_to->exact()};
    m_document.change(tr("Change cycle"), std::move(next), name);
}

void FilmPanel::setSound(const QString& path) {
    if (m_document.isEmpty()) return;
    Project next = *m_document.project();
    next.audio = path.toStdString();
    m_document.change(path.isEmpty() ? tr("Remove sound") : tr("Choose sound"), std::move(next), {});
}

void FilmPanel::chooseSound() {
    const QString path = QFileDialog::getOpenFileName(
        window(), tr("Choose Sound"), preferences::folder.value(),
        tr("Sound and films (*.wav *.mp3 *.ogg *.oga *.opus *.flac *.m4a *.aac *.mp4 *.mov *.webm *.mkv)"));
    if (path.isEmpty()) return;
    preferences::folder.set(QFileInfo(path).absolutePath());
    setSound(QFileInfo(path).absoluteFilePath());
}

}  // namespace wend
