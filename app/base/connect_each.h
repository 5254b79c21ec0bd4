#pragma once

#include <QObject>

namespace wend {

/// Connects several signals with one slot of `receiver`, a member function or a callable:
///
///     connectEach(this, &PinList::refresh, &document, &Document::opened, &playback, &Playback::timeChanged);
template <class Receiver, class Slot, class Sender, class Signal, class... More>
void connectEach(Receiver* receiver, const Slot& slot, Sender* sender, Signal signal, More... more) {
    QObject::connect(sender, signal, receiver, slot);
    if constexpr (sizeof...(more) > 0) connectEach(receiver, slot, more...);
}

}  // namespace wend
