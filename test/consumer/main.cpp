// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/core/vpHomogeneousMatrix.h>
#include <visp3/se3/vpCompatibility.h>

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

int main()
{
  const vpHomogeneousMatrix cMo;
  return cMo.isAnHomogeneousMatrix() ? 0 : 1;
}
