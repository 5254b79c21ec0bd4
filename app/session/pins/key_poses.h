#pragma once

#include <QString>
#include <vector>

#include "app/project/edits/key_edits.h"
#include "app/project/edits/progress.h"

namespace wend {

class ShapeSession;

/// Returns copies of key poses of the shown shape.
std::vector<CopiedKey> copyKeys(const ShapeSession& session, const std::vector<KeyId>& keys);
/// Returns mirrored copies. Each pose is given to the pin at the mirror image of its pin, or to the same pin
/// if there is no such pin; see mirrorOf().
std::vector<CopiedKey> mirroredKeys(const ShapeSession& session, std::vector<CopiedKey> copies);
/// Returns copies for other pins: those of a single pin for the selected ones, if these are others.
std::vector<CopiedKey> forSelected(const ShapeSession& session, const std::vector<CopiedKey>& copies);
/// Sets copied poses, the first one at a time, in one undo step. Locked pins stay; poses at the start of a
/// pin's time, where it is at rest, are left out with a notice. Returns the keys that there are now.
std::vector<KeyId> pasteKeys(ShapeSession& session, std::vector<CopiedKey> copies, double time,
                             const QString& step);
/// Gives motions another progress in one undo step; see withProgress().
void easeMotions(ShapeSession& session, const std::vector<MotionId>& motions, const Progress& progress,
                 const QString& step, const QString& mergeKey = {});

}  // namespace wend
