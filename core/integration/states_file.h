#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/base/input_file.h"
#include "core/base/safe_file.h"
#include "core/integration/deformer.h"
#include "core/integration/states_format.h"

namespace wend {

/// Identifies what the states belong to. A run continues only from states with the same header.
struct StatesHeader {
    /// A name and a digest of something that the shape depends on, such as "mesh".
    struct Part {
        std::string name, digest;

        template <class Archive>
        void archive(Archive& archive) {
            auto& [what, value] = *this;
            archive(what, value);
        }
    };

    int dimension = 2;
    double end = 1;  // of the run: the last step is cut there
    std::vector<Part> parts;

    /// Passes all members to an archive, which stores or restores them.
    template <class Archive>
    void archive(Archive& archive) {
        auto& [dim, until, digests] = *this;
        archive(dim, until, digests);
    }
};

/// Holds what a run needs besides the shape to continue from a time.
template <int Dim>
struct Checkpoint {
    double time = 0;
    Pace<Dim> pace;
    VelocityHistory<Dim> history;
    FactorMemory<Dim> factor;
    Statistics statistics;

    template <class Archive>
    void archive(Archive& archive) {
        auto& [at, method, fields, solver, counts] = *this;
        archive(at, method, fields, solver, counts);
    }
};

/// Reads the states of a run from a file.
template <int Dim>
class StatesReader final : public StepSource<Dim> {
  public:
    /// Finds the blocks; arrays are read when they are needed. Throws InputError for a file that is not a
    /// states file, for a damaged one, and for one of another shape, of which it names the first part that
    /// differs.
    StatesReader(std::string path, const StatesHeader& wanted);

    const std::string& path() const { return m_file.path(); }
    const StatesHeader& header() const { return m_header; }
    /// Return the time of the last checkpoint, and where it ends in the file (bytes).
    double reached() const { return m_reached; }
    std::uint64_t end() const { return m_end; }
    /// Returns the highest number of an array.
    std::uint64_t lastArray() const { return m_arrays.empty() ? 0 : m_arrays.rbegin()->first; }

    bool hasNext() const override { return m_next < m_counted; }
    StepRecord<Dim> next() override;
    void resume(State<Dim>& state, Statistics& statistics) override;

  private:
    /// The place of a block in the file, and the length of its content in bytes.
    struct Block {
        std::uint64_t at = 0, size = 0;
    };
    void scan();
    bool scanBlock(std::uint64_t& at);
    void requireSame(const StatesHeader& wanted) const;
    std::string payload(const Block& block) const;
    Nodal<Dim> array(std::uint64_t id);
    template <class Value>
    void restore(const std::string& bytes, Value& value);
    [[noreturn]] void failAt(std::uint64_t at) const;

    InputFile m_file;
    StatesHeader m_header;
    bool m_hasHeader = false;
    std::map<std::uint64_t, Block> m_arrays;
    std::map<std::uint64_t, std::weak_ptr<const Points<Dim>>> m_loaded;
    std::vector<Block> m_steps;
    Block m_checkpoint;
    std::size_t m_next = 0, m_counted = 0;  // steps up to the last checkpoint
    double m_reached = 0;
    std::uint64_t m_end = 0;
};

/// Writes the states of a run to a file while it is computed. The file takes its place with the first
/// checkpoint and grows there, so that it holds everything up to the last checkpoint whenever the run ends.
template <int Dim>
class StatesWriter {
  public:
    /// Begins a new file. Throws InputError.
    StatesWriter(const std::string& path, StatesHeader header);
    /// Continues the states of another run, which it copies unless it is the same file. Throws InputError.
    StatesWriter(const std::string& path, const StatesReader<Dim>& before);
    ~StatesWriter();
    StatesWriter(const StatesWriter&) = delete;
    StatesWriter& operator=(const StatesWriter&) = delete;

    /// Appends a step.
    void add(const StepRecord<Dim>& step);
    /// Appends a checkpoint from which a run can continue; `state` is at the end of the last step. Throws
    /// InputError.
    void checkpoint(const State<Dim>& state, const Statistics& statistics);
    /// Returns whether enough was computed since the last checkpoint to pay for another: at least a quarter
    /// of a second, and twenty times as long as the last one took to write. The clock decides how often
    /// states are kept, never what they are.
    bool isDue() const;
    /// Returns the time of the last checkpoint, if there is one.
    std::optional<double> reached() const { return m_reached; }

  private:
    using Clock = std::chrono::steady_clock;
    void open(const std::string& file, int flags);
    void copyFrom(const InputFile& other, std::uint64_t end);
    void write(const void* bytes, std::size_t count);
    void writeBlock(states::BlockKind kind, std::string_view head, std::string_view body = {});
    template <class Value>
    void store(states::BlockKind kind, Value& value);
    std::uint64_t idOf(const Nodal<Dim>& array);
    [[noreturn]] void fail(int error) const;

    std::string m_path;
    std::optional<PendingFile> m_pending;  // until it has its place
    int m_descriptor = -1;
    std::uint64_t m_lastArray = 0;
    /// The arrays that are in the file, by their address; an address counts while its array lives.
    std::map<std::weak_ptr<const Points<Dim>>, std::uint64_t, std::owner_less<>> m_ids;
    std::optional<double> m_reached;
    Clock::time_point m_last = Clock::now();
    Clock::duration m_cost{};  // of the last checkpoint
};

}  // namespace wend
