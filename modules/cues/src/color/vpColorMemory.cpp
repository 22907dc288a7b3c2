// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/cues/vpColorMemory.h>
#include <visp3/se3/vpExactNumber.h>

#include <algorithm>
#include <cmath>

BEGIN_VISP_NAMESPACE

namespace {
const std::uint32_t slots = 4096; // A power of two.
// Two or three control points of an object that is seen as large as usual share a cell.
const double cellsPerDiameter = 32.;
const int mostCells = 63; // Along an axis, so that a cell's number has six bits for each.
} // namespace

void vpColorMemory::clear()
{
  beginFrame();
}

void vpColorMemory::setModel(const vpTrackedModel &model)
{
  const double cellSize = model.diameter() / cellsPerDiameter;
  if (vpIsOther(cellSize, m_cellSize) || model.boxMin() != m_origin) {
    m_cellSize = cellSize;
    m_origin = model.boxMin();
    clear();
  }
}

void vpColorMemory::beginFrame()
{
  m_slots.resize(slots);
  ++m_frame;
  m_used = 0;
}

std::uint32_t vpColorMemory::cellOf(const Eigen::Vector3d &position) const
{
  std::uint32_t cell = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double place = m_cellSize > 0. ? (position[axis] - m_origin[axis]) / m_cellSize : 0.;
    cell = cell << 6U | static_cast<std::uint32_t>(std::min(std::max(place, 0.), static_cast<double>(mostCells)));
  }
  return cell;
}

int vpColorMemory::slotOf(std::uint32_t cell) const
{
  if (m_slots.empty() || m_used >= slots / 2) {
    return -1;
  }
  std::uint32_t slot = (cell * 2654435761U) >> 20U; // The upper twelve bits: slots of them.
  while (m_slots[slot].frame == m_frame && m_slots[slot].cell != cell) {
    slot = (slot + 1) % slots;
  }
  return static_cast<int>(slot);
}

// The slot of a place, which is made where there is none; null where the table is full.
vpColorMemory::Slot *vpColorMemory::take(const Eigen::Vector3d &position)
{
  const std::uint32_t cell = cellOf(position);
  const int index = slotOf(cell);
  if (index < 0) {
    return nullptr;
  }
  Slot &slot = m_slots[static_cast<std::size_t>(index)];
  if (slot.frame != m_frame) {
    slot = Slot();
    slot.cell = cell;
    slot.frame = m_frame;
    ++m_used;
  }
  return &slot;
}

const vpColorMemory::Slot *vpColorMemory::look(const Eigen::Vector3d &position) const
{
  const int index = slotOf(cellOf(position));
  return index < 0 || m_slots[static_cast<std::size_t>(index)].frame != m_frame
             ? nullptr
             : &m_slots[static_cast<std::size_t>(index)];
}

void vpColorMemory::add(const Eigen::Vector3d &position, const Means &means)
{
  if (Slot *slot = take(position)) {
    slot->count += 1.F;
    slot->sum.object += means.object;
    slot->sum.background += means.background;
  }
}

void vpColorMemory::addEvidence(const Eigen::Vector3d &position, double evidence)
{
  if (Slot *slot = take(position)) {
    slot->evidenceCount += 1.F;
    slot->evidence += static_cast<float>(evidence);
  }
}

double vpColorMemory::evidence(const Eigen::Vector3d &position, double unknown) const
{
  const Slot *slot = look(position);
  return slot == nullptr || vpIsZero(slot->evidenceCount) ? unknown
                                                          : static_cast<double>(slot->evidence / slot->evidenceCount);
}

bool vpColorMemory::find(const Eigen::Vector3d &position, Means &means) const
{
  const Slot *slot = look(position);
  if (slot == nullptr || vpIsZero(slot->count)) {
    return false;
  }
  means.object = slot->sum.object / slot->count;
  means.background = slot->sum.background / slot->count;
  return true;
}

END_VISP_NAMESPACE
