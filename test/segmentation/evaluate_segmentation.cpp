// SPDX-License-Identifier: BSD-3-Clause
// Scores ground, instances and classes of labelled drives, beside other ways of clustering.
#include <filesystem>
#include <functional>
#include <iomanip>
#include <iostream>
#include <set>
#include <string>
#include <vector>

#include "segdf/classification/classifier.hpp"
#include "segdf/classification/features.hpp"
#include "segdf/core/parallel.hpp"
#include "segdf/core/semantic_kitti.hpp"
#include "segdf/io/config_yaml.hpp"
#include "segdf/io/kitti_source.hpp"
#include "segdf/io/label_file.hpp"
#include "segdf/segmentation/segmenter.hpp"
#include "segdf/segmentation/sensor_recognition.hpp"

#include "run_app.hpp"
#include "segmentation_scores.hpp"
#include "support/euclidean_yardstick.hpp"

namespace {

using namespace segdf;
using namespace segdf::test;

struct Options {
  std::vector<std::string> drives;
  std::string sensor;
  std::string config;
  std::set<std::uint16_t> ignored;  ///< instances
  bool brief = false;
};

struct Labelled {
  Scan scan;
  std::vector<std::uint32_t> truth;
};

/// One row of the table of instances.
struct Method {
  std::string name;
  std::function<void(Config&)> change;
};

void carveNothing(Config& c) {
  c.person.jump = 0.0;
  c.bicycle.jump = 0.0;
}

/// Other ways of clustering, all without carving.
std::vector<Method> methods(bool brief) {
  std::vector<Method> all{{"segdf: stages 1 and 2, carving", [](Config&) {}}};
  if (brief) return all;
  const auto add = [&all](const char* name, auto change) {
    all.push_back({name, [change](Config& c) {
                     carveNothing(c);
                     change(c.cvi);
                   }});
  };
  add("stage 1 + stage 2 with intensity", [](auto&) {});
  add("curved voxels alone (stage 1, no intensity)", [](auto& c) { c.ext = 1; });
  add("stage 2 without intensity", [](auto& c) { c.thre_av = 1.0; });
  add("gate evidence", [](auto& c) { c.gate = IntensityGate::kEvidence; });
  add("gate literal", [](auto& c) { c.gate = IntensityGate::kLiteral; });
  add("curved voxels 0.35 m / 2 deg / 1.2 deg", [](auto& c) {
    c.drho = 0.35;
    c.dtheta = 2.0;
    c.dphi = 1.2;
    c.ext = 1;
  });
  return all;
}

/// @param ignored instances whose points are taken for unlabelled
std::vector<Labelled> load(const std::filesystem::path& drive,
                           const std::set<std::uint16_t>& ignored) {
  KittiSource source(drive);
  std::vector<Labelled> scans;
  for (std::size_t i = 0; i < source.size(); ++i) {
    Scan scan = *source.next();
    std::vector<std::uint32_t> truth = readLabels(drive / "labels" / (source.nameOf(i) + ".label"));
    if (truth.size() != scan.points.size()) {
      throw IoError("label file " + source.nameOf(i) + ".label of " + drive.string() +
                    " does not fit its scan");
    }
    for (std::uint32_t& label : truth) {
      if (ignored.count(semantic_kitti::instanceOf(label)) != 0) {
        label = semantic_kitti::kUnlabelled;
      }
    }
    scans.push_back({std::move(scan), std::move(truth)});
  }
  return scans;
}

Segmentation segment(const Scan& scan, const Config& config) {
  StageTimes times;
  Segmentation seg = segmentScan(scan, config, 1, times);
  const PointAttributes attributes{scan.points, seg.height, seg.row, seg.column, seg.surfaces};
  for (Segment& s : seg.segments) {
    describeSegment(attributes, s);
    s.object_class = classify(s.features, s.points.size(), config.classes);
  }
  return seg;
}

std::vector<std::int32_t> clusterOf(const Segmentation& seg) {
  std::vector<std::int32_t> of_point(seg.roles.size(), -1);
  for (std::size_t s = 0; s < seg.segments.size(); ++s) {
    for (std::uint32_t i : seg.segments[s].points) of_point[i] = static_cast<std::int32_t>(s);
  }
  return of_point;
}

struct Scores {
  GroundScore ground;
  ClassScore classes;
  std::vector<InstanceScore> instances;
};

void addScan(const Labelled& l, const Config& config, bool brief, Scores& scores) {
  const std::vector<Method> rows = methods(brief);
  scores.instances.resize(rows.size() + (brief ? 0 : 1));
  for (std::size_t m = 0; m < rows.size(); ++m) {
    Config changed = config;
    rows[m].change(changed);
    const Segmentation seg = segment(l.scan, changed);
    scores.instances[m].add(clusterOf(seg), seg.roles, l.truth);
    if (m > 0) continue;
    scores.ground.add(seg.roles, l.truth);
    scores.classes.add(seg, l.truth);
    if (brief) continue;
    const EuclideanClusters pcl = clusterEuclidean(objectCloud(l.scan.points, seg.roles));
    scores.instances.back().add(clusterOfPoints(pcl, l.scan.points, seg.roles), seg.roles, l.truth);
  }
}

void printGround(const GroundScore& g) {
  if (g.recall.whole > 0.0) {
    std::cout << "ground: precision " << g.precision.percent() << "  recall " << g.recall.percent()
              << "  F1 " << g.f1() << '\n';
  }
  std::cout << "labelled ground of movable instances: " << g.movable.percent() << " % of "
            << g.movable.whole << " points, of moving ones " << g.moving.percent() << " % of "
            << g.moving.whole << "\n";
}

void printInstances(const std::vector<Method>& rows, const std::vector<InstanceScore>& scores) {
  std::cout << "instances   IoU  recall  coverage  purity  clusters/scan\n";
  for (std::size_t m = 0; m < scores.size(); ++m) {
    const InstanceScore& s = scores[m];
    const auto n = static_cast<double>(std::max<std::size_t>(s.instances, 1));
    std::cout << std::setw(9) << s.instances << "  " << std::setprecision(4) << s.iou / n << "   "
              << static_cast<double>(s.found) / n << "     " << s.coverage / n << "   "
              << s.purity / n << "  " << std::setw(7) << s.clusters / s.scans << "   "
              << (m < rows.size() ? rows[m].name : "PCL VoxelGrid + EuclideanClusterExtraction")
              << std::setprecision(2) << '\n';
  }
}

void printClasses(const ClassScore& classes) {
  constexpr std::array<const char*, ClassScore::kTruths> kNames{
      "movable", "building", "vegetation", "pole, trunk, sign", "ground", "other"};
  std::cout << "percent of points     ground   noise vegetat.   build. high mob. unknown"
               " | excluded of segmented, of all\n";
  for (int t = 0; t < ClassScore::kTruths; ++t) {
    const auto truth = static_cast<ClassScore::Truth>(t);
    std::cout << std::left << std::setw(18) << kNames[static_cast<std::size_t>(t)] << std::right;
    for (double n : classes.points[static_cast<std::size_t>(t)]) {
      std::cout << std::setw(9) << 100.0 * n / std::max(1.0, classes.total(truth));
    }
    std::cout << " | " << classes.excludedOfSegmented(truth) << "  " << classes.excludedOfAll(truth)
              << '\n';
  }
}

void print(const std::string& name, const Scores& scores, bool brief) {
  std::cout << "== " << name << '\n';
  printGround(scores.ground);
  printInstances(methods(brief), scores.instances);
  printClasses(scores.classes);
}

int run(const Options& options) {
  std::cout << std::fixed << std::setprecision(2);
  Scores pooled;
  for (const std::string& drive : options.drives) {
    const std::vector<Labelled> scans = load(drive, options.ignored);
    const std::string sensor =
        options.sensor.empty() ? recogniseSensor(scans.front().scan).name : options.sensor;
    Config config = sensorConfig(sensor);
    if (!options.config.empty()) applyYamlFile(config, options.config);
    Scores scores;
    for (const Labelled& l : scans) {
      addScan(l, config, options.brief, scores);
      addScan(l, config, options.brief, pooled);
    }
    print(drive + " (" + sensor + ")", scores, options.brief);
  }
  if (options.drives.size() > 1) print("all of them", pooled, options.brief);
  return apps::kOk;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Scores ground, instances and classes of labelled drives in KITTI's layout.",
               "segdf_evaluate_segmentation");
  Options options;
  app.add_option("drives", options.drives, "folders with velodyne/, labels/ and poses")->required();
  app.add_option("--sensor", options.sensor,
                 "hdl64, hdl32, vlp16 or os1_64; recognised if not given");
  app.add_option("--config", options.config, "YAML with parameters that differ from the sensor's");
  app.add_option("--ignore", options.ignored,
                 "instances to count as unlabelled, IDS with commas between")
      ->delimiter(',');
  app.add_flag("--brief", options.brief, "no other methods beside");
  return apps::runApp(app, argc, argv, [&options] { return run(options); });
}
