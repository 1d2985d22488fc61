// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/core/config.hpp"

#include <cmath>
#include <cstdlib>
#include <iomanip>
#include <sstream>
#include <stdexcept>

namespace segdf {

namespace {

// 15 digits print every decimal as it was written; 17 read back every double.
constexpr int kMinDigits = 15;
constexpr int kMaxDigits = 17;

/// Visitor that checks bounds.
class Validator {
 public:
  template <class T>
  void section(const std::string& name, const T& values, const char*) {
    prefix_ = name + ".";
    T::visit(values, *this);
  }
  void number(
      const char* name, double value, double min, double max, const char* unit, const char*) {
    if (std::isfinite(value) && value >= min && value <= max) return;
    std::ostringstream message;
    message << "parameter " << prefix_ << name << " = " << formatNumber(value) << " is out of ["
            << formatNumber(min) << ", " << formatNumber(max) << "] " << unit;
    throw std::invalid_argument(message.str());
  }
  void integer(
      const char* name, int value, int min, int max, const char* unit, const char* meaning) {
    number(name, value, min, max, unit, meaning);
  }
  template <std::size_t N>
  void numbers(const char* name,
               const std::array<double, N>& values,
               double min,
               double max,
               const char* unit,
               const char* meaning) {
    for (double value : values) number(name, value, min, max, unit, meaning);
  }
  template <class Enum, std::size_t N>
  void choice(const char*, Enum, const std::array<EnumName<Enum>, N>&, const char*) {}

 private:
  std::string prefix_;
};

void require(bool holds, const std::string& message) {
  if (!holds) throw std::invalid_argument(message);
}

}  // namespace

std::string formatNumber(double value) {
  std::ostringstream text;
  for (int digits = kMinDigits; digits <= kMaxDigits; ++digits) {
    text.str("");
    text << std::setprecision(digits) << value;
    if (std::strtod(text.str().c_str(), nullptr) == value) break;
  }
  return text.str();
}

void validate(const Config& config) {
  Validator validator;
  Config::visit(config, validator);
  const auto& input = config.input;
  require(input.min_range < input.max_range,
          "parameter input.min_range must be below input.max_range");
  require(input.ego_box[0] <= input.ego_box[1] && input.ego_box[2] <= input.ego_box[3],
          "parameter input.ego_box must be x_min x_max y_min y_max with min <= max");
  require(config.ground.l_min < config.ground.l_max,
          "parameter ground.l_min must be below ground.l_max");
  require(config.range_image.elevation_min < config.range_image.elevation_max,
          "parameter range_image.elevation_min must be below range_image.elevation_max");
}

}  // namespace segdf
