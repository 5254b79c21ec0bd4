#include "mpi/team.h"

#include <mpi.h>
#include <petscsys.h>

#include <algorithm>
#include <cmath>
#include <new>
#include <stdexcept>

#include "core/base/input_file.h"

namespace wend {
namespace {

constexpr int kPacketTag = 1, kValuesTag = 2, kCopiesTag = 3;
constexpr std::size_t kPiece = std::size_t(1) << 30;  // MPI counts with int

/// Calls visit(offset, count) for pieces that MPI can send.
template <class Visit>
void forPieces(std::size_t size, Visit&& visit) {
    for (std::size_t at = 0; at < size; at += kPiece)
        visit(at, static_cast<int>(std::min(kPiece, size - at)));
}

/// How a process has failed.
enum Failure { None, Memory, Other };

}  // namespace

Team::Team(int& argc, char**& argv) {
    int provided = 0;
    MPI_Init_thread(&argc, &argv, MPI_THREAD_SERIALIZED, &provided);
    MPI_Comm_rank(MPI_COMM_WORLD, &m_rank);
    MPI_Comm_size(MPI_COMM_WORLD, &m_size);
    for (int rank = 0; rank < m_size; ++rank)
        if (rank != m_rank) m_others.push_back(rank);
    PETSC_COMM_WORLD = MPI_COMM_SELF;
    PetscOptionsSetValue(nullptr, "-no_signal_handler", "1");
    PetscOptionsSetValue(nullptr, "-skip_petscrc", "1");
    PetscInitializeNoArguments();
}

Team::~Team() {
    PetscFinalize();
    MPI_Finalize();
}

void Team::broadcast(Packet& packet) const {
    std::size_t size = packet.bytes().size();
    MPI_Bcast(&size, sizeof size, MPI_BYTE, 0, MPI_COMM_WORLD);
    packet.bytes().resize(size);
    forPieces(size, [&](std::size_t at, int count) {
        MPI_Bcast(packet.bytes().data() + at, count, MPI_BYTE, 0, MPI_COMM_WORLD);
    });
}

void Team::send(int to, const Packet& packet) const {
    const std::size_t size = packet.bytes().size();
    MPI_Send(&size, sizeof size, MPI_BYTE, to, kPacketTag, MPI_COMM_WORLD);
    forPieces(size, [&](std::size_t at, int count) {
        MPI_Send(packet.bytes().data() + at, count, MPI_BYTE, to, kPacketTag, MPI_COMM_WORLD);
    });
}

Packet Team::receive(int from) const {
    Packet packet;
    std::size_t size = 0;
    MPI_Recv(&size, sizeof size, MPI_BYTE, from, kPacketTag, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    packet.bytes().resize(size);
    forPieces(size, [&](std::size_t at, int count) {
        MPI_Recv(packet.bytes().data() + at, count, MPI_BYTE, from, kPacketTag, MPI_COMM_WORLD,
                 MPI_STATUS_IGNORE);
    });
    return packet;
}

void Team::send(int to, std::span<const double> values) const {
    forPieces(values.size(), [&](std::size_t at, int count) {
        MPI_Send(values.data() + at, count, MPI_DOUBLE, to, kValuesTag, MPI_COMM_WORLD);
    });
}

void Team::receive(int from, std::span<double> values) const {
    forPieces(values.size(), [&](std::size_t at, int count) {
        MPI_Recv(values.data() + at, count, MPI_DOUBLE, from, kValuesTag, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    });
}

std::vector<double> Team::all(double own) const {
    std::vector<double> values(static_cast<std::size_t>(m_size));
    MPI_Allgather(&own, 1, MPI_DOUBLE, values.data(), 1, MPI_DOUBLE, MPI_COMM_WORLD);
    return values;
}

std::vector<int> Team::all(int own) const {
    std::vector<int> values(static_cast<std::size_t>(m_size));
    MPI_Allgather(&own, 1, MPI_INT, values.data(), 1, MPI_INT, MPI_COMM_WORLD);
    return values;
}

/// Exchanges with all of these processes at once; empty messages are not sent. Pieces are as large as MPI can
/// count.
template <typename In, typename Out>
void Team::exchange(const std::vector<int>& others, In&& in, Out&& out) const {
    std::vector<MPI_Request> requests;
    const auto post = [&](const Message& message, auto&& start) {
        forPieces(message.bytes, [&](std::size_t at, int count) {
            start(static_cast<std::byte*>(message.data) + at, count, &requests.emplace_back());
        });
    };
    for (std::size_t n = 0; n < others.size(); ++n)
        post(in(n), [&](std::byte* data, int count, MPI_Request* request) {
            MPI_Irecv(data, count, MPI_BYTE, others[n], kCopiesTag, MPI_COMM_WORLD, request);
        });
    for (std::size_t n = 0; n < others.size(); ++n)
        post(out(n), [&](std::byte* data, int count, MPI_Request* request) {
            MPI_Isend(data, count, MPI_BYTE, others[n], kCopiesTag, MPI_COMM_WORLD, request);
        });
    MPI_Waitall(static_cast<int>(requests.size()), requests.data(), MPI_STATUSES_IGNORE);
}

std::vector<Packet> Team::exchange(std::vector<Packet> sent) const {
    std::vector<std::size_t> sentSize, receivedSize(sent.size());
    for (const Packet& packet : sent) sentSize.push_back(packet.bytes().size());
    MPI_Alltoall(sentSize.data(), sizeof(std::size_t), MPI_BYTE, receivedSize.data(), sizeof(std::size_t),
                 MPI_BYTE, MPI_COMM_WORLD);
    std::vector<Packet> received(sent.size());
    for (int rank : m_others) received[rank].bytes().resize(receivedSize[rank]);
    exchange(
        m_others,
        [&](std::size_t n) {
            return Message{received[m_others[n]].bytes().data(), receivedSize[m_others[n]]};
        },
        [&](std::size_t n) {
            return Message{sent[m_others[n]].bytes().data(), sentSize[m_others[n]]};
        });
    received[m_rank] = std::move(sent[m_rank]);
    return received;
}

std::vector<std::vector<int>> Team::exchange(const std::vector<std::vector<int>>& sent) const {
    std::vector<Packet> packets(sent.size());
    for (std::size_t rank = 0; rank < sent.size(); ++rank) packets[rank].put(sent[rank]);
    std::vector<std::vector<int>> received(sent.size());
    packets = exchange(std::move(packets));
    for (std::size_t rank = 0; rank < sent.size(); ++rank) packets[rank].get(received[rank]);
    return received;
}

std::vector<std::vector<double>> Team::exchange(std::vector<std::vector<double>>& sent,
                                                const std::vector<std::vector<int>>& expected,
                                                int numbers) const {
    std::vector<std::vector<double>> received(sent.size());
    for (int rank : m_others)
        received[rank].resize(expected[rank].size() * static_cast<std::size_t>(numbers));
    const auto message = [&](std::vector<double>& list) {
        return Message{list.data(), list.size() * sizeof(double)};
    };
    exchange(
        m_others, [&](std::size_t n) { return message(received[m_others[n]]); },
        [&](std::size_t n) { return message(sent[m_others[n]]); });
    received[m_rank] = std::move(sent[m_rank]);
    return received;
}

bool Team::decide(bool answer) const {
    int yes = answer ? 1 : 0;
    MPI_Bcast(&yes, 1, MPI_INT, 0, MPI_COMM_WORLD);
    return yes != 0;
}

void Team::together(const std::function<void()>& work) const {
    std::exception_ptr thrown;
    std::string text;
    int failure = None;
    try {
        work();
    } catch (const std::bad_alloc& error) {
        thrown = std::current_exception();
        failure = Memory;
    } catch (const std::exception& error) {
        thrown = std::current_exception();
        failure = Other;
        text = error.what();
    }
    const std::vector<int> failures = all(failure);
    const auto first = std::find_if(failures.begin(), failures.end(), [](int one) { return one != None; });
    if (first == failures.end()) return;
    const int rank = static_cast<int>(first - failures.begin());
    if (isFirst() && rank == 0) std::rethrow_exception(thrown);
    if (m_rank == rank) {
        Packet packet;
        packet.put(std::vector<char>(text.begin(), text.end()));
        send(0, packet);
    }
    if (!isFirst()) throw Abandoned();
    Packet packet = receive(rank);
    std::vector<char> letters;
    packet.get(letters);
    const std::string name = "process " + std::to_string(rank + 1) + " of " + std::to_string(m_size);
    if (*first == Memory) throw OutOfMemory(name, "there is not enough memory");
    throw std::runtime_error(name + ": " + std::string(letters.begin(), letters.end()));
}

TeamLinks::TeamLinks(const Team& team, std::vector<int> unknowns, std::vector<Neighbour> neighbours)
    : m_team(team), m_unknowns(std::move(unknowns)), m_neighbours(std::move(neighbours)) {
    for (const Neighbour& neighbour : m_neighbours) m_ranks.push_back(neighbour.part);
}

void TeamLinks::update(std::span<double> values, int numbers) const {
    const auto length = static_cast<std::size_t>(numbers);
    m_sent.clear();
    std::vector<std::size_t> begin;
    for (const auto& neighbour : m_neighbours) {
        begin.push_back(m_sent.size());
        for (int unknown : neighbour.sent)
            m_sent.insert(m_sent.end(), values.begin() + static_cast<std::ptrdiff_t>(unknown * length),
                          values.begin() + static_cast<std::ptrdiff_t>((unknown + 1) * length));
    }
    m_team.exchange(
        m_ranks,
        [&](std::size_t n) {
            const auto& neighbour = m_neighbours[n];
            return Team::Message{values.data() + neighbour.firstCopy * length,
                                 neighbour.copies * length * sizeof(double)};
        },
        [&](std::size_t n) {
            return Team::Message{m_sent.data() + begin[n],
                                 m_neighbours[n].sent.size() * length * sizeof(double)};
        });
}

/// First how much comes, then all of it in one message.
PartLinks::Rows TeamLinks::copiedRows(std::span<const int> start, std::span<const int> columns,
                                      std::span<const float> values, int numbers) const {
    std::vector<Packet> sent(m_neighbours.size()), received(m_neighbours.size());
    std::vector<std::size_t> sentSize(m_neighbours.size()), receivedSize(m_neighbours.size());
    for (std::size_t n = 0; n < m_neighbours.size(); ++n) {
        Rows rows;
        for (int unknown : m_neighbours[n].sent) {
            const auto first = columns.begin() + start[unknown], last = columns.begin() + start[unknown + 1];
            rows.count.push_back(static_cast<int>(last - first));
            rows.columns.insert(rows.columns.end(), first, last);
            const auto from = values.begin() + static_cast<std::ptrdiff_t>(start[unknown]) * numbers;
            rows.values.insert(rows.values.end(), from, from + (last - first) * numbers);
        }
        sent[n].put(rows.count);
        sent[n].put(rows.columns);
        sent[n].put(rows.values);
        sentSize[n] = sent[n].bytes().size();
    }
    m_team.exchange(
        m_ranks,
        [&](std::size_t n) {
            return Team::Message{&receivedSize[n], sizeof(std::size_t)};
        },
        [&](std::size_t n) {
            return Team::Message{&sentSize[n], sizeof(std::size_t)};
        });
    for (std::size_t n = 0; n < m_neighbours.size(); ++n) received[n].bytes().resize(receivedSize[n]);
    m_team.exchange(
        m_ranks,
        [&](std::size_t n) {
            return Team::Message{received[n].bytes().data(), receivedSize[n]};
        },
        [&](std::size_t n) {
            return Team::Message{sent[n].bytes().data(), sentSize[n]};
        });
    Rows all;
    const auto append = [](auto& list, const auto& more) {
        list.insert(list.end(), more.begin(), more.end());
    };
    for (Packet& packet : received) {
        Rows rows;
        packet.get(rows.count);
        packet.get(rows.columns);
        packet.get(rows.values);
        append(all.count, rows.count);
        append(all.columns, rows.columns);
        append(all.values, rows.values);
    }
    return all;
}

/// Sums in the order of the processes, with the same bits in all of them, every time.
double TeamLinks::sum(double part) const {
    double total = 0;
    for (double one : m_team.all(part)) total += one;
    return total;
}

double TeamLinks::largest(double part) const {
    double most = part;
    for (double one : m_team.all(part))
        if (!(one <= most)) most = one;
    return most;
}

bool TeamLinks::decide(bool answer) const {
    return m_team.decide(answer);
}

bool TeamLinks::all(bool answer) const {
    return largest(answer ? 0.0 : 1.0) == 0;
}

}  // namespace wend
