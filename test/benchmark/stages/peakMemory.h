// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef benchPeakMemory_h
#define benchPeakMemory_h

#include <fstream>
#include <string>

namespace bench {

//! The memory of this process since this was made, MB of resident pages; 0 where the system does not tell it (Linux
//! does).
class PeakMemory
{
public:
  PeakMemory()
  {
    std::ofstream("/proc/self/clear_refs") << "5"; // Lets the kernel forget the peak before.
    m_before = read("VmRSS:");
  }

  double most() const { return read("VmHWM:") - m_before; }
  double now() const { return read("VmRSS:") - m_before; }

private:
  static double read(const std::string &name)
  {
    std::ifstream status("/proc/self/status");
    for (std::string word; status >> word;) {
      double kilobytes = 0.;
      if (word == name && status >> kilobytes) {
        return kilobytes / 1024.;
      }
    }
    return 0.;
  }

  double m_before = 0.;
};

} // namespace bench
#endif
