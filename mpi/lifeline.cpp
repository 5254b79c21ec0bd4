#include "mpi/lifeline.h"

#include <arpa/inet.h>
#include <fcntl.h>
#include <ifaddrs.h>
#include <net/if.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/random.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdint>

#include "app/cli/terminal.h"
#include "core/base/last_act.h"

namespace wend {
namespace {

constexpr int kPatience = 1000;  // milliseconds for a connection

/// The last bytes of a process: that it ends well, or a code with which it ends.
constexpr std::uint8_t kWell = 255;

// For the last act, which may be that of a signal handler.
constexpr std::size_t kMostSockets = 4096;
std::array<std::atomic<int>, kMostSockets> farewellSockets;
std::atomic<std::size_t> farewellCount = 0;

void farewell(int code) {
    const auto last = static_cast<std::uint8_t>(code);
    for (std::size_t i = 0; i < farewellCount; ++i) send(farewellSockets[i], &last, 1, MSG_NOSIGNAL);
}

std::string hostName() {
    std::array<char, 256> name{};
    gethostname(name.data(), name.size() - 1);
    return name.data();
}

/// Returns whether there is something to read, or a connection is made, in time.
bool isReady(int socket, short events) {
    pollfd one{socket, events, 0};
    return poll(&one, 1, kPatience) == 1;
}

bool readAll(int socket, void* data, std::size_t size) {
    auto* bytes = static_cast<std::byte*>(data);
    while (size > 0) {
        if (!isReady(socket, POLLIN)) return false;
        const ssize_t count = recv(socket, bytes, size, 0);
        if (count <= 0) return false;
        bytes += count;
        size -= static_cast<std::size_t>(count);
    }
    return true;
}

bool sendAll(int socket, const void* data, std::size_t size) {
    return send(socket, data, size, MSG_NOSIGNAL) == static_cast<ssize_t>(size);
}

/// Returns the addresses of this machine, its own for itself first.
std::vector<in_addr_t> addresses() {
    std::vector<in_addr_t> result{htonl(INADDR_LOOPBACK)};
    ifaddrs* all = nullptr;
    if (getifaddrs(&all) != 0) return result;
    for (const ifaddrs* one = all; one; one = one->ifa_next) {
        const bool isOther =
            one->ifa_addr && one->ifa_addr->sa_family == AF_INET && !(one->ifa_flags & IFF_LOOPBACK);
        if (isOther) result.push_back(reinterpret_cast<const sockaddr_in*>(one->ifa_addr)->sin_addr.s_addr);
    }
    freeifaddrs(all);
    return result;
}

sockaddr_in placeOf(in_addr_t address, in_port_t port) {
    sockaddr_in place{};
    place.sin_family = AF_INET;
    place.sin_addr.s_addr = address;
    place.sin_port = port;
    return place;
}

void closeOne(int& descriptor) {
    if (descriptor >= 0) close(descriptor);
    descriptor = -1;
}

using Name = std::array<char, 64>;

Name shortened(const std::string& text) {
    Name name{};
    std::copy_n(text.begin(), std::min(text.size(), name.size() - 1), name.begin());
    return name;
}

}  // namespace

/// The address at which the first process waits for connections, and the word by which it recognizes the
/// team's own.
struct Lifeline::Meeting {
    using Token = std::array<std::uint8_t, 16>;
    /// The first message of a process.
    struct Greeting {
        Token token;
        int rank;
        Name host;
    };
    Token token{};
    in_port_t port = 0;  // 0: there is none
    std::vector<in_addr_t> addresses;

    void put(Packet& packet) const {
        packet.put(token);
        packet.put(port);
        packet.put(addresses);
    }
    void get(Packet& packet) {
        packet.get(token);
        packet.get(port);
        packet.get(addresses);
    }
};

Lifeline::Lifeline(const Team& team) : m_rank(team.rank()), m_size(team.size()) {
    if (m_size == 1) return;
    const std::string own = hostName();
    Packet name, meetingPlace;
    name.put(shortened(own));
    team.broadcast(name);
    Name first{};
    name.get(first);
    const std::vector<int> near = team.all(own == first.data() ? 1 : 0);
    const bool allNear = std::count(near.begin(), near.end(), 1) == m_size;
    if (!allNear) m_host = own;
    Meeting meeting;
    if (team.isFirst()) listen(allNear, meeting);
    meeting.put(meetingPlace);
    team.broadcast(meetingPlace);
    if (!team.isFirst()) meeting.get(meetingPlace);
    const std::vector<int> connected = team.all(!team.isFirst() && connect(meeting) ? 1 : 0);
    if (team.isFirst()) accept(static_cast<int>(std::count(connected.begin(), connected.end(), 1)), meeting);
    closeOne(m_listener);
    if (m_peers.empty() || pipe2(m_wake.data(), O_CLOEXEC) != 0) return;
    for (const Peer& peer : m_peers)
        if (farewellCount < kMostSockets) farewellSockets[farewellCount++] = peer.socket;
    setLastAct(farewell);
    m_thread = std::thread([this] { watch(); });
}

Lifeline::~Lifeline() {
    setLastAct(nullptr);
    farewellCount = 0;
    if (m_thread.joinable()) {
        closeOne(m_wake[1]);
        m_thread.join();
    }
    for (Peer& peer : m_peers) {
        sendAll(peer.socket, &kWell, 1);
        closeOne(peer.socket);
    }
    closeOne(m_wake[0]);
}

/// Processes of other machines need more than this machine's own address for itself.
void Lifeline::listen(bool isNear, Meeting& meeting) {
    if (getrandom(meeting.token.data(), meeting.token.size(), 0) !=
        static_cast<ssize_t>(meeting.token.size()))
        return;
    m_listener = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    if (m_listener < 0) return;
    sockaddr_in place = placeOf(htonl(isNear ? INADDR_LOOPBACK : INADDR_ANY), 0);
    socklen_t size = sizeof place;
    auto* const general = reinterpret_cast<sockaddr*>(&place);
    const bool listens = bind(m_listener, general, size) == 0 && ::listen(m_listener, m_size) == 0 &&
                         getsockname(m_listener, general, &size) == 0;
    if (!listens) return;
    meeting.port = place.sin_port;
    meeting.addresses = addresses();
}

bool Lifeline::connect(const Meeting& meeting) {
    if (meeting.port == 0) return false;
    for (const in_addr_t address : meeting.addresses) {
        int channel = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
        const sockaddr_in place = placeOf(address, meeting.port);
        int problem = 0;
        socklen_t size = sizeof problem;
        const Meeting::Greeting greeting{meeting.token, m_rank, shortened(m_host)};
        const bool begun = ::connect(channel, reinterpret_cast<const sockaddr*>(&place), sizeof place) == 0 ||
                           errno == EINPROGRESS;
        if (begun && isReady(channel, POLLOUT) &&
            getsockopt(channel, SOL_SOCKET, SO_ERROR, &problem, &size) == 0 && problem == 0 &&
            sendAll(channel, &greeting, sizeof greeting)) {
            m_peers.push_back({channel, 0, {}});
            return true;
        }
        closeOne(channel);
    }
    return false;
}

/// Strangers may knock, too.
void Lifeline::accept(int count, const Meeting& meeting) {
    while (static_cast<int>(m_peers.size()) < count && isReady(m_listener, POLLIN)) {
        int channel = accept4(m_listener, nullptr, nullptr, SOCK_CLOEXEC | SOCK_NONBLOCK);
        if (channel < 0) return;
        Meeting::Greeting greeting{};
        if (readAll(channel, &greeting, sizeof greeting) && greeting.token == meeting.token)
            m_peers.push_back({channel, greeting.rank, greeting.host.data()});
        else
            closeOne(channel);
    }
}

/// Watches in a thread of its own, until the destructor runs or all others have ended well.
void Lifeline::watch() {
    std::vector<pollfd> waited{{m_wake[0], POLLIN, 0}};
    for (const Peer& peer : m_peers) waited.push_back({peer.socket, POLLIN, 0});
    while (poll(waited.data(), waited.size(), -1) >= 0 || errno == EINTR) {
        if (waited[0].revents != 0) return;
        for (std::size_t i = 1; i < waited.size(); ++i) {
            if (waited[i].fd < 0 || waited[i].revents == 0) continue;
            std::uint8_t code = 0;
            const ssize_t count = recv(waited[i].fd, &code, 1, 0);
            if (count < 0 && (errno == EAGAIN || errno == EINTR)) continue;
            if (count <= 0) endFor(m_peers[i - 1], kLost);
            if (code != kWell) endProcess(code);
            waited[i].fd = -1;
        }
    }
}

/// Ends this process; only the first two report the loss, so that it is printed once.
void Lifeline::endFor(const Peer& peer, int code) {
    if (m_rank > 1) endProcess(code);
    const std::string place = peer.host.empty() ? "" : " (" + peer.host + ")",
                      text = "process " + std::to_string(peer.rank + 1) + " of " + std::to_string(m_size) +
                             place + " was lost";
    Terminal::lastWord(text.c_str(), code);
}

}  // namespace wend
