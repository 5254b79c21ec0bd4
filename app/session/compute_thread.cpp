#include "app/session/compute_thread.h"

#include <QElapsedTimer>
#include <algorithm>

#include "app/document/handle_edits.h"

namespace wend {

ComputeThread::ComputeThread(QObject* parent)
    : QObject(parent), m_thread([this](std::stop_token stop) { loop(std::move(stop)); }) {}

ComputeThread::~ComputeThread() {
    m_thread.request_stop();
    m_mailbox.interrupt();
    m_thread.join();
}

void ComputeThread::loop(std::stop_token stop) {
    while (!stop.stop_requested()) {
        const bool idle = !m_pass.isSet() || m_pass.isFinished() || m_dragging;
        try {
            if (const auto request = m_mailbox.take(idle, stop))
                handle(*request, stop);
            else if (!idle)
                runPass(m_mailbox.interruption());
        } catch (const std::exception& error) {
            m_pass.clear();
            m_live.reset();
            m_dragging = false;
            emit failed(QString::fromUtf8(error.what()));
        }
    }
}

void ComputeThread::handle(const Request& request, std::stop_token stop) {
    if (const auto* shape = std::get_if<SetShape>(&request)) setShape(*shape);
    if (const auto* begin = std::get_if<BeginDrag>(&request)) beginDrag(*begin, stop);
    if (const auto* to = std::get_if<DragTo>(&request)) dragTo(*to);
    if (const auto* end = std::get_if<EndDrag>(&request)) endDrag(*end);
}

void ComputeThread::setShape(const SetShape& request) {
    const BuiltShape shape = m_builder.build(request.inputs, m_mailbox.interruption());
    if (!shape.rest) return;  // a newer request waits
    const double end = motionEnd(*request.inputs.project);
    if (m_preview && (shape.rest != m_shape.rest || end != m_preview->end)) m_preview.reset();
    m_shape = shape;
    m_project = request.inputs.project;
    const double kept = m_pass.set(m_shape, m_project);
    emit shapeReady(request.inputs.revision, m_shape.rest, kept);
    if (m_pass.isFinished()) emitFinished();
}

void ComputeThread::beginDrag(const BeginDrag& request, std::stop_token stop) {
    if (!m_pass.isSet()) return;
    if (!m_preview && !m_pass.isFinished()) runPass(stop);
    if (!m_preview && !m_pass.isFinished()) return;
    const std::vector<int> active = activeHandles();
    std::vector<int> dragged;
    for (std::size_t i = 0; i < active.size(); ++i)
        if (std::count(request.handles.begin(), request.handles.end(), active[i]))
            dragged.push_back(static_cast<int>(i));
    prepareDrag();
    m_live->begin(std::move(dragged), m_preview ? m_preview->pose : m_pass.state().points);
    m_dragging = true;
}

std::vector<int> ComputeThread::activeHandles() const {
    const auto& handles = std::get<Design<2>>(m_project->design).handles;
    std::vector<int> active;
    for (int h = 0; h < static_cast<int>(handles.size()); ++h)
        if (isActive(handles[h], motionEnd(*m_project))) active.push_back(h);
    return active;
}

void ComputeThread::prepareDrag() {
    std::vector<Handle<2>> handles;
    for (const int h : activeHandles()) handles.push_back(std::get<Design<2>>(m_project->design).handles[h]);
    if (!m_live || !m_live->fits(m_shape, handles)) m_live.emplace(m_shape, std::move(handles));
}

void ComputeThread::dragTo(const DragTo& request) {
    if (!m_dragging) return;
    QElapsedTimer clock;
    clock.start();
    const LiveDrag::Step step = m_live->follow(request.offsets.back());
    const auto frame = makeFrame(m_pass.end(), m_live->pose(), step.pinError);
    frame->live = true;
    frame->sample = request.lastSample;
    frame->offset = step.offset;
    frame->stopped = step.stopped;
    frame->message = step.message;
    frame->milliseconds = static_cast<double>(clock.nsecsElapsed()) * 1e-6;
    emit frameReady(frame);
}

void ComputeThread::endDrag(const EndDrag& request) {
    if (m_dragging && request.keep) m_preview = Preview{m_live->pose(), m_pass.end() + 1};
    m_dragging = false;
}

void ComputeThread::runPass(std::stop_token stop) {
    MotionPass::Sink sink;
    QElapsedTimer clock;
    clock.start();
    sink.onFrame = [&](const State<2>& state, double pinError) {
        const auto frame = makeFrame(state.time, state.points, pinError);
        frame->milliseconds = static_cast<double>(clock.nsecsElapsed()) * 1e-6;
        clock.restart();
        emit frameReady(frame);
    };
    sink.progress = [this](double time, double end) { emit progress(time, end); };
    m_pass.run(sink, stop);
    if (!m_pass.isFinished()) return;
    m_preview.reset();
    emitFinished();
    prepareDrag();
}

void ComputeThread::emitFinished() {
    emit finished(m_pass.state().time, QString::fromStdString(m_pass.result().message));
}

std::shared_ptr<ShapeFrame> ComputeThread::makeFrame(double time, const Points<2>& pose,
                                                     double pinError) const {
    auto frame = std::make_shared<ShapeFrame>();
    frame->time = time;
    frame->rest = m_shape.rest;
    frame->pose = pose;
    frame->distortion = distortion<2>(*m_shape.rest, pose);
    frame->pinError = pinError;
    return frame;
}

}  // namespace wend
