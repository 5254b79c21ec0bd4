#include "app/engine/motion/compute_thread.h"

#include "app/base/said.h"
#include "core/base/error.h"
#include "core/base/memory.h"
#include "core/meshing/volume_mesher.h"

namespace wend {

ComputeThread::ComputeThread(QObject* parent)
    : QObject(parent), m_thread([this](std::stop_token stop) { loop(std::move(stop)); }) {}

ComputeThread::~ComputeThread() {
    m_thread.request_stop();
    m_mailbox.close();
    m_thread.join();
}

void ComputeThread::loop(std::stop_token stop) {
    while (!stop.stop_requested()) {
        const bool idle = !m_engine || m_engine->isIdle();
        try {
            if (const auto request = m_mailbox.take(idle, stop))
                handle(*request);
            else if (!idle)
                m_engine->work(m_mailbox.interruption());
        } catch (const SurfaceError& error) {
            giveUp(error, ComputeFailure::Shapeless);
        } catch (const NotEnoughMemory& error) {
            giveUp(InputError({sentence("Core",
                                        "the shape needs about %1 of memory; %2 are free; fewer vertices "
                                        "need less"),
                               byteText(error.needed()), byteText(error.free())}),
                   ComputeFailure::Memory);
        } catch (const std::exception& error) {
            giveUp(error, ComputeFailure::Invalid);
        }
    }
}

void ComputeThread::giveUp(const std::exception& error, ComputeFailure failure) {
    if (m_engine) m_engine->giveUp();
    m_out.call([this, revision = m_revision, reason = said(error), failure] {
        emit failed(revision, reason, failure);
    });
}

void ComputeThread::handle(const Request& request) {
    if (const auto* shape = std::get_if<SetShape>(&request)) {
        m_revision = shape->inputs.revision;
        requireEngine(shape->inputs.dimension());
        m_engine->setShape(*shape);
    }
    if (!m_engine) return;
    if (const auto* begin = std::get_if<BeginDrag>(&request)) m_engine->beginDrag(*begin);
    if (const auto* to = std::get_if<DragTo>(&request)) m_engine->dragTo(*to);
    if (std::holds_alternative<EndDrag>(request)) m_engine->endDrag();
    if (std::holds_alternative<CancelWork>(request)) m_engine->giveUp();
    if (const auto* ask = std::get_if<AskField>(&request)) m_engine->askField(*ask);
}

void ComputeThread::requireEngine(int dimension) {
    if (m_engine && m_engine->dimension() == dimension) return;
    m_engine = ShapeEngine::make(dimension, sink());
}

ShapeEngine::Sink ComputeThread::sink() {
    ShapeEngine::Sink sink;
    sink.shapeReady = [this](int revision, std::shared_ptr<const void> shape, KeptFrames kept) {
        m_out.call(
            [this, revision, shape = std::move(shape), kept] { emit shapeReady(revision, shape, kept); });
    };
    sink.frameReady = [this](FramePtr frame) {
        m_out.call([this, frame = std::move(frame)] { emit frameReady(frame); });
    };
    sink.fieldReady = [this](int number, VelocityPtr field) {
        m_out.call([this, number, field = std::move(field)] { emit fieldReady(number, field); });
    };
    sink.progress = [this](double time, double end) {
        m_out.call([this, time, end] { emit progress(time, end); });
    };
    sink.within = [this](double time, double end) {
        m_out.call([this, time, end] { emit within(time, end); });
    };
    sink.finished = [this](double time, const Message& problem, const Message& remark) {
        m_out.call(
            [this, time, why = said(problem), note = said(remark)] { emit finished(time, why, note); });
    };
    return sink;
}

}  // namespace wend
