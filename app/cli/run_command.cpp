#include <algorithm>
#include <atomic>
#include <chrono>
#include <iterator>

#include "app/cli/commands.h"
#include "app/cli/interrupt.h"
#include "app/cli/run_preparation.h"
#include "app/cli/terminal.h"
#include "app/engine/motion_transfer.h"
#include "app/project/edits/scaled_project.h"
#include "app/project/file/named_files.h"
#include "app/project/file/project_reader.h"
#include "app/project/project.h"
#include "core/base/error.h"
#include "core/integration/deformer.h"

namespace wend {
namespace {

// The time from a request to stop to the end of the process. The processes of a team end together if they
// can; mpirun kills them after a second.
constexpr std::chrono::milliseconds kPatience(200), kPatienceWithMany(800);

ExitCode runWith(const Arguments& arguments, const RunSolvers& solvers, std::chrono::milliseconds patience) {
    const std::string path = onlyFile(arguments, "project");
    RunOptions options = runOptionsOf(arguments);
    options.solvers = solvers;
    const auto shown =
        arguments.has("--progress") ? Terminal::Progress::Shown : Terminal::Progress::Automatic;
    Terminal terminal(shown, arguments.has("--quiet"));
    LoadedProject loaded = readProject(path);
    std::vector<std::string> notices = loaded.warnings;
    if (const Message text = fitToPicture(*loaded.project, folderOf(path)); !text.isEmpty())
        notices.push_back(text);
    if (arguments.has("--motion-of")) {
        auto other = withMotionOf(arguments.text("--motion-of"), *loaded.project, folderOf(path));
        loaded.project = std::move(other.project);
        std::ranges::move(other.notices, std::back_inserter(notices));
    }
    Project& project = *loaded.project;
    std::ranges::copy(takeLine(arguments, path, options, project), std::back_inserter(notices));
    const auto notice = [&](const std::string& text) {
        if (!options.strict) terminal.warn(path + ": " + text);
    };
    std::ranges::for_each(notices, notice);
    options.notices = notices;

    std::atomic<double> kept = -1;  // the time up to which there are states
    const auto cancelled = [&] {
        return kept < 0 ? std::string(kCancelled)
                        : "cancelled; " + options.outputs.states.front() + " has the states up to time " +
                              shortNumber(kept) + ", nothing else was written";
    };
    Interrupt interrupt([&] { terminal.end(cancelled()); }, patience);
    RunWatch watch;
    watch.stop = interrupt.token();
    watch.notice = notice;
    watch.summary = [&](const std::string& text) { terminal.tell(path + ": " + text); };
    watch.progress = [&](const std::string& work, double fraction) { terminal.progress(work, fraction); };
    watch.kept = [&](double time) { kept = time; };
    try {
        const AdvanceResult result = runProject(project, path, options, watch);
        if (result.outcome == Outcome::Done) return ExitCode::Done;
        Terminal::error(path + ": " + result.message);
    } catch (const Cancelled&) {
        terminal.end(cancelled());
    } catch (const NoticeError& error) {
        terminal.end(path + ": " + error.what() + " (--strict)");
        return error.isOfShape() ? ExitCode::Incomplete : ExitCode::Input;
    }
    return ExitCode::Incomplete;
}

}  // namespace

ExitCode runRun(const Arguments& arguments) {
    return runWith(arguments, {}, kPatience);
}

ExitCode runDivided(const Arguments& arguments, const RunSolvers& solvers) {
    return runWith(arguments, solvers, kPatienceWithMany);
}

}  // namespace wend
