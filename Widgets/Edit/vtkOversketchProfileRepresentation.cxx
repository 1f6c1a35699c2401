#include "vtkOversketchProfileRepresentation.h"

#include "drawn_curve.h"
#include "edit_overlay.h"

#include "Mesh/context.h"
#include "Stroke/canvas.h"
#include "Stroke/resketch.h"
#include "vtkOversketchFilterTools.h"

#include "vtkCamera.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkRenderer.h"

#include <algorithm>

using namespace oversketch;

vtkStandardNewMacro(vtkOversketchProfileRepresentation);

struct vtkOversketchProfileRepresentation::Internals
{
  std::vector<Vector3> profile, drawn; // z = 0; drawn is empty without strokes

  const std::vector<Vector3>& now() const { return this->drawn.empty() ? this->profile : this->drawn; }
};

vtkOversketchProfileRepresentation::vtkOversketchProfileRepresentation()
  : Inner(std::make_unique<Internals>())
{
}

vtkOversketchProfileRepresentation::~vtkOversketchProfileRepresentation() = default;

void vtkOversketchProfileRepresentation::SetProfile(vtkPolyData* profile, vtkPolyData* strokes)
{
  Internals& inner = *this->Inner;
  inner.profile = firstLineOf(profile);
  inner.drawn.clear();
  for (const auto& stroke : strokesOf(inner.profile.empty() ? nullptr : strokes))
  {
    Polyline fresh;
    try
    {
      fresh = ontoCanvas(ViewOf(stroke), flat(firstLineOf(stroke)));
    }
    catch (const Error& error)
    {
      vtkErrorMacro(<< error.what());
      continue;
    }
    ResketchRules rules;
    const Polyline before = flat(inner.now());
    rules.spacing = arcLengths(before).back() / 400.0; // as the edit samples a drawn profile
    const Polyline merged = resketch(before, fresh, rules).points;
    inner.drawn.clear();
    for (const Vector2& p : merged)
    {
      inner.drawn.emplace_back(p[0], p[1], 0.0);
    }
  }
  this->Modified();
}

void vtkOversketchProfileRepresentation::GetDrawn(vtkPolyData* drawn)
{
  putLine(drawn, this->Inner->now());
}

void vtkOversketchProfileRepresentation::ResetView()
{
  if (!this->Renderer)
  {
    return;
  }
  Vector2 low(0.0, 0.0), high(1.0, 0.0);
  for (const Vector2& p : flat(this->Inner->now()))
  {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const int* size = this->Renderer->GetSize();
  const double aspect = size[1] > 0 ? static_cast<double>(size[0]) / size[1] : 1.0;
  const Vector2 middle = 0.5 * (low + high), extent = (high - low).cwiseMax(Vector2(0.8, 0.8));
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetParallelScale(0.5 * 1.3 * std::max(extent[1], extent[0] / std::max(aspect, 1e-6)));
  camera->SetFocalPoint(middle[0], middle[1], 0.0);
  camera->SetPosition(middle[0], middle[1], 10.0);
  camera->SetViewUp(0.0, 1.0, 0.0);
  camera->SetClippingRange(5.0, 15.0);
}

void vtkOversketchProfileRepresentation::Paint(const View& view, Overlay& overlay)
{
  const Internals& inner = *this->Inner;
  if (inner.profile.size() < 2)
  {
    return;
  }
  const auto seen = [&](const Vector3& p) { return Vector2(view.toDisplay(p).head<2>()); };
  overlay.line({ seen(inner.profile.front()), seen(inner.profile.back()) }, 1.5, { 190, 190, 196, 255 });
  const std::vector<double> shares = sharesOf(inner.profile);
  const Vector2 from = seen(placeAt(inner.profile, shares, 0.5));
  const Vector2 up = (seen(Vector3::UnitY()) - seen(Vector3::Zero())).normalized(), beside(up[1], -up[0]);
  overlay.line({ from, from + 40.0 * up }, 2.5, inkGrey);
  overlay.polygon(
    { from + 50.0 * up, from + 36.0 * up + 7.0 * beside, from + 36.0 * up - 7.0 * beside }, inkGrey);
  overlay.profile(seenIn(view, inner.profile), 4.0);
  overlay.rimmed(seenIn(view, inner.drawn), 3.0, strokeRed);
}

void vtkOversketchProfileRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Profile: " << this->Inner->profile.size() << " points\n";
  os << indent << "Drawn: " << this->Inner->drawn.size() << " points\n";
}
