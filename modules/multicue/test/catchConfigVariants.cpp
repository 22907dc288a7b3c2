// SPDX-License-Identifier: GPL-2.0-or-later
// What becomes of configuration files that were cut off, edited, or saved in another encoding.
#include <catchMain.h>

#include "settingsFiles.h"

#include <fileVariants.h>

namespace {
using namespace fileVariants;

// Words apart, so that each of them is edited.
const char *const jsonText = R"({ "camera" : { "px" : 600.5 , "py" : 601 , "u0" : 320.25 , "v0" : 240 , "kud" : -0.1 } ,
 "cues" : [ "edge" , "point" ] , "edge" : { "range" : 7 , "mu1" : 0.4 , "maskSize" : 5 } , "hypotheses" : true ,
 "particles" : { "enabled" : false , "noiseFrame" : "camera" } , "symmetries" : { "from" : "none" } }
)";
const char *const xmlText = R"(<?xml version="1.0"?>
<conf>
 <ecm> <mask> <size> 5 </size> </mask> <range> <tracking> 7 </tracking> </range>
 <contrast> <edge_threshold_type> 1 </edge_threshold_type> <edge_threshold> 20 </edge_threshold> <mu1> 0.5 </mu1>
 </contrast> </ecm>
 <camera> <u0> 325.5 </u0> <v0> 243.25 </v0> <px> 839.125 </px> <py> 838.5 </py> </camera>
 <face> <angle_appear> 70 </angle_appear> <near_clipping> 0.125 </near_clipping> </face>
</conf>
)";
const char *const calibrationText = R"(<?xml version="1.0"?>
<root>
 <camera> <name> Camera </name> <image_width> 640 </image_width> <image_height> 480 </image_height>
 <model> <type>perspectiveProjWithDistortion</type> <px> 537.5 </px> <py> 538 </py> <u0> 344 </u0> <v0> 235.25 </v0>
 <kud> -0.25 </kud> <kdu> 0.3 </kdu> </model> </camera>
</root>
)";
const char *const genericText = R"({ "referenceCameraName" : "Camera" , "trackers" : { "Camera" : { "camera" : {
 "model" : "perspectiveWithoutDistortion" , "px" : 600.0 , "py" : 601.5 , "u0" : 192.25 , "v0" : 144.0 } ,
 "type" : [ "edge" ] , "edge" : { "range" : 7 , "maskSize" : 5 , "mu" : [ 0.4 , 0.5 ] } } } }
)";

// A configuration, as the settings that it makes.
class Config
{
public:
  Config(const std::string &name, const std::string &good) : m_name(name), m_good(good)
  {
    m_right = read(good).what;
    m_left = m_report.left.size();
  }

  Outcome read(const std::string &content)
  {
    const vpMultiCueSettings settings =
        vpMultiCueSettingsReader::read(m_folder.write(m_name, content), vpMultiCueSettings(), m_report);
    vpMultiCueSettingsReader::write(m_folder.path("read.json"), settings);
    // What ViSP's trackers have and this one has not is listed for the user.
    return {settingsFiles::textOf(m_folder.path("read.json")), m_report.left.size() > m_left};
  }

  std::string faults(const std::vector<Variant> &variants)
  {
    return fileVariants::faults(variants, m_name, m_right, [this](const std::string &text) { return read(text); });
  }

  const std::string &good() const { return m_good; }
  const std::string &right() const { return m_right; }

private:
  meshFiles::TemporaryFolder m_folder;
  std::string m_name;
  std::string m_good;
  std::string m_right;
  vpConfigReport m_report;
  std::size_t m_left = 1000;
};

std::vector<std::pair<std::string, std::string>> files()
{
  return {{"ours.json", jsonText},
          {"visp.xml", xmlText},
          {"calibration.xml", calibrationText},
          {"generic.json", genericText}};
}
} // namespace

TEST_CASE("Configurations that are cut off anywhere, or of which a word is changed, are refused or read rightly",
          "[files]")
{
  for (const auto &[name, content] : files()) {
    Config config(name, content);
    CHECK(config.right() != "");
    CHECK(config.faults(cuts(config.good())) == "");
    CHECK(config.faults(tokenEdits(config.good())) == "");
    CHECK(config.faults(byteFlips(config.good(), 300)) == "");
  }
}

TEST_CASE("Configurations are the same in every locale and encoding, or refused", "[files]")
{
  for (const auto &[name, content] : files()) {
    CAPTURE(name);
    Config config(name, content);
    CHECK(config.faults(encodings(config.good())) == "");
    CHECK(config.read("\xEF\xBB\xBF" + config.good()).what == config.right());
    const CommaLocale comma;
    CHECK(config.read(config.good()).what == config.right());
    CHECK(CommaLocale::isGlobal());
  }
}

TEST_CASE("A setting that is there twice is refused", "[files]")
{
  using settingsFiles::refusal;
  CHECK_THAT(refusal("twice.json", R"({"edge": {"range": 7, "mu1": 0.4, "range": 9}})"),
             ContainsSubstring("twice.json") && ContainsSubstring("'range' is there twice"));
  CHECK_THAT(refusal("twice.json", R"({"edge": {"range": 7}, "klt": {"quality": 0.1}, "edge": {"mu1": 0.4}})"),
             ContainsSubstring("'edge' is there twice"));
  CHECK_NOTHROW(settingsFiles::read("once.json", R"({"edge": {"enabled": true}, "klt": {"enabled": true}})"));
  const std::string camera = "<camera><px>600</px><py>600</py><u0>320</u0><v0>240</v0></camera>";
  CHECK_THAT(refusal("twice.xml", "<conf>" + camera + camera + "</conf>"),
             ContainsSubstring("twice.xml") && ContainsSubstring("<camera> is there twice"));
  CHECK_THAT(
      refusal("twice.xml", "<conf><ecm><range><tracking>7</tracking><tracking>9</tracking></range></ecm></conf>"),
      ContainsSubstring("<tracking> is there twice"));
  CHECK_THAT(refusal("cut.xml", "<conf><ecm><range><tracking>1<!-- or -->9</tracking></range></ecm></conf>"),
             ContainsSubstring("cut.xml") && ContainsSubstring("comment"));
}
