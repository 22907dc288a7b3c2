// SPDX-License-Identifier: GPL-2.0-or-later
#include "evaluate/runFiles.h"

#include <visp3/model/vpWholeFile.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <iomanip>
#include <sstream>

namespace bench {

namespace {
using Json = nlohmann::json;

// Of the .json files; one of another format is made again.
const int format = 2;

// JSON has no infinity and no "not a number".
Json toJson(double value)
{
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

std::vector<Json> toJson(const double *values, std::size_t count)
{
  std::vector<Json> result;
  std::transform(values, values + count, std::back_inserter(result), [](double value) { return toJson(value); });
  return result;
}

double toNumber(const Json &json, double otherwise)
{
  return json.is_null() ? otherwise : json.get<double>();
}

const vpTrackingState states[] = {vpTrackingState::TRACKING, vpTrackingState::UNCERTAIN, vpTrackingState::LOST};

vpTrackingState toState(const std::string &name)
{
  const auto *found = std::find_if(std::begin(states), std::end(states),
                                   [&name](vpTrackingState state) { return name == toString(state); });
  return found == std::end(states) ? vpTrackingState::LOST : *found;
}

std::string toCsv(const std::vector<FrameRecord> &records)
{
  std::ostringstream csv;
  csv << "frame,r11,r12,r13,tx,r21,r22,r23,ty,r31,r32,r33,tz,ms,reset,state,score,minimisations\n"
      << std::setprecision(17);
  for (const FrameRecord &record : records) {
    csv << record.frame;
    for (unsigned int i = 0; i < 12; ++i) {
      csv << "," << record.answer.cMo.data[i];
    }
    csv << "," << std::setprecision(6) << record.ms << "," << (record.reset ? 1 : 0) << ","
        << toString(record.answer.state) << ",";
    if (std::isfinite(record.answer.score)) {
      csv << record.answer.score;
    }
    csv << ",";
    if (std::isfinite(record.answer.minimisations)) {
      csv << record.answer.minimisations;
    }
    csv << "\n" << std::setprecision(17);
  }
  return csv.str();
}

Json toJson(const FrameRecord &record)
{
  return {{"frame", record.frame},
          {"cMo", toJson(record.answer.cMo.data, 12)},
          {"ms", record.ms},
          {"reset", record.reset},
          {"state", toString(record.answer.state)},
          {"score", toJson(record.answer.score)},
          {"stages", record.answer.stages},
          {"minimisations", toJson(record.answer.minimisations)},
          {"known", record.known},
          {"counted", record.counted},
          {"success", record.success},
          {"right", record.right},
          {"error", Json::array({toJson(record.error.translation), record.error.rotation, toJson(record.error.pixels),
                                 toJson(record.error.add), toJson(record.error.adds)})}};
}

FrameRecord toRecord(const Json &json)
{
  FrameRecord record;
  record.frame = json.at("frame");
  for (unsigned int i = 0; i < 12; ++i) {
    record.answer.cMo.data[i] = toNumber(json.at("cMo").at(i), std::nan(""));
  }
  record.ms = json.at("ms");
  record.reset = json.at("reset");
  record.answer.state = toState(json.at("state"));
  record.answer.score = toNumber(json.at("score"), std::nan(""));
  record.answer.stages = json.at("stages").get<std::vector<double>>();
  record.answer.minimisations = toNumber(json.at("minimisations"), std::nan(""));
  record.known = json.at("known");
  record.counted = json.at("counted");
  record.success = json.at("success");
  record.right = json.at("right");
  const Json &error = json.at("error");
  record.error = {toNumber(error.at(0), HUGE_VAL), error.at(1), toNumber(error.at(2), HUGE_VAL),
                  toNumber(error.at(3), HUGE_VAL), toNumber(error.at(4), HUGE_VAL)};
  return record;
}
} // namespace

void writeRun(const std::string &folder, const RunResult &run, const std::string &fingerprint)
{
  Json json = {{"format", format}, {"fingerprint", fingerprint}, {"frames", Json::array()}, {"stages", Json::array()}};
  for (const auto &stage : run.summary.stages) {
    json["stages"].push_back(stage.first);
  }
  for (const FrameRecord &record : run.records) {
    json["frames"].push_back(toJson(record));
  }
  const std::string name = folder + "/" + run.summary.key.fileName();
  vpWholeFile::write(name + ".csv", toCsv(run.records));
  vpWholeFile::write(name + ".json", json.dump()); // The last one: where it is there, the run is whole.
}

bool readRun(const std::string &folder, const RunKey &key, const std::string &fingerprint, double diameter,
             bool symmetric, RunResult &run)
{
  std::ifstream stream(folder + "/" + key.fileName() + ".json");
  const Json json = Json::parse(stream, nullptr, false);
  if (!stream || json.is_discarded() || !json.is_object() || json.value("fingerprint", "") != fingerprint ||
      json.value("format", 0) != format) {
    return false;
  }
  run.records.clear();
  for (const Json &record : json.at("frames")) {
    run.records.push_back(toRecord(record));
  }
  run.summary = summarise(key, run.records, diameter, symmetric, json.at("stages").get<std::vector<std::string>>());
  return true;
}

} // namespace bench
