/**
 * A drawing's strokes, its canvas and the curves on it, from polydata and pictures and back. Free functions,
 * for use in the .cxx of filters; not wrapped.
 */
#ifndef vtkOversketchCanvasTools_h
#define vtkOversketchCanvasTools_h

#include "OversketchFiltersStrokeModule.h" // For export macro

#include "Stroke/canvas.h"
#include "Stroke/correct.h"
#include "Stroke/polyline.h"
#include "vtkOversketchFilterTools.h"

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <vector>

class vtkImageData;
class vtkPolyData;

namespace oversketch
{

/**
 * One polyline of strokes [display px] or of curves on a canvas [world].
 */
struct DrawnLine
{
  std::vector<vtkIdType> Ids; // of the samples
  Polyline Samples;
  bool Closed = false; // its last id was its first one, which is not repeated here
};

/**
 * All strokes or curves, number i from cell i; z is ignored. Throws Error(BadStroke) naming the stroke when
 * there is no polyline or there are other cells, and for a stroke with fewer than `least` samples or one that
 * is not finite.
 */
OVERSKETCHFILTERSSTROKE_EXPORT std::vector<DrawnLine> ReadStrokes(vtkPolyData* strokes, int least = 2);

/**
 * Writes the view that all strokes are seen in: cell arrays ViewTransform, ProjectionTransform, ViewportSize.
 */
OVERSKETCHFILTERSSTROKE_EXPORT void WriteView(const View& view, vtkPolyData* strokes);

/**
 * One of several strokes as a polydata of its own, with its samples' arrays, its own and the field arrays.
 */
OVERSKETCHFILTERSSTROKE_EXPORT vtkSmartPointer<vtkPolyData> StrokeAlone(vtkPolyData* strokes, vtkIdType cell);

/**
 * Whether two hold the same polylines, to the bit: points, ids and all arrays.
 */
OVERSKETCHFILTERSSTROKE_EXPORT bool SameLines(vtkPolyData* a, vtkPolyData* b);

/**
 * Key that tells curves apart: points, polylines, point arrays and the canvas, and the cell arrays that are
 * named.
 */
OVERSKETCHFILTERSSTROKE_EXPORT MeshKey CurvesKey(vtkPolyData* curves,
  const std::vector<const char*>& cellArrays = {});

/**
 * The canvas of curves, from their field array Canvas: x and y of the lower left corner, width, height.
 * Throws Error(MissingArray) where there is none, Error(BadStroke) where it has no extent.
 */
OVERSKETCHFILTERSSTROKE_EXPORT Canvas CanvasOf(vtkPolyData* curves);

/**
 * Writes it.
 */
OVERSKETCHFILTERSSTROKE_EXPORT void WriteCanvas(const Canvas& canvas, vtkPolyData* curves);

/**
 * The rectangle of a picture and where its samples are: sample (i, j) at Origin + (i, j) * Spacing.
 */
struct PicturePlace
{
  Canvas Rectangle;
  Vector2 Origin, Spacing; // world
  int Columns = 0, Rows = 0;

  Vector2 ToPixels(const Vector2& world) const { return (world - this->Origin).cwiseQuotient(this->Spacing); }
  Vector2 ToWorld(const Vector2& pixel) const { return this->Origin + this->Spacing.cwiseProduct(pixel); }
};

/**
 * Throws Error(BadStroke) for a picture without samples, of several slices, with a spacing that is not
 * positive or with another direction matrix than the identity.
 */
OVERSKETCHFILTERSSTROKE_EXPORT PicturePlace PlaceOf(vtkImageData* picture);

/**
 * Distance of samples on a canvas, the paper's h: 0.005 of its longest side [world].
 */
OVERSKETCHFILTERSSTROKE_EXPORT double SampleSpacing(const Canvas& canvas);

/**
 * Whether a curve has two places that differ: what has not is handed on as it is, for vtkOversketchClassify
 * to reject.
 */
OVERSKETCHFILTERSSTROKE_EXPORT bool HasLength(const Polyline& points);

/**
 * Writes polylines at z = 0, a closed one with its first id repeated at the end, point array ArcLength, cell
 * arrays StrokeId and Closed, and the canvas.
 */
OVERSKETCHFILTERSSTROKE_EXPORT void WriteCurves(const std::vector<CanvasStroke>& curves,
  const Canvas& canvas,
  vtkPolyData* output);

/**
 * Point arrays of the input, at places of its curves: places[i] on curve i, in the order of the output's
 * points. An array that the output has already, ArcLength among them, is not written again.
 */
OVERSKETCHFILTERSSTROKE_EXPORT void CarryPointArrays(vtkPolyData* input,
  const std::vector<DrawnLine>& curves,
  const std::vector<std::vector<Blend>>& places,
  vtkPolyData* output);

/**
 * Passes the cell and field arrays of the input that the output does not have; those of a view and of
 * dragging never, so that curves are not taken for strokes.
 */
OVERSKETCHFILTERSSTROKE_EXPORT void PassDrawingArrays(vtkPolyData* input, vtkPolyData* output);

} // namespace oversketch
#endif
