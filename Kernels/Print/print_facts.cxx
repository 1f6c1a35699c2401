#include "Print/print_facts.h"

namespace oversketch
{

std::vector<PrintFact> printFacts(const PrintCheck& check, double wall, double unit)
{
  std::vector<PrintFact> facts;
  const auto tell = [&facts](const Message& words, bool isFault = false) {
    facts.push_back({ words, isFault });
  };
  if (check.bodies.empty())
  {
    tell("There is nothing to print: the mesh has no faces.", true);
    return facts;
  }
  const Vector3 size = unit * check.size, place = unit * check.holePlace;
  tell(Message("Size: %1 x %2 x %3 mm.", size[0], size[1], size[2]));
  tell(Message("Bodies: %1, hollows in them: %2; volume: %3 cm³.",
    static_cast<int>(check.bodies.size()) - check.hollows(),
    check.hollows(),
    1e-3 * unit * unit * unit * check.volume()));
  if (check.openEdges > 0)
  {
    tell(
      Message(
        "Open edges: %1, round holes: %2. The largest, %3 mm round, is at (%4, %5, %6) mm. Fill the holes.",
        check.openEdges,
        check.holes,
        unit * check.holeLength,
        place[0],
        place[1],
        place[2]),
      true);
  }
  else
  {
    tell("Closed: no edge is open.");
  }
  if (check.crowdedEdges > 0)
  {
    tell(
      Message("Edges of more than two faces: %1. Take faces away that are there twice, and bodies apart that "
              "share an edge.",
        check.crowdedEdges),
      true);
  }
  if (check.turnedEdges > 0)
  {
    tell(
      Message("Edges along which inside and outside change places: %1. Turn the faces on one side of them.",
        check.turnedEdges),
      true);
  }
  if (check.insideOut() > 0)
  {
    tell(Message("Bodies that are inside out: %1. Turn their faces.", check.insideOut()), true);
  }
  if (check.crowdedEdges + check.turnedEdges + check.insideOut() == 0)
  {
    tell("Oriented: faces look outward.");
  }
  if (check.crossings > 0)
  {
    tell(
      Message("Faces that pass through each other: %1 pairs. Move the bodies apart or join them, and smooth "
              "the surface where it is folded.",
        check.crossings),
      true);
  }
  else
  {
    tell("No face passes through another.");
  }
  const double thin = check.thinArea(wall);
  if (check.leastWall < 0.0)
  {
    tell("No wall can be measured: the faces enclose nothing.");
  }
  else if (thin > 0.0)
  {
    tell(
      Message(
        "Walls thinner than %1 mm: %2 mm² of the surface; the thinnest is %3 mm. Make them thicker, or the "
        "model larger.",
        unit * wall,
        unit * unit * thin,
        unit * check.leastWall),
      true);
  }
  else
  {
    tell(Message("Thinnest wall: %1 mm.", unit * check.leastWall));
  }
  const bool isReady = check.isReady(wall);
  tell(isReady ? "Ready to print." : "Not ready to print.", !isReady);
  return facts;
}

} // namespace oversketch
