#include "app/view/shape_notices.h"

#include <algorithm>

#include "app/document/said.h"
#include "app/session/shape.h"

namespace wend {

namespace {

/// A remark as a sentence. One that begins with a file's path keeps its beginning: what a blank follows is a
/// word.
QString sentence(const QString& remark) {
    QString result = remark;
    const QString first = remark.section(' ', 0, 0);
    if (!first.isEmpty() && std::ranges::all_of(first, [](QChar c) { return c.isLower(); }))
        result[0] = result[0].toUpper();
    if (!result.endsWith('.')) result += '.';
    return result;
}

}  // namespace

ShapeNotices::ShapeNotices(ShapeSession& session, QObject* parent) : QObject(parent), m_session(session) {
    connect(&session, &ShapeSession::frameChanged, this, &ShapeNotices::follow);
    connect(&session.document(), &Document::opened, this, [this] {  // what was told goes with the document
        m_shape.reset();
        m_hasTold = false;
    });
}

void ShapeNotices::follow() {
    tell<2>();
    tell<3>();
}

template <int Dim>
void ShapeNotices::tell() {
    const auto frame = m_session.frame<Dim>();
    if (!frame || frame->shape == m_shape) return;
    m_shape = frame->shape;
    QStringList lines;
    for (const std::string& notice : frame->built->notices) lines << sentence(said(notice));
    if (frame->built->refineHelps)
        lines << tr("“Refine surface” in the panel “Mesh” lets the surface's triangles be split.");
    if (!lines.isEmpty() || m_hasTold) emit told(lines.join('\n'));
    m_hasTold = !lines.isEmpty();
}

}  // namespace wend
