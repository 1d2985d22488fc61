// SPDX-License-Identifier: BSD-3-Clause
#include <cstring>
#include <fstream>

#include <gtest/gtest.h>

#include "segdf/report/base64.hpp"
#include "segdf/report/evidence.hpp"
#include "segdf/report/report_page.hpp"
#include "segdf/report/score_json.hpp"
#include "segdf/report/verdict_image.hpp"
#include "segdf/report/view_cloud.hpp"

#include "support/expect_error.hpp"
#include "support/program.hpp"
#include "support/temp_folder.hpp"
#include <nlohmann/json.hpp>

namespace segdf {
namespace {

using test::contains;
using test::errorOf;

TEST(Base64, VectorsOfTheStandard) {  // RFC 4648, section 10
  EXPECT_EQ(encodeBase64(""), "");
  EXPECT_EQ(encodeBase64("f"), "Zg==");
  EXPECT_EQ(encodeBase64("fo"), "Zm8=");
  EXPECT_EQ(encodeBase64("foo"), "Zm9v");
  EXPECT_EQ(encodeBase64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(encodeBase64(std::string("\xff\x00\xfe", 3)), "/wD+");
}

TEST(Evidence, RemovedInstancesLargestFirstWithWhateverColumns) {
  const test::TempFolder folder;
  std::ofstream(folder / "i.csv") << "id,points,verdict,votes,new_flag\n"
                                     "1,50,dynamic,3,x\n2,900,static,0,\n3,700,dynamic,2,y\n";
  const Evidence evidence = readEvidence(folder / "i.csv");
  ASSERT_EQ(evidence.columns.size(), 5U);
  ASSERT_EQ(evidence.removed.size(), 2U);
  EXPECT_EQ(evidence.removed[0], (std::vector<std::string>{"3", "700", "dynamic", "2", "y"}));
  EXPECT_EQ(evidence.removed[1][0], "1");
}

TEST(Evidence, AForeignFileIsToldInOneLine) {
  const test::TempFolder folder;
  std::ofstream(folder / "i.csv") << "id,points\n1,2\n";
  EXPECT_TRUE(contains(errorOf([&] { readEvidence(folder / "i.csv"); }), "no column 'verdict'"));
  EXPECT_TRUE(contains(errorOf([&] { readEvidence(folder / "none"); }), "cannot read"));
}

std::int16_t int16At(const std::string& bytes, std::size_t at) {
  std::int16_t value = 0;
  std::memcpy(&value, bytes.data() + at, sizeof(value));
  return value;
}

TEST(ViewCloud, PacksPointsAsDocumented) {
  ViewCloud cloud;
  cloud.add({{-50.0F, 0.0F, 0.0F}, 252, 7, 200, PointFate::kKeptMoving});
  cloud.add({{50.0F, 10.0F, 4.0F}, 40, 300, 10, PointFate::kKeptStatic});
  const PackedCloud packed = cloud.finish();
  ASSERT_EQ(packed.count, 2U);
  ASSERT_EQ(packed.bytes.size(), 22U);
  EXPECT_EQ(packed.classes, (std::vector<std::uint16_t>{40, 252}));
  // The static point comes first: points are ordered by fate, then by place.
  EXPECT_NEAR(packed.origin.x() + packed.step * int16At(packed.bytes, 0), 50.0, packed.step);
  EXPECT_NEAR(packed.origin.y() + packed.step * int16At(packed.bytes, 2), 10.0, packed.step);
  EXPECT_NEAR(packed.origin.x() + packed.step * int16At(packed.bytes, 6), -50.0, packed.step);
  EXPECT_LT(packed.step, 0.002) << "100 m on 16 bits";
  EXPECT_EQ(int16At(packed.bytes, 12), 300) << "instances after the places";
  EXPECT_EQ(packed.bytes[16], 10) << "then intensities";
  EXPECT_EQ(packed.bytes[18], 0) << "then classes";
  EXPECT_EQ(packed.bytes[19], 1);
  EXPECT_EQ(packed.bytes[20], 0) << "then fates";
  EXPECT_EQ(packed.bytes[21], 2);
}

TEST(ViewCloud, StaysSmallAndNeverHidesAMistake) {
  ViewCloud cloud(1000);
  for (int k = 0; k < 20000; ++k) {
    const auto x = 0.05F * static_cast<float>(k % 400);
    const auto y = 0.05F * static_cast<float>(k / 400);
    cloud.add({{x, y, 0.0F}, 40, 0, 0, PointFate::kKeptStatic});
  }
  cloud.add({{5.0F, 1.0F, 0.0F}, 40, 0, 0, PointFate::kRemovedStatic});
  const PackedCloud packed = cloud.finish();
  EXPECT_LE(packed.count, 1000U);
  // A grid that widens by a fifth leaves at least (1 / 1.2)^2 of the limit on a plane.
  EXPECT_GT(packed.count, 600U);
  EXPECT_GT(packed.voxel, 0.08);
  EXPECT_EQ(packed.bytes.back(), static_cast<char>(PointFate::kRemovedStatic));
}

TEST(VerdictImage, MistakesLieOnTopInTheirColours) {
  DraftScores scores;
  for (int k = 0; k < 2000; ++k) {
    scores.points.emplace_back(0.01F * static_cast<float>(k), 0.0F, 0.0F);
    scores.verdicts.push_back(MapVerdict::kTruePositive);
  }
  scores.points.emplace_back(10.0F, 0.0F, 0.0F);
  scores.verdicts.push_back(MapVerdict::kFalsePositive);
  const RgbImage image = drawVerdicts(scores);
  std::size_t green = 0;
  std::size_t red = 0;
  for (std::size_t i = 0; i < image.rgb.size(); i += 3) {
    green += image.rgb[i + 1] > 60 && image.rgb[i] < 100 ? 1 : 0;
    red += image.rgb[i] == colourOf(MapVerdict::kFalsePositive).red ? 1 : 0;
  }
  EXPECT_EQ(red, 4U) << "one mistake is two by two pixels";
  EXPECT_NEAR(static_cast<double>(green), 400.0, 12.0) << "20 m at 0.05 m a pixel, less both ends";
  EXPECT_EQ(encodePng(image).substr(1, 3), "PNG");
  EXPECT_GT(drawVerdicts(DraftScores{}).width, 0U) << "no point at all";
}

TEST(ThreeJs, IsNamedWhenItIsMissing) {
  const test::TempFolder folder;
  EXPECT_TRUE(
      contains(errorOf([&] { readThreeJs(folder.path()); }), "install the package libjs-three"));
}

TEST(ReportPage, NothingInTheDataEndsItsScript) {
  const test::TempFolder folder;
  ReportScene scene;
  scene.scores.name = "</script><b>\xff";
  writeReport(folder / "report", {scene}, {"/* three */", "/* controls */"});
  const std::string page = test::readText(folder / "report/report.html");
  EXPECT_FALSE(contains(page, "</script><b>"));
  EXPECT_TRUE(contains(page, "<\\/script><b>"));
  EXPECT_TRUE(contains(page, "/* three */"));
  EXPECT_FALSE(contains(page, "{{")) << "every part is filled in";
  EXPECT_TRUE(contains(errorOf([&] { writeReport(folder / "report/report.html/x", {}, {}); }),
                       "cannot write to report folder"));
}

TEST(ScoreJson, ProtocolsThatWereNotRunAreLeftOut) {
  DriveScores scores;
  scores.name = "drive";
  const nlohmann::ordered_json json = toJson(scores);
  EXPECT_EQ(json["drive"], "drive");
  EXPECT_FALSE(json.contains("SA"));
  EXPECT_FALSE(json.contains("draft"));
  EXPECT_FALSE(json.contains("erasor"));
}

}  // namespace
}  // namespace segdf
