#include "look_json.h"

#include "vtkMath.h"

#include <cmath>

namespace oversketch_session
{

namespace
{

constexpr double longestSide = 1e6; // px

std::optional<std::array<int, 2>> viewSizeOf(const JsonReader& json)
{
  if (!json.has("size"))
  {
    return std::nullopt;
  }
  const std::vector<double> size = json.numbers("size");
  const auto isLength = [](double length) { return length >= 1.0 && length <= longestSide; };
  if (size.size() != 2 || !isLength(size[0]) || !isLength(size[1]))
  {
    json.refuse("size", "is not two numbers from 1 to 1,000,000");
  }
  return std::array<int, 2>{ static_cast<int>(size[0]), static_cast<int>(size[1]) };
}

int upAxisOf(const JsonReader& json)
{
  const double axis = json.has("up_axis") ? json.number("up_axis") : 1.0;
  if (axis != 1.0 && axis != 2.0)
  {
    json.refuse("up_axis", "is neither 1 nor 2");
  }
  return static_cast<int>(axis);
}

} // namespace

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
  if (look.size)
  {
    json["size"].append((*look.size)[0]);
    json["size"].append((*look.size)[1]);
  }
  if (look.upAxis != 1)
  {
    json["up_axis"] = look.upAxis;
  }
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
    { shift[0], shift[1] },
    viewSizeOf(json),
    upAxisOf(json) };
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
