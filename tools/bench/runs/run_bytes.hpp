#pragma once

#include <cstddef>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/benchmark/run.hpp"

/// The outcome of a run as bytes, from one process of asv-bench to another.

namespace asv::tools {

using History = std::vector<std::pair<double, double>>;

/// Bytes of values one after the other: both ends are one program.
class Packer {
  public:
    template <class Value>
    requires std::is_trivially_copyable_v<Value>
    void operator()(const Value& value) {
        bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
    }
    void operator()(const std::string& text) {
        (*this)(text.size());
        bytes_ += text;
    }
    void operator()(const History& history) {
        (*this)(history.size());
        for (const auto& [time, cost] : history) {
            (*this)(time);
            (*this)(cost);
        }
    }
    const std::string& bytes() const { return bytes_; }

  private:
    std::string bytes_;
};

class Unpacker {
  public:
    explicit Unpacker(std::string_view bytes) : bytes_(bytes) {}

    template <class Value>
    requires std::is_trivially_copyable_v<Value>
    void operator()(Value& value) { std::memcpy(&value, take(sizeof value).data(), sizeof value); }
    void operator()(std::string& text) { text = take(size()); }
    void operator()(History& history) {
        history.resize(size());
        for (auto& [time, cost] : history) {
            (*this)(time);
            (*this)(cost);
        }
    }

  private:
    std::size_t size() {
        std::size_t count = 0;
        (*this)(count);
        return count;
    }
    std::string_view take(std::size_t count) {
        const std::string_view taken = bytes_.substr(0, count);
        bytes_.remove_prefix(count);
        return taken;
    }

    std::string_view bytes_;
};

/// Everything that a search has spent.
template <class Archive, class Statistics>
void exchange_statistics(Archive& archive, Statistics& spent) {
    for (auto* number : {&spent.time_to_first, &spent.time_total, &spent.cost_first, &spent.cost,
                         &spent.cost_of_search, &spent.cost_lower_bound})
        archive(*number);
    for (auto* count :
         {&spent.steps_lower_bound, &spent.tree_nodes[0], &spent.tree_nodes[1], &spent.iterations})
        archive(*count);
    archive(spent.optimal);
    archive(spent.state_checks);
    archive(spent.edge_checks);
    archive(spent.cost_history);
}

/// Everything of a run but its place, which both ends know.
template <class Archive, class Run>
void exchange(Archive& archive, Run& run) {
    archive(run.status);
    archive(run.reason);
    archive(run.fault);
    archive(run.primitive_steps);
    archive(run.peak_memory_bytes);
    exchange_statistics(archive, run.spent);
}

inline std::string run_bytes(const core::BenchmarkRun& run) {
    Packer packer;
    exchange(packer, run);
    return packer.bytes();
}

inline std::string place_bytes(const core::RunPlace& place) {
    Packer packer;
    packer(place);
    return packer.bytes();
}

}  // namespace asv::tools
