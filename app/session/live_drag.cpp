#include "app/session/live_drag.h"

#include <algorithm>
#include <cmath>

#include "app/document/handle_edits.h"
#include "kernels/back_end_choice.h"

namespace wend {

namespace {

constexpr double kLongestPiece = 0.06;  // of the diagonal
constexpr double kMostPieces = 2;       // per sample: the pointer is more urgent than the path

}  // namespace

LiveDrag::LiveDrag(const BuiltShape& shape, std::vector<Handle<2>> handles)
    : m_shape(shape),
      m_diagonal(boundingBoxDiagonal<2>(shape.rest->points)),
      m_handles(std::move(handles)),
      m_flow(shape.rest, shape.material, m_handles, backEndFactory<2>(BackEndKind::Automatic)) {}

bool LiveDrag::fits(const BuiltShape& shape, const std::vector<Handle<2>>& handles) const {
    return shape.rest == m_shape.rest && shape.material == m_shape.material &&
           std::equal(handles.begin(), handles.end(), m_handles.begin(), m_handles.end(), samePlace);
}

void LiveDrag::begin(std::vector<int> dragged, const Points<2>& pose) {
    m_dragged = std::move(dragged);
    m_offset.setZero();
    m_flow.begin(pose);
}

LiveDrag::Step LiveDrag::follow(const Vec<2>& offset) {
    Step step;
    const Vec<2> way = offset - m_offset;
    const double pieces = std::clamp(std::ceil(way.norm() / (kLongestPiece * m_diagonal)), 1.0, kMostPieces);
    for (int i = 0; i < pieces && !step.stopped && way != Vec<2>::Zero(); ++i) {
        Motion<2> motion;
        motion.kind = Translate<2>{way / pieces};
        const DragFlow<2>::Led led = m_flow.lead(m_dragged, motion);
        m_offset += led.done * way / pieces;
        step.stopped = led.done < 1;
        step.message = led.problem;
    }
    if (!step.stopped) m_offset = offset;
    step.offset = m_offset;
    step.pinError = m_flow.constraintError();
    return step;
}

}  // namespace wend
