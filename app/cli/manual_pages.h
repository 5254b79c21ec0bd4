#pragma once

#include <string>
#include <vector>

namespace wend {

/// A page of the manual in section 1, in the language of man(7).
struct ManualPage {
    std::string name;  // "wend-run"
    std::string text;
};

/// Returns wend(1), a page for each subcommand that the overview shows, and wend-mpi(1), all from the tables
/// of subcommands and options.
std::vector<ManualPage> manualPages();

}  // namespace wend
