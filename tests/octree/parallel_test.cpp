// Tasks on threads: each once, and the same failure for any number of threads.
#include "octree/parallel.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdint>

namespace unsliver::octree {
namespace {

TEST(Parallel, EachTaskOnceByAWorkerThatExists) {
  for (const unsigned threads : {1u, 2u, 5u})
    for (const std::size_t count : {0u, 1u, 3u, 1000u}) {
      std::vector<int> calls(count);
      std::vector<unsigned> workers(count);
      for_each_task(count, threads, [&](std::size_t task, unsigned worker) {
        ++calls[task];
        workers[task] = worker;
      });
      EXPECT_EQ(std::count(calls.begin(), calls.end(), 1), std::ptrdiff_t(count));
      for (const unsigned worker : workers) EXPECT_LT(worker, threads);
    }
}

TEST(Parallel, TheFirstFailureInOrderOfTasksIsThrown) {
  for (const unsigned threads : {1u, 2u, 5u})
    for (int repetition = 0; repetition < 50; ++repetition) {
      const auto work = [](std::size_t task, unsigned) {
        if (task == 7) std::this_thread::sleep_for(std::chrono::microseconds(200));
        if (task >= 7) throw task;
      };
      try {
        for_each_task(100, threads, work);
        ADD_FAILURE() << "nothing thrown";
      } catch (const std::size_t task) {
        EXPECT_EQ(task, 7u);
      }
    }
}

TEST(Parallel, ResizeTogetherGivesZeros) {
  for (const unsigned threads : {1u, 3u})
    for (const std::size_t n : {0u, 10u, 5'000'001u}) {
      std::vector<std::uint64_t> array;
      resize_together(array, n, threads);
      ASSERT_EQ(array.size(), n);
      EXPECT_EQ(std::count(array.begin(), array.end(), 0u), std::ptrdiff_t(n));
    }
}

}  // namespace
}  // namespace unsliver::octree
