#include "tools/bench/runs/machine.hpp"

#include <array>
#include <charconv>
#include <fstream>

#include <unistd.h>

namespace asv::tools {

namespace {

/// What follows the key and a colon in the first line that begins with it; empty when there is no
/// such line.
std::string value_in(const char* file, const std::string& key) {
    std::ifstream input(file);
    for (std::string line; std::getline(input, line);) {
        if (!line.starts_with(key)) continue;
        const std::size_t begin = line.find_first_not_of(" \t", line.find(':') + 1);
        return begin == std::string::npos ? std::string() : line.substr(begin);
    }
    return {};
}

}  // namespace

std::string host_name() {
    std::array<char, 256> name{};
    if (::gethostname(name.data(), name.size() - 1) != 0) return "unknown";
    return name.data();
}

std::string cpu_name() {
    const std::string name = value_in("/proc/cpuinfo", "model name");
    return name.empty() ? "unknown processor" : name;
}

std::optional<std::size_t> peak_memory() {
    const std::string text = value_in("/proc/self/status", "VmHWM");
    std::size_t kibibytes = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), kibibytes);
    if (error != std::errc{}) return std::nullopt;
    return 1024 * kibibytes;
}

}  // namespace asv::tools
