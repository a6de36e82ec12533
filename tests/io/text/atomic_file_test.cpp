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
              "/dev/zero: File too large");
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

// A limit on the size of files fails a write half-way, as a full disk does.
TEST(AtomicFile, AFailedWriteLeavesTheOldFileAndNothingElse) {
    const TemporaryFolder folder;
    write_file(folder / "f", "old");
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
        std::signal(SIGXFSZ, SIG_IGN);
        const rlimit limit{1000, 1000};
        ::setrlimit(RLIMIT_FSIZE, &limit);
        try {
            write_file(folder / "f", std::string(100'000, 'n'));
        } catch (const WriteError&) {
            ::_exit(5);
        }
        ::_exit(0);
    }
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    EXPECT_EQ(WEXITSTATUS(status), 5);
    EXPECT_EQ(read_file(folder / "f"), "old");
    EXPECT_EQ(folder.entries(), 1);
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
