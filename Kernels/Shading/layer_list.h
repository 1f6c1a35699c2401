// Layers as a text says them, for parameters of filters and for files: read, changed by a hand and written.
#ifndef oversketch_kernels_shading_layer_list_h
#define oversketch_kernels_shading_layer_list_h

#include "Shading/layers.h"

#include <string>
#include <vector>

namespace oversketch
{

// An area with layers of its own.
struct AreaLayers
{
  int area = 0;
  int levels = 0;                   // 0: as many as the whole disc
  std::vector<LayerHandle> handles; // none: those of the whole disc
};

struct LayerList
{
  std::vector<LayerHandle> handles;
  std::vector<AreaLayers> areas; // each once, in the text's order
};

// "handle FROM TO" puts a handle on what lies at FROM by default and drags it to TO, both shares of the way
// from the reference curve to the boundary; "area NUMBER [LEVELS]" begins an area's own, by the number of its
// stroke from 0; with ";" between them: "handle 0.4 0.2; area 0 9; handle 0.4 0.6". Throws
// Error(Failure::BadStroke) that quotes what is not understood.
LayerList layerList(const std::string& text);

// The text of a list, to the bit: what is read from it is the same list.
std::string layerText(const LayerList& list);

// Layers without those of areas that are no more, of which there are so many.
std::string layersOfAreas(const std::string& layers, int areas);

// The handles of an area, which is added where the list does not have it; of the whole disc below 0.
std::vector<LayerHandle>& handlesIn(LayerList& list, int area);

// The layers that an area's handles, or the whole disc's, make of so many levels. An area without handles of
// its own has those of the whole disc.
Layers layersOf(const LayerList& list, int area, int levels);

} // namespace oversketch
#endif
