// A drawing's strokes, one by one: a step of a system that makes a mesh of a drawing holds all of them, and
// each can be changed, switched off and taken away.
#ifndef oversketch_applications_session_scene_drawing_lines_h
#define oversketch_applications_session_scene_drawing_lines_h

#include "step.h"

#include "vtkSmartPointer.h"

#include <array>
#include <memory>
#include <string>
#include <vector>

namespace oversketch_session
{

struct DrawnStroke
{
  vtkSmartPointer<vtkPolyData> line; // one polyline with its arrays
  bool on = true;                    // off: the system does not get it
};

// In their order; none where the data are no polylines. Which are on is cell array On, absent where all are.
std::vector<DrawnStroke> strokesOf(vtkPolyData* drawing);
// Those of a step; none of one that is no drawing.
std::vector<DrawnStroke> strokesOf(const Step& step);

// The other way, with the field arrays of another drawing.
vtkSmartPointer<vtkPolyData> drawingOf(const std::vector<DrawnStroke>& strokes, vtkPolyData* like);

// The drawing that a system gets: the strokes that are on, without the array. Data without the array are
// handed back.
vtkSmartPointer<vtkPolyData> strokesThatAreOn(vtkPolyData* drawing);

// Cell arrays in which a stroke says what becomes of its inside.
constexpr const char* treatmentArray = "Treatment";
constexpr const char* depthArray = "Depth";
constexpr const char* heightArray = "Height";
constexpr const char* sectionArray = "CrossSection";

// 0 fill, 1 hole, 2 tunnel.
int treatmentOf(vtkPolyData* line);

// 0 in the plane, 1 in front, 2 behind, 3 both sides.
int depthOf(vtkPolyData* line);
// Factor of the heights over what the line bounds; 0 the drawing's.
double heightOf(vtkPolyData* line);
// 0 the drawing's cross-section, 1 circle, 2 linear, 3 step.
int crossSectionOf(vtkPolyData* line);
// A copy of a line that says so.
vtkSmartPointer<vtkPolyData> withDepth(vtkPolyData* line, int depth, double height, int crossSection);

// A first step that makes a mesh of what will be drawn: over a picture, the bytes of a PNG or JPEG file; on
// an empty canvas of that size. Throws oversketch_files::Failed for what is no picture.
std::shared_ptr<const Step> drawingOver(const Image& picture);
std::shared_ptr<const Step> drawingOn(double width, double height);
// A step over a picture, as a part about a place; world units a px of the picture.
std::shared_ptr<const Step> partOver(const Image& picture, const std::array<double, 3>& place, double unit);

// The picture that a step's drawing is over; null where it is over none.
const Image* pictureUnder(const Step& step);
// The canvas that a step's drawing is drawn on: left, bottom, right, top; zeros where nothing tells.
std::array<double, 4> canvasOf(const Step& step);

// A copy of a step with another drawing.
Step withDrawing(const Step& step, vtkPolyData* drawing);

extern const char* const drawingSystem; // "InflateDrawing"
extern const char* const strokesInput;  // "Strokes", its input beside the picture
extern const char* const pictureInput;  // "Picture"

} // namespace oversketch_session
#endif
