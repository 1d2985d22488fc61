// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/io/top_down_image.hpp"

#include <array>
#include <filesystem>
#include <vector>

#include <gtest/gtest.h>
#include <png.h>

#include "segdf/core/semantic_kitti.hpp"
#include "segdf/io/png_file.hpp"

#include "support/temp_folder.hpp"

namespace segdf {
namespace {

using Colour = std::array<int, 3>;

/// What a viewer shows of a PNG file.
struct Shown {
  std::size_t width = 0;
  std::size_t height = 0;
  std::vector<std::uint8_t> rgb;

  Colour at(std::size_t column, std::size_t row) const {
    const std::uint8_t* const pixel = &rgb[3 * (row * width + column)];
    return {pixel[0], pixel[1], pixel[2]};
  }
  bool holds(const Colour& colour) const {
    for (std::size_t row = 0; row < height; ++row) {
      for (std::size_t column = 0; column < width; ++column) {
        if (at(column, row) == colour) return true;
      }
    }
    return false;
  }
};

Shown show(const std::filesystem::path& file) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  EXPECT_NE(png_image_begin_read_from_file(&png, file.c_str()), 0) << png.message;
  png.format = PNG_FORMAT_RGB;
  Shown shown{png.width, png.height, std::vector<std::uint8_t>(PNG_IMAGE_SIZE(png))};
  EXPECT_NE(png_image_finish_read(&png, nullptr, shown.rgb.data(), 0, nullptr), 0) << png.message;
  return shown;
}

constexpr Colour kYellow{255, 220, 60};
constexpr Colour kWhite{255, 255, 255};
constexpr Colour kRed{255, 40, 40};

class Picture : public ::testing::Test {
 protected:
  void add(float x, float y, float z, std::uint32_t label) {
    image_.add({x, y, z, 0.5F, label, 1});
  }
  /// The colour of a place in the picture, which is 100 m on each side and 0.05 m a pixel.
  Colour colourAt(double x, double y) {
    image_.write(folder_.path() / "map.png");
    const Shown shown = show(folder_.path() / "map.png");
    return shown.at(static_cast<std::size_t>((x + 50.0) / 0.05),
                    static_cast<std::size_t>((50.0 - y) / 0.05));
  }

  test::TempFolder folder_;
  TopDownImage image_{{Eigen::Vector2d::Zero()}};
};

TEST_F(Picture, WhatWasRemovedIsRedAboveAllThatStands) {
  add(10.02F, 20.02F, 0.0F, semantic_kitti::kDynamic);
  add(10.02F, 20.02F, 5.0F, semantic_kitti::kBuilding);
  EXPECT_EQ(colourAt(10.02, 20.02), kRed);
}

TEST_F(Picture, WhatIsHigherIsBrighterAndCoversWhatIsLower) {
  add(10.02F, 20.02F, 3.0F, semantic_kitti::kCar);
  add(10.02F, 20.02F, -1.0F, semantic_kitti::kCar);
  add(12.02F, 20.02F, -1.0F, semantic_kitti::kCar);
  const Colour high = colourAt(10.02, 20.02);
  const Colour low = colourAt(12.02, 20.02);
  EXPECT_GT(high[2], low[2]);
  EXPECT_GT(low[2], low[0]) << "blue, as all that can move";
}

TEST_F(Picture, WayAndScaleBarAreDrawn) {
  TopDownImage image({{0.0, 0.0}, {10.0, 0.0}});
  image.write(folder_.path() / "way.png");
  const Shown shown = show(folder_.path() / "way.png");
  EXPECT_EQ(shown.width, 2201U) << "110 m";
  EXPECT_EQ(shown.height, 2001U) << "100 m";
  EXPECT_EQ(shown.at(1100, 1000), kYellow);
  EXPECT_TRUE(shown.holds(kWhite));
}

TEST(PngFile, APaletteIsShownAsItsColours) {
  const test::TempFolder folder;
  writePng(folder.path() / "two.png",
           PaletteImage{2, 2, {{10, 20, 30}, {200, 100, 0}}, {0, 1, 1, 0}});
  const Shown shown = show(folder.path() / "two.png");
  EXPECT_EQ(shown.at(0, 0), (Colour{10, 20, 30}));
  EXPECT_EQ(shown.at(1, 0), (Colour{200, 100, 0}));
  EXPECT_EQ(shown.at(0, 1), (Colour{200, 100, 0}));
  EXPECT_EQ(shown.at(1, 1), (Colour{10, 20, 30}));
}

}  // namespace
}  // namespace segdf
