// SPDX-License-Identifier: GPL-2.0-or-later
//! \example tutorial-multicue-hypotheses.cpp
// Draws what one image offers a pose: candidates, potential edges, and the poses that they allow.
#include <visp3/core/vpImageConvert.h>
#include <visp3/core/vpPoseVector.h>
#include <visp3/cues/vpFrameSource.h>
#include <visp3/io/vpImageIo.h>
#include <visp3/multicue/vpMbMultiCueTracker.h>

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include <fstream>
#include <iostream>

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

namespace {
cv::Point2d toPoint(const Eigen::Vector2d &pixel)
{
  return {pixel.x(), pixel.y()};
}

// A fraction of a pixel is drawn as well.
void drawLine(cv::Mat &picture, const cv::Point2d &a, const cv::Point2d &b, const cv::Scalar &color, int thickness)
{
  const int bits = 4;
  cv::line(picture, cv::Point(a * (1 << bits)), cv::Point(b * (1 << bits)), color, thickness, cv::LINE_AA, bits);
}

// What is around the object.
cv::Rect surroundings(const vpModelView &view, const cv::Size &size)
{
  const int margin = 25;
  std::vector<cv::Point2f> points;
  for (const vpControlPoint &point : view.points()) {
    points.emplace_back(toPoint(point.pixel));
  }
  const cv::Rect box = cv::boundingRect(points);
  return cv::Rect(box.tl() - cv::Point(margin, margin), box.br() + cv::Point(margin, margin)) &
         cv::Rect(cv::Point(0, 0), size);
}

void write(const std::string &file, const cv::Mat &picture)
{
  if (!cv::imwrite(file, picture)) {
    throw vpException(vpException::ioError, file + " cannot be written: is there such a folder?");
  }
}

// ViSP's .pos files: translation and theta u.
vpHomogeneousMatrix readPose(const std::string &file)
{
  std::ifstream stream(file);
  vpPoseVector pose;
  for (unsigned int i = 0; i < 6; ++i) {
    if (!(stream >> pose[i])) {
      throw vpException(vpException::ioError, file + " does not hold the six numbers of a pose");
    }
  }
  return vpHomogeneousMatrix(pose);
}

//! [Candidates]
// Normals along which was searched, and everything that was found on them.
void drawCandidates(cv::Mat &picture, const vpEdgeCue &edges)
{
  const double range = edges.settings().range;
  const std::size_t every = 3; // All normals would hide the image.
  for (std::size_t k = 0; k < edges.matches().size(); k += every) {
    const vpEdgeCue::Match &match = edges.matches()[k];
    const vpControlPoint &point = match.point;
    drawLine(picture, toPoint(point.pixel - range * point.normal), toPoint(point.pixel + range * point.normal),
             cv::Scalar(230, 180, 60), 1);
    for (int i = match.first; i < match.first + match.count; ++i) {
      const double offset = edges.candidates()[static_cast<std::size_t>(i)].offset;
      cv::circle(picture, toPoint(point.pixel + offset * point.normal), 1, cv::Scalar(40, 40, 230), cv::FILLED);
    }
  }
}
//! [Candidates]

//! [Lines]
// The likely ones in dark gray, the unlikely ones in light gray.
void drawPotentialEdges(cv::Mat &picture, const vpPoseHypotheses &hypotheses)
{
  for (const vpPoseHypotheses::Line &line : hypotheses.lines()) {
    const double gray = 210. * (1. - line.weight);
    for (std::size_t i = 1; i < line.points.size(); ++i) {
      drawLine(picture, toPoint(line.points[i - 1]), toPoint(line.points[i]), cv::Scalar::all(gray), 2);
    }
  }
}
//! [Lines]

//! [Poses]
// The best one in green and on top, the next one in red.
void drawPoses(cv::Mat &picture, vpMbMultiCueTracker &tracker, const std::vector<vpPoseHypothesis> &found)
{
  const cv::Scalar colors[] = {{60, 220, 60}, {60, 60, 255}};
  vpCameraParameters cam;
  tracker.getCameraParameters(cam);
  for (std::size_t h = std::min<std::size_t>(found.size(), 2); h-- > 0;) {
    for (const std::vector<double> &line : tracker.getModelForDisplay(
             static_cast<unsigned int>(picture.cols), static_cast<unsigned int>(picture.rows), found[h].cMo, cam)) {
      drawLine(picture, {line[2], line[1]}, {line[4], line[3]}, colors[h], 2);
    }
  }
}
//! [Poses]

void print(const std::vector<vpPoseHypothesis> &found)
{
  for (const vpPoseHypothesis &pose : found) {
    std::cout << "residue " << pose.residue << " px, weight " << pose.weight << ", translation "
              << pose.cMo.getTranslationVector().t() << std::endl;
  }
}

void run(const std::string &file, const std::string &model, const std::string &config, const std::string &pose,
         const std::string &folder)
{
  vpImage<vpRGBa> I;
  vpImageIo::read(I, file);
  vpMbMultiCueTracker tracker(vpMbMultiCueTracker::EDGE_TRACKER);
  tracker.loadConfigFile(config, false);
  tracker.loadModel(model);

  //! [Find]
  const vpHomogeneousMatrix cMo = readPose(pose);
  vpCameraParameters cam;
  tracker.getCameraParameters(cam);
  const std::unique_ptr<vpModelRenderer> renderer = vpModelRenderer::create(tracker.getModel());
  vpModelView view(tracker.getModel());
  view.compute(cMo, cam, I.getWidth(), I.getHeight(), vpModelViewOptions(), renderer.get());
  vpFrameSource source;
  vpEdgeCue edges(tracker.getEdgeSettings());
  edges.match(source.frame(I, cam, nullptr), view);
  vpPoseHypotheses hypotheses(tracker.getPoseHypothesisSettings());
  const std::vector<vpPoseHypothesis> &found = hypotheses.find(edges, view, cMo, 0);
  //! [Find]

  cv::Mat image;
  vpImageConvert::convert(I, image);
  // Lines in gray are seen on a pale image.
  const cv::Mat pale = 0.4 * image + cv::Scalar::all(150.);
  cv::Mat candidates = image.clone();
  cv::Mat lines = pale.clone();
  drawCandidates(candidates, edges);
  drawPotentialEdges(lines, hypotheses);
  drawPoses(image, tracker, found);
  const cv::Rect part = surroundings(view, image.size());
  write(folder + "/hypotheses1.jpg", candidates(part));
  write(folder + "/hypotheses2.jpg", lines(part));
  write(folder + "/hypotheses3.jpg", image(part));
  print(found);
}
} // namespace

int main(int argc, char *argv[])
{
  if (argc != 6) {
    std::cerr << "Usage: " << argv[0] << " <image> <model> <config> <pose.pos> <folder of the pictures>" << std::endl;
    return 1;
  }
  try {
    run(argv[1], argv[2], argv[3], argv[4], argv[5]);
  } catch (const std::exception &e) {
    std::cerr << "tutorial-multicue-hypotheses: " << e.what() << std::endl;
    return 1;
  }
  return 0;
}
