#pragma once

namespace wend {

/// OpenImageIO looks for plug-ins once, where the environment says, and loads what it finds (already to learn
/// whether an attribute's prefix is a format's name). This makes it look now, and nowhere. It changes the
/// environment for a moment: call it before any thread begins.
void lookForNoPlugins();

}  // namespace wend
