// SPDX-License-Identifier: BSD-3-Clause
// Every stage of segmentation and classification on one core, beside PCL's Euclidean clustering of
// the same points. Only ratios within one run mean anything on a shared machine.
#include <benchmark/benchmark.h>
#include <pcl/features/esf.h>

#include "segdf/classification/classifier.hpp"
#include "segdf/classification/features.hpp"
#include "segdf/classification/shape_histogram.hpp"
#include "segdf/segmentation/carving.hpp"
#include "segdf/segmentation/ground.hpp"
#include "segdf/segmentation/intensity.hpp"
#include "segdf/segmentation/segmenter.hpp"

#include "run_app.hpp"
#include "support/benchmark_scan.hpp"
#include "support/euclidean_yardstick.hpp"

namespace {

using namespace segdf;

/// One scan and everything that is made of it, computed once.
struct Fixture {
  Config config;
  Scan scan = test::benchmarkScan();
  std::vector<PointRole> used = selectPoints(scan.points, config.input);
  RangeImage image{scan.points, used, config.range_image};
  Ground ground =
      extractGround(scan.points, used, image.turns(), config.ground, config.range_image, 1);
  StageTimes times;
  Segmentation seg = segmentScan(scan, config, 1, times);
  std::vector<float> intensity = calibrateIntensity(scan.points, seg.surfaces, config.intensity);
  CurvedGrid grid{config.cvi, config.input.min_range};
};

Fixture& fixture() {
  static Fixture instance;
  return instance;
}

std::vector<KeyedPoint> objectKeys(const Fixture& f) {
  std::vector<KeyedPoint> items;
  for (std::uint32_t i = 0; i < f.scan.points.size(); ++i) {
    if (f.seg.roles[i] != PointRole::kObject) continue;
    const auto key = f.grid.keyOf(f.scan.points[i].position().cast<double>());
    if (key) items.emplace_back(*key, i);
  }
  return items;
}

/// What segmentScan has after stage 2, on the ground that it found.
Segmentation clustered(const Fixture& f) {
  Segmentation seg;
  seg.roles = f.seg.roles;
  seg.height = f.seg.height;
  seg.voxels = buildCurvedVoxels(objectKeys(f), f.intensity);
  seg.clusters = clusterVoxels(f.scan.points, f.intensity, seg.voxels, f.grid, f.config.cvi);
  return seg;
}

void carve(const Fixture& f, Segmentation& seg) {
  carveClusters(f.scan.points, f.image, seg.height, f.config, seg.voxels, seg.clusters);
}

pcl::ESFSignature640 esfByPcl(const std::vector<Point>& points,
                              const std::vector<std::uint32_t>& indices) {
  pcl::PointCloud<pcl::PointXYZ>::Ptr cloud(new pcl::PointCloud<pcl::PointXYZ>);
  for (std::uint32_t i : indices) cloud->push_back({points[i].x, points[i].y, points[i].z});
  pcl::ESFEstimation<pcl::PointXYZ, pcl::ESFSignature640> estimation;
  estimation.setInputCloud(cloud);
  pcl::PointCloud<pcl::ESFSignature640> result;
  estimation.compute(result);
  return result.front();
}

/// Registers `body(fixture)` as a benchmark.
template <class Body>
void add(const char* name, const Body& body) {
  benchmark::RegisterBenchmark(name, [body](benchmark::State& state) {
    Fixture& f = fixture();
    for (auto _ : state) benchmark::DoNotOptimize(body(f));
  })->Unit(benchmark::kMillisecond);
}

void addSegmentation() {
  add("select points", [](Fixture& f) { return selectPoints(f.scan.points, f.config.input); });
  add("ground", [](Fixture& f) {
    return extractGround(f.scan.points, f.used, f.image.turns(), f.config.ground,
                         f.config.range_image, 1);
  });
  add("height over ground",
      [](Fixture& f) { return heightOverGround(f.scan.points, f.ground, f.config.ground.l_max); });
  add("range image",
      [](Fixture& f) { return RangeImage(f.scan.points, f.seg.roles, f.config.range_image); });
  add("normals", [](Fixture& f) {
    return estimateSurfaces(f.scan.points, f.seg.roles, f.image, f.config.range_image, 1);
  });
  add("intensity", [](Fixture& f) {
    return calibrateIntensity(f.scan.points, f.seg.surfaces, f.config.intensity);
  });
  add("curved voxels", [](Fixture& f) { return buildCurvedVoxels(objectKeys(f), f.intensity); });
  add("stages 1 and 2", [](Fixture& f) {
    return clusterVoxels(f.scan.points, f.intensity, f.seg.voxels, f.grid, f.config.cvi);
  });
  add("curved voxels + stages 1 and 2", [](Fixture& f) {
    const CurvedVoxels voxels = buildCurvedVoxels(objectKeys(f), f.intensity);
    return clusterVoxels(f.scan.points, f.intensity, voxels, f.grid, f.config.cvi);
  });
  add("curved voxels + stages 1 and 2 + carving", [](Fixture& f) {
    Segmentation seg = clustered(f);
    carve(f, seg);
    return seg.clusters.count;
  });
  add("curved voxels + stages 1 and 2 + carving + vehicles", [](Fixture& f) {
    Segmentation seg = clustered(f);
    carve(f, seg);
    completeVehicles(f.scan, f.image, f.config, f.grid, seg);
    return seg.clusters.count;
  });
  add("YARDSTICK PCL VoxelGrid + EuclideanClusterExtraction", [](Fixture& f) {
    return test::clusterEuclidean(test::objectCloud(f.scan.points, f.seg.roles)).of_thinned.size();
  });
  add("whole segmentation", [](Fixture& f) { return segmentScan(f.scan, f.config, 1, f.times); });
}

void addClassification() {
  add("features of all segments", [](Fixture& f) {
    const PointAttributes attributes{f.scan.points, f.seg.height, f.seg.row, f.seg.column,
                                     f.seg.surfaces};
    for (Segment& segment : f.seg.segments) describeSegment(attributes, segment);
    return f.seg.segments.size();
  });
  add("shape histogram of one segment (mean)", [](Fixture& f) {
    static std::size_t next = 0;
    return shapeHistogram(f.scan.points, f.seg.segments[next++ % f.seg.segments.size()].points);
  });
  add("YARDSTICK PCL ESFEstimation of one segment (mean)", [](Fixture& f) {
    static std::size_t next = 0;
    return esfByPcl(f.scan.points, f.seg.segments[next++ % f.seg.segments.size()].points);
  });
  add("classes of all segments", [](Fixture& f) {
    for (Segment& s : f.seg.segments) {
      s.object_class = classify(s.features, s.points.size(), f.config.classes);
    }
    return f.seg.segments.size();
  });
}

}  // namespace

int main(int argc, char** argv) {
  segdf::apps::keepFreedMemory();
  benchmark::Initialize(&argc, argv);
  addSegmentation();
  addClassification();
  const Fixture& f = fixture();
  std::cerr << f.scan.points.size() << " points, " << f.seg.voxels.points.size() << " not ground, "
            << f.seg.voxels.size() << " voxels, " << f.seg.segments.size() << " segments\n";
  benchmark::RunSpecifiedBenchmarks();
}
