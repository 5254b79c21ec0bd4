#pragma once

#include <string>
#include <vector>

namespace wend {

class OutputSet;
struct Rig;

/// Returns whether a path names a rig: .glb, NAME_ske.json for DragonBones, and another .json for Spine.
bool isRigFile(const std::string& path);

/// Returns the files that are written beside a rig: its texture, and the description of that.
std::vector<std::string> filesBesideRig(const std::string& path);

/// Writes a rig by the name of its file, with those beside it. Throws InputError.
/// glTF 2.0: morph targets, a thousand pixels per unit, y up, parts in front nearer by a thousandth of the
/// larger side. Spine 4.1 and DragonBones 5.5: a mesh per part with keys of its vertices, and of the order
/// of the parts where that changes.
void writeRig(const std::string& path, const Rig& rig, OutputSet& files);

/// Describes what players of the format do not hold of a rig; empty if they hold everything. Those of
/// DragonBones begin every part's keys at one of 65536 numbers.
std::string lostInRig(const std::string& path, const Rig& rig);

}  // namespace wend
