// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/io/intensity_plot.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <cairo.h>

#include "segdf/io/png_file.hpp"

namespace segdf {

namespace {

constexpr int kWidth = 1000;  // pixels
constexpr int kHeight = 460;
constexpr double kPanelWidth = 390.0;
constexpr double kPanelHeight = 330.0;
constexpr double kPanelTop = 50.0;
constexpr std::array<double, 2> kPanelLeft{75.0, 575.0};
constexpr double kFontSize = 13.0;
constexpr double kTick = 5.0;
constexpr double kDot = 4.0;
constexpr double kKeyLine = 22.0;
constexpr int kSteps = 100;  // of a curve
constexpr double kLowest = 0.02;
constexpr double kHighest = 5.0;
constexpr std::array<double, 8> kHeights{0.02, 0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0};
constexpr std::array<double, 8> kRanges{5.0, 7.0, 10.0, 15.0, 20.0, 30.0, 40.0, 60.0};
constexpr std::array<double, 6> kCosines{0.1, 0.2, 0.4, 0.6, 0.8, 1.0};

struct Ink {
  double r, g, b;
};
constexpr Ink kBlack{0.0, 0.0, 0.0};
constexpr Ink kGrid{0.88, 0.88, 0.88};
constexpr Ink kFitted{0.84, 0.15, 0.16};
constexpr Ink kFlat{0.17, 0.63, 0.17};
constexpr Ink kModel{0.12, 0.47, 0.71};

struct Destroy {
  void operator()(cairo_t* context) const { cairo_destroy(context); }
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
};

/// One line of the key and the curves of both panels: value at r_ref and facing is 1.
struct Model {
  std::string name;
  Ink ink;
  double range_exponent;
  double incidence_exponent;
};

/// Axes with logarithmic scales and what is drawn between them.
class Panel {
 public:
  Panel(cairo_t* context, double left, double from, double to)
      : context_(context), left_(left), from_(from), to_(to) {}

  template <std::size_t N>
  void axes(const std::array<double, N>& ticks, const std::string& title) const {
    for (double x : ticks) {
      if (x < from_ || x > to_) continue;
      line(kGrid, x, kLowest, x, kHighest);
      text(number(x), px(x), kPanelTop + kPanelHeight + 3.5 * kTick, 0.5);
    }
    for (double y : kHeights) {
      line(kGrid, from_, y, to_, y);
      text(number(y), left_ - kTick, py(y) + kTick, 1.0);
    }
    colour(kBlack);
    cairo_rectangle(context_, left_, kPanelTop, kPanelWidth, kPanelHeight);
    cairo_stroke(context_);
    text(title, left_ + kPanelWidth / 2.0, kPanelTop + kPanelHeight + 8.0 * kTick, 0.5);
  }

  void curve(const Ink& ink, const std::function<double(double)>& f) const {
    cairo_save(context_);
    cairo_rectangle(context_, left_, kPanelTop, kPanelWidth, kPanelHeight);
    cairo_clip(context_);
    colour(ink);
    for (int k = 0; k <= kSteps; ++k) {
      const double x = from_ * std::pow(to_ / from_, static_cast<double>(k) / kSteps);
      cairo_line_to(context_, px(x), py(f(x)));
    }
    cairo_stroke(context_);
    cairo_restore(context_);
  }

  void dots(const std::vector<IntensityBin>& bins) const {
    colour(kBlack);
    for (const IntensityBin& bin : bins) {
      const double x = std::sqrt(std::max(bin.from, from_) * bin.to);
      const double y = std::clamp(bin.relative, kLowest, kHighest);
      cairo_arc(context_, px(x), py(y), kDot, 0.0, 2.0 * std::acos(-1.0));
      cairo_fill(context_);
    }
  }

  /// @param share of its width that lies left of x @returns the width
  double text(const std::string& words, double x, double y, double share) const {
    cairo_text_extents_t extents;
    cairo_text_extents(context_, words.c_str(), &extents);
    colour(kBlack);
    cairo_move_to(context_, x - share * extents.x_advance, y);
    cairo_show_text(context_, words.c_str());
    return extents.x_advance;
  }

  void keyLine(const Ink& ink, double x, double y) const {
    colour(ink);
    cairo_move_to(context_, x, y);
    cairo_line_to(context_, x + kKeyLine, y);
    cairo_stroke(context_);
  }

 private:
  static std::string number(double value) { return formatNumber(value); }
  void colour(const Ink& ink) const { cairo_set_source_rgb(context_, ink.r, ink.g, ink.b); }
  double px(double x) const {
    return left_ + kPanelWidth * std::log(x / from_) / std::log(to_ / from_);
  }
  static double py(double y) {
    return kPanelTop + kPanelHeight * std::log(kHighest / y) / std::log(kHighest / kLowest);
  }
  void line(const Ink& ink, double x0, double y0, double x1, double y1) const {
    colour(ink);
    cairo_move_to(context_, px(x0), py(y0));
    cairo_line_to(context_, px(x1), py(y1));
    cairo_stroke(context_);
  }

  cairo_t* context_;
  double left_;
  double from_;
  double to_;
};

void draw(cairo_t* context, const IntensityFit& fit, const IntensityConfig& config) {
  cairo_set_source_rgb(context, 1.0, 1.0, 1.0);
  cairo_paint(context);
  cairo_set_font_size(context, kFontSize);
  cairo_set_line_width(context, 1.5);
  const std::array<Model, 3> models{{{"compensated sensor", kFlat, 0.0, 0.0},
                                     {"formula (6)", kModel, 2.0, 1.0},
                                     {"fit", kFitted, fit.range_exponent, fit.incidence_exponent}}};
  const Panel range(context, kPanelLeft[0], config.r_near, config.r_cap);
  const Panel cosine(context, kPanelLeft[1], kCosines.front(), kCosines.back());
  range.axes(kRanges, "range, m");
  cosine.axes(kCosines, "cosine of the incidence angle");
  double x = kPanelLeft[0];
  for (const Model& m : models) {
    range.curve(m.ink, [&](double r) { return std::pow(r / config.r_ref, -m.range_exponent); });
    cosine.curve(m.ink, [&](double c) { return std::pow(c, m.incidence_exponent); });
    range.keyLine(m.ink, x, kPanelTop / 2.0 - kTick);
    x += kKeyLine + kTick;
    x += range.text(m.name, x, kPanelTop / 2.0, 0.0) + 2.0 * kFontSize;
  }
  range.text("dots: intensity of the same surface over that at " + formatNumber(config.r_ref) +
                 " m, facing",
             x, kPanelTop / 2.0, 0.0);
  range.dots(fit.by_range);
  cosine.dots(fit.by_cosine);
}

RgbImage toImage(cairo_surface_t* surface) {
  cairo_surface_flush(surface);
  const auto stride = static_cast<std::size_t>(cairo_image_surface_get_stride(surface));
  const unsigned char* data = cairo_image_surface_get_data(surface);
  RgbImage image{kWidth, kHeight, {}};
  image.rgb.reserve(3 * image.width * image.height);
  for (std::size_t row = 0; row < image.height; ++row) {
    for (std::size_t column = 0; column < image.width; ++column) {
      // One 32-bit number a pixel, in the machine's own order: 0x00RRGGBB.
      std::uint32_t pixel = 0;
      std::copy_n(data + row * stride + column * sizeof(pixel), sizeof(pixel),
                  reinterpret_cast<unsigned char*>(&pixel));
      for (unsigned shift : {16U, 8U, 0U}) {
        image.rgb.push_back(static_cast<std::uint8_t>((pixel >> shift) & 0xFFU));
      }
    }
  }
  return image;
}

}  // namespace

void writeIntensityPlot(const std::filesystem::path& file,
                        const IntensityFit& fit,
                        const IntensityConfig& config) {
  const std::unique_ptr<cairo_surface_t, Destroy> surface(
      cairo_image_surface_create(CAIRO_FORMAT_RGB24, kWidth, kHeight));
  const std::unique_ptr<cairo_t, Destroy> context(cairo_create(surface.get()));
  draw(context.get(), fit, config);
  writePng(file, toImage(surface.get()));
}

}  // namespace segdf
