#include <filesystem>

#include "app/cli/commands.h"
#include "app/cli/completion.h"
#include "app/cli/manual_pages.h"
#include "app/project/file/text_file.h"
#include "app/project/options/options.h"

namespace wend {
namespace {

void writeManualPages(const std::filesystem::path& folder) {
    for (const ManualPage& page : manualPages())
        writeTextFile((folder / (page.name + ".1")).string(), page.text);
}

}  // namespace

ExitCode runReference(const Arguments& arguments) {
    if (!arguments.files().empty()) throw UsageError("`wend reference` takes no file");
    if (arguments.has("--man")) writeManualPages(arguments.text("--man"));
    if (arguments.has("--completion")) return print(completionFor(arguments.text("--completion")));
    return arguments.has("--man") ? ExitCode::Done : print(referencePage());
}

}  // namespace wend
