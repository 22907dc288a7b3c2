// SPDX-License-Identifier: GPL-2.0-or-later
// The JSON schema that is installed, beside what is read.
#include <catchMain.h>

#include "settingsFiles.h"

#include <nlohmann/json.hpp>

#include <string>

namespace {
using settingsFiles::Folder;
using settingsFiles::textOf;
using Json = nlohmann::ordered_json;

const std::string schemaFile = MULTICUE_SCHEMA_FILE;

// The one of several schemas that is for an object.
const Json &objectOf(const Json &schema)
{
  return schema.contains("anyOf") ? schema["anyOf"][1] : schema;
}
} // namespace

TEST_CASE("The schema that is installed is that of the settings", "[schema]")
{
  INFO("multicue-check --schema writes the one that " << schemaFile << " should be");
  CHECK(textOf(schemaFile) == vpMultiCueSettingsReader::jsonSchema());
}

TEST_CASE("All that is written is in the schema, with the default that it has", "[schema]")
{
  const Folder folder;
  vpMultiCueSettings defaults;
  defaults.camera.initPersProjWithDistortion(600., 600., 320., 240., 0., 0.);
  vpMultiCueSettingsReader::write(folder.path("defaults.json"), defaults);
  const Json written = Json::parse(textOf(folder.path("defaults.json")));
  const Json schema = Json::parse(textOf(schemaFile));
  for (const auto &[object, value] : written.items()) {
    INFO(object);
    REQUIRE(schema["properties"].contains(object));
    const Json &place = objectOf(schema["properties"][object]);
    if (!value.is_object() || object == "factors") {
      CHECK(place["default"] == value);
      continue;
    }
    CHECK(place["additionalProperties"] == false);
    for (const auto &[key, one] : value.items()) {
      INFO(key);
      REQUIRE(place["properties"].contains(key));
      CHECK((object == "camera" || place["properties"][key]["default"] == one));
    }
  }
}

TEST_CASE("Ranges of the schema are those that are read", "[schema]")
{
  const Json schema = Json::parse(textOf(schemaFile));
  unsigned int bounds = 0;
  for (const auto &[object, place] : schema["properties"].items()) {
    const Json properties = objectOf(place).value("properties", Json::object());
    for (const auto &[key, one] : properties.items()) {
      if (object == "factors" || !one.contains("description")) {
        continue;
      }
      for (const char *bound : {"minimum", "exclusiveMinimum", "maximum"}) {
        if (one.contains(bound)) {
          ++bounds;
          const bool isHigh = bound == std::string("maximum");
          const double outside = one[bound].get<double>() + (isHigh ? 1. : -1.);
          const Json value = one["type"] == "integer" ? Json(static_cast<long long>(outside)) : Json(outside);
          INFO(object << '.' << key << " = " << value);
          CHECK_THAT(settingsFiles::refusal("a.json", Json{{object, {{key, value}}}}.dump()),
                     ContainsSubstring("it must be"));
        }
      }
    }
  }
  CHECK(bounds > 100); // There are some.
}

TEST_CASE("A file may name its schema", "[schema]")
{
  CHECK(settingsFiles::refusal("a.json", R"({"$schema": "multicue-settings.schema.json", "search": true})") == "");
}
