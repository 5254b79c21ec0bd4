#pragma once

#include <exception>
#include <functional>
#include <string>
#include <vector>

#include "core/solver/part_links.h"
#include "mpi/division.h"
#include "mpi/packet.h"

namespace wend {

/// Thrown in every process but the first if one of them has failed; the first one reports the reason.
class Abandoned : public std::exception {
  public:
    const char* what() const noexcept override { return "abandoned"; }
};

/// The processes that mpirun or srun has started together, by MPI. The first one, with number 0, runs the
/// program; the others do what it says. Functions are called by all processes in the same order unless they
/// say otherwise. One object for the life of the process, and one thread that uses it.
class Team {
  public:
    /// Starts MPI, and PETSc for each process by itself.
    Team(int& argc, char**& argv);
    ~Team();
    Team(const Team&) = delete;
    Team& operator=(const Team&) = delete;

    int rank() const { return m_rank; }
    int size() const { return m_size; }
    bool isFirst() const { return m_rank == 0; }

    /// Sends the first process's bytes to all.
    void broadcast(Packet& packet) const;
    /// Send from one process to another; both call these.
    void send(int to, const Packet& packet) const;
    Packet receive(int from) const;
    void send(int to, std::span<const double> values) const;
    void receive(int from, std::span<double> values) const;

    /// Returns one number of every process, in all of them.
    std::vector<double> all(double own) const;
    std::vector<int> all(int own) const;
    /// Exchange data from every process to every other. Each gets, by the processes, what they sent to it.
    std::vector<Packet> exchange(std::vector<Packet> sent) const;
    std::vector<std::vector<int>> exchange(const std::vector<std::vector<int>>& sent) const;
    /// Exchanges lists that have `numbers` values for every entry of `expected`.
    std::vector<std::vector<double>> exchange(std::vector<std::vector<double>>& sent,
                                              const std::vector<std::vector<int>>& expected,
                                              int numbers) const;
    /// Returns the answer of the first process.
    bool decide(bool answer) const;

    /// Does some work without messages, and throws in all processes if it throws in one: in the first process
    /// what it has thrown itself, or OutOfMemory or std::runtime_error that names the process; Abandoned in
    /// the others.
    void together(const std::function<void()>& work) const;

  private:
    struct Message {
        void* data;
        std::size_t bytes;
    };
    template <typename In, typename Out>
    void exchange(const std::vector<int>& others, In&& in, Out&& out) const;

    int m_rank = 0, m_size = 1;
    std::vector<int> m_others;  // all processes but this one

    friend class TeamLinks;
};

/// The links of a part to its neighbours, by messages between their processes.
class TeamLinks final : public PartLinks {
  public:
    TeamLinks(const Team& team, std::vector<int> unknowns, std::vector<Neighbour> neighbours);

    int own(int) const override { return static_cast<int>(m_unknowns.size()); }
    int number(int unknown) const override { return m_unknowns[unknown]; }
    void update(std::span<double> values, int numbers) const override;
    Rows copiedRows(std::span<const int> start, std::span<const int> columns, std::span<const float> values,
                    int numbers) const override;
    double sum(double part) const override;
    double largest(double part) const override;
    bool decide(bool answer) const override;
    bool all(bool answer) const override;

  private:
    const Team& m_team;
    std::vector<int> m_unknowns;
    std::vector<Neighbour> m_neighbours;
    std::vector<int> m_ranks;  // of the neighbours
    mutable std::vector<double> m_sent;
};

}  // namespace wend
