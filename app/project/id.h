#pragma once

#include <atomic>

namespace wend {

/// Identifies a pin or a layer while a project is open: it is made with the object, kept by edits, undo and
/// copies, and not stored in files.
enum class Id : unsigned long long { None };

/// Returns an id that no other call in this process returns.
inline Id newId() {
    static std::atomic<unsigned long long> last = 0;
    return Id{++last};
}

}  // namespace wend
