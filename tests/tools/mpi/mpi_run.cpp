#include "tests/tools/mpi/mpi_run.hpp"

#include <csignal>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace asv::test {
namespace {

namespace fs = std::filesystem;

/// A file of /proc, empty where its process has ended.
std::string content(const fs::path& file) {
    std::ifstream in(file);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

/// The folder of its parent in /proc.
fs::path parent_of(const fs::path& process) {
    const std::string status = content(process / "stat");
    const std::size_t end_of_name = status.rfind(')');
    if (end_of_name == std::string::npos) return {};
    std::istringstream rest(status.substr(end_of_name + 1));
    std::string state, parent;
    rest >> state >> parent;
    return fs::path("/proc") / parent;
}

/// Is this in the environment that the process was started with?
bool has(const fs::path& process, const std::string& entry) {
    return content(process / "environ").find(entry) != std::string::npos;
}

}  // namespace

Outcome run_ranks(int ranks, const std::string& program, const std::vector<std::string>& arguments,
                  const Surroundings& surroundings) {
    std::vector<std::string> words{"--allow-run-as-root", "--oversubscribe", "-n",
                                   std::to_string(ranks),
                                   std::string(ASV_PROGRAM_DIR) + "/" + program};
    words.insert(words.end(), arguments.begin(), arguments.end());
    return run_program(ASV_MPIRUN, words, surroundings);
}

bool kill_rank(int rank, const std::string& word) {
    const std::string entry = "OMPI_COMM_WORLD_RANK=" + std::to_string(rank) + '\0';
    for (const fs::directory_entry& process : fs::directory_iterator("/proc")) {
        const std::string number = process.path().filename().string();
        if (number.find_first_not_of("0123456789") != std::string::npos) continue;
        if (!has(process.path(), entry)) continue;
        if (content(process.path() / "cmdline").find(word) == std::string::npos) continue;
        // A rank has children with the same arguments.
        if (!has(parent_of(process.path()), entry)) return ::kill(std::stoi(number), SIGKILL) == 0;
    }
    return false;
}

}  // namespace asv::test
