// SPDX-License-Identifier: GPL-3.0-or-later
// Tests files that are written whole or not at all, under kill -9 and by several writers at once.
#include "algorithms/results/write_whole.hpp"

#include <fcntl.h>
#include <sys/ioctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <random>
#include <set>
#include <thread>

#include "proptests/harness/child_process.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/harness/session.hpp"
#include "proptests/harness/temporary_folder.hpp"

// Records what is synced to the disk, in order, as long as a test listens: 'd' for a folder, 'f' for a file.
namespace {
std::string* synced = nullptr;
}
extern "C" int fsync(int descriptor) {
  struct stat about {};
  if (synced && fstat(descriptor, &about) == 0) *synced += S_ISDIR(about.st_mode) ? 'd' : 'f';
  return static_cast<int>(syscall(SYS_fsync, descriptor));
}

namespace proptests::suite_write_whole {
namespace {

using namespace refitlab;

// Returns texts that differ in every byte and in length: no part of one is another.
std::set<std::string> texts_of(char first, int count) {
  std::set<std::string> out;
  for (int i = 0; i < count; ++i) out.insert(std::string(100000 + 5000 * i, static_cast<char>(first + i)));
  return out;
}

// Writes the texts one after the other, again and again.
void write_forever(const std::string& path, const std::set<std::string>& texts, std::size_t start = 0) {
  const std::vector<std::string> list(texts.begin(), texts.end());
  for (std::size_t i = start;; ++i) write_whole(path, list[i % list.size()]);
}

std::string message_of(const std::function<void()>& f) {
  try {
    f();
  } catch (const std::runtime_error& e) {
    return e.what();
  }
  return "";
}

Checked killed_at_random_moments() {
  const TemporaryFolder folder;
  const std::string path = folder.file("results.csv");
  const std::set<std::string> texts = texts_of('a', 5);
  std::mt19937_64 random(Session::get().seed());
  const auto start = std::chrono::steady_clock::now();
  for (const std::string& text : texts) write_whole(path, text);
  // Disks differ in speed.
  const auto some_writes = std::chrono::steady_clock::now() - start;
  std::set<std::string> seen;
  // If a writer is slow to start, the moments get later until every text was seen.
  int kills = 0;
  for (; kills < 200 || (seen.size() < texts.size() && kills < 2000); ++kills) {
    const int i = kills;
    ChildProcess writer([&] { write_forever(path, texts, i); });
    std::this_thread::sleep_for(some_writes * static_cast<double>(random() % 1000) / 2000 * (1 + i / 100));
    writer.kill_now();
    const std::string found = read_whole(path);
    if (!texts.contains(found)) return {false, i, "a file of " + std::to_string(found.size()) + " bytes"};
    seen.insert(found);
  }
  return {seen.size() == texts.size(), kills, std::to_string(seen.size()) + " texts seen"};
}

Checked two_writers_and_a_reader() {
  const TemporaryFolder folder;
  const std::string path = folder.file("results.csv");
  const std::set<std::string> mine = texts_of('a', 3), yours = texts_of('p', 3);
  std::set<std::string> all = mine, seen;
  all.insert(yours.begin(), yours.end());
  write_whole(path, *mine.begin());
  ChildProcess first([&] { write_forever(path, mine); }), second([&] { write_forever(path, yours); });
  const auto start = std::chrono::steady_clock::now();
  long reads = 0;
  for (; std::chrono::steady_clock::now() - start < std::chrono::seconds(20) && seen.size() < all.size(); ++reads) {
    const std::string found = read_whole(path);
    if (!all.contains(found)) return {false, reads, "a file of " + std::to_string(found.size()) + " bytes"};
    seen.insert(found);
  }
  return {seen.size() == all.size(), reads, std::to_string(seen.size()) + " texts seen"};
}

Checked threads_of_one_process() {
  const TemporaryFolder folder;
  const std::string path = folder.file("results.csv");
  const std::set<std::string> texts = texts_of('a', 4);
  std::vector<std::thread> threads;
  std::atomic<bool> failed = false;
  for (const std::string& text : texts)
    threads.emplace_back([&, text] {
      for (int i = 0; i < 20; ++i) try {
          write_whole(path, text);
          if (!texts.contains(read_whole(path))) failed = true;
        } catch (const std::runtime_error&) {
          failed = true;
        }
    });
  for (auto& thread : threads) thread.join();
  return {!failed, 80};
}

// Checks a file that may have 1000 bytes: of a longer one less than all is written, and then nothing.
Checked full_disk() {
  const TemporaryFolder folder;
  const std::string path = folder.file("results.csv");
  write_whole(path, "old");
  rlimit before{};
  ::getrlimit(RLIMIT_FSIZE, &before);
  rlimit small = before;
  small.rlim_cur = 1000;
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  ::setrlimit(RLIMIT_FSIZE, &small);
  const std::string message = message_of([&] { write_whole(path, std::string(5000, 'x')); });
  ::setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  const std::filesystem::directory_iterator files(folder.path());
  return Checked(message == path + ": cannot write: File too large" && read_whole(path) == "old" &&
                     std::distance(begin(files), end(files)) == 1,
                 1, message);
}

// Checks devices, pipes and links. The devices are reached by a link, so that only the link is lost where a device is replaced.
Checked devices_pipes_and_links() {
  const TemporaryFolder folder;
  namespace fs = std::filesystem;
  const std::string null = folder.file("null"), full = folder.file("full"), pipe = folder.file("pipe");
  fs::create_symlink("/dev/null", null);
  fs::create_symlink("/dev/full", full);
  if (::mkfifo(pipe.c_str(), 0600) != 0) return {false, 0, "no pipe can be made"};
  write_whole(null, "x");
  const std::string message = message_of([&] { write_whole(full, "x"); });
  // It is open for both, so that nobody waits for anybody.
  const int end = ::open(pipe.c_str(), O_RDWR | O_NONBLOCK);
  write_whole(pipe, "through a pipe");
  std::string read(100, ' ');
  read.resize(static_cast<std::size_t>(std::max<ssize_t>(::read(end, read.data(), read.size()), 0)));
  ::close(end);

  const std::string link = folder.file("link"), dangling = folder.file("dangling");
  write_whole(folder.file("there/file"), "old");
  fs::create_symlink("there/file", link);
  fs::create_symlink("nowhere", dangling);
  write_whole(link, "new");
  write_whole(dangling, "in place of a link that leads nowhere");
  const bool good = fs::is_symlink(null) && fs::is_character_file(null) && fs::is_symlink(full) &&
                    message == full + ": cannot write: No space left on device" && fs::is_fifo(pipe) &&
                    read == "through a pipe" && fs::is_symlink(link) && read_whole(folder.file("there/file")) == "new" &&
                    fs::is_regular_file(fs::symlink_status(dangling)) && read_whole(dangling).starts_with("in place");
  return {good, 5, message + "; " + read};
}

// Checks a writer that waits for the reader of a full pipe, while signals interrupt it before the next byte is written.
Checked interrupted_by_signals() {
  const TemporaryFolder folder;
  const std::string pipe = folder.file("pipe");
  std::string text(300000, ' '), read;  // This is more than the pipe holds.
  for (std::size_t i = 0; i < text.size(); ++i) text[i] = static_cast<char>('a' + i % 23);
  if (::mkfifo(pipe.c_str(), 0600) != 0) return {false, 0, "no pipe can be made"};
  const int end = ::open(pipe.c_str(), O_RDWR | O_NONBLOCK);
  struct sigaction handled {
  }, before{};
  handled.sa_handler = [](int) {};  // The handler is set without SA_RESTART.
  ::sigaction(SIGUSR1, &handled, &before);
  const auto pause = [] { std::this_thread::sleep_for(std::chrono::milliseconds(5)); };
  const auto start = std::chrono::steady_clock::now();
  const auto is_late = [&] { return std::chrono::steady_clock::now() - start > std::chrono::seconds(20); };
  bool is_done = false;
  {
    ChildProcess writer([&] { write_whole(pipe, text); });
    int waiting = 0;
    // Nothing more is written.
    for (int full = 0; full < 4 && !is_late(); pause()) {
      const int were = waiting;
      ::ioctl(end, FIONREAD, &waiting);
      full = waiting > 0 && waiting == were ? full + 1 : 0;
    }
    for (int i = 0; i < 10; ++i, pause()) ::kill(writer.id(), SIGUSR1);
    std::string part(10000, ' ');
    siginfo_t ended{};
    while (read.size() < text.size() && !is_late()) {
      const ssize_t size = ::read(end, part.data(), part.size());
      if (size > 0) read.append(part, 0, static_cast<std::size_t>(size));
      // The pipe is empty then.
      else if (ended.si_pid != 0) break;
      else ::waitid(P_PID, static_cast<id_t>(writer.id()), &ended, WEXITED | WNOHANG | WNOWAIT);
    }
    is_done = read.size() == text.size() && writer.wait();
  }
  ::sigaction(SIGUSR1, &before, nullptr);
  ::close(end);
  return {is_done && read == text, 1, std::to_string(read.size()) + " bytes read"};
}

}  // namespace

PROPTEST(write_whole) {
  t.example("devices and pipes take what is written and stay; what a link leads to is written, and the link stays", {},
            devices_pipes_and_links);
  t.example("a writer that signals interrupt goes on where it was", {}, interrupted_by_signals);
  t.example("a file's bytes are on the disk before its name is, and its name when writing ends", {}, [] {
    const TemporaryFolder folder;
    std::string order;
    synced = &order;
    write_whole(folder.file("new"), "text");
    write_whole(folder.file("new"), "other");
    synced = nullptr;
    return Checked(order == "fdfd", 2, order);
  });
  t.holds("what is written is read back, byte by byte, in place of what was there", {.cases = 50}, [] {
    const TemporaryFolder folder;
    const auto first = *rc::gen::arbitrary<std::string>(), second = *rc::gen::arbitrary<std::string>();
    const std::string path = folder.file("new/folder/results.csv");
    write_whole(path, first);
    RC_ASSERT(read_whole(path) == first);
    write_whole(path, second);
    RC_ASSERT(read_whole(path) == second);
    const std::filesystem::directory_iterator files(folder.file("new/folder"));
    RC_ASSERT(std::distance(begin(files), end(files)) == 1);  // no temporary file is left
  });
  t.example("a writer killed at random moments leaves the old file or the new one, complete", {}, killed_at_random_moments);
  t.example("a reader finds one of two writers' files, complete, whatever they do at once", {}, two_writers_and_a_reader);
  t.example("where there is no room the old file stays, alone, and the reason is told", {}, full_disk);
  t.example("threads of one process do not write into each other's temporary files", {}, threads_of_one_process);
  t.example(
      "refused, with the path and the reason, which can be told before: a folder in place of the file, a file in place of the "
      "folder",
      {}, [] {
        const TemporaryFolder folder;
        write_whole(folder.file("file"), "x");
        std::filesystem::create_directories(folder.file("folder/inside"));
        const std::string in_file = message_of([&] { write_whole(folder.file("file/results.csv"), "y"); });
        const std::string on_folder = message_of([&] { write_whole(folder.file("folder"), "y"); });
        const std::string no_file = message_of([&] { read_whole(folder.file("missing")); });
        const std::string no_text = message_of([&] { read_whole(folder.file("folder")); });
        bool is_told_before = message_of([&] { check_writable(folder.file("file/results.csv")); }) == in_file &&
                              message_of([&] { check_writable(folder.file("folder")); }) == on_folder &&
                              message_of([&] { check_writable(folder.file("file/of/no/folder")); }).ends_with("Not a directory");
        for (const char* can : {"file", "new", "new/folder/file", "folder/inside/new"})
          is_told_before = is_told_before && message_of([&] { check_writable(folder.file(can)); }).empty();
        const std::filesystem::directory_iterator files(folder.path());
        const bool good =
            is_told_before && in_file == folder.file("file/results.csv") + ": cannot write: Not a directory" &&
            on_folder == folder.file("folder") + ": cannot replace: Is a directory" &&
            no_file == folder.file("missing") + ": cannot read: No such file or directory" &&
            no_text.starts_with(folder.file("folder") + ": cannot read: ") && no_text.ends_with("Is a directory") &&
            message_of([] { read_whole("/dev/zero"); }) == "/dev/zero: cannot read: it is a device, which need not end" &&
            std::distance(begin(files), end(files)) == 2 && read_whole(folder.file("file")) == "x";
        return Checked(good, 12, in_file + "; " + on_folder + "; " + no_file + "; " + no_text);
      });
}

}  // namespace proptests::suite_write_whole
