// SPDX-License-Identifier: BSD-3-Clause
// Chooses the intensity profile of an unknown sensor from a drive (method.md 3.5).
#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <string>

#include "segdf/io/intensity_plot.hpp"
#include "segdf/segmentation/intensity_fit.hpp"
#include "segdf/segmentation/segmenter.hpp"

#include "drive_input.hpp"
#include "run_app.hpp"

namespace {

using namespace segdf;

struct Options {
  apps::DriveInput input;
  std::filesystem::path plot;
  std::size_t scans = 40;
  int threads = 1;
};

/// Samples and how many scans they are from.
struct Gathered {
  IntensitySamples samples;
  std::size_t scans = 0;
};

/// Takes scans from all over the drive: neighbouring ones show the same surfaces.
Gathered gather(ScanSource& source, const Options& options) {
  std::optional<Scan> scan = source.next();
  if (!scan) throw IoError("no scan in " + source.describe());
  const Config config = apps::configureDrive(options.input, scan).config;
  Gathered gathered{IntensitySamples(config.intensity), 0};
  const std::size_t step = std::max<std::size_t>(1, source.size() / options.scans);
  for (std::size_t i = 0; scan; scan = source.next(), ++i) {
    if (i % step != 0) continue;
    StageTimes times;
    gathered.samples.add(*scan, segmentScan(*scan, config, options.threads, times));
    if (++gathered.scans == options.scans) break;
  }
  return gathered;
}

IntensityFit fitOf(const Gathered& gathered, const std::string& drive) {
  const IntensitySamples& samples = gathered.samples;
  if (!(samples.greatest() > 0.0)) {
    throw IoError("no intensity above 0 in " + std::to_string(gathered.scans) + " scans of " +
                  drive + ": the field is there but empty; take the driver's intensity output");
  }
  const std::optional<IntensityFit> fit = samples.fit();
  if (fit) return *fit;
  throw IoError("too little to fit in " + std::to_string(gathered.scans) + " scans of " + drive +
                ": " + std::to_string(samples.surfaces()) +
                " smooth surfaces are seen over a span of range and angle; take more scans, of a "
                "street with walls and parked cars");
}

void printBins(const char* what, const std::vector<IntensityBin>& bins, int digits) {
  std::cout << "# " << what << "  from     to  points  intensity of the same surface\n"
            << std::fixed;
  for (const IntensityBin& bin : bins) {
    std::cout << "# " << std::string(std::string(what).size(), ' ') << std::setprecision(digits)
              << std::setw(6) << bin.from << ' ' << std::setw(6) << bin.to << ' ' << std::setw(7)
              << bin.points << "  " << std::setprecision(3) << bin.relative << '\n';
  }
}

void print(const Gathered& gathered, const IntensityFit& fit, const IntensityProposal& proposal) {
  const IntensitySamples& samples = gathered.samples;
  const IntensityConfig& config = proposal.config;
  std::cout << std::fixed << std::setprecision(2) << "# " << gathered.scans << " scans, "
            << samples.points() << " points on smooth surfaces from " << config.r_near << " to "
            << config.r_cap << " m, " << samples.surfaces() << " surfaces\n"
            << "# values: median " << samples.quantile(0.5) << ", 95 % " << samples.quantile(0.95)
            << ", greatest " << samples.greatest() << "\n"
            << "# fit of log I = a_surface - p log R + gamma log(cos alpha): p = "
            << fit.range_exponent << " +- " << fit.range_error
            << ", gamma = " << fit.incidence_exponent << " +- " << fit.incidence_error << "\n";
  printBins("range, m", fit.by_range, 1);
  printBins("cosine  ", fit.by_cosine, 1);
  std::cout << "# 99 % of calibrated values are below " << formatNumber(proposal.full_scale)
            << "\nintensity:\n  profile: " << nameOf(config.profile, IntensityConfig::kProfiles)
            << '\n';
  if (config.full_scale > 0.0) {
    std::cout << "  full_scale: " << formatNumber(config.full_scale) << '\n';
  }
}

int run(const Options& options) {
  const std::unique_ptr<ScanSource> source = apps::openDrive(options.input);
  const Gathered gathered = gather(*source, options);
  const IntensityFit fit = fitOf(gathered, source->describe());
  const IntensityProposal proposal = gathered.samples.propose(fit);
  if (!options.plot.empty()) writeIntensityPlot(options.plot, fit, proposal.config);
  print(gathered, fit, proposal);
  if (!proposal.certain) {
    apps::warn(
        "the fit is far from, or between, the exponents of all profiles: the nearest is "
        "proposed; look at the table, or try another drive");
  }
  return apps::kOk;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app(
      "Chooses the intensity profile of an unknown sensor: prints how intensity depends on range "
      "and incidence angle, and lines for --config of segdf_offline.",
      "segdf_fit_intensity");
  Options options;
  apps::addDriveOptions(app, options.input);
  app.add_option("--plot", options.plot, "PNG to draw the fit into");
  app.add_option("--scans", options.scans, "scans to look at, from all over the drive (default 40)")
      ->check(CLI::Range(1, 1000000));
  app.add_option("--threads", options.threads, "worker threads (default 1)")
      ->check(CLI::Range(1, 256));
  app.callback([&options] { apps::checkDriveOptions(options.input); });
  return apps::runApp(app, argc, argv, [&options] { return run(options); });
}
