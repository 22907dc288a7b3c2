// SPDX-License-Identifier: GPL-2.0-or-later
// What test/compatibility/visp-programs puts before each program of ViSP, whichever tracker it uses: a display and a
// grabber that need no window, no mouse and no camera, and a note of what the tracker did. It includes nothing of the
// trackers, so that a program's own headers have to be enough.
#ifndef withoutWindow_h
#define withoutWindow_h

#include <visp3/core/vpCameraParameters.h>
#include <visp3/core/vpDisplay.h>
#include <visp3/core/vpHomogeneousMatrix.h>
#include <visp3/core/vpImage.h>

#include <string>

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

namespace withoutWindow {
//! Where the user would click next: VISP_PROGRAMS_CLICKS is "u,v u,v ...".
vpImagePoint nextClick();
//! The answer to questions that do not wait: VISP_PROGRAMS_READY=1 has the first one be "yes".
bool isClicked();
//! True where the grabber has no image left.
bool isOver();
//! Counts what was drawn.
void draw();
//! The next image of VISP_PROGRAMS_VIDEO.
void grab(vpImage<unsigned char> &I);
void grab(vpImage<vpRGBa> &I);
//! A line of VISP_PROGRAMS_POSES: number of the tracker, kind, pose, and how far the edges of VISP_PROGRAMS_MODEL are
//! off the image's gradients.
void note(const void *tracker, const std::string &kind, const vpImage<unsigned char> &I, const vpHomogeneousMatrix &cMo,
          const vpCameraParameters &cam);
void note(const void *tracker, const std::string &kind, const vpImage<vpRGBa> &I, const vpHomogeneousMatrix &cMo,
          const vpCameraParameters &cam);

//! After tracking, with the camera that the tracker has.
template <typename Tracker, typename Pixel> void noteTracked(const Tracker &tracker, const vpImage<Pixel> &I)
{
  vpHomogeneousMatrix cMo;
  vpCameraParameters cam;
  tracker.getPose(cMo);
  tracker.getCameraParameters(cam);
  note(&tracker, "tracked", I, cMo, cam);
}
template <typename Tracker, typename Pixel> void noteTracked(Tracker *tracker, const vpImage<Pixel> &I)
{
  noteTracked(*tracker, I);
}
//! After a pose was given, with the camera of the image: tutorial-detection-object-mbt2 leaves the tracker another one.
template <typename Tracker, typename Pixel>
void noteSet(const Tracker &tracker, const vpImage<Pixel> &I, const vpCameraParameters &cam)
{
  vpHomogeneousMatrix cMo;
  tracker.getPose(cMo);
  note(&tracker, "set", I, cMo, cam);
}
} // namespace withoutWindow

//! In the place of vpDisplayX.
class vpDisplayWithoutWindow : public vpDisplay
{
public:
  vpDisplayWithoutWindow() = default;
  template <typename Pixel> explicit vpDisplayWithoutWindow(vpImage<Pixel> &I, vpScaleType = SCALE_DEFAULT) { show(I); }
  template <typename Pixel>
  vpDisplayWithoutWindow(vpImage<Pixel> &I, int, int, const std::string & = "", vpScaleType = SCALE_DEFAULT)
  {
    show(I);
  }

  void init(vpImage<unsigned char> &I, int = -1, int = -1, const std::string & = "") override { show(I); }
  void init(vpImage<vpRGBa> &I, int = -1, int = -1, const std::string & = "") override { show(I); }
  void init(unsigned int width, unsigned int height, int = -1, int = -1, const std::string & = "") override
  {
    m_width = width;
    m_height = height;
    m_displayHasBeenInitialized = true;
  }

  bool getClick(bool blocking = true) override { return blocking || withoutWindow::isClicked(); }
  bool getClick(vpImagePoint &ip, bool blocking = true) override
  {
    if (blocking) {
      ip = withoutWindow::nextClick();
    }
    return blocking;
  }
  // The right button ends the programs that grab.
  bool getClick(vpImagePoint &, vpMouseButton::vpMouseButtonType &button, bool blocking = true) override
  {
    button = blocking ? vpMouseButton::button1 : vpMouseButton::button3;
    return blocking || withoutWindow::isOver();
  }
  bool getClickUp(vpImagePoint &, vpMouseButton::vpMouseButtonType &button, bool blocking = true) override
  {
    button = vpMouseButton::button1;
    return blocking;
  }
  bool getKeyboardEvent(bool blocking = true) override { return blocking; }
  bool getKeyboardEvent(std::string &key, bool blocking = true) override
  {
    key.clear();
    return blocking;
  }
  bool getPointerMotionEvent(vpImagePoint &) override { return false; }
  bool getPointerPosition(vpImagePoint &) override { return false; }

  unsigned int getScreenHeight() override { return 1080; }
  unsigned int getScreenWidth() override { return 1920; }
  void getScreenSize(unsigned int &width, unsigned int &height) override
  {
    width = getScreenWidth();
    height = getScreenHeight();
  }
  void clearDisplay(const vpColor & = vpColor::white) override {}
  void closeDisplay() override {}
  void flushDisplay() override {}
  void flushDisplayROI(const vpImagePoint &, unsigned int, unsigned int) override {}
  void setFont(const std::string &) override {}
  void setTitle(const std::string &) override {}
  void setWindowPosition(int, int) override {}

  void displayImage(const vpImage<unsigned char> &) override {}
  void displayImage(const vpImage<vpRGBa> &) override {}
  void displayImageROI(const vpImage<unsigned char> &, const vpImagePoint &, unsigned int, unsigned int) override {}
  void displayImageROI(const vpImage<vpRGBa> &, const vpImagePoint &, unsigned int, unsigned int) override {}
  void displayCharString(const vpImagePoint &, const char *, const vpColor & = vpColor::green) override {}
  void displayArrow(const vpImagePoint &, const vpImagePoint &, const vpColor & = vpColor::white, unsigned int = 4,
                    unsigned int = 2, unsigned int = 1) override
  {
  }
  void displayCircle(const vpImagePoint &, unsigned int, const vpColor &, bool = false, unsigned int = 1) override
  {
    withoutWindow::draw();
  }
  void displayCross(const vpImagePoint &, unsigned int, const vpColor &, unsigned int = 1) override
  {
    withoutWindow::draw();
  }
  void displayDotLine(const vpImagePoint &, const vpImagePoint &, const vpColor &, unsigned int = 1) override
  {
    withoutWindow::draw();
  }
  void displayLine(const vpImagePoint &, const vpImagePoint &, const vpColor &, unsigned int = 1) override
  {
    withoutWindow::draw();
  }
  void displayPoint(const vpImagePoint &, const vpColor &, unsigned int = 1) override { withoutWindow::draw(); }
  void displayRectangle(const vpImagePoint &, unsigned int, unsigned int, const vpColor &, bool = false,
                        unsigned int = 1) override
  {
  }
  void displayRectangle(const vpImagePoint &, const vpImagePoint &, const vpColor &, bool = false,
                        unsigned int = 1) override
  {
  }
  void displayRectangle(const vpRect &, const vpColor &, bool = false, unsigned int = 1) override {}

private:
  void getImage(vpImage<vpRGBa> &) override {}
  template <typename Pixel> void show(vpImage<Pixel> &I)
  {
    vpDisplayWithoutWindow::init(I.getWidth(), I.getHeight());
    I.display = this;
  }
};

//! In the place of vpV4l2Grabber.
class vpGrabberWithoutCamera
{
public:
  void setDevice(const std::string &) {}
  void setScale(unsigned int) {}
  template <typename Pixel> void open(vpImage<Pixel> &I) { withoutWindow::grab(I); }
  template <typename Pixel> void acquire(vpImage<Pixel> &I) { withoutWindow::grab(I); }
};

#endif
