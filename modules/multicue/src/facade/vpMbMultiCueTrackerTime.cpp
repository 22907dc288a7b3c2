// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/multicue/vpMbMultiCueTracker.h>

#include "facade/vpTrackerImpl.h"

#include <visp3/core/vpException.h>

#include <filesystem>
#include <fstream>

BEGIN_VISP_NAMESPACE

void vpMbMultiCueTracker::setFrameDeadline(double milliseconds)
{
  m_impl->engine().deadline.set(milliseconds);
  m_impl->choice.keepsDeadline = true;
}

double vpMbMultiCueTracker::getFrameDeadline() const
{
  return m_impl->engine().deadline.get();
}

void vpMbMultiCueTracker::setViewCache(const std::string &folder)
{
  if (!folder.empty()) {
    const std::filesystem::path trial = std::filesystem::path(folder) / ".multicue-views";
    const bool isWritten = static_cast<bool>(std::ofstream(trial) << '\n' << std::flush);
    std::error_code ignored;
    std::filesystem::remove(trial, ignored);
    if (!isWritten) {
      throw vpException(vpException::ioError,
                        "Views cannot be kept in '" + folder + "': give a folder that is there and can be written to");
    }
  }
  m_impl->engine().setViewCache(folder);
}

std::string vpMbMultiCueTracker::getViewCache() const
{
  return m_impl->engine().viewCache();
}

END_VISP_NAMESPACE
