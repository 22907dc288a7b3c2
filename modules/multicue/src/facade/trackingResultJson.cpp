// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/multicue/vpMbTrackingResult.h>

#include "motion/vpPoseCheck.h"

#include <visp3/core/vpException.h>
#include <visp3/model/vpJsonWatch.h>
#include <visp3/model/vpWholeFile.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>

BEGIN_VISP_NAMESPACE

namespace {
using Json = nlohmann::ordered_json;
using Result = vpMbTrackingResult;

[[noreturn]] void refuse(const std::string &reason)
{
  throw vpException(vpException::badValue, "Tracking result: " + reason);
}

// JSON has no word for what is not a number.
Json numberJson(double value)
{
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json matrixJson(const vpArray2D<double> &matrix)
{
  Json rows = Json::array();
  for (unsigned int i = 0; i < matrix.getRows(); ++i) {
    Json row = Json::array();
    for (unsigned int j = 0; j < matrix.getCols(); ++j) {
      row.push_back(numberJson(matrix[i][j]));
    }
    rows.push_back(row);
  }
  return rows;
}

// Names are no std::string: compilers of today take what is returned for a part of a temporary one.
const Json &member(const Json &json, const char *name)
{
  if (!json.is_object() || !json.contains(name)) {
    refuse(std::string("'") + name + "' is missing");
  }
  return json[name];
}

template <typename Value> Value valueOf(const Json &json, const char *name)
{
  const Json &value = member(json, name);
  try {
    return value.get<Value>();
  } catch (const Json::exception &) {
    refuse(std::string("'") + name + "' is " + value.dump() + ", it must be of another type");
  }
}

double asNumber(const Json &value, const char *name)
{
  if (!value.is_number() && !value.is_null()) {
    refuse(std::string("'") + name + "' has " + value.dump() + " where a number must be");
  }
  return value.is_null() ? std::numeric_limits<double>::quiet_NaN() : value.get<double>();
}

double numberOf(const Json &json, const char *name)
{
  return asNumber(member(json, name), name);
}

const Json &listOf(const Json &json, const char *name)
{
  const Json &list = member(json, name);
  if (!list.is_array()) {
    refuse(std::string("'") + name + "' is " + list.dump() + ", it must be a list [...]");
  }
  return list;
}

// \param matrix Has the size that is expected.
void readMatrix(const Json &json, const char *name, vpArray2D<double> &matrix)
{
  const Json &rows = listOf(json, name);
  bool fits = rows.size() == matrix.getRows();
  for (unsigned int i = 0; fits && i < matrix.getRows(); ++i) {
    fits = rows[i].is_array() && rows[i].size() == matrix.getCols();
    for (unsigned int j = 0; fits && j < matrix.getCols(); ++j) {
      matrix[i][j] = asNumber(rows[i][j], name);
    }
  }
  if (!fits) {
    refuse(std::string("'") + name + "' must be a list of " + std::to_string(matrix.getRows()) + " rows of " +
           std::to_string(matrix.getCols()) + " numbers");
  }
}

vpHomogeneousMatrix poseOf(const Json &json)
{
  vpArray2D<double> matrix(4, 4);
  readMatrix(json, "cMo", matrix);
  vpHomogeneousMatrix cMo;
  std::copy(matrix.data, matrix.data + matrix.size(), cMo.data);
  vpPoseCheck::requireRigid(cMo);
  return cMo;
}

// The value whose name is written. \param values All that there are.
template <typename Enum> Enum choiceOf(const Json &text, const char *name, const std::vector<Enum> &values)
{
  for (const Enum value : values) {
    if (text == toString(value)) {
      return value;
    }
  }
  refuse(std::string("'") + name + "' is not known as " + text.dump());
}

Json putOffJson(const std::vector<vpPutOff> &works)
{
  Json list = Json::array();
  for (const vpPutOff work : works) {
    list.push_back(toString(work));
  }
  return list;
}

std::vector<vpPutOff> readPutOff(const Json &json)
{
  std::vector<vpPutOff> works;
  for (const Json &one : listOf(json, "putOff")) {
    works.push_back(choiceOf<vpPutOff>(
        one, "putOff", {vpPutOff::STARTS, vpPutOff::KEYFRAMES, vpPutOff::SEARCH, vpPutOff::COMPARISON}));
  }
  return works;
}

Json cuesJson(const std::vector<Result::Cue> &cues)
{
  Json list = Json::array();
  for (const Result::Cue &cue : cues) {
    list.push_back({{"type", cue.type},
                    {"name", cue.name},
                    {"expected", cue.expected},
                    {"good", cue.good},
                    {"agreement", numberJson(cue.agreement)},
                    {"reason", cue.reason}});
  }
  return list;
}

std::vector<Result::Cue> readCues(const Json &json)
{
  std::vector<Result::Cue> cues;
  for (const Json &one : listOf(json, "cues")) {
    cues.push_back({valueOf<int>(one, "type"), valueOf<std::string>(one, "name"),
                    valueOf<unsigned int>(one, "expected"), valueOf<unsigned int>(one, "good"),
                    numberOf(one, "agreement"), valueOf<std::string>(one, "reason")});
  }
  return cues;
}

Json unobservedJson(const std::vector<Result::UnobservedMotion> &motions)
{
  Json list = Json::array();
  for (const Result::UnobservedMotion &motion : motions) {
    list.push_back({{"direction", matrixJson(motion.direction.t())[0]}, {"text", motion.text}});
  }
  return list;
}

std::vector<Result::UnobservedMotion> readUnobserved(const Json &json)
{
  std::vector<Result::UnobservedMotion> motions;
  for (const Json &one : listOf(json, "unobserved")) {
    Result::UnobservedMotion motion;
    for (const Json &value : listOf(one, "direction")) {
      motion.direction.stack(asNumber(value, "direction"));
    }
    motion.text = valueOf<std::string>(one, "text");
    motions.push_back(motion);
  }
  return motions;
}

Json hypothesesJson(const std::vector<vpPoseHypothesis> &hypotheses)
{
  Json list = Json::array();
  for (const vpPoseHypothesis &hypothesis : hypotheses) {
    list.push_back({{"cMo", matrixJson(hypothesis.cMo)},
                    {"residue", numberJson(hypothesis.residue)},
                    {"weight", numberJson(hypothesis.weight)},
                    {"classes", hypothesis.classes}});
  }
  return list;
}

std::vector<vpPoseHypothesis> readHypotheses(const Json &json)
{
  std::vector<vpPoseHypothesis> hypotheses;
  for (const Json &one : listOf(json, "hypotheses")) {
    hypotheses.push_back(
        {poseOf(one), numberOf(one, "residue"), numberOf(one, "weight"), valueOf<std::vector<int>>(one, "classes")});
  }
  return hypotheses;
}

Json timingsJson(const vpTrackingTimings &timings)
{
  return {{"frame", timings.frame}, {"view", timings.view},           {"match", timings.match}, {"pose", timings.pose},
          {"map", timings.map},     {"particles", timings.particles}, {"total", timings.total}};
}

vpTrackingTimings readTimings(const Json &json)
{
  const Json &one = member(json, "timings");
  return {numberOf(one, "frame"), numberOf(one, "view"),      numberOf(one, "match"), numberOf(one, "pose"),
          numberOf(one, "map"),   numberOf(one, "particles"), numberOf(one, "total")};
}
} // namespace

std::string vpMbTrackingResult::toJson(int indent) const
{
  const Json json = {{"cMo", matrixJson(cMo)},
                     {"covariance", matrixJson(covariance)},
                     {"state", toString(state)},
                     {"score", numberJson(score)},
                     {"reason", toString(reason)},
                     {"text", text},
                     {"cues", cuesJson(cues)},
                     {"unobserved", unobservedJson(unobserved)},
                     {"hypotheses", hypothesesJson(hypotheses)},
                     {"timings", timingsJson(timings)},
                     {"putOff", putOffJson(putOff)}};
  return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

vpMbTrackingResult vpMbTrackingResult::fromJson(const std::string &text)
{
  constexpr int deepest = 20;
  const Json json = Json::parse(text, vpJsonWatch(deepest, refuse), false);
  if (!json.is_object()) {
    refuse("this is no JSON object");
  }
  vpMbTrackingResult result;
  result.cMo = poseOf(json);
  if (!listOf(json, "covariance").empty()) {
    result.covariance.resize(6, 6);
    readMatrix(json, "covariance", result.covariance);
  }
  result.state = choiceOf<vpTrackingState>(
      member(json, "state"), "state", {vpTrackingState::TRACKING, vpTrackingState::UNCERTAIN, vpTrackingState::LOST});
  result.score = numberOf(json, "score");
  result.reason =
      choiceOf<Reason>(member(json, "reason"), "reason",
                       {Reason::NOT_STARTED, Reason::WELL_EXPLAINED, Reason::PARTLY_EXPLAINED, Reason::CONFIRMING,
                        Reason::NOTHING_SEEN, Reason::FEW_FEATURES, Reason::CONTRADICTED, Reason::COASTING});
  result.text = valueOf<std::string>(json, "text");
  result.cues = readCues(json);
  result.unobserved = readUnobserved(json);
  result.hypotheses = readHypotheses(json);
  result.timings = readTimings(json);
  result.putOff = readPutOff(json);
  return result;
}

void vpMbTrackingResult::saveToFile(const std::string &filename) const
{
  constexpr int indent = 2;
  vpWholeFile::write(filename, toJson(indent) + '\n');
}

vpMbTrackingResult vpMbTrackingResult::readFromJsonFile(const std::string &filename)
{
  std::error_code error;
  std::ifstream stream(filename, std::ios::binary);
  if (!stream || std::filesystem::is_directory(filename, error)) {
    throw vpException(vpException::ioError, "Tracking result '" + filename + "' cannot be read");
  }
  const std::string text((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
  try {
    return fromJson(text);
  } catch (const vpException &e) {
    throw vpException(vpException::badValue, "'" + filename + "': " + e.getMessage());
  }
}

END_VISP_NAMESPACE
