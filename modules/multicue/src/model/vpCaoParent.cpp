// SPDX-License-Identifier: GPL-2.0-or-later
#include "model/vpCaoParent.h"

#include <fstream>

BEGIN_VISP_NAMESPACE

unsigned int countPartsOfCaoParent(const std::string &modelFile)
{
  std::ifstream file(modelFile);
  std::string line;
  bool versionSeen = false;
  unsigned int parts = 0;
  while (std::getline(file, line)) {
    const std::size_t start = line.find_first_not_of(" \t\r");
    if (start == std::string::npos || line[start] == '#') {
      continue;
    }
    if (!versionSeen) {
      if (line[start] != 'V') {
        return 0;
      }
      versionSeen = true;
    } else if (line.compare(start, 5, "load(") == 0) {
      ++parts;
    } else {
      return 0;
    }
  }
  return parts;
}

END_VISP_NAMESPACE
