#include "app/session/comparison.h"

#include "app/project/edits/material_edits.h"
#include "app/project/options/options.h"

namespace wend {

Comparison::Comparison(ShapeSession& session, QObject* parent) : QObject(parent), m_session(session) {
    m_other.document().undoStack()->setUndoLimit(1);
    connect(&m_session.document(), &Document::opened, this, [this] {
        end();
        m_generation = -1;
        m_other.document().close();
    });
    connect(&m_session.document(), &Document::projectChanged, this, &Comparison::take);
    connect(&m_session.playback(), &Playback::timeChanged, &m_other.playback(), &Playback::setTime);
    connect(&m_session.selection(), &Selection::changed, this, &Comparison::takeSelection);
    connect(&m_session, &ShapeSession::dragBegan, this, [this] {
        if (!m_on) return;
        m_other.selection().set(m_session.gesture()->handles());
        m_other.beginDrag(m_session.gesture()->grip());
    });
    connect(&m_session, &ShapeSession::dragMoved, &m_other,
            [this](const Amount& amount) { m_other.dragBy(amount); });
    connect(&m_session, &ShapeSession::dragEnded, &m_other, &ShapeSession::letGo);
    connect(&m_session, &ShapeSession::dragCancelled, &m_other, &ShapeSession::cancelDrag);
}

void Comparison::begin(std::optional<double> phi) {
    if (m_session.document().isEmpty()) return;
    m_phi = phi;
    m_on = true;
    take();
    emit changed();
}

void Comparison::end() {
    if (std::exchange(m_on, false)) emit changed();
}

FramePtr Comparison::frame() const {
    return m_on && !m_other.isStale() && !m_other.isMeshing() ? m_other.frame() : FramePtr();
}

std::shared_ptr<const Project> Comparison::wanted() const {
    const auto project = copyOf(*m_session.document().project());
    if (m_phi)
        option("material.phi").field.at.set(*project, *m_phi);
    else
        designOf(*project) = withoutCells(withAllHidden(designOf(*project)));
    return project;
}

void Comparison::take() {
    if (!m_on) return;
    const Document& document = m_session.document();
    if (std::exchange(m_generation, document.generation()) == document.generation()) {
        m_other.document().change({}, wanted());
    } else {
        OpenedFile file;
        file.project = wanted();
        file.picture = document.picture();
        file.path = document.path();
        file.source = document.source();
        m_other.document().open(std::move(file));
    }
    m_other.playback().setTime(m_session.playback().time());
    takeSelection();
}

/// Copies the selection, which decides whose influence a map shows.
void Comparison::takeSelection() {
    if (m_on) m_other.selection().set(m_session.selection().handles());
}

}  // namespace wend
