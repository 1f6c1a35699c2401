// The user's arrays from one mesh to the next, for the filters of this module. Not installed.
#ifndef vtkOversketchStellarCarry_h
#define vtkOversketchStellarCarry_h

#include "Mesh/place.h"
#include "Stellar/forest.h"

#include "vtkSmartPointer.h"
#include "vtkType.h"

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
  // How far the surface turned at points of the result where it did.
  std::vector<std::pair<int, Eigen::Quaterniond>> turned;
};

// Of canonical forests with one base, some vertices moved within the surface (`slides`) or, the forests alike
// but for positions, out of it (`turns`).
Origins originsOf(const Forest& before, const Forest& after, bool slides, bool turns);

// Keeps what became of each array while it and the origins stand.
class CarriedArrays
{
public:
  CarriedArrays() = default;
  explicit CarriedArrays(Origins origins);

  // Point and cell arrays of numbers but those that this module writes itself, and ids, which would be there
  // twice; field arrays. Real ones are mixed, others taken from the nearest; an array that stays as it is is
  // the same object.
  void Carry(vtkPolyData* input, vtkPolyData* output);

private:
  struct Item
  {
    const void* Source;
    vtkMTimeType Time;
    bool Points, Normals;
    vtkSmartPointer<vtkDataArray> Result;
  };
  vtkSmartPointer<vtkDataArray> CarryPoints(vtkDataArray* array, bool normals) const;
  vtkSmartPointer<vtkDataArray> CarryCells(vtkDataArray* array) const;

  Origins From;
  bool SamePoints = false, SameCells = false;
  std::vector<Item> Items;
};

} // namespace oversketch
#endif
