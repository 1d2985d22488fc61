// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/segmentation/intensity_fit.hpp"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace segdf {
namespace {

/// Walls seen at ranges from 10 to 60 m and at any angle, each of a reflectance of its own: the
/// far ones are the brighter, as materials may be.
class Walls {
 public:
  Walls(double p, double gamma, double scale) : p_(p), gamma_(gamma), scale_(scale) {}

  IntensitySamples samples(int walls) const {
    IntensitySamples samples{IntensityConfig{}};
    std::mt19937 random(7);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    for (int w = 0; w < walls; ++w) {
      const double range = 12.0 + 40.0 * w / walls;
      add(samples, range, 0.1 + 0.01 * range, unit(random));
    }
    return samples;
  }

 private:
  /// A wall of 10 m whose surface turns away from the ray by up to 60 degrees.
  void add(IntensitySamples& samples, double start, double reflectance, double turn) const {
    Scan scan;
    Segmentation seg;
    seg.segments.resize(1);
    for (int k = 0; k < 400; ++k) {
      const double range = start + k % 20 * 0.5;
      const double angle = turn * k / 400.0 * 3.14159265 / 3.0;
      const double cosine = std::cos(angle);
      const double value =
          scale_ * reflectance * std::pow(range / 10.0, -p_) * std::pow(cosine, gamma_);
      scan.points.push_back(
          {static_cast<float>(range), 0.0F, 0.0F, static_cast<float>(value), 0.0F, -1});
      Surface surface;
      surface.normal = Eigen::Vector3d(-cosine, std::sin(angle), 0.0).cast<float>();
      surface.curvature = 0.0F;
      seg.surfaces.push_back(surface);
      seg.segments[0].points.push_back(static_cast<std::uint32_t>(k));
    }
    samples.add(scan, seg);
  }

  double p_;
  double gamma_;
  double scale_;
};

TEST(IntensityFit, FindsTheExponentsWhateverTheWallsAreMadeOf) {
  const auto fit = Walls(1.3, 0.5, 1.0).samples(40).fit();
  ASSERT_TRUE(fit);
  // Means over cells of 10 % in range and 0.1 in cosine differ a little from values at their means.
  EXPECT_NEAR(fit->range_exponent, 1.3, 0.02);
  EXPECT_NEAR(fit->incidence_exponent, 0.5, 0.02);
  EXPECT_LT(fit->range_error, 0.02);
  ASSERT_GT(fit->by_range.size(), 10U);
  for (const IntensityBin& bin : fit->by_range) {
    EXPECT_NEAR(bin.relative, std::pow(std::sqrt(bin.from * bin.to) / 10.0, -1.3),
                0.1 * bin.relative)  // a bin is 10 % wide
        << bin.from;
  }
}

TEST(IntensityFit, ProposesTheProfileOfExponentsAndScale) {
  const auto profile = [](double p, double gamma, double scale) {
    const IntensitySamples samples = Walls(p, gamma, scale).samples(40);
    const IntensityProposal proposal = samples.propose(samples.fit().value());
    EXPECT_TRUE(proposal.certain);
    return proposal.config.profile;
  };
  EXPECT_EQ(profile(0.1, 0.2, 1.0), IntensityProfile::kKittiHdl64);
  EXPECT_EQ(profile(0.0, 0.0, 100.0), IntensityProfile::kVelodyneReflectivity);
  EXPECT_EQ(profile(0.0, 0.0, 255.0), IntensityProfile::kOusterReflectivity);
  EXPECT_EQ(profile(2.0, 1.0, 1.0), IntensityProfile::kRaw);
  EXPECT_EQ(profile(2.0, 1.0, 1000.0), IntensityProfile::kOusterSignal);
}

TEST(IntensityFit, ProposesTheScaleThatAProfileDoesNotHave) {
  const IntensitySamples bytes = Walls(0.0, 0.0, 255.0).samples(40);
  EXPECT_EQ(bytes.propose(bytes.fit().value()).config.full_scale, 0.0) << "the profile's is right";
  const IntensitySamples words = Walls(0.0, 0.0, 60000.0).samples(40);
  // Reflectances reach 0.62.
  EXPECT_NEAR(words.propose(words.fit().value()).config.full_scale, 0.62 * 60000.0, 2000.0);
}

TEST(IntensityFit, BetweenTheProfilesNothingIsCertain) {
  const IntensitySamples samples = Walls(1.0, 0.5, 1.0).samples(40);
  EXPECT_FALSE(samples.propose(samples.fit().value()).certain);
}

TEST(IntensityFit, FewSurfacesOrOneAngleAreNotEnough) {
  EXPECT_FALSE(Walls(2.0, 1.0, 1.0).samples(10).fit());
  IntensitySamples nothing{IntensityConfig{}};
  EXPECT_FALSE(nothing.fit());
}

}  // namespace
}  // namespace segdf
