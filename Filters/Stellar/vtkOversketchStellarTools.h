// The 4-8 mesh and its curves from polydata and back, for the filters of this module. Not installed.
#ifndef vtkOversketchStellarTools_h
#define vtkOversketchStellarTools_h

#include "Stellar/displace.h"
#include "Stellar/forest.h"
#include "vtkOversketchFilterTools.h"
#include "vtkOversketchKept.h"
#include "vtkOversketchStellarCarry.h"
#include "vtkOversketchStellarCurves.h"

#include "vtkSmartPointer.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

class vtkAlgorithm;
class vtkDataArray;
class vtkFieldData;
class vtkInformationVector;
class vtkPolyData;

namespace oversketch
{

// Whether a polydata has an array of a 4-8 mesh's structure, sound or not.
bool HasStellarArrays(vtkPolyData* mesh);

// Key of what a step reads of a 4-8 mesh.
MeshKey StellarKey(vtkPolyData* mesh);

// The forest of a 4-8 mesh. What a step of this module emitted is found as long as somebody holds it, by
// StellarKey; else it is rebuilt from the arrays, the same to the bit. Throws Error(MissingArray or BadMesh)
// that names the array, the cell or point, and the likely culprit. Callable from any thread.
std::shared_ptr<const Forest> SharedForest(vtkPolyData* mesh, const Context& context);

// Takes what a forest has that nobody else holds, for its holder to change it; empty, and the holder keeps
// it, where somebody does.
Forest TakeForest(std::shared_ptr<const Forest>& forest);

// How often a forest has been rebuilt from arrays since the process started.
std::atomic<int>& ForestsRebuilt();

// A canonical forest as points, polygons and arrays, known to SharedForest. `digest`: of the curves that
// CurveId means. `alike`: null, or a 4-8 mesh with the same cells, whose cells and their arrays are shared;
// `same`: points too. `curvesOf`: null, or one with the same CurveId and CurveParam, which are shared.
vtkSmartPointer<vtkPolyData> StellarPolyData(const std::shared_ptr<const Forest>& forest,
  const std::optional<std::uint64_t>& digest,
  vtkPolyData* alike = nullptr,
  bool same = false,
  vtkPolyData* curvesOf = nullptr);

// Whether a vertex lies on a curve of the stroke that has not ended.
bool HasSnapped(const Forest& forest);

// A step with a 4-8 mesh on port 0 and curves on port 1, null where there are none.
struct CurveStep
{
  vtkPolyData *mesh, *curves, *output;
  vtkPolyData* third; // of port 2; null: none
  Context context;
};
// Reads that of a filter; without curves the mesh has gone through, and is refused all the same where it is
// none.
CurveStep CurveStepOf(vtkAlgorithm* filter, vtkInformationVector** inputs, vtkInformationVector* outputs);

// Throws Error unless the snapped vertices of the mesh, where it has any, are on these curves.
void RequireSameCurves(vtkPolyData* mesh, const Forest& forest, const FeatureCurves& curves);

// The value of a field array of one number; none where it is absent.
std::optional<std::uint64_t> WholeNumber(vtkFieldData* data, const char* name);

// All values of an array. Throws Error(BadMesh) naming the first that is no whole number.
std::vector<int> WholeNumbers(vtkDataArray* array);

// A length that may be left to the filter, which then takes a share of the mesh's diagonal: below 0. Throws
// Error(BadStroke) naming the parameter where it is not finite.
double LengthOf(double value, double share, const Forest& forest, const char* name);

// Keeps the last result of a step, and carries the user's arrays to it.
class StellarStep
{
public:
  struct Made
  {
    std::shared_ptr<const Forest> forest; // canonical
    std::function<Origins()> origins;
    std::optional<std::uint64_t> digest;   // of the curves that it is snapped to
    bool sameCells = false;                // as a 4-8 mesh that is the input
    bool turns = false;                    // point normals are to turn with the surface
    vtkSmartPointer<vtkPolyData> curvesOf; // null, or what has the same CurveId and CurveParam
  };
  // Writes what `make` gives to the output; asks it where the key is a new one.
  void Provide(const StepKey& key,
    vtkPolyData* input,
    vtkPolyData* output,
    const std::function<Made()>& make);

  // Motion of vertices that a step from one 4-8 mesh to the next does not make.
  enum class Motion
  {
    None,
    Slide, // within the surface
    Rise   // out of it
  };
  // Gives the canonical forest after the step; none: it is as it was.
  using Change = std::function<std::optional<Forest>(const Forest& before)>;
  // `otherInputs`: what it reads beside mesh and curves. `values`: the parameters. `curves`: the step's,
  // which are to be those that the mesh is snapped to; null: of no matter.
  void Provide(const CurveStep& step,
    const std::vector<MeshKey>& otherInputs,
    const std::vector<double>& values,
    const FeatureCurves* curves,
    Motion motion,
    const Change& change);

  // Number of each point of the last result in the input, -1 for a new one.
  const std::vector<int>& PointFrom() { return this->Arrays.PointFrom(); }

  // The forest of the last result; null: nothing is kept.
  const std::shared_ptr<const Forest>& Result() const { return this->After; }

private:
  StepKey Key, InputsKey;
  std::shared_ptr<const Forest> Before, After; // held for who asks SharedForest
  vtkSmartPointer<vtkPolyData> Stem;           // what this module writes of the output; null: nothing is kept
  StellarCarry Arrays;
  bool Turns = false; // to be found where there are normals
};

// The chart of each root by cell array Chart, one whole number per triangle (see vtkOversketchRemesh); empty
// where the mesh has none. A root that lies in several, as over a simplified base, has that of its first
// cell. Throws Error(BadMesh) naming a number that is none.
std::vector<int> PartsOf(vtkPolyData* mesh, const Forest& forest);

// Key of what PartsOf reads of a mesh beside its 4-8 arrays.
MeshKey PartsKey(vtkPolyData* mesh);

// Knowledge of a displacement about its mesh, for the simplification that follows it.
struct Raised
{
  std::shared_ptr<const Forest> before;
  std::shared_ptr<const CurvesReached> reached;
  MeshKey curves; // WholeKey of them
  double radius;
  CurveDistance distance;
  bool connectedOnly;
};

// Keeps it, as long as somebody holds it, with the mesh that it was raised to; callable from any thread.
void AddRaised(vtkPolyData* mesh, const std::shared_ptr<const Raised>& raised);
// Null where it is not known.
std::shared_ptr<const Raised> RaisedOf(vtkPolyData* mesh);

} // namespace oversketch
#endif
