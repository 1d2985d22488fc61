// SPDX-License-Identifier: BSD-3-Clause
#include <benchmark/benchmark.h>

#include "segdf/simulation/simulator.hpp"

namespace {

/// One sweep of the mixed drive on one core; items are rays.
void simulateScan(benchmark::State& state, const char* sensor) {
  segdf::SimulationConfig config;
  config.sensor = sensor;
  segdf::Simulator simulator(config);
  for (auto _ : state) {
    // Anew at its end: the setup is part of no sweep.
    auto scan = simulator.next();
    benchmark::DoNotOptimize(scan);
  }
  const segdf::SensorModel model = segdf::sensorModel(sensor);
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(model.elevations.size()) *
                          model.columns);
}

BENCHMARK_CAPTURE(simulateScan, hdl64, "hdl64")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(simulateScan, hdl32, "hdl32")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(simulateScan, vlp16, "vlp16")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(simulateScan, os1_64, "os1_64")->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
