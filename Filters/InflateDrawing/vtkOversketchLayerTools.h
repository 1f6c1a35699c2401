// Layers of a drawing: what lies in the plane, and bodies in front of it and behind. Not installed.
#ifndef vtkOversketchLayerTools_h
#define vtkOversketchLayerTools_h

#include "Mesh/context.h"

#include "vtkSmartPointer.h"

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

class vtkImageData;
class vtkOversketchInflateDrawing;
class vtkPolyData;

namespace oversketch
{

// Bits of a layer's depth.
constexpr int inFront = 1, isBehind = 2;

// Part of a drawing that is made by itself.
struct DrawingLayer
{
  int Line = -1;       // the stroke that bounds it; -1 of the plane
  int Depth = 0;       // where it lies; 0 in the plane
  double Height = 1.0; // factor of the drawing's heights
  int CrossSection = 0;
  std::vector<int> Numbers;                              // of its strokes in the drawing, ascending
  vtkSmartPointer<vtkPolyData> Strokes;                  // without arrays of layers
  vtkSmartPointer<vtkOversketchInflateDrawing> System{}; // null: nobody has it yet

  // Of a list of strokes of the drawing those that it has, by their numbers in it.
  std::string Own(const std::vector<int>& list) const;
};

// Lists of strokes that are in front, behind, on both sides.
using DepthLists = std::array<std::string, 3>;

// The layers of a drawing, first the plane, which may have no stroke, then others in the order of the strokes
// that bound them. None where no stroke bounds one. Throws Error(BadStroke) for lists and arrays that are
// none, and what vtkOversketchCanvas does.
std::vector<DrawingLayer> LayersOf(vtkPolyData* drawing, vtkImageData* picture, const DepthLists& lists);

// Gives layers but the first the systems of earlier ones: with the same strokes, then any, then new ones.
// Layers that have the same strokes as before have the same object of them.
void TakeSystems(std::vector<DrawingLayer>& layers, std::vector<DrawingLayer>& before);

// Body of a layer, by the layer's number.
struct LayerBody
{
  vtkPolyData* Made;
  vtkPolyData* Curves; // that it was made of
  int Layer;
};

// The bodies for vtkOversketchAssemble, placed over those before them, with cell array LayerId and, in point
// array StrokeId, numbers of the drawing's strokes. Those in the plane, or the first one where there are
// none, stay in it. `warn` hears of strokes that lie over nothing.
std::vector<vtkSmartPointer<vtkPolyData>> PlacedBodies(const std::vector<DrawingLayer>& layers,
  const std::vector<LayerBody>& bodies,
  const std::function<void(const Message& message)>& warn,
  const Context& context);

} // namespace oversketch
#endif
