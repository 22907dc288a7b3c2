// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef compareReport_h
#define compareReport_h

#include <visp3/core/vpHomogeneousMatrix.h>
#include <visp3/core/vpMath.h>
#include <visp3/core/vpThetaUVector.h>
#include <visp3/model/vpWholeFile.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <map>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

//! What one tracker did with one frame.
struct compareFrame
{
  double ms = 0.;
  double projectionError = 90.; //!< Degrees.
  double translation = 0.;      //!< Distance from the truth, metres.
  double rotation = 0.;         //!< Angle to the truth, degrees.
  bool held = false;

  void compare(const vpHomogeneousMatrix &cMo, const vpHomogeneousMatrix &truth)
  {
    translation = (cMo.getTranslationVector() - truth.getTranslationVector()).frobeniusNorm();
    const vpHomogeneousMatrix difference = truth.inverse() * cMo;
    rotation = vpMath::deg(difference.getThetaUVector().getTheta());
  }
};

struct compareRun
{
  std::vector<compareFrame> frames;
  std::vector<vpHomogeneousMatrix> poses;
};

//! Collects runs and prints one line for each tracker, and the ratio of their times.
class compareReport
{
public:
  explicit compareReport(std::ostream &os) : m_os(os) {}

  void add(const std::string &tracker, const compareRun &run)
  {
    std::vector<compareFrame> &frames = m_frames[tracker];
    frames.insert(frames.end(), run.frames.begin(), run.frames.end());
  }

  void writePoses(const std::string &name, const compareRun &run) const
  {
    std::ostringstream file;
    file << std::setprecision(17);
    for (const vpHomogeneousMatrix &cMo : run.poses) {
      for (unsigned int i = 0; i < 12; ++i) {
        file << cMo.data[i] << (i < 11 ? " " : "\n");
      }
    }
    vpWholeFile::write(name, file.str());
  }

  void print(bool hasTruth) const
  {
    m_os << "tracker      frames  held  proj. error median    max   ms median    95 %";
    m_os << (hasTruth ? "   t error median      max (mm)   r error median      max (deg)\n" : "\n");
    for (const auto &entry : m_frames) {
      const std::vector<compareFrame> &frames = entry.second;
      const auto held = std::count_if(frames.begin(), frames.end(), [](const compareFrame &f) { return f.held; });
      m_os << std::fixed << std::left << std::setw(12) << entry.first << std::right << std::setw(7) << frames.size()
           << std::setw(6) << held << std::setprecision(3) << std::setw(20)
           << quantile(frames, &compareFrame::projectionError, 0.5) << std::setw(7)
           << quantile(frames, &compareFrame::projectionError, 1.) << std::setw(12)
           << quantile(frames, &compareFrame::ms, 0.5) << std::setw(8) << quantile(frames, &compareFrame::ms, 0.95);
      if (hasTruth) {
        m_os << std::setw(17) << 1e3 * quantile(frames, &compareFrame::translation, 0.5) << std::setw(9)
             << 1e3 * quantile(frames, &compareFrame::translation, 1.) << std::setw(22)
             << quantile(frames, &compareFrame::rotation, 0.5) << std::setw(9)
             << quantile(frames, &compareFrame::rotation, 1.);
      }
      m_os << "\n";
    }
    m_os << "time ratio multicue / visp (medians): " << std::setprecision(2)
         << quantile(m_frames.at("multicue"), &compareFrame::ms, 0.5) /
                quantile(m_frames.at("visp"), &compareFrame::ms, 0.5)
         << std::endl;
  }

private:
  static double quantile(const std::vector<compareFrame> &frames, double compareFrame::*member, double q)
  {
    std::vector<double> values;
    for (const compareFrame &frame : frames) {
      values.push_back(frame.*member);
    }
    std::sort(values.begin(), values.end());
    return values.empty() ? 0. : values[static_cast<std::size_t>(q * static_cast<double>(values.size() - 1))];
  }

  std::ostream &m_os;
  std::map<std::string, std::vector<compareFrame>> m_frames;
};

#endif
