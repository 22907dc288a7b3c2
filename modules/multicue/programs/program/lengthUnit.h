// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef programsLengthUnit_h
#define programsLengthUnit_h

#include <string>

namespace programs {

//! \param unit "m", "cm", "mm" or "inch". \return Metres. \throw vpException for others.
double metresPerUnit(const std::string &unit);

} // namespace programs
#endif
