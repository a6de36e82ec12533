#include "tools/solve/batch/answer_file.hpp"

#include <cerrno>
#include <cstring>

#include <fcntl.h>
#include <unistd.h>

#include "io/text/atomic_file.hpp"
#include "io/text/escape.hpp"
#include "io/text/parse_error.hpp"
#include "io/text/write_all.hpp"

namespace asv::tools {

namespace {

constexpr mode_t permissions = 0666;  // less what the umask takes

int open_answers(const std::filesystem::path& file) {
    if (file == io::standard_stream) return ::dup(STDOUT_FILENO);
    return ::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, permissions);
}

}  // namespace

AnswerFile::AnswerFile(const std::filesystem::path& file)
    : name_(io::escaped(io::output_name(file))), file_(open_answers(file)) {
    if (file_.number() < 0) fail();
}

void AnswerFile::write(std::string_view line) {
    if (!io::write_all(file_.number(), line)) {
        const int error = errno;
        // Where it is a pipe or a device, there is nothing to take back.
        [[maybe_unused]] const int result = ::ftruncate(file_.number(), static_cast<off_t>(size_));
        errno = error;
        fail();
    }
    size_ += line.size();
}

void AnswerFile::fail() const {
    throw io::WriteError(name_ + ": " + std::strerror(errno));
}

}  // namespace asv::tools
