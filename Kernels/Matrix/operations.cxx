#include "Matrix/operations.h"

#include "Mesh/context.h"

#include <array>
#include <cmath>
#include <locale>
#include <set>
#include <sstream>

namespace oversketch
{
namespace
{

constexpr const char* howTo = "write \"move T AXIS LENGTH\", \"rotate T AXIS DEGREES\", \"scale T AXIS "
                              "FACTOR\", \"pin T\" or \"drag X Y\", "
                              "apart by semicolons, with T from 0 to 1 along the curve and AXIS t, w or n";

struct Operation
{
  std::string name; // for messages
  std::string verb;
  double t = 0.0;
  HandleAxis axis = HandleAxis::Along;
  double amount = 0.0;
  Vector2 pixels = Vector2::Zero(); // of a drag

  [[noreturn]] void refuse(const std::string& why) const
  {
    throw Error(Failure::BadStroke, this->name + ": " + why);
  }
};

// The next word of a text.
std::string wordOf(std::istringstream& words)
{
  std::string word;
  words >> word;
  return word;
}

double numberOf(const Operation& operation, std::istringstream& words, const char* what)
{
  const std::string word = wordOf(words);
  std::istringstream digits(word);
  digits.imbue(std::locale::classic());
  double number = 0.0;
  if (!(digits >> number) || !digits.eof() || !std::isfinite(number))
  {
    operation.refuse(std::string("its ") + what + (word.empty() ? " is missing" : " is \"" + word + "\"") +
                     "; " + howTo + ".");
  }
  return number;
}

Operation operationOf(const std::string& text, int number)
{
  std::istringstream words(text);
  Operation operation;
  operation.name = "Operation " + std::to_string(number) + ", \"" + text + "\"";
  operation.verb = wordOf(words);
  const std::string& verb = operation.verb;
  if (verb != "move" && verb != "rotate" && verb != "scale" && verb != "pin" && verb != "drag")
  {
    operation.refuse("\"" + verb + "\" is none; " + howTo + ".");
  }
  if (verb == "drag")
  {
    operation.pixels[0] = numberOf(operation, words, "way to the right");
    operation.pixels[1] = numberOf(operation, words, "way up");
  }
  else
  {
    operation.t = numberOf(operation, words, "place");
    if (!(operation.t >= 0.0 && operation.t <= 1.0))
    {
      operation.refuse("its place is not on the curve; give one from 0, where the curve begins, to 1.");
    }
  }
  if (verb != "pin" && verb != "drag")
  {
    const std::string axis = wordOf(words), axes = "twn";
    if (axis.size() != 1 || axes.find(axis) == std::string::npos)
    {
      operation.refuse("its axis is \"" + axis + "\"; give t, along the curve, w, beside it, or n, outward.");
    }
    operation.axis = static_cast<HandleAxis>(axes.find(axis));
    operation.amount = numberOf(operation, words, "amount");
  }
  const std::string rest = wordOf(words);
  if (!rest.empty())
  {
    operation.refuse("\"" + rest + "\" is too much; " + howTo + ".");
  }
  return operation;
}

Matrix4 matrixOf(const Operation& operation, const CurveFrame& frame)
{
  try
  {
    return operation.verb == "move"     ? movedAlong(frame, operation.axis, operation.amount)
           : operation.verb == "rotate" ? turnedAbout(frame, operation.axis, operation.amount)
           : operation.verb == "scale"  ? scaledAlong(frame, operation.axis, operation.amount)
                                        : Matrix4(Matrix4::Identity());
  }
  catch (const Error& error)
  {
    operation.refuse(error.what());
  }
}

std::string trimmed(const std::string& text)
{
  constexpr const char* blanks = " \t\r\n";
  const std::size_t begin = text.find_first_not_of(blanks);
  return begin == std::string::npos ? std::string()
                                    : text.substr(begin, text.find_last_not_of(blanks) - begin + 1);
}

} // namespace

OperatedHandles handlesOf(const std::string& operations,
  const std::function<CurveFrame(double t)>& frameAt,
  const std::function<Vector3(const Vector2& pixels)>& shiftOf)
{
  OperatedHandles result;
  std::istringstream parts(operations);
  int number = 0;
  for (std::string part; std::getline(parts, part, ';');)
  {
    ++number;
    const std::string text = trimmed(part);
    if (text.empty())
    {
      continue; // after the last semicolon, say
    }
    const Operation operation = operationOf(text, number);
    if (operation.verb == "drag")
    {
      if (!shiftOf)
      {
        operation.refuse(
          "the curve carries no view that it could be dragged in; draw it, or move it along axes.");
      }
      result.shift += shiftOf(operation.pixels);
      continue;
    }
    const CurveFrame frame = frameAt(operation.t);
    result.handles.push_back({ operation.t, frame, matrixOf(operation, frame) });
  }
  return result;
}

void shiftAll(std::vector<PlacedHandle>& handles,
  const Vector3& shift,
  const std::function<CurveFrame(double t)>& frameAt)
{
  std::set<double> places;
  for (const PlacedHandle& handle : handles)
  {
    places.insert(handle.t);
  }
  if (places.empty())
  {
    places.insert(0.5);
  }
  Matrix4 matrix = Matrix4::Identity();
  matrix.topRightCorner<3, 1>() = shift;
  for (const double t : places)
  {
    handles.push_back({ t, frameAt(t), matrix });
  }
}

Matrix4 matrixOf(const CurveFrame& frame)
{
  Matrix4 matrix = Matrix4::Identity();
  matrix.col(0).head<3>() = frame.along;
  matrix.col(1).head<3>() = frame.side;
  matrix.col(2).head<3>() = frame.outward;
  matrix.col(3).head<3>() = frame.origin;
  return matrix;
}

Matrix4 inWorld(const CurveFrame& frame, const Matrix4& local)
{
  // T is the way to the frame's origin, R its axes: T R local R^-1 T^-1, whose linear part and shift each
  // come out of one product, so that an identity and a plain shift stay what they are.
  const Eigen::Matrix3d axes = matrixOf(frame).topLeftCorner<3, 3>();
  const Eigen::Matrix3d linear = local.topLeftCorner<3, 3>();
  Matrix4 world = local;
  if (linear != Eigen::Matrix3d::Identity())
  {
    world.topLeftCorner<3, 3>() = axes * linear * axes.transpose();
  }
  const Vector3 shift = local.topRightCorner<3, 1>();
  world.topRightCorner<3, 1>() =
    axes * shift + (linear == Eigen::Matrix3d::Identity()
                       ? Vector3(Vector3::Zero())
                       : Vector3(frame.origin - world.topLeftCorner<3, 3>() * frame.origin));
  return world;
}

} // namespace oversketch
