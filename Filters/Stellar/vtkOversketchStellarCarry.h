// The user's arrays from one mesh to the next, for the filters of this module. Not installed.
#ifndef vtkOversketchStellarCarry_h
#define vtkOversketchStellarCarry_h

#include "Mesh/place.h"
#include "Stellar/forest.h"
#include "vtkOversketchCarriedArrays.h"

#include "vtkSmartPointer.h"

#include <functional>
#include <utility>
#include <vector>

class vtkDataArray;
class vtkPolyData;

namespace oversketch
{

// Where points and cells of a result come from.
struct Origins
{
  std::vector<int> pointFrom; // a point of the input, or -1 for one in `born`
  std::vector<int> cellFrom;
  // Points of the result that lie elsewhere than their point of the input did: there, between points of the
  // input. And new ones, ascending, between lower points of the result.
  std::vector<std::pair<int, Binding>> slid, born;
};

// Origins between canonical forests with one base, some vertices moved within the surface (`slides`).
Origins originsOf(const Forest& before, const Forest& after, bool slides);

// How far the surface turned at points where it did, of forests that are alike but for positions.
using Turns = std::vector<std::pair<int, Eigen::Quaterniond>>;
Turns turnsOf(const Forest& before, const Forest& after);

// Carries arrays, and keeps what became of each while it and the origins stand. Those are asked for once they
// are needed: many meshes have no arrays.
class StellarCarry
{
public:
  StellarCarry() = default;
  explicit StellarCarry(std::function<Origins()> origins)
    : Find(std::move(origins))
  {
  }

  // Has normals turn with the surface.
  void Turn(Turns turned) { this->Turned = std::move(turned); }

  const std::vector<int>& PointFrom()
  {
    this->NeedOrigins();
    return this->From.pointFrom;
  }

  // Point and cell arrays of numbers but those that this module writes itself, and ids, which would be there
  // twice; field arrays. Real ones are mixed, others taken from the nearest; an array that stays as it is is
  // the same object.
  void Carry(vtkPolyData* input, vtkPolyData* output);

private:
  void NeedOrigins();
  vtkSmartPointer<vtkDataArray> CarryPoints(vtkDataArray* array, bool normals) const;
  vtkSmartPointer<vtkDataArray> CarryCells(vtkDataArray* array) const;

  std::function<Origins()> Find; // null once they are found
  Origins From;
  Turns Turned;
  bool SamePoints = false, SameCells = false;
  KeptArrays Kept;
};

} // namespace oversketch
#endif
