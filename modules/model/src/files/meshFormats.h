// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef meshFormats_h
#define meshFormats_h

#include "files/meshSink.h"

/*!
  \file meshFormats.h
  Readers of the formats that are read to the letter. assimp 5 reads them too, but repeats or drops what it does not
  understand without a word, so that a file would have to be read here anyway to find out; on some files of COLLADA it
  ends the program.
*/

BEGIN_VISP_NAMESPACE
namespace vpMeshDetail {
//! \throw vpException naming file and line of what is wrong.
void readObj(MeshSink &sink);
//! \throw vpException naming the file, and line or element of what is wrong.
void readPly(MeshSink &sink);
//! Text or binary. \throw vpException naming the file, and the line of what is wrong.
void readStl(MeshSink &sink);
//! COLLADA, as far as it is meshes in nodes. \throw vpException naming the file, and what is wrong in it.
void readDae(MeshSink &sink);
} // namespace vpMeshDetail
END_VISP_NAMESPACE
#endif
