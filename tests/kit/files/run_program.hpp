#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace asv::test {

/// What a program left behind.
struct Outcome {
    int exit_code = 0;  ///< minus the signal where one ended it
    std::string out;
    std::string err;
};

/// The world that a program runs in; 0 means as it is here.
struct Surroundings {
    std::size_t largest_file = 0;  ///< bytes that any file may grow to
    std::size_t memory = 0;        ///< bytes of address space; not kept under sanitizers
    unsigned user = 0;             ///< run as this user, which only root can ask for
    std::filesystem::path standard_output = {};  ///< instead of Outcome::out
    std::filesystem::path standard_input = {};   ///< instead of none
    /// Sent to it one after the other, each so many milliseconds after the one before.
    std::vector<int> signals = {};
    unsigned before_each_signal = 1000;
    /// What the first of them waits for, where a time alone would depend on how busy the machine
    /// is.
    std::function<bool()> first_signal_when = {};
    /// More of its environment: "NAME=VALUE".
    std::vector<std::string> environment = {};
    unsigned most_processes = 0;  ///< of its user, threads too
};

/// Exit code of a program in which a sanitizer found something.
inline constexpr int sanitizer_exit_code = 99;

/// Exit code when the program itself could not be started.
inline constexpr int cannot_start = 127;

/// Runs bin/NAME of this build, or an absolute NAME, to its end, at most a minute.
Outcome run_program(const std::string& name, const std::vector<std::string>& arguments,
                    const Surroundings& surroundings = {});

}  // namespace asv::test
