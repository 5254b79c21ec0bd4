#include "app/panels/region_panel.h"

#include "app/document/handle_edits.h"
#include "app/document/project.h"
#include "app/panels/panel_parts.h"
#include "app/panels/region_numbers.h"
#include "app/session/solid_places.h"

namespace wend {

RegionPanel::RegionPanel(ShapeSession& session, QWidget* parent)
    : QWidget(parent),
      m_session(session),
      m_numbers(new RegionNumbers(this)),
      m_count(secondLabel({}, this)) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(16, 14, 16, 14);
    layout->setSpacing(10);
    layout->addWidget(panelTitle(tr("Region"), this));
    layout->addWidget(m_numbers);
    layout->addWidget(m_count);
    m_count->setObjectName(QStringLiteral("regionCount"));
    connect(m_numbers, &RegionNumbers::changed, this, &RegionPanel::apply);
    connect(&m_session, &ShapeSession::pinsChanged, this, &RegionPanel::showHandle);
    connect(&m_session, &ShapeSession::frameChanged, this, &RegionPanel::takeFrame);
    showHandle();
}

const Region<3>* RegionPanel::region() const {
    const auto& selected = m_session.selection().handles();
    if (m_session.document().dimension() != 3 || selected.size() != 1) return nullptr;
    const auto& handles = m_session.document().design<3>().handles;
    if (selected.front() >= static_cast<int>(handles.size())) return nullptr;
    const auto* region = std::get_if<Region<3>>(&handles[selected.front()].at);
    return region && RegionNumbers::canShow(*region) ? region : nullptr;
}

/// One undo step for numbers that follow each other. What holds nothing is not taken.
void RegionPanel::apply(const Region<3>& next) {
    const auto frame = m_session.frame<3>();
    if (!region() || !frame || next == *region()) return;
    if (verticesIn(next, *frame->rest).empty()) {
        m_count->setText(tr("There is no vertex in this region: nothing was changed."));
        return;
    }
    const int handle = m_session.selection().handles().front();
    m_session.document().change(tr("Change region"),
                                withHandlePlace<3>(*m_session.document().project(), handle, next),
                                QStringLiteral("handle region %1").arg(handle));
}

/// Poses change nothing here.
void RegionPanel::takeFrame() {
    const auto frame = m_session.frame<3>();
    if (!frame || frame->shape != m_mesh || isHidden()) showHandle();
}

void RegionPanel::showHandle() {
    const Region<3>* now = region();
    const auto frame = m_session.frame<3>();
    m_mesh = frame ? frame->shape : nullptr;
    setVisible(now && frame);
    if (!now || !frame) return;
    m_numbers->showRegion(*now, frame->diagonal);
    m_count->setText(tr("%n vertices", nullptr, static_cast<int>(verticesIn(*now, *frame->rest).size())));
}

}  // namespace wend
