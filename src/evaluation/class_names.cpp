// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/evaluation/class_names.hpp"

#include <map>

namespace segdf {

std::string className(std::uint16_t semantic_class) {
  static const std::map<std::uint16_t, std::string> names{
      {0, "unlabelled"},    {1, "outlier"},        {9, "static"},         {10, "car"},
      {11, "bicycle"},      {13, "bus"},           {15, "motorcycle"},    {16, "on-rails"},
      {18, "truck"},        {20, "other-vehicle"}, {30, "person"},        {31, "bicyclist"},
      {32, "motorcyclist"}, {40, "road"},          {44, "parking"},       {48, "sidewalk"},
      {49, "other-ground"}, {50, "building"},      {51, "fence"},         {52, "other-structure"},
      {60, "lane-marking"}, {70, "vegetation"},    {71, "trunk"},         {72, "terrain"},
      {80, "pole"},         {81, "traffic-sign"},  {99, "other-object"},  {252, "car"},
      {253, "bicyclist"},   {254, "person"},       {255, "motorcyclist"}, {256, "on-rails"},
      {257, "bus"},         {258, "truck"},        {259, "other-vehicle"}};
  const auto found = names.find(semantic_class);
  return found != names.end() ? found->second : "class " + std::to_string(semantic_class);
}

}  // namespace segdf
