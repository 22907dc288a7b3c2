// SPDX-License-Identifier: GPL-2.0-or-later
#include "sphere/vpFingerprint.h"

#include <visp3/model/vpViewSphere.h>

BEGIN_VISP_NAMESPACE

namespace {
void addFaces(vpFingerprint &print, const vpTrackedModel &model)
{
  print.add(model.faces().size());
  for (const vpModelFace &face : model.faces()) {
    print.add(face.normal);
    print.add(face.centre);
    print.add(face.planar);
    print.add(face.oriented);
    print.add(face.corners);
  }
}

void addEdges(vpFingerprint &print, const vpTrackedModel &model)
{
  print.add(model.edges().size());
  for (const vpModelEdge &edge : model.edges()) {
    print.add(edge.vertex);
    print.add(edge.firstFace);
    print.add(edge.faceCount);
    print.add(edge.line);
  }
  print.add(model.edgeFaces());
}

void addRoundParts(vpFingerprint &print, const vpTrackedModel &model)
{
  print.add(model.cylinders().size());
  for (const vpModelCylinder &cylinder : model.cylinders()) {
    print.add(cylinder.axis);
    print.add(cylinder.radius);
    print.add(cylinder.face);
  }
  print.add(model.circles().size());
  for (const vpModelCircle &circle : model.circles()) {
    print.add(circle.centre);
    print.add(circle.normal);
    print.add(circle.radius);
    print.add(circle.face);
  }
}

void addSurface(vpFingerprint &print, const vpTrackedModel &model)
{
  print.add(model.vertices());
  print.add(model.normals());
  print.add(model.triangles().size());
  for (const vpModelTriangle &triangle : model.triangles()) {
    print.add(triangle.vertex);
    print.add(triangle.normal);
    print.add(triangle.face);
  }
  print.add(model.smoothTriangles());
  print.add(model.isConvex());
}

void addTexture(vpFingerprint &print, const vpModelAppearance &appearance)
{
  print.add(appearance.color);
  print.add(appearance.texture);
  print.add(appearance.image);
  for (const vpImage<vpRGBa> &image : appearance.images) {
    print.add(image.getHeight());
    print.add(image.getWidth());
    print.addBytes(image.bitmap, image.getSize() * sizeof(vpRGBa));
  }
}

void addOptions(vpFingerprint &print, const vpViewSphereOptions &options)
{
  print.add(options.level);
  print.add(options.distance);
  print.add(options.points);
  print.add(options.view.sampleStep);
  print.add(options.view.appearAngle);
  print.add(options.view.visibilitySize);
  print.add(options.view.allEdges);
  print.add(options.view.textureEdges);
  print.add(options.view.textureEdgesLeftOut);
  print.add(options.view.details.size());
  for (const vpFaceDetail &detail : options.view.details) {
    print.add(detail.enabled);
    print.add(detail.minLineLength);
    print.add(detail.minPolygonArea);
    print.add(detail.tracked);
  }
}
} // namespace

std::uint64_t fingerprintOf(const vpTrackedModel &model, const vpViewSphereOptions &options)
{
  vpFingerprint print;
  addOptions(print, options);
  addSurface(print, model);
  addFaces(print, model);
  addEdges(print, model);
  addRoundParts(print, model);
  if (options.view.textureEdges) {
    addTexture(print, model.appearance());
  }
  return print.value();
}

END_VISP_NAMESPACE
