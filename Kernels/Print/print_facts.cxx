#include "Print/print_facts.h"

#include <cmath>

namespace oversketch
{

namespace
{

// As few read more of a number than four digits.
double shown(double number)
{
  return std::abs(number) < 1000.0 ? number : std::round(number);
}

} // namespace

std::vector<PrintFact> printFacts(const PrintCheck& check, double wall, double unit)
{
  if (check.bodies.empty())
  {
    return { { "There is nothing to print: the mesh has no faces.", true } };
  }
  const Vector3 size = unit * check.size, place = unit * check.holePlace;
  const double thin = check.thinArea(wall);
  std::vector<PrintFact> facts = {
    { { "Size: %1 x %2 x %3 mm.", shown(size[0]), shown(size[1]), shown(size[2]) } },
    { { "Bodies: %1, hollows in them: %2; volume: %3 cm³.",
      static_cast<int>(check.bodies.size()) - check.hollows,
      check.hollows,
      shown(1e-3 * unit * unit * unit * check.volume) } }
  };
  // What is wrong, or the words where nothing is.
  const auto tell = [&facts](bool isFault, const Message& fault, const Message& well = {})
  {
    if (isFault || !well.empty())
    {
      facts.push_back({ isFault ? fault : well, isFault });
    }
  };
  tell(check.openEdges > 0,
    { "Open edges: %1, round holes: %2. The largest, %3 mm round, is at (%4, %5, %6) mm. Fill the holes.",
      check.openEdges,
      check.holes,
      shown(unit * check.holeLength),
      shown(place[0]),
      shown(place[1]),
      shown(place[2]) },
    "Closed: no edge is open.");
  tell(check.crowdedEdges > 0,
    { "Edges of more than two faces: %1. Take faces away that are there twice, and bodies apart that share "
      "an "
      "edge.",
      check.crowdedEdges });
  tell(check.turnedEdges > 0,
    { "Edges along which inside and outside change places: %1. Turn the faces on one side of them.",
      check.turnedEdges });
  tell(check.insideOut > 0, { "Bodies that are inside out: %1. Turn their faces.", check.insideOut });
  if (check.crowdedEdges + check.turnedEdges + check.insideOut == 0)
  {
    facts.push_back({ "Oriented: faces look outward." });
  }
  tell(check.crossings > 0,
    { "Faces that pass through each other: %1 pairs. Move the bodies apart or join them, and smooth the "
      "surface "
      "where it is folded.",
      check.crossings },
    "No face passes through another.");
  tell(thin > 0.0,
    { "Walls thinner than %1 mm: %2 mm² of the surface; the thinnest is %3 mm. Make them thicker, or the "
      "model "
      "larger.",
      unit * wall,
      shown(unit * unit * thin),
      unit * check.leastWall },
    check.leastWall < 0.0 ? Message("No wall can be measured: the faces enclose nothing.")
                          : Message("Thinnest wall: %1 mm.", unit * check.leastWall));
  tell(!check.isReady(wall), "Not ready to print.", "Ready to print.");
  return facts;
}

} // namespace oversketch
