// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef benchImageStore_h
#define benchImageStore_h

#include "frames/imageFile.h"
#include "evaluate/benchTracker.h"

#include <opencv2/core.hpp>

#include <unordered_map>

namespace bench {

//! Decoded images of one sequence: several runs read the same ones, and decoding takes longer than tracking.
class ImageStore
{
public:
  //! \param sequence Must outlive the store.
  explicit ImageStore(const Sequence &sequence) : m_sequence(sequence) {}

  /*!
    \param index Into Sequence::frames.
    \param I Result.
    \throw vpException naming the file where it is no image, or of another size than the first one of the sequence.
  */
  void get(std::size_t index, BenchImage &I);

private:
  const cv::Mat &decoded(std::size_t index);

  const Sequence &m_sequence;
  std::unordered_map<std::size_t, cv::Mat> m_images;
  cv::Mat m_last; // Where the store is full.
  cv::Size m_size;
  programs::ImageDepth m_depth;
  std::size_t m_bytes = 0;
};

} // namespace bench
#endif
