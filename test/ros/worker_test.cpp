// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/nodelets/worker.hpp"

#include <future>
#include <numeric>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

namespace segdf {
namespace {

TEST(Worker, DoesJobsInTheirOrder) {
  std::vector<int> done;
  std::promise<void> last;
  Worker worker(200);
  for (int i = 0; i < 100; ++i) worker.post([&done, i] { done.push_back(i); });
  worker.post([&last] { last.set_value(); });
  last.get_future().wait();
  std::vector<int> expected(100);
  std::iota(expected.begin(), expected.end(), 0);
  EXPECT_EQ(done, expected);
}

TEST(Worker, RefusesMoreThanMayWait) {
  std::promise<void> started;
  std::promise<void> open;
  std::shared_future<void> gate = open.get_future().share();
  Worker worker(2);
  worker.post([&started, gate] {
    started.set_value();
    gate.wait();
  });
  started.get_future().wait();
  EXPECT_TRUE(worker.tryPost([] {}));
  EXPECT_TRUE(worker.tryPost([] {}));
  EXPECT_FALSE(worker.tryPost([] {}));
  open.set_value();
}

TEST(Worker, DropsWhatWaitsWhenItEnds) {
  std::promise<void> started;
  std::promise<void> open;
  std::shared_future<void> gate = open.get_future().share();
  bool late = false;
  std::optional<Worker> worker(std::in_place, 2U);
  worker->post([&started, gate] {
    started.set_value();
    gate.wait();
  });
  worker->post([&late] { late = true; });
  started.get_future().wait();
  std::future<void> ended = std::async(std::launch::async, [&worker] { worker.reset(); });
  // Ends only after the job at hand: give the other thread its time to get there.
  EXPECT_EQ(ended.wait_for(std::chrono::milliseconds(100)), std::future_status::timeout);
  open.set_value();
  ended.wait();
  EXPECT_FALSE(late);
}

TEST(Worker, TakesNothingAfterItHasStopped) {
  Worker worker(2);
  worker.stop();
  bool done = false;
  EXPECT_FALSE(worker.tryPost([&done] { done = true; }));
  worker.post([&done] { done = true; });
  EXPECT_FALSE(done);
}

}  // namespace
}  // namespace segdf
