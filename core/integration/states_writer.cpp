#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>
#include <zlib.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

#include "core/base/same_file.h"
#include "core/integration/states_file.h"

namespace wend {
namespace {

using namespace states;

constexpr std::chrono::milliseconds kLeastApart(250);
// A checkpoint may cost this part of the time between two of them.
constexpr int kPart = 20;

template <class T>
void append(std::string& bytes, T value) {
    std::array<char, sizeof(T)> raw;
    std::memcpy(raw.data(), &value, sizeof(T));
    bytes.append(raw.data(), raw.size());
}

}  // namespace

template <int Dim>
StatesWriter<Dim>::StatesWriter(const std::string& path, StatesHeader header) : m_path(path) {
    m_pending.emplace(path);
    open(m_pending->temporary(), O_CREAT | O_EXCL);
    write(kMagic.data(), kMagic.size());
    store(BlockKind::Header, header);
}

/// Continues another run's states: the same file is cut after its last checkpoint, a different one gets a
/// copy.
template <int Dim>
StatesWriter<Dim>::StatesWriter(const std::string& path, const StatesReader<Dim>& before) : m_path(path) {
    m_lastArray = before.lastArray();
    m_reached = before.reached();
    if (sameFile(path, before.path())) {
        open(path, 0);
        if (ftruncate(m_descriptor, static_cast<off_t>(before.end())) != 0 ||
            lseek(m_descriptor, 0, SEEK_END) < 0)
            fail(errno);
        return;
    }
    m_pending.emplace(path);
    open(m_pending->temporary(), O_CREAT | O_EXCL);
    copyFrom(InputFile(before.path()), before.end());
    m_pending->place();
    m_pending.reset();
}

template <int Dim>
StatesWriter<Dim>::~StatesWriter() {
    if (m_descriptor >= 0) close(m_descriptor);
}

template <int Dim>
void StatesWriter<Dim>::open(const std::string& file, int flags) {
    if (m_pending && m_pending->isSpecial())
        throw InputError(m_path, "is no regular file, where states are kept");
    m_descriptor = ::open(file.c_str(), O_RDWR | O_CLOEXEC | flags, 0666);
    if (m_descriptor < 0) fail(errno);
    if (flock(m_descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)
        throw InputError(m_path, "is being written by another run");
}

template <int Dim>
void StatesWriter<Dim>::copyFrom(const InputFile& other, std::uint64_t end) {
    constexpr std::uint64_t kPiece = 1 << 22;
    for (std::uint64_t at = 0; at < end; at += kPiece) {
        const std::string piece = other.bytes(at, std::min(kPiece, end - at));
        write(piece.data(), piece.size());
    }
}

template <int Dim>
void StatesWriter<Dim>::fail(int error) const {
    const InputError why(m_path, std::string("cannot be written: ") + std::strerror(error));
    throwExplained(why, std::filesystem::path(m_path).parent_path().string());
}

/// Writes all bytes, in several pieces if necessary.
template <int Dim>
void StatesWriter<Dim>::write(const void* bytes, std::size_t count) {
    const char* from = static_cast<const char*>(bytes);
    while (count > 0) {
        const ssize_t put = ::write(m_descriptor, from, count);
        if (put < 0 && errno == EINTR) continue;
        if (put <= 0) fail(put < 0 ? errno : ENOSPC);
        from += put;
        count -= static_cast<std::size_t>(put);
    }
}

/// Writes a block with its length and checksum.
template <int Dim>
void StatesWriter<Dim>::writeBlock(BlockKind kind, std::string_view head, std::string_view body) {
    std::string before;
    append(before, kind);
    append(before, static_cast<std::uint64_t>(head.size() + body.size()));
    before += head;
    const auto sum = [](uLong start, std::string_view bytes) {
        return crc32_z(start, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size());
    };
    std::string after;
    append(after, static_cast<std::uint32_t>(body.empty() ? sum(0, before) : sum(sum(0, before), body)));
    write(before.data(), before.size());
    write(body.data(), body.size());
    write(after.data(), after.size());
}

/// Writes a value as a block, after the arrays that it refers to and that are not in the file yet.
template <int Dim>
template <class Value>
void StatesWriter<Dim>::store(BlockKind kind, Value& value) {
    Storing<Dim> archive([this](const Nodal<Dim>& array) { return idOf(array); });
    archive(value);
    writeBlock(kind, archive.bytes());
}

/// Returns the number of an array, which is written when it is named first.
template <int Dim>
std::uint64_t StatesWriter<Dim>::idOf(const Nodal<Dim>& array) {
    const auto [known, isNew] = m_ids.try_emplace(array, m_lastArray + 1);
    if (!isNew) return known->second;
    std::string head;
    append(head, ++m_lastArray);
    append(head, static_cast<std::uint64_t>(array->cols()));
    writeBlock(BlockKind::Array, head,
               {reinterpret_cast<const char*>(array->data()),
                sizeof(double) * static_cast<std::size_t>(array->size())});
    return m_lastArray;
}

template <int Dim>
void StatesWriter<Dim>::add(const StepRecord<Dim>& step) {
    StepRecord<Dim> copy = step;
    store(BlockKind::Step, copy);
    std::erase_if(m_ids, [](const auto& one) { return one.first.expired(); });
}

/// Writes the checkpoint after everything that it counts for is on the disk. A power failure between both
/// flushes leaves the checkpoint before.
template <int Dim>
void StatesWriter<Dim>::checkpoint(const State<Dim>& state, const Statistics& statistics) {
    const auto begin = Clock::now();
    Checkpoint<Dim> kept{state.time, state.pace, state.history, state.factor, statistics};
    if (fdatasync(m_descriptor) != 0 && errno != EINVAL) fail(errno);
    store(BlockKind::Checkpoint, kept);
    if (fdatasync(m_descriptor) != 0 && errno != EINVAL) fail(errno);
    if (m_pending) {
        m_pending->place();
        m_pending.reset();
    }
    m_reached = state.time;
    m_last = Clock::now();
    m_cost = m_last - begin;
}

/// Lets the time between checkpoints grow with their cost, so that they take a twentieth of a run at most,
/// even on a slow disk.
template <int Dim>
bool StatesWriter<Dim>::isDue() const {
    return Clock::now() - m_last > std::max<Clock::duration>(kLeastApart, kPart * m_cost);
}

template class StatesWriter<2>;
template class StatesWriter<3>;

}  // namespace wend
