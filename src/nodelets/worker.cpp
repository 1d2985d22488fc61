// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/nodelets/worker.hpp"

#include <utility>

namespace segdf {

Worker::Worker(std::size_t capacity) : jobs_(capacity), thread_([this] { run(); }) {}

Worker::~Worker() { stop(); }

bool Worker::tryPost(Job job) {
  return jobs_.try_push_back(std::move(job)) == boost::queue_op_status::success;
}

void Worker::post(Job job) { jobs_.wait_push_back(std::move(job)); }

void Worker::stop() {
  stopping_ = true;
  jobs_.close();
  if (thread_.joinable()) thread_.join();
}

void Worker::run() {
  Job job;
  while (jobs_.wait_pull_front(job) == boost::queue_op_status::success && !stopping_) {
    job();
    job = nullptr;  // frees the messages that it holds before waiting for the next one
  }
}

}  // namespace segdf
