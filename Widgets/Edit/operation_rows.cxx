#include "operation_rows.h"

#include <algorithm>
#include <cmath>
#include <locale>
#include <sstream>

namespace oversketch
{
namespace
{

constexpr double mostDegrees = 179.0, leastFactor = 0.05, mostFactor = 20.0; // of a drag

} // namespace

std::string operationText(const Operation& row)
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
    text += (text.empty() ? "" : "; ") + operationText(row);
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
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  return places;
}

} // namespace oversketch
