/// \file
/// Numbered tasks on a few threads, and large arrays made by them.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include "base/page_pieces.hpp"

namespace unsliver::octree {

/// Calls work(task, worker) once for each task in 0..count-1, worker in 0..threads-1; worker 0 is the calling
/// thread. An exception stops the others at their next task; that of the first task that fails, which is the
/// same for any number of threads, is thrown when all have ended.
template <class Work>
void for_each_task(std::size_t count, unsigned threads, const Work& work) {
  std::atomic<std::size_t> next{0};
  std::size_t failed_task = count;
  std::exception_ptr failure;
  std::mutex failure_guard;
  const auto attempt = [&](std::size_t task, unsigned worker) {
    try {
      work(task, worker);
    } catch (...) {
      next.store(count);
      const std::lock_guard lock(failure_guard);
      if (task < failed_task) failed_task = task, failure = std::current_exception();
    }
  };
  const auto run = [&](unsigned worker) {
    for (std::size_t task; (task = next.fetch_add(1)) < count;) attempt(task, worker);
  };
  std::vector<std::thread> others;
  for (unsigned worker = 1; worker < std::min<std::size_t>(threads, count); ++worker)
    others.emplace_back(run, worker);
  run(0);
  for (std::thread& thread : others) thread.join();
  if (failure) std::rethrow_exception(failure);
}

/// array.resize(n) for an empty array.
template <class T>
void resize_together(std::vector<T>& array, std::size_t n, unsigned threads) {
  array.reserve(n);
  const PagePieces pieces(array.data(), n * sizeof(T));
  for_each_task(pieces.count(), threads, [&](std::size_t piece, unsigned) { pieces.populate(piece); });
  array.resize(n);
}

}  // namespace unsliver::octree
