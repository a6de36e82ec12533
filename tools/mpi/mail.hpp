#pragma once

#include <cstddef>
#include <list>
#include <optional>
#include <string>
#include <string_view>

#include <boost/mpi/communicator.hpp>
#include <boost/mpi/request.hpp>

namespace asv::tools {

/// What a letter is about. Rank 0 deals and collects; the others hear from it and tell it alone.
enum class Tag : int {
    // From rank 0 to the others.
    plan,           ///< what a sweep runs
    place,          ///< make this run of it
    order,          ///< solve this problem
    give_path,      ///< send your first path
    go_on_from,     ///< a path of another rank: improve that, unless you have one
    stop,           ///< come to an end
    give_solution,  ///< send your solution
    end,            ///< the program ends
    // From the others to rank 0.
    run,         ///< the outcome of a run
    found,       ///< there is a path
    first_path,  ///< this is it
    cost,        ///< of the best path so far
    finish,      ///< how solving ended
    solution,    ///< and its path
    farewell     ///< nothing more comes
};

struct Letter {
    int rank = 0;  ///< who has sent it
    Tag tag = Tag::end;
    std::string bytes;
};

/// Messages of bytes between the processes that MPI has started, counted. Nobody waits for a
/// receiver, nor turns in circles for a sender, as MPI's own waiting does, at the cost of a
/// processor. For one thread at a time.
class Mail {
  public:
    int rank() const { return world_.rank(); }
    int ranks() const { return world_.size(); }
    /// The most ranks that there are on one machine.
    int ranks_on_a_machine() const;

    void send(int rank, Tag tag, std::string bytes = {});
    /// To all others.
    void send_to_all(Tag tag, const std::string& bytes = {});
    /// The next letter that has come, if any.
    std::optional<Letter> receive();
    /// Is there one? It stays there.
    bool has_come() const;
    /// The next letter, once it has come.
    Letter wait();
    /// Lets a moment pass, a longer one where nothing has come for long.
    void rest();
    /// Returns when everything that was sent has been taken.
    void flush();

    /// "12 messages with 3456 bytes": sent to and by this rank so far.
    std::string counts() const;

  private:
    struct Sent {
        std::string bytes;
        boost::mpi::request request;
    };
    void forget_what_has_arrived();

    boost::mpi::communicator world_;
    std::list<Sent> under_way_;
    std::size_t messages_ = 0, bytes_ = 0;
    int microseconds_of_rest_ = 0;
};

/// For rank 0: tells the others to end, and returns when they do.
void dismiss_others(Mail& mail);

/// For the others: the last word.
void bid_farewell(Mail& mail);

/// Blocks the signals that interrupt programs, for this thread and those that MPI is about to
/// start, so that they reach the thread that the program has for them. Rank 0 acts on them; the
/// others, which are told, leave them alone.
void hold_signals_for_rank_0();

}  // namespace asv::tools
