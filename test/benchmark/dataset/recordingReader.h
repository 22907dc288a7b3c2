// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef benchRecordingReader_h
#define benchRecordingReader_h

#include "dataset/sequence.h"

namespace bench {
/*!
  Recordings in the way of ViSP's own image data: numbered images, a text file of 4 x 4 numbers for each pose, ViSP's
  XML files for the camera.
*/
namespace recordingReader {
//! \throw vpException as openRecording().
Sequence open(const Recording &recording);
} // namespace recordingReader

} // namespace bench
#endif
