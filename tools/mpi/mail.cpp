#include "tools/mpi/mail.hpp"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <functional>
#include <limits>
#include <stdexcept>
#include <thread>
#include <utility>

#include <boost/mpi/collectives.hpp>
#include <mpi.h>
#include <pthread.h>

#include "tools/common/interrupt.hpp"

namespace asv::tools {

namespace {

/// The rests between looks for letters that have not come: each twice as long as the one before.
constexpr int shortest_rest = 20, longest_rest = 1000;  // microseconds

}  // namespace

int Mail::ranks_on_a_machine() const {
    MPI_Comm here = MPI_COMM_NULL;
    MPI_Comm_split_type(world_, MPI_COMM_TYPE_SHARED, world_.rank(), MPI_INFO_NULL, &here);
    const int ranks = boost::mpi::communicator(here, boost::mpi::comm_take_ownership).size();
    return boost::mpi::all_reduce(world_, ranks, boost::mpi::maximum<int>());
}

void Mail::send(int rank, Tag tag, std::string bytes) {
    // A message of MPI has so many at most.
    if (bytes.size() > static_cast<std::size_t>(std::numeric_limits<int>::max()))
        throw std::length_error("a message of more than 2 GB to another rank");
    ++messages_;
    bytes_ += bytes.size();
    under_way_.push_back({std::move(bytes), {}});
    Sent& sent = under_way_.back();
    sent.request = world_.isend(rank, static_cast<int>(tag), sent.bytes.data(),
                                static_cast<int>(sent.bytes.size()));
    microseconds_of_rest_ = 0;
}

void Mail::send_to_all(Tag tag, const std::string& bytes) {
    for (int rank = 0; rank < ranks(); ++rank)
        if (rank != this->rank()) send(rank, tag, bytes);
}

std::optional<Letter> Mail::receive() {
    forget_what_has_arrived();
    const auto status = world_.iprobe();
    if (!status) return std::nullopt;
    Letter letter{status->source(), static_cast<Tag>(status->tag()), {}};
    letter.bytes.resize(static_cast<std::size_t>(status->count<char>().value_or(0)));
    world_.recv(letter.rank, status->tag(), letter.bytes.data(),
                static_cast<int>(letter.bytes.size()));
    ++messages_;
    bytes_ += letter.bytes.size();
    microseconds_of_rest_ = 0;
    return letter;
}

bool Mail::has_come() const {
    return world_.iprobe().has_value();
}

Letter Mail::wait() {
    for (;;) {
        if (std::optional<Letter> letter = receive()) return std::move(*letter);
        rest();
    }
}

void Mail::rest() {
    microseconds_of_rest_ = std::clamp(2 * microseconds_of_rest_, shortest_rest, longest_rest);
    std::this_thread::sleep_for(std::chrono::microseconds(microseconds_of_rest_));
}

void Mail::flush() {
    while (!under_way_.empty()) {
        forget_what_has_arrived();
        rest();
    }
}

void Mail::forget_what_has_arrived() {
    under_way_.remove_if([](Sent& sent) { return sent.request.test().has_value(); });
}

std::string Mail::counts() const {
    return std::to_string(messages_) + " messages with " + std::to_string(bytes_) + " bytes";
}

void dismiss_others(Mail& mail) {
    mail.send_to_all(Tag::end);
    for (int farewells = 1; farewells < mail.ranks();)
        if (mail.wait().tag == Tag::farewell) ++farewells;
    mail.flush();
}

void bid_farewell(Mail& mail) {
    mail.send(0, Tag::farewell);
    mail.flush();
}

void hold_signals_for_rank_0() {
    const sigset_t set = interrupting_signals();
    pthread_sigmask(SIG_BLOCK, &set, nullptr);
}

}  // namespace asv::tools
