#include "app/panels/surface_panel.h"

#include <QLabel>
#include <QPushButton>

#include "app/panels/panel_parts.h"

namespace wend {

SurfacePanel::SurfacePanel(QWidget* parent)
    : QWidget(parent),
      m_text(secondLabel({}, this)),
      m_show(new QPushButton(tr("Show them"), this)),
      m_save(new QPushButton(tr("Save list…"), this)),
      m_repair(new QPushButton(tr("Repair"), this)) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(16, 14, 16, 14);
    layout->setSpacing(10);
    layout->addWidget(panelTitle(tr("The surface bounds no solid"), this));
    layout->addWidget(m_text);
    auto* row = new QHBoxLayout;
    for (QPushButton* button : {m_show, m_save}) row->addWidget(button);
    layout->addLayout(row);
    layout->addWidget(m_repair);
    describe(m_show, tr("Show the triangles"),
             tr("Colours the triangles that are wrong, and looks at them."));
    describe(m_save, tr("Save the list"),
             tr("Writes the numbers of all wrong triangles and edges to a file."));
    describe(
        m_repair, tr("Repair"),
        tr("Merges points at one place, drops degenerate and double triangles, orients them and fills small "
           "holes."));
    connect(m_show, &QPushButton::clicked, this, &SurfacePanel::showRequested);
    connect(m_save, &QPushButton::clicked, this, &SurfacePanel::saveRequested);
    connect(m_repair, &QPushButton::clicked, this, &SurfacePanel::repairRequested);
}

void SurfacePanel::showProblems(const QStringList& problems, int triangles, bool mayRepair) {
    const QString repair =
        mayRepair ? tr("“Repair” can mend it.") : tr("“Repair” cannot mend it: another program has to.");
    m_text->setText(problems.join('\n') + QStringLiteral("\n\n") + repair);
    m_show->setEnabled(triangles > 0);
    m_repair->setEnabled(mayRepair);
    m_repair->setStatusTip(
        mayRepair ? m_repair->accessibleDescription()
                  : tr("The simple repairs do not help; another program has to mend the surface."));
}

}  // namespace wend
