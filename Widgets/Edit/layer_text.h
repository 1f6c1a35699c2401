// Layers read, changed by a hand and written: the text of vtkOversketchShadingLevels.
#ifndef oversketch_widgets_edit_layer_text_h
#define oversketch_widgets_edit_layer_text_h

#include "Shading/layers.h"

#include <string>
#include <vector>

namespace oversketch
{

std::string layerText(const LayerList& list);

// The same layers without those of areas that are no more, of which there are so many.
std::string layersOfAreas(const std::string& layers, int areas);

// The handles of an area, which is added where the list does not have it; of the whole disc below 0.
std::vector<LayerHandle>& handlesIn(LayerList& list, int area);

// The layers that an area's handles, or the whole disc's, make of so many levels. An area without handles of
// its own has those of the whole disc.
Layers layersOf(const LayerList& list, int area, int levels);

} // namespace oversketch
#endif
