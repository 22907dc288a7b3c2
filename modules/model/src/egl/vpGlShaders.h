// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpGlShaders_h
#define vpGlShaders_h

#include <visp3/se3/vpCompatibility.h>

BEGIN_VISP_NAMESPACE

//! "objectToClip" has the depth as clip coordinate w.
constexpr const char *vpGlVertexShader = R"(#version 330 core
uniform mat4 objectToClip;
layout(location = 0) in vec3 position;
out float depth;
void main()
{
  gl_Position = objectToClip * vec4(position, 1.0);
  depth = gl_Position.w;
}
)";

//! Depth along the optical axis and index of the triangle.
constexpr const char *vpGlFragmentShader = R"(#version 330 core
in float depth;
layout(location = 0) out float pixelDepth;
layout(location = 1) out int pixelTriangle;
void main()
{
  pixelDepth = depth;
  pixelTriangle = gl_PrimitiveID;
}
)";

END_VISP_NAMESPACE
#endif
