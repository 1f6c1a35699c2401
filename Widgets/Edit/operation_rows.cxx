#include "operation_rows.h"

#include "Matrix/operations.h"

#include <algorithm>
#include <cmath>
#include <locale>
#include <sstream>

namespace oversketch
{
namespace
{

constexpr const char* verbs[] = { "move", "scale", "rotate", "pin", "drag" };
constexpr const char* axes = "twn";
constexpr double mostDegrees = 179.0, leastFactor = 0.05, mostFactor = 20.0; // of a drag

} // namespace

std::vector<OperationRow> operationRows(const std::string& text)
{
  CurveFrame anywhere{ Vector3::Zero(), Vector3::UnitX(), Vector3::UnitY(), Vector3::UnitZ() };
  handlesOf(
    text,
    [&](double) { return anywhere; },
    [](const Vector2&) { return Vector3(Vector3::Zero()); }); // its messages
  std::vector<OperationRow> rows;
  std::istringstream parts(text);
  for (std::string part; std::getline(parts, part, ';');)
  {
    std::istringstream words(part);
    words.imbue(std::locale::classic());
    std::string verb, axis;
    OperationRow row;
    double first = 0.0;
    if (!(words >> verb >> first))
    {
      continue; // after the last semicolon, say
    }
    row.verb = static_cast<Verb>(std::find(std::begin(verbs), std::end(verbs), verb) - std::begin(verbs));
    (row.verb == Verb::Drag ? row.amount : row.t) = first;
    if (row.verb == Verb::Drag)
    {
      words >> row.up;
    }
    else if (words >> axis >> row.amount)
    {
      row.axis = static_cast<int>(std::string(axes).find(axis));
    }
    rows.push_back(row);
  }
  return rows;
}

std::string operationText(const OperationRow& row)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << verbs[static_cast<int>(row.verb)] << ' ' << (row.verb == Verb::Drag ? row.amount : row.t);
  if (row.verb == Verb::Drag)
  {
    text << ' ' << row.up;
  }
  else if (row.verb != Verb::Pin)
  {
    text << ' ' << axes[row.axis] << ' ' << row.amount;
  }
  return text.str();
}

std::string operationWords(const OperationRow& row)
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

std::string operationText(const std::vector<OperationRow>& rows)
{
  std::string text;
  for (const OperationRow& row : rows)
  {
    text += (text.empty() ? "" : "; ") + operationText(row);
  }
  return text;
}

void operate(std::vector<OperationRow>& rows, Verb verb, double t, int axis, double amount)
{
  const auto known = std::find_if(rows.begin(),
    rows.end(),
    [&](const OperationRow& row) { return row.verb == verb && row.t == t && row.axis == axis; });
  OperationRow made{ verb, t, axis, verb == Verb::Scale ? 1.0 : 0.0 };
  OperationRow& row = known != rows.end() ? *known : made;
  row.amount = verb == Verb::Move    ? row.amount + amount
               : verb == Verb::Scale ? std::clamp(row.amount * amount, leastFactor, mostFactor)
                                     : std::clamp(row.amount + amount, -mostDegrees, mostDegrees);
  if (known == rows.end())
  {
    const auto pin = std::find_if(rows.begin(),
      rows.end(),
      [&](const OperationRow& other) { return other.verb == Verb::Pin && other.t == t; });
    pin != rows.end() ? void(*pin = made) : rows.push_back(made);
  }
}

std::vector<double> handlePlaces(const std::vector<OperationRow>& rows)
{
  std::vector<double> places;
  for (const OperationRow& row : rows)
  {
    if (row.verb != Verb::Drag)
    {
      places.push_back(row.t);
    }
  }
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  return places;
}

} // namespace oversketch
