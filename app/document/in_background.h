#pragma once

#include <QFutureWatcher>
#include <QtConcurrent>
#include <type_traits>
#include <utility>

namespace wend {

/// Works in a thread of the pool; `take` gets the result in the thread of `context`, unless that is gone by
/// then or the work threw. Call it there. (QFuture::then() of Qt 6.4 calls contexts that are gone.)
template <class Work, class Take>
auto inBackground(QObject* context, Work work, Take take) {
    using Result = std::invoke_result_t<Work>;
    auto* watcher = new QFutureWatcher<Result>(context);
    QObject::connect(watcher, &QFutureWatcherBase::finished, context, [watcher, take = std::move(take)] {
        watcher->deleteLater();
        if (watcher->future().isResultReadyAt(0)) take(watcher->result());
    });
    const QFuture<Result> future = QtConcurrent::run(std::move(work));
    watcher->setFuture(future);
    return future;
}

}  // namespace wend
