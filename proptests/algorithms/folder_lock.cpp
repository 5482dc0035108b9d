// SPDX-License-Identifier: GPL-3.0-or-later
// Tests that there is one run at a time in a folder, however the last one ended.
#include "experiments/resume/folder_lock.hpp"

#include <unistd.h>

#include <atomic>
#include <barrier>
#include <chrono>
#include <cstdio>
#include <optional>
#include <thread>

#include "algorithms/results/write_whole.hpp"
#include "proptests/harness/child_process.hpp"
#include "proptests/harness/harness.hpp"
#include "proptests/harness/temporary_folder.hpp"

namespace proptests::suite_folder_lock {
namespace {

using namespace refitlab;

// Returns why the folder cannot be had, or nothing if it can.
std::string refusal(const std::string& folder) {
  try {
    const FolderLock lock(folder);
  } catch (const std::runtime_error& e) {
    return e.what();
  }
  return "";
}

// Starts a run that holds the folder until it is killed.
void hold(const std::string& folder) {
  const FolderLock lock(folder);
  write_whole(folder + "/held", "");
  for (;;) pause();
}

}  // namespace

PROPTEST(folder_lock) {
  t.example("a folder that is held is refused, with its name and the process that holds it", {}, [] {
    const TemporaryFolder folder;
    std::optional<FolderLock> lock(folder.file("units"));
    const std::string held = refusal(folder.file("units"));
    const bool other_is_free = refusal(folder.file("other")).empty();
    lock.reset();
    const std::string mine = folder.file("units") + ": in use by another run, process " + std::to_string(getpid());
    return Checked(held == mine && other_is_free && refusal(folder.file("units")).empty(), 3, held);
  });
  t.example("a run killed by kill -9 holds its folder no longer", {}, [] {
    const TemporaryFolder folder;
    for (int i = 0; i < 20; ++i) {
      ChildProcess run([&] { hold(folder.path()); });
      while (!std::filesystem::exists(folder.file("held"))) std::this_thread::sleep_for(std::chrono::milliseconds(1));
      const std::string held = refusal(folder.path());
      run.kill_now();
      std::filesystem::remove(folder.file("held"));
      if (held.find("process " + std::to_string(run.id())) == std::string::npos || !refusal(folder.path()).empty())
        return Checked(false, i, held);
    }
    return Checked(true, 20);
  });
  t.example("threads that want one folder have it one at a time, each in the end, and are refused for no other reason", {}, [] {
    const TemporaryFolder folder;
    // A thread asks until it has had the folder so often. The scheduler decides how many refusals that takes.
    constexpr int threads = 8, times = 25;
    std::atomic<int> inside = 0, together = 0, refused = 0, strange = 0;
    std::barrier start(threads);
    {
      std::vector<std::jthread> all;
      for (int i = 0; i < threads; ++i)
        all.emplace_back([&] {
          start.arrive_and_wait();
          for (int held = 0; held < times && strange == 0;) try {
              const FolderLock lock(folder.path());
              together += ++inside > 1;
              std::this_thread::yield();
              ++held, --inside;
            } catch (const std::runtime_error& e) {
              ++refused;
              strange += !std::string(e.what()).starts_with(folder.path() + ": in use by another run");
              std::this_thread::yield();
            }
        });
    }
    return Checked(together == 0 && strange == 0, threads * times, std::to_string(refused.load()) + " times refused");
  });
  t.example("what an earlier run wrote into the lock, longer than a process's number, is not part of the next refusal", {}, [] {
    const TemporaryFolder folder;
    write_whole(folder.file("lock"), "99999999999999 and more");
    const FolderLock lock(folder.path());
    const std::string message = refusal(folder.path());
    return Checked(message == folder.path() + ": in use by another run, process " + std::to_string(getpid()), 1, message);
  });
  t.example("a program that is started meanwhile and goes on does not hold the folder", {}, [] {
    const TemporaryFolder folder;
    std::optional<FolderLock> lock(folder.path());
    std::FILE* const program = popen("cat > /dev/null", "w");  // It runs until it is closed.
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    lock.reset();
    const std::string message = refusal(folder.path());
    pclose(program);
    return Checked(message.empty(), 1, message);
  });
  t.example("a process without standard input has its folder as any other, though its lock's descriptor is 0", {}, [] {
    const TemporaryFolder folder;
    const int input = dup(STDIN_FILENO);
    close(STDIN_FILENO);
    const std::string message = refusal(folder.path());
    if (input >= 0) dup2(input, STDIN_FILENO), close(input);
    return Checked(message.empty(), 1, message);
  });
  t.example("refused, with the path and the reason: a folder that cannot be made", {}, [] {
    const TemporaryFolder folder;
    write_whole(folder.file("file"), "");
    const std::string message = refusal(folder.file("file"));
    return Checked(message == folder.file("file/lock") + ": cannot lock: Not a directory", 1, message);
  });
}

}  // namespace proptests::suite_folder_lock
