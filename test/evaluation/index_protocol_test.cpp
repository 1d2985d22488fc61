// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/evaluation/index_protocol.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

namespace segdf {
namespace {

constexpr std::uint32_t label(std::uint32_t semantic_class, std::uint32_t instance = 0) {
  return (instance << 16U) | semantic_class;
}

constexpr std::uint32_t kKept = 9;
constexpr std::uint32_t kRemoved = 251;
constexpr std::uint32_t kUnjudged = 0;

/// `count` points at 10 m with the same truth and estimate.
void add(IndexProtocol& protocol,
         std::size_t count,
         std::uint32_t truth,
         std::uint32_t estimate,
         float x = 10.0F) {
  protocol.add(std::vector<Point>(count, {x, 0.0F, 0.0F, 0.0F, 0.0F, -1}),
               std::vector<std::uint32_t>(count, truth),
               std::vector<std::uint32_t>(count, estimate));
}

TEST(IndexProtocol, HandComputedExample) {
  IndexProtocol protocol;
  add(protocol, 90, label(50), kKept);  // 90 of 100 static kept
  add(protocol, 6, label(40), kRemoved);
  add(protocol, 3, label(10), kKept);  // 3 of 4 parked kept
  add(protocol, 1, label(10), kRemoved);
  add(protocol, 16, label(252, 3), kRemoved);  // 16 of 25 moving removed
  add(protocol, 9, label(254, 4), kKept);
  EXPECT_DOUBLE_EQ(*protocol.scores().staticKept().percent(), 93.0);
  EXPECT_DOUBLE_EQ(*protocol.scores().movingRemoved().percent(), 64.0);
  EXPECT_DOUBLE_EQ(*protocol.scores().parkedKept().percent(), 75.0);
  EXPECT_DOUBLE_EQ(*protocol.scores().associatedAccuracy(), std::sqrt(93.0 * 64.0));
  EXPECT_DOUBLE_EQ(*protocol.scores().harmonicAccuracy(), 2.0 * 93.0 * 64.0 / 157.0);
  EXPECT_DOUBLE_EQ(*protocol.scores().rightOfClass(252).percent(), 100.0);
  EXPECT_DOUBLE_EQ(*protocol.scores().rightOfClass(254).percent(), 0.0);
  EXPECT_FALSE(protocol.scores().rightOfClass(253).percent());
  EXPECT_EQ(protocol.scores().scoredPoints(), 125U);
}

TEST(IndexProtocol, UnjudgedIsNotInTheMap) {
  IndexProtocol protocol;
  add(protocol, 1, label(50), kUnjudged);
  add(protocol, 1, label(252), kUnjudged);
  EXPECT_DOUBLE_EQ(*protocol.scores().staticKept().percent(), 0.0);
  EXPECT_DOUBLE_EQ(*protocol.scores().movingRemoved().percent(), 100.0);
}

TEST(IndexProtocol, TheInstanceHalfOfTheEstimateDoesNotMatter) {
  IndexProtocol protocol;
  add(protocol, 1, label(252), label(kRemoved, 77));
  EXPECT_DOUBLE_EQ(*protocol.scores().movingRemoved().percent(), 100.0);
}

TEST(IndexProtocol, UnlabelledAndOutliersAreNotScored) {
  IndexProtocol protocol;
  add(protocol, 5, label(0), kKept);
  add(protocol, 5, label(1), kRemoved);
  EXPECT_EQ(protocol.scores().scoredPoints(), 0U);
  add(protocol, 5, label(9), kKept);
  EXPECT_EQ(protocol.scores().scoredPoints(), 5U);
}

TEST(IndexProtocol, TheRangeIsInclusiveAndNaNIsOutside) {
  IndexProtocol protocol(50.0);
  add(protocol, 1, label(50), kKept, 50.0F);
  EXPECT_EQ(protocol.scores().scoredPoints(), 1U);
  add(protocol, 1, label(50), kKept, 50.001F);
  add(protocol, 1, label(50), kKept, std::numeric_limits<float>::quiet_NaN());
  EXPECT_EQ(protocol.scores().scoredPoints(), 1U);
}

TEST(IndexProtocol, ClassesAtTheEdgesOfMoving) {
  IndexProtocol protocol;
  add(protocol, 1, label(251), kKept);  // not a moving class
  add(protocol, 1, label(252), kRemoved);
  add(protocol, 1, label(259), kRemoved);
  EXPECT_EQ(protocol.scores().staticKept().whole, 1U);
  EXPECT_EQ(protocol.scores().movingRemoved().whole, 2U);
  EXPECT_EQ(protocol.scores().rightOfClass(259).whole, 1U);
}

TEST(IndexProtocol, AnInstanceCountsFromTwentyPointsOverAllScans) {
  IndexProtocol protocol;
  add(protocol, 10, label(252, 1), kRemoved);
  add(protocol, 9, label(252, 1), kRemoved);
  EXPECT_EQ(protocol.scores().instancesRemoved().whole, 0U);
  add(protocol, 1, label(252, 1), kRemoved);
  EXPECT_EQ(protocol.scores().instancesRemoved().whole, 1U);
}

TEST(IndexProtocol, AnInstanceIsRemovedFromHalfOfItsPoints) {
  IndexProtocol protocol;
  add(protocol, 10, label(252, 1), kRemoved);
  add(protocol, 10, label(252, 1), kKept);
  EXPECT_EQ(protocol.scores().instancesRemoved().part, 1U);
  add(protocol, 1, label(252, 1), kKept);
  EXPECT_EQ(protocol.scores().instancesRemoved().part, 0U);
}

TEST(IndexProtocol, InstancesAreToldApartByClassAndIdAndZeroIsNone) {
  IndexProtocol protocol;
  add(protocol, 20, label(252, 1), kRemoved);
  add(protocol, 20, label(254, 1), kKept);
  add(protocol, 20, label(252, 0), kRemoved);
  EXPECT_EQ(protocol.scores().instancesRemoved().whole, 2U);
  EXPECT_EQ(protocol.scores().instancesRemoved().part, 1U);
}

TEST(IndexProtocol, AStaticInstanceHalfRemovedIsAFalseOne) {
  IndexProtocol protocol;
  add(protocol, 10, label(10, 1), kKept);
  add(protocol, 10, label(10, 1), kRemoved);
  add(protocol, 11, label(10, 2), kKept);
  add(protocol, 9, label(10, 2), kRemoved);
  add(protocol, 19, label(10, 3), kRemoved);  // too few points to count
  EXPECT_EQ(protocol.scores().falseInstances().part, 1U);
  EXPECT_EQ(protocol.scores().falseInstances().whole, 2U);
  EXPECT_EQ(protocol.scores().instancesRemoved().whole, 0U);
}

TEST(IndexProtocol, FiguresByClassAndRangeBand) {
  IndexProtocol protocol(80.0);
  add(protocol, 3, label(40), kKept, 9.99F);
  add(protocol, 1, label(40), kRemoved, 9.99F);
  add(protocol, 2, label(70), kKept, 10.0F);
  add(protocol, 5, label(252), kRemoved, 49.0F);
  add(protocol, 5, label(252), kKept, 79.0F);
  const PointScores& scores = protocol.scores();
  EXPECT_DOUBLE_EQ(*scores.staticKeptByBand()[0].percent(), 75.0);
  EXPECT_EQ(scores.staticKeptByBand()[1].whole, 2U);
  EXPECT_DOUBLE_EQ(*scores.movingRemovedByBand()[4].percent(), 100.0);
  EXPECT_DOUBLE_EQ(*scores.movingRemovedByBand()[5].percent(), 0.0) << "the last band has no end";
  EXPECT_EQ(scores.rightByClass().at(40)[0].part, 3U);
  EXPECT_DOUBLE_EQ(*scores.groundKept().percent(), 75.0) << "vegetation is no ground";
}

TEST(IndexProtocol, WhatIsNotThereHasNoFigure) {
  IndexProtocol protocol;
  add(protocol, 5, label(50), kKept);
  EXPECT_FALSE(protocol.scores().movingRemoved().percent());
  EXPECT_FALSE(protocol.scores().parkedKept().percent());
  EXPECT_FALSE(protocol.scores().associatedAccuracy());
  EXPECT_FALSE(protocol.scores().harmonicAccuracy());
}

TEST(IndexProtocol, RemovingNothingAndEverythingScoreZero) {
  IndexProtocol nothing;
  add(nothing, 5, label(50), kKept);
  add(nothing, 5, label(252), kKept);
  EXPECT_DOUBLE_EQ(*nothing.scores().associatedAccuracy(), 0.0);
  EXPECT_DOUBLE_EQ(*nothing.scores().harmonicAccuracy(), 0.0);
}

TEST(IndexProtocol, ListsOfDifferentLengthAreRefused) {
  IndexProtocol protocol;
  EXPECT_THROW(protocol.add(std::vector<Point>(2), {1, 2}, {1}), std::invalid_argument);
}

}  // namespace
}  // namespace segdf
