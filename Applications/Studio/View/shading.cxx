#include "shading.h"

#include "vtkActor.h"
#include "vtkProperty.h"
#include "vtkShaderProperty.h"

namespace oversketch_studio
{

namespace
{

constexpr const char* place = "//VTK::Light::Impl";

// The colour by the way the surface faces, seen from the eye: of a ball of clay under a warm light from above
// and the left, a cool one from below and the right, and a bright rim. Lights of the scene, colours and
// pictures do not count. Reflected, so that a perspective shows flat faces alike wherever they are.
constexpr const char* clay = R"(//VTK::Light::Impl
  {
    vec3 seen = cameraParallel == 1 ? vec3(0.0, 0.0, -1.0) : normalize(vertexVC.xyz);
    vec3 away = reflect(seen, normalVCVSOutput);
    float m = 2.0 * sqrt(away.x * away.x + away.y * away.y + (away.z + 1.0) * (away.z + 1.0));
    vec2 on = 2.0 * away.xy / max(m, 1e-6); // the ball's picture [-1 to 1]
    float high = sqrt(max(0.0, 1.0 - dot(on, on)));
    vec3 ball = vec3(on, high);
    float warm = max(0.0, dot(ball, normalize(vec3(-0.45, 0.65, 0.61))));
    float cool = max(0.0, dot(ball, normalize(vec3(0.70, -0.55, 0.45))));
    float shine = pow(max(0.0, dot(ball, normalize(vec3(-0.28, 0.42, 0.86)))), 28.0);
    float rim = pow(1.0 - high, 3.0);
    vec3 colour = vec3(0.16, 0.09, 0.08) + warm * vec3(0.66, 0.40, 0.31) + cool * vec3(0.10, 0.13, 0.18);
    gl_FragData[0].rgb = colour + 0.30 * shine + rim * vec3(0.22, 0.20, 0.22);
  }
)";

} // namespace

void shade(vtkActor* actor, Shading shading)
{
  vtkProperty* look = actor->GetProperty();
  shading == Shading::Flat ? look->SetInterpolationToFlat() : look->SetInterpolationToGouraud();
  look->SetEdgeVisibility(shading == Shading::Wire);
  look->SetEdgeColor(0.33, 0.34, 0.36);
  vtkShaderProperty* shaders = actor->GetShaderProperty();
  shaders->ClearFragmentShaderReplacement(place, false);
  if (shading == Shading::Matcap)
  {
    shaders->AddFragmentShaderReplacement(place, false, clay, false);
  }
}

// Without a picture this place is free; a picture has no alpha here (opaquePicture).
void makeOpaque(vtkActor* actor)
{
  actor->GetShaderProperty()->AddFragmentShaderReplacement(
    "//VTK::TCoord::Impl", false, "//VTK::TCoord::Impl\n  gl_FragData[0].a = 1.0;\n", false);
}

} // namespace oversketch_studio
