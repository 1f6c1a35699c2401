/**
 * Tools that the Oversketch filters share: VTK data to kernel data and back, the view that a stroke carries,
 * errors and cancelling, cache keys. Free functions, for use in the .cxx of filters; not wrapped.
 */
#ifndef vtkOversketchFilterTools_h
#define vtkOversketchFilterTools_h

#include "OversketchFiltersCoreModule.h" // For export macro

#include "Mesh/context.h"
#include "Mesh/mesh.h"
#include "Mesh/view.h"
#include "vtkOversketchArrays.h"

#include "vtkType.h"

#include <atomic>
#include <functional>
#include <string>
#include <vector>

class vtkAlgorithm;
class vtkDataArray;
class vtkDataObject;
class vtkDataSetAttributes;
class vtkObject;
class vtkPolyData;

namespace oversketch
{

/**
 * Runs the body of a RequestData. Resets the filter's error code, makes every vtk error, exception or abort
 * come out alike: one vtkErrorMacro with the message, SetErrorCode(vtkErrorCode::UserError + failure), every
 * output of the filter initialised, return 0. A cancelled run (AbortExecute) is silent: no error event, error
 * code Cancelled, outputs initialised, return 0 - the driver calls Modified() on the filter before it tries
 * again. Returns 1 when body returns normally.
 */
OVERSKETCHFILTERSCORE_EXPORT int RunFilter(vtkAlgorithm* self, const std::function<void()>& body);

/**
 * Kind of a port, where it is not one vtkPolyData that must be there.
 */
enum class Port
{
  Optional,
  Repeatable,
  Image // vtkImageData
};

///@{
/**
 * Says it of an input or output; for a filter's constructor, once the number of ports is set.
 */
OVERSKETCHFILTERSCORE_EXPORT void DeclareInput(vtkAlgorithm* self, int port, const std::vector<Port>& is);
OVERSKETCHFILTERSCORE_EXPORT void DeclareOutput(vtkAlgorithm* self, int port, const std::vector<Port>& is);
///@}

/**
 * Tells a warning event of an object: one vtkWarningMacro. Its observers get the message itself by MessageOf.
 */
OVERSKETCHFILTERSCORE_EXPORT void Warn(vtkObject* self, const Message& message);

/**
 * The message of an error or warning event, from what its observer is given: while RunFilter or Warn tell
 * one, that one. Of others, the bare text; VTK's macros wrap it as "ERROR: In file, line N\nClass (address):
 * message\n\n".
 */
OVERSKETCHFILTERSCORE_EXPORT Message MessageOf(const void* eventData);

/**
 * Sets a text parameter of a filter, which is modified where it is another text; null is an empty one.
 */
OVERSKETCHFILTERSCORE_EXPORT void SetText(vtkAlgorithm* self, std::string& value, const char* text);

/**
 * Threads from vtkSMPTools, progress mapped to [from, to] of the filter's own, cancel from AbortExecute.
 */
OVERSKETCHFILTERSCORE_EXPORT Context ContextOf(vtkAlgorithm* self, double from = 0.0, double to = 1.0);

/**
 * Throws Error(BadMesh) when the mesh holds lines, vertices or strips besides its polygons (remedy:
 * vtkTriangleFilter).
 */
OVERSKETCHFILTERSCORE_EXPORT void RequirePolygonsOnly(vtkPolyData* polyData);

/**
 * Threads from vtkSMPTools, without progress or cancel.
 */
OVERSKETCHFILTERSCORE_EXPORT Context ThreadsOnly();

/**
 * The largest coordinate that is taken: the product of three fits single precision, in which rays are cast.
 */
constexpr double LargestCoordinate = 1e12;

/**
 * The largest coordinate of a mesh with points, without its sign.
 */
OVERSKETCHFILTERSCORE_EXPORT double ReachOf(vtkPolyData* polyData);

/**
 * The mesh as kernels see it; vertex i is point i, triangle i is polygon i. Throws Error(BadMesh) naming the
 * first offending cell or point when a polygon is not a triangle, an id is out of range, a point is not
 * finite, or there are lines, vertices or strips besides the polygons (remedy: vtkTriangleFilter).
 */
OVERSKETCHFILTERSCORE_EXPORT Mesh MeshOf(vtkPolyData* polyData);

/**
 * Counts of what has been made of whole meshes since the process started; a test sees by it what sharing
 * spares.
 */
struct MeshWork
{
  std::atomic<int> Conversions{ 0 }; // by MeshOf
  std::atomic<int> Linkings{ 0 };    // adjacencies, by SharedMesh
  std::atomic<int> Normals{ 0 };     // computed by SharedMesh, but where most are those of another mesh
};
OVERSKETCHFILTERSCORE_EXPORT MeshWork& MeshWorkDone();

/**
 * The one view of the stroke polydata, from cell arrays ViewTransform, ProjectionTransform (16 components
 * each, row-major) and ViewportSize (2 components). Throws Error(MissingArray) naming an absent array,
 * Error(BadStroke) when there is no stroke, when cells carry different views, or a value is not finite.
 */
OVERSKETCHFILTERSCORE_EXPORT View ViewOf(vtkPolyData* stroke);

/**
 * The samples of the one stroke [display px], its z left out. Throws Error(BadStroke) when the polydata does
 * not hold exactly one polyline, when that has fewer than two samples, or a sample is not finite.
 */
OVERSKETCHFILTERSCORE_EXPORT std::vector<Vector2> StrokeOf(vtkPolyData* stroke);

/**
 * How far the one stroke was dragged since it was drawn [px], from cell array Moved; zero without it. Throws
 * Error(BadStroke) where that is not two finite numbers.
 */
OVERSKETCHFILTERSCORE_EXPORT Vector2 MovedOf(vtkPolyData* stroke);

/**
 * The array by name with the given number of components (and, where tuples >= 0, that number of tuples), or
 * throws Error(MissingArray) naming it, what holds it ("mesh", "handles") and the filter that makes it.
 */
OVERSKETCHFILTERSCORE_EXPORT vtkDataArray* RequireArray(vtkDataSetAttributes* attributes,
  const char* name,
  int components,
  vtkIdType tuples,
  const std::string& holder,
  const std::string& remedy);

/**
 * The same, null where there is no array of that name.
 */
OVERSKETCHFILTERSCORE_EXPORT vtkDataArray* OptionalArray(vtkDataSetAttributes* attributes,
  const char* name,
  int components,
  vtkIdType tuples,
  const std::string& holder,
  const std::string& remedy);

/**
 * The one value of a field array. Throws Error(MissingArray), naming the array and its holder ("mesh"), where
 * it is not one finite positive number.
 */
OVERSKETCHFILTERSCORE_EXPORT double FieldValue(vtkDataObject* object,
  const char* name,
  const std::string& holder,
  const std::string& remedy);

/**
 * Throws Error(BadStroke) naming the parameter where its value is not finite.
 */
OVERSKETCHFILTERSCORE_EXPORT void RequireFinite(double value, const char* name);

/**
 * 1 per tuple of an array of labels (Region, RegionSeed, Visible) that is not 0, else 0.
 */
OVERSKETCHFILTERSCORE_EXPORT std::vector<char> LabelsOf(vtkDataArray* labels);

/**
 * Identity and modified time of what a step reads of a mesh or of curves: points, cells and, optionally, some
 * arrays. Equal keys mean equal content: modified times are unique in a process, so a recycled address cannot
 * fool it.
 */
class OVERSKETCHFILTERSCORE_EXPORT MeshKey
{
public:
  MeshKey() = default;
  explicit MeshKey(vtkPolyData* mesh, const std::vector<vtkDataArray*>& arrays = {});
  bool operator==(const MeshKey& other) const { return this->Key == other.Key; }
  bool operator!=(const MeshKey& other) const { return !(*this == other); }

private:
  std::vector<std::pair<const void*, vtkMTimeType>> Key;
};

/**
 * The key of all numbers that a polydata holds.
 */
OVERSKETCHFILTERSCORE_EXPORT MeshKey WholeKey(vtkPolyData* data);

/**
 * The cell arrays that a view is read from, and others, those that are there and have the right length.
 */
OVERSKETCHFILTERSCORE_EXPORT std::vector<vtkDataArray*> ViewArraysOf(vtkPolyData* strokes,
  const std::vector<const char*>& others = {});

/**
 * The view of one stroke, see ViewOf; strokes of one polydata may carry different ones. Names the stroke in
 * what it throws.
 */
OVERSKETCHFILTERSCORE_EXPORT View ViewOfStroke(vtkPolyData* strokes, vtkIdType stroke);

} // namespace oversketch
#endif
