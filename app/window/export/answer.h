#pragma once

#include <QString>

#include "app/base/said.h"
#include "core/base/error.h"

namespace wend {

/// The result of background work, or its error. (Futures would slice the exception.)
template <class Value>
struct Answer {
    Value value{};
    QString problem;
    bool stopped = false;
};

template <class Value, class Work>
Answer<Value> answerOf(const Work& work) {
    try {
        return {work(), {}, false};
    } catch (const Cancelled&) {
        return {{}, {}, true};
    } catch (const std::exception& error) {
        return {{}, said(error), false};
    }
}

}  // namespace wend
