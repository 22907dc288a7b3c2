// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpViewMaker_h
#define vpViewMaker_h

#include <visp3/model/vpViewSphere.h>

#include <atomic>
#include <thread>

BEGIN_VISP_NAMESPACE

/*!
  Makes the views of a sphere beside the frames, coarse levels first, so that none of them has to be waited for. Once
  all are made, they may be kept in a folder for the next start of the program.

  As long as it lives, nobody else may make views; those of level() may be looked at.
*/
class vpViewMaker
{
public:
  //! Begins to make those that are not made yet. \param sphere To live longer. \param folder Where to keep them; empty:
  //! nowhere.
  vpViewMaker(vpViewSphere &sphere, const std::string &folder);
  //! Waits for the view that is being made.
  ~vpViewMaker();
  vpViewMaker(const vpViewMaker &) = delete;
  vpViewMaker &operator=(const vpViewMaker &) = delete;

  //! True where all views of a level are made.
  bool has(unsigned int level) const { return m_made.load(std::memory_order_acquire) >= vpViewSphere::size(level); }
  //! The finest one; 0 where there is none, too.
  unsigned int level() const;

private:
  void run() noexcept;
  void make();

  vpViewSphere &m_sphere;
  std::string m_folder;
  std::atomic<std::size_t> m_made{0}; // From the first one on.
  std::atomic<bool> m_mustStop{false};
  std::thread m_thread; // Of all the above: the last one.
};

END_VISP_NAMESPACE
#endif
