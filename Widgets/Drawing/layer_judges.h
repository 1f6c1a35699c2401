// What the lines of a drawing are, those of each layer judged apart: lines of several may cross.
#ifndef oversketch_widgets_drawing_layer_judges_h
#define oversketch_widgets_drawing_layer_judges_h

#include "Mesh/message.h"

#include <memory>
#include <vector>

class vtkPolyData;

namespace oversketch
{

class LayerJudges
{
public:
  LayerJudges();
  ~LayerJudges();

  // Puts curves of vtkOversketchTreatment into a polydata, made of those of vtkOversketchResample; of a layer
  // in which that fails as far as it came. `layers`: the layer of each stroke (LayersOfStrokes); `arranges`:
  // strokes may cross. Returns what is to be said: errors, where there are none warnings.
  std::vector<Message> judge(vtkPolyData* lines,
    const std::vector<int>& layers,
    bool arranges,
    vtkPolyData* curves);

private:
  struct Judge;
  std::vector<std::unique_ptr<Judge>> All; // of each layer, which keep what they made
};

} // namespace oversketch
#endif
