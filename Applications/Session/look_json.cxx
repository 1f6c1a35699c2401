#include "look_json.h"

#include "vtkMath.h"

#include <cmath>

namespace oversketch_session
{

Json::Value jsonOf(const Look& look)
{
  Json::Value json;
  json["position"] = jsonOf(look.position);
  json["focus"] = jsonOf(look.focus);
  json["up"] = jsonOf(look.up);
  json["angle"] = look.angle;
  json["height"] = look.height;
  json["parallel"] = look.parallel;
  json["shift"].append(look.shift[0]);
  json["shift"].append(look.shift[1]);
  return json;
}

Look lookOf(const JsonReader& json)
{
  const std::vector<double> shift = json.numbers("shift");
  if (shift.size() != 2)
  {
    json.refuse("shift", "is not two numbers");
  }
  const Look look{ json.point("position"),
    json.point("focus"),
    json.point("up"),
    json.number("angle"),
    json.number("height"),
    json.yes("parallel"),
    { shift[0], shift[1] } };
  double along[3], across[3];
  vtkMath::Subtract(look.focus.data(), look.position.data(), along);
  vtkMath::Cross(along, look.up.data(), across);
  if (!(vtkMath::Norm(across) > 1e-9 * vtkMath::Norm(along) * vtkMath::Norm(look.up.data())) ||
      !std::isfinite(vtkMath::Norm(across)))
  {
    json.refuse("up", "is not across the line of sight");
  }
  if (!(look.angle > 0.0 && look.angle < 180.0))
  {
    json.refuse("angle", "is not between 0 and 180 degrees");
  }
  if (!(look.height > 0.0))
  {
    json.refuse("height", "is not above 0");
  }
  return look;
}

} // namespace oversketch_session
