// The steps that judge a drawing's lines, run on those of each layer: lines of several may cross.
#ifndef oversketch_widgets_drawing_by_layers_h
#define oversketch_widgets_drawing_by_layers_h

#include "Mesh/message.h"

#include <vector>

class vtkPolyData;
class vtkPolyDataAlgorithm;

namespace oversketch
{

// Runs steps that follow on each other. `layers`: the layer of each stroke (LayersOfStrokes); `curves` gets
// what they make of the lines, where one fails what came to it. Returns what is to be said: errors, where
// there are none warnings.
std::vector<Message> runByLayers(const std::vector<vtkPolyDataAlgorithm*>& steps,
  vtkPolyData* lines,
  const std::vector<int>& layers,
  vtkPolyData* curves);

} // namespace oversketch
#endif
