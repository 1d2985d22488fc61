// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <thread>

#include <boost/thread/concurrent_queues/sync_bounded_queue.hpp>

namespace segdf {

/// One thread that does jobs in the order in which they were posted, with a bounded number waiting.
class Worker {
 public:
  using Job = std::function<void()>;

  /// @param capacity jobs that may wait, at least 1
  explicit Worker(std::size_t capacity);
  ~Worker();
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  /// @return false, and the job is not taken, if as many wait as may, or after stop()
  bool tryPost(Job job);

  /// Waits until there is room. After stop() the job is dropped.
  void post(Job job);

  /// Ends the job at hand; those that still wait are dropped.
  void stop();

 private:
  void run();

  std::atomic<bool> stopping_{false};
  boost::concurrent::sync_bounded_queue<Job> jobs_;
  std::thread thread_;
};

}  // namespace segdf
