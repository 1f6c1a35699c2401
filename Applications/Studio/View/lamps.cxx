#include "lamps.h"

#include "vtkLight.h"
#include "vtkLightKit.h"
#include "vtkRenderer.h"

namespace oversketch_studio
{

namespace
{

// White with the shine of ModelView is then just below white.
constexpr double headIntensity = 0.86;

} // namespace

Lamps::Lamps(vtkRenderer* renderer)
  : Renderer(renderer)
{
  this->Kit->SetKeyLightWarmth(0.55);
  this->Kit->SetKeyToFillRatio(2.5);
  this->Head->SetLightTypeToHeadlight();
  this->Head->SetIntensity(headIntensity);
  this->set(Light::Three);
}

Lamps::~Lamps() = default;

void Lamps::set(Light light)
{
  this->Renderer->RemoveAllLights();
  light == Light::Head ? this->Renderer->AddLight(this->Head)
                       : this->Kit->AddLightsToRenderer(this->Renderer);
}

} // namespace oversketch_studio
