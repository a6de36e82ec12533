#include "tools/view/film.hpp"

#include <array>
#include <cerrno>
#include <map>
#include <stdexcept>
#include <system_error>
#include <vector>

#include <fcntl.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tools/common/command_line.hpp"
#include "tools/common/descriptor.hpp"

extern char** environ;

namespace asv::tools {

namespace {

using Words = std::vector<std::string>;

constexpr const char* program = "ffmpeg";
/// The number that the film's file has for ffmpeg, and the name by which it opens that.
constexpr int film_number = 3;
constexpr const char* film_file = "/dev/fd/3";

/// Whatever ends this program, no file is left behind.
int file_in_memory(const char* name) {
    const int number = ::memfd_create(name, MFD_CLOEXEC);
    if (number < 0) throw_errno("a film");
    return number;
}

std::string content(const Descriptor& file) {
    std::string bytes;
    std::array<char, 1U << 16U> part{};
    for (;;) {
        const ssize_t count =
            ::pread(file.number(), part.data(), part.size(), static_cast<off_t>(bytes.size()));
        if (count < 0 && errno != EINTR) throw_errno("a film");
        if (count == 0) return bytes;
        if (count > 0) bytes.append(part.data(), static_cast<std::size_t>(count));
    }
}

/// What makes a film of pictures that have an even number of pixels in both directions.
Words coding(FilmFormat format) {
    switch (format) {
        case FilmFormat::gif:  // with a palette of its own
            return {"-filter_complex", "split[a][b];[a]palettegen[p];[b][p]paletteuse", "-f",
                    "gif"};
        case FilmFormat::mp4:
            return {"-c:v",      "libx264",    "-pix_fmt", "yuv420p",
                    "-movflags", "+faststart", "-f",       "mp4"};
        case FilmFormat::webm:
            return {"-c:v", "libvpx-vp9", "-pix_fmt", "yuv420p", "-b:v",
                    "0",    "-crf",       "30",       "-f",      "webm"};
    }
    return {};
}

Words command(FilmFormat format, unsigned pictures_per_second) {
    Words words{program,      "-y",         "-loglevel",
                "error",      "-bitexact",  "-f",
                "image2pipe", "-framerate", std::to_string(pictures_per_second),
                "-i",         "-"};
    // Films are coded in squares of two by two pixels.
    if (format != FilmFormat::gif)
        for (const char* word : {"-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2"}) words.emplace_back(word);
    for (std::string& word : coding(format)) words.push_back(std::move(word));
    words.emplace_back(film_file);
    return words;
}

/// Starts the program with these files as its standard input, its standard error and the film.
pid_t start(Words words, const Descriptor& input, const Descriptor& errors,
            const Descriptor& film) {
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    ::posix_spawn_file_actions_init(&actions);
    ::posix_spawn_file_actions_adddup2(&actions, input.number(), STDIN_FILENO);
    ::posix_spawn_file_actions_adddup2(&actions, errors.number(), STDOUT_FILENO);
    ::posix_spawn_file_actions_adddup2(&actions, errors.number(), STDERR_FILENO);
    ::posix_spawn_file_actions_adddup2(&actions, film.number(), film_number);
    pid_t child = 0;
    const int error = ::posix_spawnp(&child, program, &actions, nullptr, arguments.data(), environ);
    ::posix_spawn_file_actions_destroy(&actions);
    if (error == ENOENT)
        throw UsageError(
            "a film needs the program ffmpeg (Debian package ffmpeg); -o NAME-%d.png makes "
            "numbered pictures without it");
    if (error != 0) throw std::system_error(error, std::generic_category(), program);
    return child;
}

/// False when nobody reads any more.
bool send_all(const Descriptor& socket, const std::string& bytes) {
    for (std::size_t sent = 0; sent < bytes.size();) {
        const ssize_t count =
            ::send(socket.number(), bytes.data() + sent, bytes.size() - sent, MSG_NOSIGNAL);
        if (count < 0 && errno != EINTR) return false;
        if (count > 0) sent += static_cast<std::size_t>(count);
    }
    return true;
}

void send_pictures(const Descriptor& socket, const io::Animation& animation,
                   unsigned pictures_per_second) {
    for (std::size_t i = 0; i < animation.size(); ++i) {
        const bool at_an_end = i == 0 || i + 1 == animation.size();
        const std::string picture = animation.picture(i);
        for (unsigned times = at_an_end ? 1 + pictures_per_second / 2 : 1; times > 0; --times)
            if (!send_all(socket, picture)) return;
    }
}

}  // namespace

std::optional<FilmFormat> film_format(std::string_view ending) {
    static const std::map<std::string_view, FilmFormat> formats{
        {".gif", FilmFormat::gif}, {".mp4", FilmFormat::mp4}, {".webm", FilmFormat::webm}};
    const auto found = formats.find(ending);
    if (found == formats.end()) return std::nullopt;
    return found->second;
}

std::string make_film(const io::Animation& animation, FilmFormat format,
                      unsigned pictures_per_second) {
    const Descriptor film(file_in_memory("film")), errors(file_in_memory("errors"));
    std::array<int, 2> ends{};
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0)
        throw_errno("a film");
    Descriptor ours(ends[0]), theirs(ends[1]);
    const pid_t child = start(command(format, pictures_per_second), theirs, errors, film);
    theirs.close();
    send_pictures(ours, animation, pictures_per_second);
    ours.close();
    int status = 0;
    while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    if (status != 0) throw std::runtime_error("ffmpeg: " + content(errors));
    return content(film);
}

}  // namespace asv::tools
