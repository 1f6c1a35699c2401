#include "Matrix/operations.h"

#include "Mesh/context.h"
#include "Mesh/mesh.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <locale>
#include <set>
#include <sstream>

namespace oversketch
{

namespace
{

const Vector3& directionOf(const CurveFrame& frame, HandleAxis axis)
{
  return axis == HandleAxis::Along ? frame.along : axis == HandleAxis::Side ? frame.side : frame.outward;
}

void check(bool good, const char* what, double value, const char* remedy)
{
  if (!good)
  {
    throw Error(Failure::BadStroke, "A handle cannot be %1 %2; %3.", what, value, remedy);
  }
}

// A linear map about the frame's origin.
Matrix4 about(const CurveFrame& frame, const Eigen::Matrix3d& linear)
{
  Matrix4 result = Matrix4::Identity();
  result.topLeftCorner<3, 3>() = linear;
  result.topRightCorner<3, 1>() = frame.origin - linear * frame.origin;
  return result;
}

} // namespace

Matrix4 movedAlong(const CurveFrame& frame, HandleAxis axis, double length)
{
  check(std::isfinite(length), "moved by", length, "give a finite length");
  Matrix4 result = Matrix4::Identity();
  result.topRightCorner<3, 1>() = length * directionOf(frame, axis);
  return result;
}

Matrix4 scaledAlong(const CurveFrame& frame, HandleAxis axis, double factor)
{
  check(std::isfinite(factor) && factor > 0.0, "scaled by", factor, "give a factor above 0");
  const Vector3& d = directionOf(frame, axis);
  return about(frame, Eigen::Matrix3d::Identity() + (factor - 1.0) * d * d.transpose());
}

Matrix4 turnedAbout(const CurveFrame& frame, HandleAxis axis, double degrees)
{
  check(std::abs(degrees) < 180.0, "turned by", degrees, "give less than 180 degrees either way");
  if (degrees == 0.0)
  {
    return Matrix4::Identity();
  }
  const Eigen::AngleAxisd turn(degrees * M_PI / 180.0, directionOf(frame, axis));
  return about(frame, turn.toRotationMatrix());
}

namespace
{

constexpr const char* howTo = "write \"move T AXIS LENGTH\", \"rotate T AXIS DEGREES\", \"scale T AXIS "
                              "FACTOR\", \"pin T\" or \"drag X Y\", "
                              "apart by semicolons, with T from 0 to 1 along the curve and AXIS t, w or n";

constexpr double mostDegrees = 179.0, leastFactor = 0.05, mostFactor = 20.0; // of a hand

struct NamedOperation : Operation
{
  std::string name; // for messages

  [[noreturn]] void refuse(const Message& why) const
  {
    throw Error(Failure::BadStroke, "%1: %2", this->name, why);
  }
};

// The next word of a text.
std::string wordOf(std::istringstream& words)
{
  std::string word;
  words >> word;
  return word;
}

double numberOf(const NamedOperation& operation, std::istringstream& words, const char* what)
{
  const std::string word = wordOf(words);
  std::istringstream digits(word);
  digits.imbue(std::locale::classic());
  double number = 0.0;
  if (!(digits >> number) || !digits.eof() || !std::isfinite(number))
  {
    operation.refuse(
      { word.empty() ? "its %1 is missing; %3." : "its %1 is \"%2\"; %3.", what, word, howTo });
  }
  return number;
}

NamedOperation operationOf(const std::string& text, int number)
{
  std::istringstream words(text);
  NamedOperation operation;
  operation.name = "Operation " + std::to_string(number) + ", \"" + text + "\"";
  const std::string verb = wordOf(words);
  const auto known = std::find(std::begin(verbNames), std::end(verbNames), verb);
  if (known == std::end(verbNames))
  {
    operation.refuse({ "\"%1\" is none; %2.", verb, howTo });
  }
  operation.verb = static_cast<Verb>(known - std::begin(verbNames));
  if (operation.verb == Verb::Drag)
  {
    operation.amount = numberOf(operation, words, "way to the right");
    operation.up = numberOf(operation, words, "way up");
  }
  else
  {
    operation.t = numberOf(operation, words, "place");
    if (!(operation.t >= 0.0 && operation.t <= 1.0))
    {
      operation.refuse("its place is not on the curve; give one from 0, where the curve begins, to 1.");
    }
  }
  if (operation.verb != Verb::Pin && operation.verb != Verb::Drag)
  {
    const std::string axis = wordOf(words), axes = axisNames;
    if (axis.size() != 1 || axes.find(axis) == std::string::npos)
    {
      operation.refuse({ "its axis is \"%1\"; give t, along the curve, w, beside it, or n, outward.", axis });
    }
    operation.axis = static_cast<int>(axes.find(axis));
    operation.amount = numberOf(operation, words, "amount");
  }
  const std::string rest = wordOf(words);
  if (!rest.empty())
  {
    operation.refuse({ "\"%1\" is too much; %2.", rest, howTo });
  }
  return operation;
}

Matrix4 matrixOf(const NamedOperation& operation, const CurveFrame& frame)
{
  const auto axis = static_cast<HandleAxis>(operation.axis);
  try
  {
    return operation.verb == Verb::Move     ? movedAlong(frame, axis, operation.amount)
           : operation.verb == Verb::Rotate ? turnedAbout(frame, axis, operation.amount)
           : operation.verb == Verb::Scale  ? scaledAlong(frame, axis, operation.amount)
                                            : Matrix4(Matrix4::Identity());
  }
  catch (const Error& error)
  {
    operation.refuse(error.message());
  }
}

std::string trimmed(const std::string& text)
{
  constexpr const char* blanks = " \t\r\n";
  const std::size_t begin = text.find_first_not_of(blanks);
  return begin == std::string::npos ? std::string()
                                    : text.substr(begin, text.find_last_not_of(blanks) - begin + 1);
}

std::vector<NamedOperation> read(const std::string& operations)
{
  std::vector<NamedOperation> result;
  std::istringstream parts(operations);
  int number = 0;
  for (std::string part; std::getline(parts, part, ';');)
  {
    ++number;
    const std::string text = trimmed(part);
    if (!text.empty()) // after the last semicolon, say
    {
      result.push_back(operationOf(text, number));
    }
  }
  return result;
}

std::string textOf(const Operation& row)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << verbNames[static_cast<int>(row.verb)] << ' ' << (row.verb == Verb::Drag ? row.amount : row.t);
  if (row.verb == Verb::Drag)
  {
    text << ' ' << row.up;
  }
  else if (row.verb != Verb::Pin)
  {
    text << ' ' << axisNames[row.axis] << ' ' << row.amount;
  }
  return text.str();
}

} // namespace

std::vector<Operation> operationsOf(const std::string& text)
{
  const CurveFrame anywhere{ Vector3::Zero(), Vector3::UnitX(), Vector3::UnitY(), Vector3::UnitZ() };
  std::vector<Operation> result;
  for (const NamedOperation& operation : read(text))
  {
    matrixOf(operation, anywhere); // refuses what no frame allows
    result.push_back(operation);
  }
  return result;
}

std::string operationWords(const Operation& row)
{
  static const char* const forward[] = { "along the line", "to the side", "outward" };
  static const char* const backward[] = { "back along the line", "to the other side", "inward" };
  std::ostringstream words;
  words.imbue(std::locale::classic());
  words.precision(2);
  switch (row.verb)
  {
    case Verb::Move:
      words << "moved " << (row.amount < 0.0 ? backward : forward)[row.axis] << ' ' << std::abs(row.amount);
      break;
    case Verb::Scale:
      words << "scaled " << row.amount << " times";
      break;
    case Verb::Rotate:
      words << "turned " << std::lround(row.amount) << "\u00b0";
      break;
    default:
      break;
  }
  return words.str();
}

std::string operationText(const std::vector<Operation>& rows)
{
  std::string text;
  for (const Operation& row : rows)
  {
    text += (text.empty() ? "" : "; ") + textOf(row);
  }
  return text;
}

void operate(std::vector<Operation>& rows, Verb verb, double t, int axis, double amount)
{
  const auto known = std::find_if(rows.begin(),
    rows.end(),
    [&](const Operation& row) { return row.verb == verb && row.t == t && row.axis == axis; });
  Operation made{ verb, t, axis, verb == Verb::Scale ? 1.0 : 0.0 };
  Operation& row = known != rows.end() ? *known : made;
  row.amount = verb == Verb::Move    ? row.amount + amount
               : verb == Verb::Scale ? std::clamp(row.amount * amount, leastFactor, mostFactor)
                                     : std::clamp(row.amount + amount, -mostDegrees, mostDegrees);
  if (known == rows.end())
  {
    const auto pin = std::find_if(rows.begin(),
      rows.end(),
      [&](const Operation& other) { return other.verb == Verb::Pin && other.t == t; });
    pin != rows.end() ? void(*pin = made) : rows.push_back(made);
  }
}

std::vector<double> handlePlaces(const std::vector<Operation>& rows)
{
  std::vector<double> places;
  for (const Operation& row : rows)
  {
    if (row.verb != Verb::Drag)
    {
      places.push_back(row.t);
    }
  }
  sortUnique(places);
  return places;
}

OperatedHandles handlesOf(const std::string& operations,
  const std::function<CurveFrame(double t)>& frameAt,
  const std::function<Vector3(const Vector2& pixels)>& shiftOf)
{
  OperatedHandles result;
  for (const NamedOperation& operation : read(operations))
  {
    if (operation.verb == Verb::Drag)
    {
      if (!shiftOf)
      {
        operation.refuse(
          "the curve carries no view that it could be dragged in; draw it, or move it along axes.");
      }
      result.shift += shiftOf({ operation.amount, operation.up });
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
