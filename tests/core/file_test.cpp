#include "tristim/core/file.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <csignal>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <thread>
#include <vector>

#include "lib/core/temporary_name.h"
#include "tests/support.h"
#include "tristim/core/error.h"

namespace tristim {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> names_in(const fs::path& directory) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(directory)) {
    names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

using Names = std::vector<std::string>;

/// The Error that `call` throws.
template <typename Call>
Error error_of(Call call) {
  try {
    call();
  } catch (const Error& error) {
    return error;
  }
  return Error(ErrorKind::kGate, "test", "nothing was thrown");
}

template <typename Call>
void expect_system_error(Call call, const std::string& text) {
  const Error error = error_of(call);
  EXPECT_EQ(error.what(), text);
  EXPECT_EQ(error.kind(), ErrorKind::kSystem);
}

void write_file(const std::string& path, std::string_view text, bool replace = false) {
  OutputFile file(path, replace);
  file.write(text);
  file.commit();
}

/// Ignores a signal that would end the tests.
class Ignored {
 public:
  explicit Ignored(int signal) : signal_(signal), old_(std::signal(signal, SIG_IGN)) {}
  ~Ignored() { std::signal(signal_, old_); }
  Ignored(const Ignored&) = delete;
  Ignored& operator=(const Ignored&) = delete;

 private:
  int signal_;
  void (*old_)(int);
};

/// Both ways to an atomic file: one without a name, and one with a temporary name beside.
class OutputFileTest : public testing::TestWithParam<bool> {
 protected:
  void SetUp() override { detail::use_unnamed_files = GetParam(); }
  void TearDown() override { detail::use_unnamed_files = true; }
  TemporaryDirectory directory_;
};

INSTANTIATE_TEST_SUITE_P(Ways, OutputFileTest, testing::Bool(), [](const auto& way) {
  return std::string(way.param ? "WithoutName" : "WithTemporaryName");
});

TEST_P(OutputFileTest, AppearsAtCommit) {
  const std::string path = directory_.file("out");
  OutputFile file(path, false);
  file.write("abc");
  EXPECT_FALSE(fs::exists(path));
  EXPECT_EQ(file.size(), 3u);
  file.commit();
  EXPECT_EQ(read_bytes(path), "abc");
  EXPECT_EQ(names_in(directory_.path()), Names{"out"});
}

TEST_P(OutputFileTest, LeavesNothingWithoutCommit) {
  {
    OutputFile file(directory_.file("out"), false);
    file.write(std::string(1 << 20, 'x'));
  }
  EXPECT_EQ(names_in(directory_.path()), Names{});
}

TEST_P(OutputFileTest, KeepsTheOrderOfSmallAndLargeWrites) {
  std::string expected;
  OutputFile file(directory_.file("out"), false);
  for (const std::size_t length : {1u, 300000u, 7u, 262144u, 262143u, 2u, 0u, 1000000u}) {
    const std::string part(length, static_cast<char>('a' + expected.size() % 26));
    file.write(part);
    expected += part;
    EXPECT_EQ(file.size(), expected.size());
  }
  file.commit();
  EXPECT_TRUE(read_bytes(directory_.file("out")) == expected);
}

TEST_P(OutputFileTest, TakesItsPermissionsFromTheUmask) {
  const mode_t old = ::umask(027);
  write_file(directory_.file("out"), "abc");
  ::umask(old);
  EXPECT_EQ(fs::status(directory_.file("out")).permissions(), fs::perms{0640});
}

TEST_P(OutputFileTest, RefusesAnExistingFile) {
  const std::string path = directory_.file("out");
  write_bytes(path, "old");
  expect_system_error([&] { OutputFile file(path, false); },
                      path + ": exists already; give --force to replace it");
  EXPECT_EQ(read_bytes(path), "old");
}

TEST_P(OutputFileTest, ReplacesAtCommit) {
  const std::string path = directory_.file("out");
  write_bytes(path, "old");
  {
    OutputFile given_up(path, true);
    given_up.write("half");
  }
  EXPECT_EQ(read_bytes(path), "old");
  OutputFile file(path, true);
  file.write("new");
  EXPECT_EQ(read_bytes(path), "old");
  file.commit();
  EXPECT_EQ(read_bytes(path), "new");
  EXPECT_EQ(names_in(directory_.path()), Names{"out"});
}

TEST_P(OutputFileTest, DoesNotReplaceWhatCameIntoBeingMeanwhile) {
  const std::string path = directory_.file("out");
  {
    OutputFile file(path, false);
    file.write("late");
    write_bytes(path, "first");
    expect_system_error([&] { file.commit(); },
                        path + ": exists already; give --force to replace it");
  }
  EXPECT_EQ(read_bytes(path), "first");
  EXPECT_EQ(names_in(directory_.path()), Names{"out"});
}

TEST_P(OutputFileTest, ReplacesWhatCameIntoBeingMeanwhile) {
  const std::string path = directory_.file("out");
  OutputFile file(path, true);
  file.write("late");
  write_bytes(path, "first");
  file.commit();
  EXPECT_EQ(read_bytes(path), "late");
  EXPECT_EQ(names_in(directory_.path()), Names{"out"});
}

TEST_P(OutputFileTest, LetsOneOfManyWritersWin) {
  const std::string path = directory_.file("out");
  std::atomic<int> done{0};
  std::atomic<int> refused{0};
  std::vector<std::thread> writers;
  for (int i = 0; i < 16; ++i) {
    writers.emplace_back([&, i] {
      try {
        write_file(path, std::string(1000, static_cast<char>('a' + i)));
        ++done;
      } catch (const Error&) {
        ++refused;
      }
    });
  }
  for (std::thread& writer : writers) writer.join();
  EXPECT_EQ(done, 1);
  EXPECT_EQ(refused, 15);
  const std::string text = read_bytes(path);
  EXPECT_EQ(text, std::string(1000, text.at(0)));
  EXPECT_EQ(names_in(directory_.path()), Names{"out"});
}

TEST_P(OutputFileTest, WritesThroughASymbolicLink) {
  fs::create_directory(directory_.path() / "far");
  write_bytes(directory_.path() / "far/target", "old");
  fs::create_symlink("far/target", directory_.path() / "link");
  fs::create_symlink("link", directory_.path() / "link of link");
  write_file(directory_.file("link of link"), "new", true);
  EXPECT_EQ(read_bytes(directory_.path() / "far/target"), "new");
  EXPECT_TRUE(fs::is_symlink(directory_.path() / "link"));
  EXPECT_EQ(names_in(directory_.path() / "far"), Names{"target"});
}

TEST_P(OutputFileTest, MakesTheTargetOfADanglingLinkOnlyWithForce) {
  const std::string link = directory_.file("link");
  fs::create_symlink("target", link);
  expect_system_error([&] { OutputFile file(link, false); },
                      link + ": exists already; give --force to replace it");
  write_file(link, "new", true);
  EXPECT_EQ(read_bytes(directory_.path() / "target"), "new");
  EXPECT_TRUE(fs::is_symlink(link));
}

TEST_P(OutputFileTest, LeavesNothingOnAFullDisk) {
  const Ignored ignored(SIGXFSZ);
  const std::string path = directory_.file("out");
  rlimit old{};
  ::getrlimit(RLIMIT_FSIZE, &old);
  const rlimit small{100000, old.rlim_max};
  ::setrlimit(RLIMIT_FSIZE, &small);
  std::optional<OutputFile> file;
  file.emplace(path, false);
  const Error error = error_of([&] { file->write(std::string(1 << 20, 'x')); });
  const Error again = error_of([&] { file->commit(); });
  ::setrlimit(RLIMIT_FSIZE, &old);
  file.reset();
  EXPECT_EQ(
      error.what(),
      path + ": cannot write: file too large; raise the limit (ulimit -f) or write elsewhere");
  EXPECT_EQ(again.what(), path + ": was not written completely");
  EXPECT_EQ(names_in(directory_.path()), Names{});
}

TEST_P(OutputFileTest, OverwritesAtAPosition) {
  const std::string path = directory_.file("out");
  OutputFile file(path, false);
  file.write("0123456789");
  file.write_at(2, std::as_bytes(std::span(std::string_view("ab"))));
  file.write("end");
  file.write_at(8, std::as_bytes(std::span(std::string_view("vwxyz"))));
  EXPECT_THROW(file.write_at(9, std::as_bytes(std::span(std::string_view("vwxyz")))),
               std::invalid_argument);
  file.commit();
  EXPECT_EQ(read_bytes(path), "01ab4567vwxyz");
}

TEST_P(OutputFileTest, RefusesImpossiblePlaces) {
  const std::string here = directory_.path().string();
  expect_system_error([&] { OutputFile file(here, true); },
                      here + ": is a directory; give the name of a file in it");
  expect_system_error([&] { OutputFile file(here + "/new/", true); },
                      here + "/new/: is a directory; give the name of a file in it");
  expect_system_error([&] { OutputFile file(here + "/no/out", true); },
                      here + "/no/out: there is no directory " + here + "/no; create it first");
  write_bytes(here + "/file", "x");
  expect_system_error([&] { OutputFile file(here + "/file/out", true); },
                      here + "/file/out: " + here + "/file is no directory; choose another place");
  const std::string long_name = here + "/" + std::string(300, 'n');
  expect_system_error([&] { OutputFile file(long_name, true); },
                      long_name + ": cannot be written: file name too long");
  EXPECT_EQ(error_of([] { OutputFile file("", true); }).kind(), ErrorKind::kMisuse);
}

/// Runs `call` in a child that may not do what root may; returns the text of its Error.
template <typename Call>
std::string error_without_privileges(Call call) {
  int ends[2];
  if (::pipe(ends) != 0) return "no pipe";
  const pid_t child = ::fork();
  if (child == 0) {
    constexpr uid_t kNobody = 65534;
    if (::geteuid() == 0 && ::setuid(kNobody) != 0) ::_exit(1);
    const std::string text = error_of(call).what();
    ::_exit(::write(ends[1], text.data(), text.size()) < 0 ? 1 : 0);
  }
  ::close(ends[1]);
  std::string text;
  char chunk[4096];
  for (ssize_t got = 1; got > 0;) {
    got = ::read(ends[0], chunk, sizeof chunk);
    if (got > 0) text.append(chunk, static_cast<std::size_t>(got));
  }
  ::close(ends[0]);
  ::waitpid(child, nullptr, 0);
  return text;
}

TEST_P(OutputFileTest, RefusesAWriteProtectedTargetAndDirectory) {
  const std::string path = directory_.file("out");
  write_bytes(path, "old");
  ::chmod(path.c_str(), 0444);
  ::chmod(directory_.path().c_str(), 0777);
  EXPECT_EQ(error_without_privileges([&] { OutputFile file(path, true); }),
            path + ": is write-protected; make it writable (chmod u+w) or choose another name");
  ::chmod(directory_.path().c_str(), 0555);
  const std::string other = directory_.file("other");
  EXPECT_EQ(error_without_privileges([&] { OutputFile file(other, true); }),
            other + ": cannot write in directory " + directory_.path().string() +
                ": permission denied; check the permissions");
  ::chmod(directory_.path().c_str(), 0755);
  EXPECT_EQ(names_in(directory_.path()), Names{"out"});
}

TEST(OutputFile, LeavesNothingWhenItsProcessIsKilled) {
  const TemporaryDirectory directory;
  const int unnamed = ::open(directory.path().c_str(), O_TMPFILE | O_WRONLY, 0600);
  if (unnamed < 0) GTEST_SKIP() << "this file system has no files without a name";
  ::close(unnamed);
  const pid_t child = ::fork();
  if (child == 0) {
    OutputFile file(directory.file("out"), false);
    file.write(std::string(1 << 20, 'x'));
    ::raise(SIGKILL);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_TRUE(WIFSIGNALED(status));
  EXPECT_EQ(names_in(directory.path()), Names{});
}

TEST(OutputFile, LosesItsTemporaryFilesToTheSignalHandler) {
  const TemporaryDirectory directory;
  detail::use_unnamed_files = false;
  {
    OutputFile one(directory.file("one"), false);
    OutputFile two(directory.file("two"), false);
    detail::use_unnamed_files = true;
    EXPECT_EQ(names_in(directory.path()).size(), 2u);
    remove_temporary_files();
    EXPECT_EQ(names_in(directory.path()), Names{});
  }
  write_bytes(directory.path() / "kept", "x");
  remove_temporary_files();
  EXPECT_EQ(names_in(directory.path()), Names{"kept"});
}

TEST(OutputFile, WritesDevicesDirectly) {
  write_file("/dev/null", "gone");
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST(OutputFile, TellsAFullDevice) {
  expect_system_error(
      [] { write_file("/dev/full", "abc"); },
      "/dev/full: cannot write: no space left on device; free some space or write elsewhere");
}

/// What a reader of `fifo` gets.
class FifoReader {
 public:
  explicit FifoReader(const std::string& fifo) {
    ::mkfifo(fifo.c_str(), 0600);
    thread_ = std::thread([this, fifo] { text_ = read_text_file(fifo); });
  }
  std::string text() {
    thread_.join();
    return text_;
  }

 private:
  std::string text_;
  std::thread thread_;
};

TEST(OutputFile, WritesAPipeDirectly) {
  const TemporaryDirectory directory;
  FifoReader reader(directory.file("fifo"));
  {
    OutputFile file(directory.file("fifo"), false);
    file.write("abc");
    EXPECT_THROW(file.write_at(0, std::as_bytes(std::span(std::string_view("x")))),
                 std::invalid_argument);
    file.commit();
  }
  EXPECT_EQ(reader.text(), "abc");
  EXPECT_TRUE(fs::is_fifo(directory.file("fifo")));
}

TEST(OutputFile, SpoolsWhatAPipeCannotTakeYet) {
  const TemporaryDirectory directory;
  FifoReader reader(directory.file("fifo"));
  std::string expected(1000000, 'a');
  {
    OutputFile file(directory.file("fifo"), false, true);
    file.write(expected);
    expected[500000] = 'b';
    file.write_at(500000, std::as_bytes(std::span(std::string_view("b"))));
    file.commit();
  }
  EXPECT_TRUE(reader.text() == expected);
}

TEST(OutputFile, TellsThatTheReaderOfAPipeHasEnded) {
  const Ignored ignored(SIGPIPE);
  const TemporaryDirectory directory;
  const std::string fifo = directory.file("fifo");
  ::mkfifo(fifo.c_str(), 0600);
  const int reader = ::open(fifo.c_str(), O_RDONLY | O_NONBLOCK);
  OutputFile file(fifo, false);
  ::close(reader);
  expect_system_error([&] { file.write(std::string(1 << 20, 'x')); },
                      fifo + ": cannot write: broken pipe; the program that reads it has ended");
}

/// Sends standard output to a file for a while.
class RedirectedOutput {
 public:
  explicit RedirectedOutput(const std::string& path) : saved_(::dup(STDOUT_FILENO)) {
    const int file = ::open(path.c_str(), O_CREAT | O_WRONLY, 0600);
    ::dup2(file, STDOUT_FILENO);
    ::close(file);
  }
  ~RedirectedOutput() {
    ::dup2(saved_, STDOUT_FILENO);
    ::close(saved_);
  }
  RedirectedOutput(const RedirectedOutput&) = delete;
  RedirectedOutput& operator=(const RedirectedOutput&) = delete;

 private:
  int saved_;
};

TEST(OutputFile, WritesStandardOutput) {
  const TemporaryDirectory directory;
  {
    const RedirectedOutput redirected(directory.file("out"));
    write_file("-", "abc");
    write_file("/dev/stdout", "def");
    OutputFile spooled("-", false, true);
    spooled.write("ghi");
    spooled.write_at(1, std::as_bytes(std::span(std::string_view("H"))));
    spooled.commit();
  }
  EXPECT_EQ(read_bytes(directory.file("out")), "abcdefgHi");
}

TEST(OutputFile, NamesStandardOutputInErrors) {
  const TemporaryDirectory directory;
  Error error(ErrorKind::kGate, "test", "nothing");
  {
    const RedirectedOutput redirected("/dev/full");
    error = error_of([] { write_file("-", "abc"); });
  }
  EXPECT_EQ(error.what(), std::string("standard output: cannot write: no space left on device; "
                                      "free some space or write elsewhere"));
}

TEST(ReadTextFile, ReadsAllOfIt) {
  const TemporaryDirectory directory;
  std::string text(1000000, 'x');
  text[999999] = '\n';
  write_bytes(directory.file("text"), text);
  EXPECT_TRUE(read_text_file(directory.file("text")) == text);
  EXPECT_TRUE(read_text_file(directory.file("text"), text.size()) == text);
  write_bytes(directory.file("empty"), "");
  EXPECT_EQ(read_text_file(directory.file("empty")), "");
}

TEST(ReadTextFile, RefusesWhatIsNoTextFile) {
  const TemporaryDirectory directory;
  const std::string here = directory.path().string();
  expect_system_error([&] { read_text_file(here + "/no"); },
                      here + "/no: there is no such file; check the name");
  expect_system_error([&] { read_text_file(here); },
                      here + ": is a directory; give the name of a file in it");
  write_bytes(here + "/long", "12345");
  const Error error = error_of([&] { read_text_file(here + "/long", 4); });
  EXPECT_EQ(error.what(), here + "/long: is longer than 4 bytes; give a smaller file");
  EXPECT_EQ(error.kind(), ErrorKind::kContent);
}

}  // namespace
}  // namespace tristim
