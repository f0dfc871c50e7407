/// \file
/// Numbered tasks on a few threads.
#pragma once

#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace unsliver::octree {

/// Calls work(task, worker) once for each task in 0..count-1, worker in 0..threads-1; worker 0 is the calling
/// thread. The first exception stops the others at their next task and is thrown when all have ended.
template <class Work>
void for_each_task(std::size_t count, unsigned threads, const Work& work) {
  std::atomic<std::size_t> next{0};
  std::exception_ptr failure;
  std::mutex failure_guard;
  const auto run = [&](unsigned worker) {
    try {
      for (std::size_t task; (task = next.fetch_add(1)) < count;) work(task, worker);
    } catch (...) {
      next.store(count);
      const std::lock_guard lock(failure_guard);
      if (!failure) failure = std::current_exception();
    }
  };
  std::vector<std::thread> others;
  for (unsigned worker = 1; worker < threads; ++worker) others.emplace_back(run, worker);
  run(0);
  for (std::thread& thread : others) thread.join();
  if (failure) std::rethrow_exception(failure);
}

}  // namespace unsliver::octree
