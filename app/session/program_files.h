#pragma once

#include <QString>

namespace wend {

/// Where what is installed with the program lies: beside it, whatever the prefix and wherever it has been
/// moved; of a program that is not installed, in the sources that it was built from. Empty if it is gone.
QString sampleFolder();
/// The manual's pages and, in `pictures`, what they show.
QString manualFolder();

}  // namespace wend
