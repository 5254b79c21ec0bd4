#pragma once

#include <compare>
#include <memory>
#include <vector>

#include "app/project/edits/grip.h"
#include "app/project/edits/timing_edits.h"

namespace wend {

/// Edits of key poses, which are the ends of a handle's motions: pure functions to the next design or
/// project. What they do not touch keeps its bits. Motions that do not only translate keep their kind: where
/// an edit would change their path, it leaves them.

/// A key pose: a handle, and a time at which one of its motions begins or ends.
struct KeyId {
    int handle = -1;
    double time = 0;
    auto operator<=>(const KeyId&) const = default;
};
/// Returns the times of a handle's key poses, increasing.
std::vector<double> keyTimes(const Design& design, int handle);

/// Returns the possible shift in time nearest to the wanted one: every key stays between those of its handle
/// that do not move along, and within the time that the handle holds.
double fittedShift(const Design& design, const std::vector<KeyId>& keys, double wanted);
/// Moves keys in time, as far as possible. Motions on either side become longer or shorter. If a key is moved
/// beyond the end of the film, the film becomes longer.
std::shared_ptr<const Project> withKeysMoved(const Project& project, const std::vector<KeyId>& keys,
                                             double by);

/// Removes key poses. The handle then moves in a straight line from the previous key to the next one; one
/// that rotates or grows on either side does so all the way. If there is no next key, it stays at the
/// previous one; if there is no previous key, it starts from its rest place.
Design withoutKeys(const Design& design, std::vector<KeyId> keys);

/// Holds the handle from each key to the next one, and leads it from there to the one after that.
Design withKeysHeld(const Design& design, std::vector<KeyId> keys);

/// Says whether a handle slows down before a key, and starts slowly after it.
struct KeyEase {
    bool before = false, after = false;
    bool operator==(const KeyEase&) const = default;
};
KeyEase easeAt(const Design& design, const KeyId& key);
Design withKeyEase(const Design& design, const std::vector<KeyId>& keys, const KeyEase& ease);

/// A key pose to be set elsewhere: how long it is after the first one that was copied, and how far its handle
/// is from its place at the beginning.
struct CopiedKey {
    int handle = -1;
    double after = 0;
    Amount offset = Amount::Zero();
    KeyEase ease = {};
};
/// Returns keys in the order of time. `starts` are the places of all handles at their beginning.
std::vector<CopiedKey> copiedKeys(const Design& design, const std::vector<KeyId>& keys,
                                  const std::vector<Vec3>& starts);
/// Sets copied poses, the first one at a time. Motions around them are led through them as by withPose(); the
/// film becomes longer if necessary. `pasted` gets the keys that there are now; poses that cannot be set are
/// none of them.
std::shared_ptr<const Project> withKeysPasted(const Project& project, const std::vector<CopiedKey>& copies,
                                              double time, const std::vector<Vec3>& starts,
                                              std::vector<KeyId>& pasted);

/// Both leave motions that do not only translate as they are.

/// Makes motions straight: their ends, times and easing stay.
Design straightened(const Design& design, const std::vector<MotionId>& motions);

/// Replaces motions by as few straight ones between key poses as needed: at every time the handle is within
/// `tolerance` of where it was. Each of them has the easing that fits best.
Design withFewKeys(const Design& design, std::vector<MotionId> motions, double tolerance);

}  // namespace wend
