// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef fuzzDataset_h
#define fuzzDataset_h

#include <dataset/sequence.h>
#include <test/datasetFolder.h>

#include <visp3/core/vpException.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <string>
#include <vector>

namespace fuzz {
#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

//! A data set of which the bytes of an input are one file.
class Dataset
{
public:
  /*!
    \param put Writes all files. \param files Those that an input may replace: its first byte chooses.
    \param open Reads what is in the folder.
  */
  Dataset(const std::function<void(const DatasetFolder &)> &put, const std::vector<std::string> &files,
          const std::function<bench::Sequence(const DatasetFolder &)> &open)
      : m_files(files), m_open(open)
  {
    put(m_folder);
    for (const std::string &file : files) {
      m_texts.push_back(m_folder.text(file));
    }
  }

  //! vpException is an answer; what else leaves, and numbers that are none, are faults.
  int read(const std::uint8_t *data, std::size_t size) const
  {
    if (size == 0) {
      return 0;
    }
    const std::size_t chosen = data[0] % m_files.size();
    m_folder.put(m_files[chosen], std::string(reinterpret_cast<const char *>(data + 1), size - 1));
    try {
      const bench::Sequence sequence = m_open(m_folder);
      if (!std::all_of(sequence.frames.begin(), sequence.frames.end(), isSound)) {
        std::cerr << "Fault: a frame has numbers that are none" << std::endl;
        std::abort();
      }
    } catch (const vpException &) { // Refused by name.
    }
    m_folder.put(m_files[chosen], m_texts[chosen]);
    return 0;
  }

private:
  static bool isSound(const bench::SequenceFrame &frame)
  {
    const vpCameraParameters &cam = frame.cam;
    return std::all_of(frame.cMo.data, frame.cMo.data + 16, [](double x) { return std::isfinite(x); }) &&
           std::isfinite(cam.get_u0()) && std::isfinite(cam.get_v0()) && std::isnormal(cam.get_px()) &&
           std::isnormal(cam.get_py()) && frame.visibility >= 0. && frame.visibility <= 1.;
  }

  DatasetFolder m_folder;
  std::vector<std::string> m_files;
  std::vector<std::string> m_texts; // Of the files as they should be.
  std::function<bench::Sequence(const DatasetFolder &)> m_open;
};
} // namespace fuzz

#endif
