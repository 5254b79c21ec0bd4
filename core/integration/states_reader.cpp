#include <zlib.h>

#include "core/integration/states_file.h"

namespace wend {
namespace {

using namespace states;

template <class T>
T number(std::string_view bytes, std::size_t at) {
    T value{};
    std::memcpy(&value, bytes.data() + at, sizeof(T));
    return value;
}

}  // namespace

template <int Dim>
StatesReader<Dim>::StatesReader(std::string path, const StatesHeader& wanted) : m_file(std::move(path)) {
    scan();
    requireSame(wanted);
}

template <int Dim>
void StatesReader<Dim>::failAt(std::uint64_t at) const {
    throw InputError(path(), "is damaged near byte " + std::to_string(at) +
                                 ": remove it, and keep the states again (--states)");
}

/// Finds the blocks up to the first one that is incomplete.
template <int Dim>
void StatesReader<Dim>::scan() {
    const std::string magic = m_file.bytes(0, kMagic.size());
    if (magic.substr(0, kVersionAt) != kMagic.substr(0, kVersionAt))
        throw InputError(path(), "is no states file of Wend (see --states)");
    if (magic != kMagic) throw InputError(path(), "was written by another version of Wend");
    std::uint64_t at = kMagic.size();
    while (scanBlock(at)) requireReading();
    if (!m_hasHeader || m_end == 0) failAt(at);
}

/// Notes the block at a place and moves the place behind it. Returns false if there is no whole block there.
/// Only the checksums of headers and checkpoints are verified now; payload() verifies the others when they
/// are needed.
template <int Dim>
bool StatesReader<Dim>::scanBlock(std::uint64_t& at) {
    const std::uint64_t left = m_file.size() - at;
    if (left < kBeforeBlock + kAfterBlock) return false;
    const std::string before = m_file.bytes(at, kBeforeBlock + 8);
    const Block block{at, number<std::uint64_t>(before, 4)};
    if (block.size > left - kBeforeBlock - kAfterBlock) return false;
    switch (number<BlockKind>(before, 0)) {
        case BlockKind::Header:
            restore(payload(block), m_header);
            m_hasHeader = true;
            break;
        case BlockKind::Array:
            if (block.size < 16) return false;
            m_arrays[number<std::uint64_t>(before, kBeforeBlock)] = block;
            break;
        case BlockKind::Step:
            m_steps.push_back(block);
            break;
        case BlockKind::Checkpoint:
            if (block.size < sizeof(double)) return false;
            m_reached = number<double>(payload(block), 0);
            m_checkpoint = block;
            m_counted = m_steps.size();
            m_end = at + kBeforeBlock + block.size + kAfterBlock;
            break;
        default:
            return false;
    }
    at += kBeforeBlock + block.size + kAfterBlock;
    return true;
}

/// Compares the dimension, and then every part of the header with the wanted one.
template <int Dim>
void StatesReader<Dim>::requireSame(const StatesHeader& wanted) const {
    if (m_header.dimension != wanted.dimension)
        throw InputError(path(), m_header.dimension == 2 ? "holds states of a shape in the plane"
                                                         : "holds states of a solid");
    for (const StatesHeader::Part& part : wanted.parts)
        for (const StatesHeader::Part& own : m_header.parts)
            if (own.name == part.name && own.digest != part.digest)
                throw InputError(path(), "holds states of another run: its " + part.name + " differ" +
                                             (part.name.back() == 's' ? "" : "s"));
    if (m_header.parts.size() != wanted.parts.size()) throw InputError(path(), "holds states of another run");
}

/// Returns the content of a block whose checksum is right.
template <int Dim>
std::string StatesReader<Dim>::payload(const Block& block) const {
    std::string bytes = m_file.bytes(block.at, kBeforeBlock + block.size + kAfterBlock);
    const std::size_t summed = kBeforeBlock + block.size;
    if (bytes.size() < summed + kAfterBlock) failAt(block.at);
    const auto sum = crc32_z(0, reinterpret_cast<const Bytef*>(bytes.data()), summed);
    if (sum != number<std::uint32_t>(bytes, summed)) failAt(block.at);
    bytes.resize(summed);
    bytes.erase(0, kBeforeBlock);
    return bytes;
}

template <int Dim>
template <class Value>
void StatesReader<Dim>::restore(const std::string& bytes, Value& value) try {
    Restoring<Dim> archive(bytes, [this](std::uint64_t id) { return array(id); });
    archive(value);
} catch (const InputError& error) {
    throw error.named(path());
}

/// Returns an array by its number. Arrays that are still in use are not read again.
template <int Dim>
Nodal<Dim> StatesReader<Dim>::array(std::uint64_t id) {
    auto& loaded = m_loaded[id];
    if (Nodal<Dim> there = loaded.lock()) return there;
    const auto block = m_arrays.find(id);
    if (block == m_arrays.end()) failAt(m_end);
    const std::string bytes = payload(block->second);
    const auto columns = number<std::uint64_t>(bytes, 8);
    const std::uint64_t size = bytes.size() - 16;
    if (columns > size || columns * Dim * sizeof(double) != size) failAt(block->second.at);
    auto made = std::make_shared<Points<Dim>>(Dim, static_cast<Eigen::Index>(columns));
    std::memcpy(made->data(), bytes.data() + 16, size);
    loaded = made;
    return made;
}

template <int Dim>
StepRecord<Dim> StatesReader<Dim>::next() {
    StepRecord<Dim> step;
    restore(payload(m_steps.at(m_next++)), step);
    std::erase_if(m_loaded, [](const auto& one) { return one.second.expired(); });
    return step;
}

/// Throws InputError if the checkpoint is not of the time at which the steps have ended.
template <int Dim>
void StatesReader<Dim>::resume(State<Dim>& state, Statistics& statistics) {
    Checkpoint<Dim> kept;
    restore(payload(m_checkpoint), kept);
    if (kept.time != state.time) failAt(m_checkpoint.at);
    state.pace = kept.pace;
    state.history = kept.history;
    state.factor = kept.factor;
    statistics = kept.statistics;
}

template class StatesReader<2>;
template class StatesReader<3>;

}  // namespace wend
