#include "io/text/atomic_file.hpp"

#include <csignal>
#include <functional>
#include <string>
#include <thread>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "io/text/parse_error.hpp"
#include "tests/kit/files/error_message.hpp"
#include "tests/kit/files/temporary_folder.hpp"

namespace asv::io {
namespace {

namespace fs = std::filesystem;
using test::error_message;
using test::TemporaryFolder;

unsigned permissions(const fs::path& file) {
    struct stat status {};
    EXPECT_EQ(::stat(file.c_str(), &status), 0);
    return status.st_mode & 0777U;
}

TEST(AtomicFile, ReadsBackWhatWasWritten) {
    const TemporaryFolder folder;
    for (const std::string& content :
         {std::string(), std::string("a\0b\n", 4), std::string(200'000, 'x')}) {
        write_file(folder / "f", content);
        EXPECT_EQ(read_file(folder / "f"), content);
        EXPECT_EQ(folder.entries(), 1);
    }
}

TEST(AtomicFile, SaysWhyAFileCannotBeRead) {
    const TemporaryFolder folder;
    const std::string missing = (folder / "missing").string();
    EXPECT_EQ(error_message<ReadError>([&] { read_file(missing); }),
              missing + ": No such file or directory");
    EXPECT_EQ(error_message<ReadError>([&] { read_file(folder.path()); }),
              folder.path().string() + ": Is a directory");
    EXPECT_EQ(error_message<ReadError>([&] { read_file(""); }), ": No such file or directory");
}

TEST(AtomicFile, RefusesToReadWithoutEnd) {
    if (!fs::exists("/dev/zero")) GTEST_SKIP() << "no /dev/zero";
    EXPECT_EQ(error_message<ReadError>([] { read_file("/dev/zero", 1'000'000); }),
              "/dev/zero: File too large (at most 1000000 bytes are read)");
}

TEST(AtomicFile, AFileOfExactlyTheLimitIsRead) {
    const TemporaryFolder folder;
    for (const std::size_t size : {1U, 1000U, 65'535U, 65'536U, 65'537U, 300'000U}) {
        write_file(folder / "f", std::string(size, 'x'));
        EXPECT_EQ(read_file(folder / "f", size).size(), size);
        EXPECT_THROW(read_file(folder / "f", size - 1), ReadError) << size;
    }
}

TEST(AtomicFile, ReadsPipes) {
    const TemporaryFolder folder;
    const fs::path pipe = folder / "pipe";
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    const std::string content(300'000, 'y');
    std::thread writer([&] { write_file(pipe, content); });
    EXPECT_EQ(read_file(pipe), content);
    writer.join();
    EXPECT_TRUE(fs::is_fifo(pipe));
}

TEST(AtomicFile, SaysWhyAFileCannotBeWritten) {
    const TemporaryFolder folder;
    const std::string orphan = (folder / "no" / "f").string();
    const auto both = [&](const fs::path& file) {
        const std::string text = error_message<WriteError>([&] { write_file(file, "x"); });
        EXPECT_EQ(error_message<WriteError>([&] { require_writable(file); }), text);
        return text;
    };
    EXPECT_EQ(both(orphan), orphan + ": No such file or directory");
    EXPECT_EQ(both(folder.path()), folder.path().string() + ": Is a directory");
    EXPECT_EQ(both(folder / "new/"), (folder / "new/").string() + ": No such file or directory");
    EXPECT_EQ(both(""), ": No such file or directory");
    EXPECT_EQ(folder.entries(), 0);
}

TEST(AtomicFile, AWritableFileIsNotTouchedByTheQuestion) {
    const TemporaryFolder folder;
    require_writable(folder / "new");
    EXPECT_EQ(folder.entries(), 0);
    write_file(folder / "old", "content");
    require_writable(folder / "old");
    EXPECT_EQ(read_file(folder / "old"), "content");
    require_writable("/dev/null");
}

TEST(AtomicFile, AFullDeviceIsAnError) {
    if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full";
    EXPECT_EQ(error_message<WriteError>([] { write_file("/dev/full", "x"); }),
              "/dev/full: No space left on device");
}

/// How the child ends that does this.
template <class Work>
int end_of_child(const Work& work) {
    const pid_t child = ::fork();
    if (child == 0) {
        work();
        ::_exit(0);
    }
    int status = 0;
    EXPECT_EQ(::waitpid(child, &status, 0), child);
    return status;
}

/// How a process ends whose write is failed half-way by a limit on the size of files, as a full
/// disk does; the signal that comes with it is not ignored by the process.
int end_of_writing_too_much(const std::filesystem::path& file) {
    return end_of_child([&] {
        std::signal(SIGXFSZ, SIG_DFL);
        const rlimit limit{1000, 1000};
        ::setrlimit(RLIMIT_FSIZE, &limit);
        try {
            write_file(file, std::string(100'000, 'n'));
        } catch (const WriteError&) {
            ::_exit(5);
        }
    });
}

TEST(AtomicFile, AFailedWriteLeavesTheOldFileAndNothingElse) {
    const TemporaryFolder folder;
    write_file(folder / "f", "old");
    const int status = end_of_writing_too_much(folder / "f");
    ASSERT_TRUE(WIFEXITED(status)) << WTERMSIG(status);
    EXPECT_EQ(WEXITSTATUS(status), 5);
    EXPECT_EQ(read_file(folder / "f"), "old");
    EXPECT_EQ(folder.entries(), 1);
}

TEST(AtomicFile, AFailedWriteOfANewFileLeavesNothing) {
    const TemporaryFolder folder;
    const int status = end_of_writing_too_much(folder / "f");
    ASSERT_TRUE(WIFEXITED(status)) << WTERMSIG(status);
    EXPECT_EQ(WEXITSTATUS(status), 5);
    EXPECT_EQ(folder.entries(), 0);
}

TEST(AtomicFile, WhateverEndsTheProcessFilesAreWholeOrNotThere) {
    const TemporaryFolder folder;
    const int probe = ::open(folder.path().c_str(), O_TMPFILE | O_WRONLY, 0600);
    if (probe < 0) GTEST_SKIP() << "no nameless files here";
    ::close(probe);
    const std::string content(1 << 22U, 'c');
    for (int round = 0; round < 5; ++round) {
        const pid_t child = ::fork();
        ASSERT_GE(child, 0);
        if (child == 0) {
            for (int i = 0; i < 1000; ++i)
                write_file(folder / (std::to_string(round) + "-" + std::to_string(i)), content);
            ::_exit(0);
        }
        ::usleep(30'000);
        ::kill(child, SIGKILL);
        int status = 0;
        ASSERT_EQ(::waitpid(child, &status, 0), child);
        for (const auto& entry : fs::directory_iterator(folder.path())) {
            EXPECT_EQ(entry.path().filename().string()[0], '0' + round);
            EXPECT_EQ(entry.file_size(), content.size());
            fs::remove(entry.path());
        }
    }
}

TEST(AtomicFile, OldFilesKeepTheirOwner) {
    if (::geteuid() != 0) GTEST_SKIP() << "only root may give files away";
    const TemporaryFolder folder;
    write_file(folder / "f", "x");
    constexpr uid_t other = 12345;
    ASSERT_EQ(::chown((folder / "f").c_str(), other, other + 1), 0);
    fs::permissions(folder / "f", fs::perms{0640});
    write_file(folder / "f", "y");
    struct stat status {};
    ASSERT_EQ(::stat((folder / "f").c_str(), &status), 0);
    EXPECT_EQ(status.st_uid, other);
    EXPECT_EQ(status.st_gid, other + 1);
    EXPECT_EQ(permissions(folder / "f"), 0640U);
}

TEST(AtomicFile, ADashIsStandardInputAndOutput) {
    const TemporaryFolder folder;
    write_file(folder / "in", "what is there");
    const int status = end_of_child([&] {
        ::dup2(::open((folder / "in").c_str(), O_RDONLY), STDIN_FILENO);
        ::dup2(::open((folder / "out").c_str(), O_WRONLY | O_CREAT, 0600), STDOUT_FILENO);
        write_file("-", read_file("-"));
        ::close(STDIN_FILENO);
        try {
            read_file("-");
        } catch (const ReadError& error) {
            write_file("-", std::string("; ") + error.what());
        }
    });
    EXPECT_EQ(status, 0);
    EXPECT_EQ(read_file(folder / "out"), "what is there; <stdin>: Bad file descriptor");
    EXPECT_EQ(input_name("-"), "<stdin>");
    EXPECT_EQ(output_name("-"), "<stdout>");
    EXPECT_EQ(input_name("./-"), "./-");
}

TEST(AtomicFile, RegularFilesAloneWhereThatIsWanted) {
    const TemporaryFolder folder;
    ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
    EXPECT_EQ(error_message<ReadError>([&] { read_regular_file(folder / "pipe"); }),
              (folder / "pipe").string() + ": not a regular file");
    write_file(folder / "f", "content");
    EXPECT_EQ(read_regular_file(folder / "f"), "content");
}

TEST(AtomicFile, NewFilesHaveThePermissionsThatTheMaskLeaves) {
    const TemporaryFolder folder;
    const mode_t old = ::umask(027);
    write_file(folder / "f", "x");
    ::umask(old);
    EXPECT_EQ(permissions(folder / "f"), 0640U);
}

TEST(AtomicFile, OldFilesKeepTheirPermissions) {
    const TemporaryFolder folder;
    write_file(folder / "f", "x");
    fs::permissions(folder / "f", fs::perms{0604});
    write_file(folder / "f", "y");
    EXPECT_EQ(permissions(folder / "f"), 0604U);
    EXPECT_EQ(read_file(folder / "f"), "y");
}

TEST(AtomicFile, AProtectedFileIsNotReplaced) {
    if (::geteuid() == 0) GTEST_SKIP() << "root may write everything";
    const TemporaryFolder folder;
    write_file(folder / "f", "x");
    fs::permissions(folder / "f", fs::perms{0444});
    EXPECT_EQ(error_message<WriteError>([&] { write_file(folder / "f", "y"); }),
              (folder / "f").string() + ": Permission denied");
    EXPECT_EQ(read_file(folder / "f"), "x");
}

TEST(AtomicFile, SymbolicLinksStayAndTheirTargetsChange) {
    const TemporaryFolder folder;
    fs::create_directory(folder / "a");
    write_file(folder / "a/target", "old");
    fs::create_symlink("a/target", folder / "link");
    fs::create_symlink("link", folder / "link2");
    fs::create_symlink("a/new", folder / "dangling");
    require_writable(folder / "link2");
    require_writable(folder / "dangling");
    write_file(folder / "link2", "new");
    write_file(folder / "dangling", "fresh");
    EXPECT_TRUE(fs::is_symlink(folder / "link"));
    EXPECT_TRUE(fs::is_symlink(folder / "link2"));
    EXPECT_TRUE(fs::is_symlink(folder / "dangling"));
    EXPECT_EQ(read_file(folder / "a/target"), "new");
    EXPECT_EQ(read_file(folder / "a/new"), "fresh");
}

TEST(AtomicFile, ALoopOfLinksIsAnError) {
    const TemporaryFolder folder;
    fs::create_symlink("b", folder / "a");
    fs::create_symlink("a", folder / "b");
    EXPECT_EQ(error_message<WriteError>([&] { write_file(folder / "a", "x"); }),
              (folder / "a").string() + ": Too many levels of symbolic links");
}

TEST(AtomicFile, AnOpenFileOfTheProcessIsWrittenInPlace) {
    const TemporaryFolder folder;
    write_file(folder / "f", "before ");
    const int descriptor = ::open((folder / "f").c_str(), O_WRONLY);
    ASSERT_GE(descriptor, 0);
    write_file("/proc/self/fd/" + std::to_string(descriptor), "after");
    ::close(descriptor);
    EXPECT_EQ(read_file(folder / "f"), "before after");
    EXPECT_EQ(folder.entries(), 1);
}

}  // namespace
}  // namespace asv::io
