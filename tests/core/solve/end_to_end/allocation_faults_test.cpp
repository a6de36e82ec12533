#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <new>

#include <gtest/gtest.h>

#include "core/solve/solve.hpp"
#include "tests/kit/chains/problems.hpp"
#include "tests/kit/solving.hpp"

/// Every allocation of solve() fails once, whatever thread it is in: the caller gets an exception.
/// The program has an operator new of its own.

namespace {

constexpr long none = std::numeric_limits<long>::max();
std::atomic<long> until_failure = none;

void* allocated(std::size_t size, std::size_t alignment) {
    if (until_failure.fetch_sub(1) == 1) throw std::bad_alloc();
    const std::size_t whole = (size + alignment - 1) / alignment * alignment;
    void* memory = alignment <= alignof(std::max_align_t) ? std::malloc(size + (size == 0))
                                                          : std::aligned_alloc(alignment, whole);
    if (!memory) throw std::bad_alloc();
    return memory;
}

}  // namespace

void* operator new(std::size_t size) {
    return allocated(size, 1);
}
void* operator new(std::size_t size, std::align_val_t alignment) {
    return allocated(size, static_cast<std::size_t>(alignment));
}
void operator delete(void* memory) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::align_val_t) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
    std::free(memory);
}

namespace asv::core {
namespace {

/// How many allocations the call makes.
long allocations(const Problem& problem, const SolveOptions& options) {
    until_failure = none;
    static_cast<void>(solve(problem, options));
    return none - until_failure.exchange(none);
}

/// True when solve() threw std::bad_alloc, false when it returned, since it had ended before or
/// could do without.
bool fails_at(long allocation, const Problem& problem, const SolveOptions& options) {
    until_failure = allocation;
    try {
        const SolveResult result = solve(problem, options);
        until_failure = none;
        EXPECT_EQ(result.status, SolveStatus::solved) << result.reason;
        return false;
    } catch (const std::bad_alloc&) {
        until_failure = none;
        return true;
    }
}

/// The first allocations one by one, the others in growing strides.
void fail_everywhere(const Problem& problem, const SolveOptions& options) {
    const long all = allocations(problem, options);
    long failed = 0;
    for (long k = 1; k <= all; k += 1 + k / 50) {
        SCOPED_TRACE("allocation " + std::to_string(k) + " of " + std::to_string(all));
        failed += fails_at(k, problem, options) ? 1 : 0;
    }
    EXPECT_GT(failed, 100);
    test::expect_solved(problem, solve(problem, options));
}

SolveOptions on_threads(std::size_t threads) {
    SolveOptions options = test::plain(1);
    options.threads = threads;
    options.optimize = 0.005;
    options.keep_trees = true;
    return options;
}

TEST(AllocationFaults, AreExceptionsOfTheCallWithOneThreadAndWithTwo) {
    for (const char* file : {"3ASV.txt", "bodies/arm-3-plane.json"})
        for (const std::size_t threads : {1U, 2U}) {
            SCOPED_TRACE(std::string(file) + ", threads " + std::to_string(threads));
            fail_everywhere(test::testcase(file), on_threads(threads));
        }
}

TEST(AllocationFaults, AreExceptionsInEveryPlanner) {
    const Problem problem = test::testcase("3ASV.txt");
    for (const std::string_view name : planner_names()) {
        SCOPED_TRACE(name);
        SolveOptions options = on_threads(2);
        options.planner = planner_named(name);
        const long all = allocations(problem, options);
        long failed = 0;
        for (const double share : {0.01, 0.1, 0.3, 0.5, 0.7, 0.9})
            failed +=
                fails_at(1 + static_cast<long>(share * static_cast<double>(all)), problem, options)
                    ? 1
                    : 0;
        EXPECT_GT(failed, 0);
    }
}

}  // namespace
}  // namespace asv::core
