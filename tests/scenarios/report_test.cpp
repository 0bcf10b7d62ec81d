#include "scenarios/report.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>

#include "base/rotation.h"

namespace amble {
namespace {

using Json = nlohmann::ordered_json;

std::string textOf(const Report& report) {
  std::ostringstream out;
  writeJson(out, report);
  return out.str();
}

Report solvedReport() {
  Report report;
  report.status = PlanStatus::kSolved;
  report.scenario = "room";
  report.planner = "visibility";
  report.length = 4.25;
  report.frames = 200;
  report.frame_time = 1.0 / 60.0;
  StepMeasure step;
  step.side = kRight;
  step.at = {1, 2, 0};
  step.stride = 0.7;
  report.steps = {step};
  report.goal_heading_error = 0.25 * kDegree;
  report.clearance = {0.03, "left hand", "stool", 2.5};
  report.refusals = {{"contact", 12}, {"turn_rate", 3}};
  report.inputs = {{"room.yaml", std::string(64, 'a')}};
  BodyPart part;
  part.name = "head";
  part.joint = 1;
  part.from = {0, 0.1, 0};
  part.to = {0, 0.2, 0};
  part.radius = 0.09;
  report.body = {part};
  report.joint_names = {"Hips", "Head"};
  return report;
}

TEST(Report, AWalksReportHasEveryFieldOfTheAgreement) {
  const Json json = Json::parse(textOf(solvedReport()));
  for (const char* field :
       {"status",     "seed",     "planner",       "length",    "duration",   "frames",
        "frame_time", "steps",    "goal_error",    "clearance", "foot_skate", "ground_penetration",
        "roadmap",    "refusals", "poses_checked", "times",     "inputs",     "version",
        "bvh_unit",   "body"}) {
    EXPECT_TRUE(json.contains(field)) << field;
  }
  for (const char* field : {"foot", "start", "end", "at", "stride", "lift", "climb", "slide"}) {
    EXPECT_TRUE(json["steps"][0].contains(field)) << field;
  }
  for (const char* field : {"part", "joint", "from", "to", "radius", "sole"}) {
    EXPECT_TRUE(json["body"][0].contains(field)) << field;
  }
  for (const char* field : {"guards", "connectors", "edges", "samples", "coverage"}) {
    EXPECT_TRUE(json["roadmap"].contains(field)) << field;
  }
  for (const char* field : {"load", "scene", "library", "ground", "character", "collision",
                            "roadmap", "search", "refine", "export"}) {
    EXPECT_TRUE(json["times"].contains(field)) << field;
  }
  for (const char* field : {"min", "part", "object", "time"}) {
    EXPECT_TRUE(json["clearance"].contains(field)) << field;
  }
  EXPECT_EQ(json["status"], "solved");
  EXPECT_EQ(json["body"][0]["joint"], "Head");
  EXPECT_EQ(json["refusals"]["contact"], 12);
  EXPECT_FALSE(json.contains("why"));
}

TEST(Report, AnglesAreWrittenInDegrees) {
  const Json json = Json::parse(textOf(solvedReport()));
  EXPECT_NEAR(json["goal_error"]["heading"].get<double>(), 0.25, 1e-9);
}

TEST(Report, WithoutAWalkThereIsAWhyAndNoLength) {
  Report report;
  report.status = PlanStatus::kNoWalk;
  report.why = "contact: head and beam";
  report.obstruction.emplace();
  report.obstruction->rule = WalkRule::kContact;
  report.obstruction->part = "head";
  report.obstruction->object = "beam";
  report.obstruction->at = {1, 2, 1.6};
  report.obstruction->width = 1.62;
  report.obstruction->lack = Obstruction::Lack::kHeadroom;
  report.obstruction->overlap = 0.02;
  report.reached = {12.5, {1.5, 2, 0}, {3, 2, 0}};
  const Json json = Json::parse(textOf(report));
  EXPECT_EQ(json["obstruction"]["rule"], "contact");
  EXPECT_EQ(json["obstruction"]["part"], "head");
  EXPECT_EQ(json["obstruction"]["object"], "beam");
  EXPECT_TRUE(json["obstruction"]["other"].is_null());
  EXPECT_EQ(json["obstruction"]["at"][2], 1.6);
  EXPECT_EQ(json["obstruction"]["width"], 1.62);
  EXPECT_TRUE(json["obstruction"]["needed"].is_null());
  EXPECT_EQ(json["obstruction"]["lack"], "headroom");
  EXPECT_EQ(json["obstruction"]["overlap"], 0.02);
  EXPECT_TRUE(json["obstruction"]["slope"].is_null());
  EXPECT_EQ(json["reached"]["area"], 12.5);
  EXPECT_EQ(json["reached"]["near"][0], 1.5);
  EXPECT_EQ(json["proved"], false);
  EXPECT_EQ(json["status"], "no_walk");
  EXPECT_EQ(json["why"], "contact: head and beam");
  EXPECT_FALSE(json.contains("length"));
  EXPECT_TRUE(json.contains("roadmap"));
}

TEST(Report, TimesAreLastSoThatTheRestCanBeCompared) {
  const Json json = Json::parse(textOf(solvedReport()));
  EXPECT_EQ(std::prev(json.end()).key(), "times");
  Report slower = solvedReport();
  slower.times.roadmap = 3.0;
  const std::string a = textOf(solvedReport()), b = textOf(slower);
  EXPECT_EQ(a.substr(0, a.find("\"times\"")), b.substr(0, b.find("\"times\"")));
  EXPECT_NE(a, b);
}

TEST(Report, WhatIsNoNumberBecomesNull) {
  Report report = solvedReport();
  report.clearance.min = std::numeric_limits<double>::infinity();
  report.foot_skate_max = std::nan("");
  const Json json = Json::parse(textOf(report));
  EXPECT_TRUE(json["clearance"]["min"].is_null());
  EXPECT_TRUE(json["foot_skate"]["max"].is_null());
}

TEST(Report, BytesThatAreNoTextDoNotStopIt) {
  Report report = solvedReport();
  report.clearance.object = "stool\xff\"<";
  EXPECT_NO_THROW(Json::parse(textOf(report)));
}

TEST(Report, MinusZeroIsZero) {
  Report report = solvedReport();
  report.steps[0].at = {-1e-12, 0, 0};
  EXPECT_EQ(textOf(report).find("-0.0"), std::string::npos);
}

}  // namespace
}  // namespace amble
